//! Rows of a file's samples become rows of linear light, and those the working picture.

use std::ops::Range;
use std::sync::Arc;

use image::metadata::Orientation;
use moxcms::Transform16BitExecutor;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::colour::{Kind, Matrix, Meaning, Table, apply_matrix, curve_table, srgb_table};
use super::orient::{turned, upright};
use super::shrink::{Extent, Shrink};
use crate::raster::crop::Part;
use crate::raster::planes::Raster;
use crate::units::Size;

/// How the samples of a pixel follow one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Layout {
    /// What they mean; inks are 0 for none and the largest number for full.
    pub(super) kind: Kind,
    /// Whether opacity follows them (0 for clear, not multiplied into the colours).
    pub(super) alpha: bool,
    /// Their size and order of bytes.
    pub(super) depth: Depth,
}

/// Size of a sample and its order of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Depth {
    Eight,
    SixteenBigEndian,
    /// As this machine has it.
    SixteenNative,
}

impl Layout {
    /// 8 bits, no opacity.
    pub(super) fn plain(kind: Kind) -> Self {
        Self { kind, alpha: false, depth: Depth::Eight }
    }

    fn channels(self) -> usize {
        let colours = match self.kind {
            Kind::Grey => 1,
            Kind::Rgb => 3,
            Kind::Cmyk => 4,
        };
        colours + usize::from(self.alpha)
    }

    /// Bytes for a row of `width` pixels.
    pub(super) fn row_bytes(self, width: u32) -> usize {
        let bytes = if self.depth == Depth::Eight { 1 } else { 2 };
        width as usize * self.channels() * bytes
    }

    fn planes(self) -> usize {
        if self.kind == Kind::Grey { 1 } else { 3 }
    }
}

/// Takes the rows of a file from the top.
pub(super) struct Rows {
    extents: (u32, Extent, Extent),
    light: Light,
    shrink: Shrink,
    /// Working size before the turn.
    stored: Size,
    orientation: Orientation,
}

impl Rows {
    /// For rows of `width` pixels of which the two extents are used; `target` is the upright working size.
    pub(super) fn new(
        layout: Layout,
        meaning: Meaning,
        extents: (u32, Extent, Extent),
        target: Size,
        orientation: Orientation,
    ) -> Self {
        let stored = turned(target, orientation);
        let (width, across, down) = extents;
        let light = Light::new(layout, meaning, width);
        let shrink = Shrink::new(across, down, stored, layout.planes());
        Self { extents, light, shrink, stored, orientation }
    }

    /// For rows that hold exactly the pixels of a picture of `width` pixels across, of which `part` is used.
    pub(super) fn whole(
        layout: Layout,
        meaning: Meaning,
        (width, part): (u32, Part),
        target: Size,
        orientation: Orientation,
    ) -> Self {
        let across = Extent::pixels(part.left, part.size.width);
        let down = Extent::pixels(part.top, part.size.height);
        Self::new(layout, meaning, (width, across, down), target, orientation)
    }

    /// Takes the next row as the layout says, [`Layout::row_bytes`] long.
    pub(super) fn push(&mut self, row: &[u8]) {
        self.light.take(row);
        self.shrink.push(&self.light.planes);
    }

    /// The working picture; `None` when rows are missing.
    pub(super) fn finish(self) -> Option<Raster> {
        let planes = self.shrink.finish()?;
        raster(planes, self.light.matrix.as_ref(), self.stored, self.orientation)
    }

