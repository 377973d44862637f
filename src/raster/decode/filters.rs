//! How much work the filters of a drawing are, found before resvg does it: it looks at every pixel of a filter's region
//! for every part of the filter, and a small file can have thousands of them, each as large as the canvas.

use resvg::tiny_skia::{Rect, Transform};
use usvg::filter::{Filter, Kind};
use usvg::{Group, Node, Tree};

use crate::units::Size;

/// Most work, ns: ten seconds. A shadow under everything on a page of 200 mm takes half a second; drawings of people
/// and their programs are far below.
const MOST_WORK: f64 = 1e10;

// What resvg 0.49 takes for a pixel on one core, ns, measured with two cores busy (release, x86-64); small blurs take
// twice what is said here, as they are made otherwise.

/// A group that is blended as a whole: its layer is cleared, and laid over the others.
const OF_LAYER: f64 = 40.0;
/// A part of a filter, with two turns between colour spaces.
const OF_PART: f64 = 200.0;
/// A blur, whatever its radius: three boxes in two directions.
const OF_BLUR: f64 = 400.0;
/// Light on a surface.
const OF_LIGHT: f64 = 300.0;
/// An octave of turbulence: noise of four channels.
const OF_OCTAVE: f64 = 450.0;
/// A number of a convolution's matrix.
const OF_NUMBER: f64 = 20.0;
/// A pixel of the square at which a dilation or an erosion looks.
const OF_NEIGHBOUR: f64 = 5.0;

/// # Errors
/// The filters and layers of a drawing are more work than can be done in some seconds, on a canvas so many times finer.
pub(super) fn check(tree: &Tree, transform: Transform, canvas: Size, finer: u32) -> Result<(), String> {
    let finer = finer as f32;
    let [width, height] = [canvas.width as f32 * finer, canvas.height as f32 * finer];
    // resvg draws no layer that reaches farther beyond the canvas
    let Some(reach) = Rect::from_xywh(-2.0 * width, -2.0 * height, 5.0 * width, 5.0 * height) else { return Ok(()) };
    let work = work(tree.root(), transform.post_scale(finer, finer), reach);
    if work <= MOST_WORK {
        return Ok(());
    }
    Err(format!("its filters would take about {:.0} seconds, and {:.0} are the most", 1e-9 * work, 1e-9 * MOST_WORK))
}

/// The work of what is in a group.
fn work(group: &Group, transform: Transform, reach: Rect) -> f64 {
    let of_node = |node: &Node| {
        let own = match node {
            Node::Group(group) => of_layer(group, transform, reach) + work(group, transform, reach),
            Node::Text(text) => work(text.flattened(), transform, reach),
            Node::Path(_) | Node::Image(_) => 0.0,
        };
        // patterns, masks and the like
        let mut inner = 0.0;
        node.subroots(|root| inner += work(root, transform, reach));
        own + inner
    };
    group.children().iter().map(of_node).sum()
}

/// The work of a group itself, where it is drawn on a layer of its own.
fn of_layer(group: &Group, transform: Transform, reach: Rect) -> f64 {
    if !group.should_isolate() {
        return 0.0;
    }
    let area = group.abs_layer_bounding_box().to_rect().transform(transform).and_then(|area| area.intersect(&reach));
    let pixels = area.map_or(0.0, |area| f64::from(area.width()) * f64::from(area.height()));
    let to_pixels = transform.pre_concat(group.abs_transform());
    let scale = [to_pixels.sx.hypot(to_pixels.ky), to_pixels.kx.hypot(to_pixels.sy)];
    pixels * (OF_LAYER + group.filters().iter().map(|filter| of_filter(filter, scale)).sum::<f64>())
}

/// What a filter takes for each pixel of its region; `scale` is that of lengths to pixels, across and down.
fn of_filter(filter: &Filter, scale: [f32; 2]) -> f64 {
    let of_part = |kind: &Kind| match kind {
        Kind::ConvolveMatrix(part) => OF_NUMBER * f64::from(part.matrix().columns()) * f64::from(part.matrix().rows()),
        Kind::Morphology(part) => {
            let radii = [part.radius_x().get() * scale[0], part.radius_y().get() * scale[1]];
            OF_NEIGHBOUR * radii.into_iter().map(|radius| f64::from(2.0 * radius + 1.0)).product::<f64>()
        }
        Kind::Turbulence(part) => OF_OCTAVE * f64::from(part.num_octaves()),
        Kind::GaussianBlur(_) | Kind::DropShadow(_) => OF_BLUR,
        Kind::DiffuseLighting(_) | Kind::SpecularLighting(_) => OF_LIGHT,
        _ => 0.0,
    };
    filter.primitives().iter().map(|part| OF_PART + of_part(part.kind())).sum()
}
