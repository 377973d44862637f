//! The texts of a drawing. Letters as lines are squiggles under a finger, so texts are left out of the picture, and
//! kept as data.

use resvg::tiny_skia::Transform;
use usvg::{Group, Node, Text, Tree};

use crate::raster::vector::DrawnText;
use crate::units::{PxPoint, Size};

/// The texts that are seen in a drawing which is rendered with `transform` at a size, in the order in which they are
/// painted.
pub(super) fn of_tree(tree: &Tree, transform: Transform, size: Size) -> Vec<DrawnText> {
    let mut found = Vec::new();
    add_group(tree.root(), transform, size, &mut found);
    found
}

/// Whether a group has a text in it. (usvg 0.49 has such a question, but does not look into groups.)
pub(super) fn has_any(group: &Group) -> bool {
    group.children().iter().any(|node| match node {
        Node::Group(group) => has_any(group),
        Node::Text(_) => true,
        Node::Path(_) | Node::Image(_) => false,
    })
}

fn add_group(group: &Group, transform: Transform, size: Size, found: &mut Vec<DrawnText>) {
    for node in group.children() {
        match node {
            Node::Group(group) => add_group(group, transform, size, found),
            Node::Text(text) => found.extend(drawn(text, transform, size)),
            Node::Path(_) | Node::Image(_) => {}
        }
    }
}

/// A text, if it has letters and a part of it is in the picture.
fn drawn(text: &Text, transform: Transform, size: Size) -> Option<DrawnText> {
    let letters = text.chunks().iter().map(|chunk| chunk.text()).collect::<Vec<_>>().join(" ");
    let string = letters.split_whitespace().collect::<Vec<_>>().join(" ");
    let place = text.abs_bounding_box().transform(transform)?;
    let is_seen = place.left() < size.width as f32
        && place.top() < size.height as f32
        && place.right() > 0.0
        && place.bottom() > 0.0;
    if string.is_empty() || !is_seen {
        return None;
    }
    let to_pixels = transform.pre_concat(text.abs_transform());
    let turned = text.rotate().first().copied().unwrap_or(0.0);
    let largest = text.chunks().iter().flat_map(|chunk| chunk.spans()).map(|span| span.font_size().get());
    Some(DrawnText {
        string,
        min: PxPoint::new(place.left(), place.top()),
        max: PxPoint::new(place.right(), place.bottom()),
        angle: -to_pixels.ky.atan2(to_pixels.sx).to_degrees() - turned,
        size: largest.fold(0.0, f32::max) * to_pixels.kx.hypot(to_pixels.sy),
        hidden: false,
    })
}
