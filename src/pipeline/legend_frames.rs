//! Frames around legends: one closed line, or four lines that meet at corners, as they are found in a bitmap.

use super::legend_patches::{SAME, index};
use super::on_sheet::on_sheet;
use super::texts::Text;
use crate::edges::Edges;
use crate::geom::polygon::holds_box;
use crate::raster::Raster;
use crate::raster::contrast::distance;
use crate::raster::lab::pixel;
use crate::units::{MmPoint, MmRect, PageTransform};

/// A frame of a legend lies no farther from the sides of the box around it, mm: its corners may be round.
const BESIDE_FRAME: f32 = 1.5;
/// Strokes around a patch reach no further beyond it, mm.
pub(super) const OF_PATCH: f32 = 1.0;
/// Beside a line, its ground is looked at so far from its edge, px.
pub(super) const OFF: f32 = 2.0;
/// A side of a frame leaves its direction by no more than this, mm.
const STRAIGHT: f32 = 0.5;
/// So many level and so many upright lines are looked at: there is no legend in a grid of more.
const MOST_LINES: usize = 200;

/// Lines along the sides of a box, and the box.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FrameLines {
    pub(super) place: MmRect,
    /// The numbers of the contours, the one at the top first.
    chains: Vec<usize>,
}

/// Where contours may be frames: such that have something inside.
pub(super) fn boxes(edges: &Edges, transform: &PageTransform) -> Vec<FrameLines> {
    let places: Vec<MmRect> =
        edges.chains.iter().map(|chain| MmRect::from_points(on_sheet(edges, chain, transform))).collect();
    let is_along = |&chain: &usize| {
        let (inside, chain) = (places[chain].inflate(-BESIDE_FRAME, -BESIDE_FRAME), &edges.chains[chain]);
        chain.closed && on_sheet(edges, chain, transform).all(|at| !inside.contains(at))
    };
    let closed = (0..places.len()).filter(is_along);
    let closed = closed.map(|chain| FrameLines { place: places[chain], chains: vec![chain] });
    let open: Vec<usize> = (0..places.len()).filter(|chain| !edges.chains[*chain].closed).collect();
    let boxes = closed.chain(of_four_lines(&open, &places));
    boxes.filter(|frame| !frame.place.inflate(-BESIDE_FRAME, -BESIDE_FRAME).is_empty()).collect()
}

/// Boxes of two level and two upright ones of these lines that meet at the corners.
fn of_four_lines(lines: &[usize], places: &[MmRect]) -> Vec<FrameLines> {
    let long = 2.0 * BESIDE_FRAME;
    let is_level = |line: &&usize| places[**line].height() <= STRAIGHT && places[**line].width() > long;
    let is_upright = |line: &&usize| places[**line].width() <= STRAIGHT && places[**line].height() > long;
    let level: Vec<usize> = lines.iter().filter(is_level).copied().collect();
    let upright: Vec<usize> = lines.iter().filter(is_upright).copied().collect();
    if level.len().max(upright.len()) > MOST_LINES {
        return Vec::new();
    }
    let is_near = |a: f32, b: f32| (a - b).abs() <= BESIDE_FRAME;
    let mut boxes = Vec::new();
    for (&top, &bottom) in level.iter().flat_map(|top| level.iter().map(move |bottom| (top, bottom))) {
        let (a, b) = (places[top], places[bottom]);
        if b.min.y - a.min.y <= long || !is_near(a.min.x, b.min.x) || !is_near(a.max.x, b.max.x) {
            continue;
        }
        let side = |x: f32| {
            let is_side = |line: &&usize| {
                let own = places[**line];
                is_near(own.min.x, x) && is_near(own.min.y, a.min.y) && is_near(own.max.y, b.max.y)
            };
            upright.iter().find(is_side).copied()
        };
        if let (Some(left), Some(right)) = (side(a.min.x), side(a.max.x)) {
            let place = [a, b, places[left], places[right]].into_iter().reduce(|a, b| a.union(&b)).unwrap_or(a);
            boxes.push(FrameLines { place, chains: vec![top, bottom, left, right] });
        }
    }
    boxes
}

/// Which of the contours are [`frames`], and the number of the text that is the heading in them: one above all patches,
/// and the only one that is not of the legend.
pub(super) fn with_heading(
    edges: &Edges,
    of_patches: &[bool],
    patches: &[MmRect],
    texts: &mut [Text],
    raster: &Raster,
    transform: &PageTransform,
) -> (Vec<bool>, Option<usize>) {
    let of_frame = frames(edges, of_patches, patches, texts, raster, transform);
    let top = patches.iter().map(|patch| patch.min.y).fold(f32::INFINITY, f32::min);
    let is_above = |text: &Text| text.is_read() && !text.of_legend && text.place.center().y < top;
    let heading = |frame: MmRect| {
        let mut inside =
            (0..texts.len()).filter(|&text| frame.contains(texts[text].place.center()) && is_above(&texts[text]));
        inside.next().filter(|_| inside.next().is_none())
    };
    let holds_patches =
        |frame: &MmRect| patches.iter().all(|patch| holds_box(*frame, patch.inflate(-OF_PATCH, -OF_PATCH)));
    let boxes = boxes(edges, transform).into_iter().map(|frame| frame.place).filter(holds_patches);
    let headings: Vec<usize> = boxes.filter_map(heading).collect();
    for number in headings.into_iter().filter(|_| !of_frame.contains(&true)) {
        texts[number].of_legend = true;
        let of_frame = frames(edges, of_patches, patches, texts, raster, transform);
        if of_frame.contains(&true) {
            return (of_frame, Some(number));
        }
        texts[number].of_legend = false;
    }
    (of_frame, None)
}

