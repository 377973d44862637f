//! Rows of samples, of a file or in memory, become the working picture: linear light, shrunk, upright.

use std::ops::Range;

use image::metadata::Orientation;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::colour::{ColourKind, Meaning, apply_matrix};
use super::job::{DecodeOptions, Decoded, Job};
use super::light::{Light, SampleDepth, SampleLayout};
use super::orient::{turned, upright};
use crate::Error;
use crate::raster::crop::PixelPart;
use crate::raster::planes::{Planes, Raster};
use crate::raster::shrink::{Extent, Shrinker};
use crate::units::Size;

/// Which part of the rows of a file becomes the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extents {
    /// Pixels in a row.
    pub(super) width: u32,
    pub(super) across: Extent,
    pub(super) down: Extent,
}

impl Extents {
    /// `part` of a picture that is `width` pixels wide, and comes pixel for pixel.
    pub(super) fn pixels(width: u32, part: PixelPart) -> Self {
        let across = Extent::pixels(part.left, part.size.width);
        Self { width, across, down: Extent::pixels(part.top, part.size.height) }
    }
}

/// What the samples of a file are, and which working picture they become.
pub(super) struct Samples {
    source: Extents,
    light: Light,
    /// Working size before the turn.
    stored: Size,
    orientation: Orientation,
}

impl Samples {
    /// `target` is the upright working size.
    pub(super) fn new(
        layout: SampleLayout,
        meaning: Meaning,
        source: Extents,
        target: Size,
        orientation: Orientation,
    ) -> Self {
        let light = Light::new(layout, meaning, source.width);
        Self { source, light, stored: turned(target, orientation), orientation }
    }

    fn shrink(&self, rows: Range<usize>) -> Planes<Shrinker<f64>> {
        let Extents { width, across, down } = self.source;
        let shrinker = Shrinker::of_rows(width, across, down, self.stored, rows);
        self.light.planes().map(|()| shrinker.clone())
    }

    /// To take the rows one by one, from the top.
    pub(super) fn rows(self) -> Rows {
        Rows { shrink: self.shrink(0..self.stored.height as usize), samples: self }
    }

    /// The working picture of all rows, which lie one behind the other: the cores take bands of it side by side. `None`
    /// when rows are missing.
    pub(super) fn raster(self, samples: &[u8]) -> Option<Raster> {
        let row_bytes = self.light.layout.row_bytes(self.source.width);
        let height = self.stored.height as usize;
        let bands = rayon::current_num_threads().min(height);
        let band = |band: usize| {
            let mut light = self.light.clone();
            let mut shrink = self.shrink(band * height / bands..(band + 1) * height / bands);
            let rows = shrink.as_slice().first().map_or(0..0, Shrinker::rows);
            shrink.as_mut_slice().iter_mut().for_each(|shrinker| shrinker.skip_to(rows.start));
            for row in samples.chunks_exact(row_bytes).take(rows.end).skip(rows.start) {
                push(row, &mut light, &mut shrink);
            }
            finished(shrink)
        };
        let parts: Option<Vec<_>> = (0..bands).into_par_iter().map(band).collect();
        let mut parts = parts?.into_iter();
        let mut planes = parts.next()?;
        for below in parts {
            for (plane, below) in planes.as_mut_slice().iter_mut().zip(below.as_slice()) {
                plane.extend_from_slice(below);
            }
        }
        Some(self.raster_of(planes))
    }

    /// The upright picture of planes as they are stored.
    fn raster_of(self, planes: Planes<Vec<f32>>) -> Raster {
        let Self { light, stored, orientation, .. } = self;
        let planes = match planes {
            // A picture without colour in an RGB file is grey from here on: a third of the work in every stage.
            Planes::Colour([red, green, blue]) if red == green && green == blue => Planes::Grey(red),
            Planes::Colour(mut colours) => {
                if let Some(matrix) = &light.matrix {
                    apply_matrix(&mut colours, matrix);
                }
                Planes::Colour(colours)
            }
            Planes::Grey(grey) => Planes::Grey(grey),
        };
        Raster::new(turned(stored, orientation), planes.map(|plane| upright(plane, stored, orientation)))
    }
}

/// Takes the rows of a file from the top.
pub(super) struct Rows {
    samples: Samples,
    shrink: Planes<Shrinker<f64>>,
}

impl Rows {
    /// Takes the next row as the layout says, [`SampleLayout::row_bytes`] long.
    pub(super) fn push(&mut self, row: &[u8]) {
        push(row, &mut self.samples.light, &mut self.shrink);
    }

    /// The working picture; `None` when rows are missing.
    pub(super) fn finish(self) -> Option<Raster> {
        Some(self.samples.raster_of(finished(self.shrink)?))
    }
}

fn push(row: &[u8], light: &mut Light, shrink: &mut Planes<Shrinker<f64>>) {
    light.take(row);
    shrink.as_mut_slice().iter_mut().zip(light.row()).for_each(|(shrinker, row)| shrinker.push(row));
}

fn finished(shrink: Planes<Shrinker<f64>>) -> Option<Planes<Vec<f32>>> {
    shrink.map(|shrinker| shrinker.finish_whole().map(|plane| plane.values)).all()
}

/// What pixels in memory are called where a file's format is named.
const FORMAT: &str = "RGBA";

/// The working picture of RGBA samples in sRGB, 8 bits each, that a program has in memory: treated as those of a PNG
/// file with the same samples.
pub(super) fn decode_rgba8(size: Size, pixels: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    let job = Job::begin(FORMAT, size, Orientation::NoTransforms, options)?;
    let layout = SampleLayout { kind: ColourKind::Rgb, alpha: true, depth: SampleDepth::Eight };
    let source = Extents::pixels(size.width, job.part);
    let samples = Samples::new(layout, Meaning::Srgb, source, job.target, job.orientation);
    job.end(samples.raster(pixels))
}
