//! Small shapes of a drawing with words beside them, which may be the patches of a legend.

use super::on_sheet::on_sheet;
use super::texts::Text;
use crate::edges::Edges;
use crate::raster::Raster;
use crate::raster::contrast::distance;
use crate::raster::lab::pixel;
use crate::units::{MmRect, PageTransform, PxPoint};

/// Short side of a patch, mm: smaller ones are points, and larger ones may be areas by themselves.
const PATCH: std::ops::RangeInclusive<f32> = 1.5..=12.0;
/// Its long side and its area at most, mm and mm2: the patches of Matplotlib are three times as wide as high, and in a
/// chart that is small before it is drawn across the sheet they are 17 mm wide. What is larger may have a texture.
const LONGEST_PATCH: f32 = 24.0;
const LARGEST_PATCH: f32 = 144.0;
/// Farthest that the word of a patch lies from it, mm: print stands up to half of its own width beside it.
const FARTHEST_WORD: f32 = 8.0;
/// A line that is seen up to a point ends no farther from it, mm.
const OF_POINT: f32 = 0.5;
/// Patches of one column have their middles in line, and their words begin in line, mm.
pub(super) const IN_LINE: f32 = 0.5;
const WORDS_IN_LINE: f32 = 1.0;
/// Colours nearer than this are one (perceptual; 2 can just be told apart side by side).
pub(super) const SAME: f32 = 4.0;
/// So many small shapes with words are looked at, among them the towns of a map.
const MOST_SHAPES: usize = 100;

/// A small shape with a word at its side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Patch {
    /// The number of its word among all texts.
    pub(super) text: usize,
    pub(super) place: MmRect,
    /// The number of the pixel in its middle.
    pub(super) middle: usize,
}

/// What may be patches among the contours of a drawing, no two of one word, and none in another.
pub(super) fn patches(edges: &Edges, texts: &[Text], raster: &Raster, transform: &PageTransform) -> Vec<Patch> {
    let mut patches: Vec<Patch> = Vec::new();
    for chain in edges.chains.iter().filter(|chain| chain.closed && chain.kind.of_drawing) {
        let place = MmRect::from_points(on_sheet(edges, chain, transform));
        if patches.len() >= MOST_SHAPES || !may_be_patch(place) {
            continue;
        }
        // in a legend in one line a patch has the word of another on its other side
        let beside = (0..texts.len()).filter(|&text| texts[text].is_read() && is_beside(place, texts[text].place));
        let nearest = beside.min_by(|&a, &b| gap(place, texts[a].place).total_cmp(&gap(place, texts[b].place)));
        let known = |text: usize| {
            let is_known = |other: &Patch| other.text == text || other.place.contains(place.center());
            patches.iter().any(is_known)
        };
        if let (Some(text), Some(middle)) = (nearest, index(raster, transform.to_px(place.center())))
            && !known(text)
            && !is_on_line(place, edges, transform)
        {
            patches.push(Patch { text, place, middle });
        }
    }
    patches
}

/// The colours in the middle of patches.
pub(super) fn colours_of(patches: &[Patch], raster: &Raster) -> Vec<[f32; 3]> {
    patches.iter().map(|patch| pixel(raster, patch.middle)).collect()
}

/// Whether no two of these colours are one.
pub(super) fn are_of_different_colours(colours: &[[f32; 3]]) -> bool {
    let is_known = |number: usize| colours[..number].iter().any(|other| distance(*other, colours[number]) < SAME);
    !(0..colours.len()).any(is_known)
}

/// Whether a shape is as large as a patch.
fn may_be_patch(place: MmRect) -> bool {
    let (short, long) = (place.width().min(place.height()), place.width().max(place.height()));
    PATCH.contains(&short) && long <= LONGEST_PATCH && short * long <= LARGEST_PATCH
}

/// Whether a line ends at a small shape or goes through it: then it is a point of a curve, and the word beside it a
/// number at an axis. The lines of a grid may lie behind a legend.
fn is_on_line(place: MmRect, edges: &Edges, transform: &PageTransform) -> bool {
    let around = place.inflate(OF_POINT, OF_POINT);
    let lines = edges.chains.iter().filter(|chain| !chain.closed && chain.kind.of_drawing && !chain.kind.faint);
    lines.flat_map(|chain| on_sheet(edges, chain, transform)).any(|at| around.contains(at))
}

/// Whether a text stands at the side of a patch, at its height.
pub(super) fn is_beside(patch: MmRect, text: MmRect) -> bool {
    let level = (patch.center().y - text.center().y).abs() <= 0.5 * patch.height().max(text.height());
    level && (0.0..=FARTHEST_WORD).contains(&gap(patch, text))
}

/// The blank between a patch and a text on its left or right, mm.
pub(super) fn gap(patch: MmRect, text: MmRect) -> f32 {
    (text.min.x - patch.max.x).max(patch.min.x - text.max.x)
}

/// Whether two shapes and their words stand in one column.
pub(super) fn are_in_column(shapes: [MmRect; 2], words: [MmRect; 2]) -> bool {
    is_in_column_of(shapes[0], shapes[1]) && (words[0].min.x - words[1].min.x).abs() <= WORDS_IN_LINE
}

/// Whether the middle of a shape is above or below that of another.
pub(super) fn is_in_column_of(shape: MmRect, other: MmRect) -> bool {
    (shape.center().x - other.center().x).abs() <= IN_LINE
}

/// The number of the pixel at a place; none outside.
pub(super) fn index(raster: &Raster, at: PxPoint) -> Option<usize> {
    let size = raster.size();
    let is_inside = at.x >= 0.0 && at.y >= 0.0 && at.x < size.width as f32 && at.y < size.height as f32;
    is_inside.then(|| at.y as usize * size.width as usize + at.x as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MmPoint;

    #[test]
    fn a_patch_may_be_flat() {
        let may_be = |width: f32, height: f32| {
            may_be_patch(MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(10.0 + width, 10.0 + height)))
        };
        assert!(may_be(5.0, 5.0) && may_be(11.5, 11.5));
        assert!(may_be(16.8, 5.9) && may_be(5.9, 16.8), "of Matplotlib, on A4");
        assert!(!may_be(1.0, 5.0), "a stroke or a point");
        assert!(!may_be(14.0, 14.0) && !may_be(23.0, 8.0), "an area");
        assert!(!may_be(40.0, 2.0), "a bar");
    }
}