/// Which of the contours are frames of a legend: along the sides of a box that holds all `patches`, and in that
/// nothing of the drawing but what is `of_patches` and words of the legend. What is filled stays, as its texture
/// does.
pub(super) fn frames(
    edges: &Edges,
    of_patches: &[bool],
    patches: &[MmRect],
    texts: &[Text],
    raster: &Raster,
    transform: &PageTransform,
) -> Vec<bool> {
    let mut are = vec![false; edges.chains.len()];
    let holds_patches =
        |place: MmRect| patches.iter().all(|patch| holds_box(place, patch.inflate(-OF_PATCH, -OF_PATCH)));
    for FrameLines { place, chains } in boxes(edges, transform) {
        let is_own = |chain: usize| of_patches[chain] || chains.contains(&chain);
        let inside = place.inflate(-BESIDE_FRAME, -BESIDE_FRAME);
        let is_inside = |chain: usize| on_sheet(edges, &edges.chains[chain], transform).any(|at| inside.contains(at));
        // the lines of a grid may lie behind it
        let is_other = |&chain: &usize| !is_own(chain) && !edges.chains[chain].kind.faint && is_inside(chain);
        // what nobody has read is left out whether a frame is around it or not
        let is_other_text = |text: &Text| text.is_read() && !text.of_legend;
        let is_frame = !chains.iter().any(|chain| of_patches[*chain])
            && holds_patches(place)
            && !texts.iter().any(|text| is_other_text(text) && place.contains(text.place.center()))
            && is_hollow(edges, chains[0], place, raster, transform)
            && !(0..are.len()).any(|chain| is_other(&chain));
        if is_frame {
            chains.iter().for_each(|chain| are[*chain] = true);
            doubled(edges, place, transform).into_iter().for_each(|chain| are[chain] = true);
        }
    }
    are
}

/// Open lines beside a frame in a bitmap, as where the blank between this and other lines was taken for a stroke.
fn doubled(edges: &Edges, place: MmRect, transform: &PageTransform) -> Vec<usize> {
    let (around, inside) = (place.inflate(BESIDE_FRAME, BESIDE_FRAME), place.inflate(-BESIDE_FRAME, -BESIDE_FRAME));
    let is_doubled = |chain: &usize| {
        let of = &edges.chains[*chain];
        let points = || on_sheet(edges, of, transform);
        let size = MmRect::from_points(points()).size();
        let is_long = size.width.max(size.height) >= 0.5 * place.width().min(place.height());
        !of.closed && !of.kind.exact && is_long && points().all(|at| around.contains(at) && !inside.contains(at))
    };
    (0..edges.chains.len()).filter(is_doubled).collect()
}

/// Whether a frame, whose upper side is this contour, has one colour on both of its sides, above and below.
fn is_hollow(edges: &Edges, top: usize, place: MmRect, raster: &Raster, transform: &PageTransform) -> bool {
    let off = transform.mm_per_px() * (0.5 * edges.chains[top].kind.stroke.unwrap_or(0.0) + OFF);
    let colour = |y: f32| {
        let at = transform.to_px(MmPoint::new(place.center().x, y));
        index(raster, at).map(|at| pixel(raster, at))
    };
    let is_same = |y: f32| colour(y - off).zip(colour(y + off)).is_some_and(|(a, b)| distance(a, b) < SAME);
    [place.min.y, place.max.y].into_iter().all(is_same)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect(x: f32, y: f32, width: f32, height: f32) -> MmRect {
        MmRect::new(MmPoint::new(x, y), MmPoint::new(x + width, y + height))
    }

    #[test]
    fn four_lines_that_meet_at_corners_are_a_frame() {
        let sides = [
            rect(10.0, 10.0, 20.0, 0.1),
            rect(10.3, 22.0, 20.0, 0.1),
            rect(10.0, 10.2, 0.1, 11.7),
            rect(30.2, 10.0, 0.0, 12.0),
        ];
        let found = |lines: &[MmRect]| of_four_lines(&(0..lines.len()).collect::<Vec<_>>(), lines);
        let frame = FrameLines { place: rect(10.0, 10.0, 20.3, 12.1), chains: vec![0, 1, 2, 3] };
        let boxes = found(&sides);
        assert_eq!(boxes.iter().map(|of| of.chains.clone()).collect::<Vec<_>>(), [frame.chains]);
        assert!(boxes[0].place.inflate(0.01, 0.01).contains_box(&frame.place));
        assert_eq!(found(&sides[..3]), [], "three sides");
        let with = |line: MmRect| found(&[sides[0], sides[1], sides[2], line]);
        assert_eq!(with(rect(30.2, 4.0, 0.0, 18.0)), [], "it goes on beyond the corner");
        assert_eq!(with(rect(34.0, 10.0, 0.0, 12.0)), [], "it does not meet them");
        assert_eq!(with(rect(30.2, 10.0, 3.0, 12.0)), [], "aslant");
    }
}