    /// The working picture of all rows, which lie one behind the other: the cores take bands of it side by side. `None` when
    /// rows are missing.
    pub(super) fn finish_with(self, samples: &[u8]) -> Option<Raster> {
        let Self { extents: (width, across, down), light, stored, orientation, .. } = self;
        let (row_bytes, count) = (light.layout.row_bytes(width), light.layout.planes());
        let height = stored.height as usize;
        let bands = rayon::current_num_threads().min(height);
        let band = |band: usize| {
            let mut light = light.clone();
            let rows = band * height / bands..(band + 1) * height / bands;
            let mut shrink = Shrink::part(across, down, stored, count, rows);
            let Range { start, end } = shrink.rows();
            for row in samples.chunks_exact(row_bytes).take(end).skip(start) {
                light.take(row);
                shrink.push(&light.planes);
            }
            shrink.finish()
        };
        let parts: Option<Vec<_>> = (0..bands).into_par_iter().map(band).collect();
        let mut parts = parts?.into_iter();
        let mut planes = parts.next()?;
        for below in parts {
            planes.iter_mut().zip(below).for_each(|(plane, below)| plane.extend(below));
        }
        raster(planes, light.matrix.as_ref(), stored, orientation)
    }
}

/// The upright picture of planes as they are stored.
fn raster(
    mut planes: Vec<Vec<f32>>,
    matrix: Option<&Matrix>,
    stored: Size,
    orientation: Orientation,
) -> Option<Raster> {
    // A picture without colour in an RGB file is grey from here on: a third of the work in every stage.
    if planes.windows(2).all(|pair| pair[0] == pair[1]) {
        planes.truncate(1);
    }
    if let Some(matrix) = matrix {
        apply_matrix(&mut planes, matrix);
    }
    let mut planes = planes.into_iter().map(|plane| upright(plane, stored, orientation));
    let size = turned(stored, orientation);
    Some(match (planes.next(), planes.next(), planes.next()) {
        (Some(red), Some(green), Some(blue)) => Raster::colour(size, [red, green, blue]),
        (Some(grey), ..) => Raster::grey(size, grey),
        (None, ..) => return None,
    })
}

/// One row in linear light, over white.
#[derive(Clone)]
struct Light {
    layout: Layout,
    way: Way,
    matrix: Option<Matrix>,
    /// The row as whole numbers, for samples of 16 bits.
    wide: Vec<u16>,
    planes: Vec<Vec<f32>>,
}

/// From samples to light.
#[derive(Clone)]
enum Way {
    /// A table for each plane.
    Tables(Vec<Table>),
    /// Inks by the plain formula: light passes where there is neither the colour nor black. The table takes the product
    /// of two 8-bit transparencies.
    Inks(Table),
    /// moxcms, with room for what goes in and what comes out, and the table of 16-bit sRGB.
    Transform { transform: Arc<Transform16BitExecutor>, from: Vec<u16>, to: Vec<u16>, table: Table },
}

impl Light {
    fn new(layout: Layout, meaning: Meaning, width: u32) -> Self {
        let last = if layout.depth == Depth::Eight { 255 } else { 65535 };
        let width = width as usize;
        let (way, matrix) = match meaning {
            Meaning::Srgb if layout.kind == Kind::Cmyk => (Way::Inks(srgb_table(255 * 255)), None),
            Meaning::Srgb => (Way::Tables(vec![srgb_table(last); layout.planes()]), None),
            Meaning::Curves(curves, matrix) => {
                let mut tables: Vec<Table> = curves.iter().map(|curve| curve_table(curve, last)).collect();
                if let Some(table) = tables.first().cloned() {
                    tables.resize(layout.planes(), table);
                }
                (Way::Tables(tables), matrix)
            }
            Meaning::Transform(transform) => {
                let channels = layout.channels() - usize::from(layout.alpha);
                let (from, to) = (vec![0; width * channels], vec![0; width * 3]);
                (Way::Transform { transform, from, to, table: srgb_table(65535) }, None)
            }
        };
        Self { layout, way, matrix, wide: Vec::new(), planes: vec![vec![0.0; width]; layout.planes()] }
    }

    fn take(&mut self, row: &[u8]) {
        let (layout, planes) = (self.layout, &mut self.planes);
        match layout.depth {
            Depth::Eight => light(layout, &mut self.way, row, planes),
            depth => {
                let number = if depth == Depth::SixteenNative { u16::from_ne_bytes } else { u16::from_be_bytes };
                self.wide.clear();
                self.wide.extend(row.as_chunks().0.iter().map(|&bytes| number(bytes)));
                light(layout, &mut self.way, &self.wide, planes);
            }
        }
    }
}

