//! The texts of a drawing. Letters as lines are squiggles under a finger, so texts are left out of the picture, and
//! kept as data.

use resvg::tiny_skia::{Pixmap, Transform};
use usvg::{Group, Node, Text, Tree};

use super::colour::one_line;
use crate::listing::{counted, first_few};
use crate::raster::vector::DrawnText;
use crate::units::{PxPoint, Size};

/// The texts of a drawing which is rendered with `transform` at a size, in the order in which they are painted.
pub(super) fn of_tree(tree: &Tree, transform: Transform, size: Size) -> Vec<DrawnText> {
    let mut found = Vec::new();
    add_group(tree.root(), transform, size, &mut found);
    found
}

/// Most texts that are named in a remark.
const MOST_NAMED: usize = 5;

/// What is told of texts that are not seen.
pub(super) fn told_unseen(unseen: &[DrawnText]) -> Option<String> {
    let are = if unseen.len() == 1 { "is" } else { "are" };
    let names = first_few(unseen, MOST_NAMED, |text| format!("\"{}\"", short(&text.string)));
    let texts = counted(unseen.len(), "text");
    (!unseen.is_empty()).then(|| {
        format!(
            "{texts} that {are} not seen in the drawing (transparent, covered, or of the colour of the ground): {names}"
        )
    })
}

/// The beginning of a text from a drawing, on one line.
pub(super) fn short(text: &str) -> String {
    const LONGEST: usize = 60;
    let text = one_line(&text);
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text,
    }
}

/// Letters are seen where they change a value of 0 to 255 by more than this: as many as blending rounds off.
const SEEN: u8 = 3;

/// Whether letters are seen, by the drawing rendered with and without its texts: not those that are transparent,
/// covered, clipped, or of the colour of their ground.
pub(super) fn is_seen(text: &DrawnText, [with, without]: [&Pixmap; 2]) -> bool {
    let columns = text.min.x.max(0.0) as usize..(text.max.x.ceil() as usize).min(with.width() as usize);
    let rows = text.min.y.max(0.0) as usize..(text.max.y.ceil() as usize).min(with.height() as usize);
    let row = |pixmap: &Pixmap, y: usize| {
        let start = y * pixmap.width() as usize;
        4 * (start + columns.start)..4 * (start + columns.end)
    };
    let differs = |(a, b): (&u8, &u8)| a.abs_diff(*b) > SEEN;
    !columns.is_empty() && { rows }
        .any(|y| with.data()[row(with, y)].iter().zip(&without.data()[row(without, y)]).any(differs))
}

/// Texts of which some are lines of one sentence, as programs write them that know no paragraphs: the lines are one
/// text. One goes on with the other if it comes next, begins with a small letter right below a text that begins with a
/// capital, in letters of the same size, and one of them has several words. A list of single words is none.
pub(super) fn sentences(texts: Vec<DrawnText>) -> Vec<DrawnText> {
    let mut joined: Vec<DrawnText> = Vec::new();
    // the last line of the text that was last
    let mut line: Option<(PxPoint, PxPoint)> = None;
    for text in texts {
        let own = (text.min, text.max);
        match (joined.last_mut(), line) {
            (Some(last), Some(above)) if goes_on(last, above, &text) => {
                match last.string.strip_suffix('-') {
                    Some(begun) => last.string = format!("{begun}{}", text.string),
                    None => last.string = format!("{} {}", last.string, text.string),
                }
                (last.min, last.max) = (last.min.min(text.min), last.max.max(text.max));
            }
            _ => joined.push(text),
        }
        line = Some(own);
    }
    joined
}

/// Lines of a paragraph are so far apart, in sizes of their font (the usual leading is 1.2).
const LEADING: std::ops::RangeInclusive<f32> = 0.9..=1.45;
/// Their beginnings or their middles are in line within this, in sizes of their font.
const IN_LINE: f32 = 0.35;

/// Whether a text goes on with the sentence of `text`, whose last line is `above` it.
fn goes_on(text: &DrawnText, (min, max): (PxPoint, PxPoint), next: &DrawnText) -> bool {
    let size = text.size.max(f32::MIN_POSITIVE);
    let is_alike = text.hidden == next.hidden
        && (next.size / size - 1.0).abs() < 0.05
        && text.angle.abs() < 1.0
        && next.angle.abs() < 1.0;
    let step = 0.5 * (next.min.y + next.max.y - min.y - max.y) / size;
    let middles = 0.5 * (next.min.x + next.max.x - min.x - max.x);
    let in_line = (next.min.x - min.x).abs().min(middles.abs()) <= IN_LINE * size;
    let begins = text.string.chars().next().is_some_and(char::is_uppercase);
    let is_ended = text.string.ends_with(['.', '!', '?', ':', ';']);
    let has_small = next.string.chars().next().is_some_and(char::is_lowercase);
    let has_words = text.string.contains(' ') || next.string.contains(' ') || text.string.ends_with('-');
    is_alike && LEADING.contains(&step) && in_line && begins && !is_ended && has_small && has_words
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

#[cfg(test)]
mod tests;
