//! The canvas on which a drawing is rendered, and what it costs.

use image::metadata::Orientation;
use resvg::tiny_skia;
use usvg::{ImageKind, Tree};

use super::colour::{ColourKind, Meaning};
use super::filters;
use super::job::{Limits, check_memory};
use super::light::{SampleDepth, SampleLayout};
use super::rows::{Extents, Samples};
use crate::Error;
use crate::raster::crop::PixelPart;
use crate::raster::planes::Raster;
use crate::units::Size;

/// The format of drawings.
pub(super) const FORMAT: &str = "SVG";

/// What to do about a drawing that takes too much memory where no limit can be raised.
const FLATTER: &str = "make it smaller, or take groups with an opacity, a mask or a filter apart";

/// Most times finer than the working picture a drawing is rendered.
pub(super) const MOST_FINER: f32 = 8.0;

/// How many pixels of a picture inside a drawing lie side by side in a pixel of the canvas, at most. resvg takes the
/// nearest ones, or the nearest 16, of each place: where they are close, it passes over most of them, and thin lines of
/// a scan go to pieces.
pub(super) fn density(group: &usvg::Group, transform: tiny_skia::Transform) -> f32 {
    let of_node = |node: &usvg::Node| match node {
        usvg::Node::Group(group) => density(group, transform),
        usvg::Node::Image(image) if !matches!(image.kind(), ImageKind::SVG(_)) => {
            let to_canvas = transform.pre_concat(image.abs_transform());
            let (across, down) = (to_canvas.sx.hypot(to_canvas.ky), to_canvas.kx.hypot(to_canvas.sy));
            1.0 / across.min(down).max(1e-6)
        }
        _ => 1.0,
    };
    let of_mask = group.mask().map(|mask| density(mask.root(), transform));
    group.children().iter().map(of_node).chain(of_mask).fold(1.0, f32::max)
}

const NO_ROOM: Error = Error::NoMemory { what: "the drawing" };

/// A drawing over white on a canvas of a size.
pub(super) fn canvas(tree: &Tree, transform: tiny_skia::Transform, size: Size) -> Result<tiny_skia::Pixmap, Error> {
    let mut canvas = tiny_skia::Pixmap::new(size.width, size.height).ok_or(NO_ROOM)?;
    canvas.fill(tiny_skia::Color::WHITE);
    resvg::render(tree, transform, &mut canvas.as_mut());
    Ok(canvas)
}

/// Renders a drawing over white: on a canvas so many times finer, of which each pixel is an average. Also gives the
/// canvas.
pub(super) fn render(
    tree: &Tree,
    transform: tiny_skia::Transform,
    target: Size,
    finer: u32,
) -> Result<(Raster, tiny_skia::Pixmap), Error> {
    let size = Size::new(target.width * finer, target.height * finer);
    let canvas = canvas(tree, transform.post_scale(finer as f32, finer as f32), size)?;
    let layout = SampleLayout { kind: ColourKind::Rgb, alpha: true, depth: SampleDepth::Eight };
    let source = Extents::pixels(size.width, PixelPart::whole(size));
    let samples = Samples::new(layout, Meaning::Srgb, source, target, Orientation::NoTransforms);
    Ok((samples.raster(canvas.data()).ok_or(NO_ROOM)?, canvas))
}

/// Refuses a drawing that takes more memory than the default limits while it is drawn at `target` pixels, as each group
/// that is blended as a whole has a canvas of that size; or more work than can be done in some seconds. `transform`
/// leads to the canvas.
///
/// # Errors
/// [`Error::TooMuchMemory`] and [`Error::TooComplex`].
pub(crate) fn check_canvases(tree: &Tree, transform: tiny_skia::Transform, target: Size) -> Result<(), Error> {
    let canvas = target.area().saturating_mul(4);
    let bytes = (1 + canvases(tree.root())).saturating_mul(canvas);
    // who looks at a page sets no limits
    check_memory(FORMAT, target, bytes, Limits::default()).map_err(|error| match error {
        Error::TooMuchMemory { format, size, needed_mb, limit_mb, .. } => {
            Error::TooMuchMemory { format, size, needed_mb, limit_mb, remedy: FLATTER }
        }
        other => other,
    })?;
    filters::check(tree, transform, target, 1).map_err(|why| Error::too_complex(FORMAT, why))
}

/// Most canvases one inside the other below a group.
pub(super) fn canvases(group: &usvg::Group) -> u64 {
    let below = |node: &usvg::Node| match node {
        usvg::Node::Group(group) => {
            // A mask or a filter works on copies.
            let own = u64::from(group.should_isolate()) + u64::from(group.mask().is_some());
            own + 3 * u64::from(!group.filters().is_empty()) + canvases(group)
        }
        usvg::Node::Image(image) => match image.kind() {
            ImageKind::SVG(tree) => 1 + canvases(tree.root()),
            _ => 0,
        },
        _ => 0,
    };
    group.children().iter().map(below).max().unwrap_or(0)
}