/// A sample as it stands in a file.
trait Sample: Copy + PartialEq {
    const FULL: Self;
    fn index(self) -> usize;
    fn wide(self) -> u16;
}

impl Sample for u8 {
    const FULL: Self = 255;
    fn index(self) -> usize {
        usize::from(self)
    }
    fn wide(self) -> u16 {
        u16::from(self) * 257
    }
}

impl Sample for u16 {
    const FULL: Self = 65535;
    fn index(self) -> usize {
        usize::from(self)
    }
    fn wide(self) -> u16 {
        self
    }
}

fn light<S: Sample>(layout: Layout, way: &mut Way, row: &[S], planes: &mut [Vec<f32>]) {
    match (way, planes) {
        (Way::Tables(tables), [grey]) if !layout.alpha => {
            for (out, sample) in grey.iter_mut().zip(row) {
                *out = tables[0][sample.index()];
            }
        }
        (Way::Tables(tables), [red, green, blue]) => {
            let [r, g, b] = [&*tables[0], &*tables[1], &*tables[2]];
            let out = red.iter_mut().zip(green).zip(blue);
            if layout.alpha {
                for (((red, green), blue), pixel) in out.zip(row.as_chunks::<4>().0) {
                    (*red, *green, *blue) = (r[pixel[0].index()], g[pixel[1].index()], b[pixel[2].index()]);
                    if pixel[3] != S::FULL {
                        [*red, *green, *blue] = [*red, *green, *blue].map(|light| over_white(light, pixel[3]));
                    }
                }
            } else {
                for (((red, green), blue), pixel) in out.zip(row.as_chunks::<3>().0) {
                    (*red, *green, *blue) = (r[pixel[0].index()], g[pixel[1].index()], b[pixel[2].index()]);
                }
            }
        }
        (Way::Tables(tables), [grey]) => {
            for (out, pixel) in grey.iter_mut().zip(row.as_chunks::<2>().0) {
                *out = over_white(tables[0][pixel[0].index()], pixel[1]);
            }
        }
        (Way::Inks(table), [red, green, blue]) => {
            // Pictures of inks have 8 bits; more are cut.
            let eight = |sample: S| 255 - usize::from(sample.wide() >> 8);
            for (((red, green), blue), pixel) in
                red.iter_mut().zip(green).zip(blue).zip(row.chunks_exact(layout.channels()))
            {
                let black = eight(pixel[3]);
                [*red, *green, *blue] = [0, 1, 2].map(|i| table[eight(pixel[i]) * black]);
            }
        }
        (Way::Transform { transform, from, to, table }, [red, green, blue]) => {
            let channels = layout.channels();
            let colours = channels - usize::from(layout.alpha);
            for (from, pixel) in from.chunks_exact_mut(colours).zip(row.chunks_exact(channels)) {
                for (from, sample) in from.iter_mut().zip(pixel) {
                    *from = sample.wide();
                }
            }
            // Cannot fail: both are as long as moxcms asks for.
            if transform.transform(from, to).is_err() {
                to.fill(u16::MAX);
            }
            let out = red.iter_mut().zip(green).zip(blue);
            for ((((red, green), blue), to), pixel) in out.zip(to.as_chunks::<3>().0).zip(row.chunks_exact(channels)) {
                [*red, *green, *blue] = to.map(|sample| table[sample.index()]);
                if layout.alpha {
                    [*red, *green, *blue] = [*red, *green, *blue].map(|light| over_white(light, pixel[colours]));
                }
            }
        }
        _ => {}
    }
}

/// Light of a pixel of some opacity on white paper.
fn over_white<S: Sample>(light: f32, opacity: S) -> f32 {
    let opacity = opacity.index() as f32 / S::FULL.index() as f32;
    opacity * light + (1.0 - opacity)
}
