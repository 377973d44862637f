//! Pixels that a program has in memory: treated as those of a PNG file with the same samples.

use image::metadata::Orientation;

use super::colour::{Kind, Meaning};
use super::job::{Job, Options, Picture};
use super::light::{Depth, Layout};
use super::rows::{Extents, Samples};
use crate::Error;
use crate::units::Size;

/// What they are called where a file's format is named.
const FORMAT: &str = "RGBA";

/// The working picture of RGBA samples in sRGB, 8 bits each.
pub(super) fn decode_rgba8(size: Size, pixels: &[u8], options: &Options<'_>) -> Result<Picture, Error> {
    let job = Job::begin(FORMAT, size, Orientation::NoTransforms, options)?;
    let layout = Layout { kind: Kind::Rgb, alpha: true, depth: Depth::Eight };
    let source = Extents::pixels(size.width, job.part);
    let samples = Samples::new(layout, Meaning::Srgb, source, job.target, job.orientation);
    job.end(samples.raster(pixels))
}
