//! Which texts of a drawing name a point: those beside a small ring, such as the names of towns on a map. Their labels
//! are placed as those of points that are given: beside the ring, or with a leader line to it and not to what else is
//! near.

use std::collections::BTreeSet;

use super::placed::Wanted;
use super::scale;
use crate::geom::polygon::{corners, distance_to_box};
use crate::page::{Line, Run};
use crate::units::{MmPoint, MmRect};

/// The largest ring that stands for a point, mm across: twice what a fingertip feels at once would be a shape.
const LARGEST: f32 = 12.0;
/// The smallest, mm across: a bead on a line.
const SMALLEST: f32 = 4.0;
/// Sides of the box around a ring differ by so much at most, mm: a step of a coarse grid of dots.
const ROUND: f32 = 2.6;
/// Farthest that a ring lies from the text that names it, mm: print stands up to 4 mm beside it, as beside the end of a
/// line, and large print as far as it is high.
const FARTHEST_RING: f32 = 5.0;
/// Texts of a column have their middles so near to that of the ring between them, mm: they were centred on it.
const IN_COLUMN: f32 = 1.5;
/// Farthest that the second text of a ring lies from it, mm: two lines of large print, as where the names along a time
/// line stand at two heights.
const FARTHEST_SECOND: f32 = 20.0;
/// Words of a row have their middles so near to one another, mm: some have letters that reach higher or lower.
const IN_ROW: f32 = 1.5;
/// Fewest texts of a row: two names of a map stand level by chance.
const FEWEST_OF_ROW: usize = 3;
/// Fewest rings with two texts: one alone may stand between two texts by chance.
const FEWEST_WITH_TWO: usize = 2;

/// A small ring: its middle, and how far it reaches from there, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SmallRing {
    pub(super) at: MmPoint,
    pub(super) reach: f32,
}

/// The small rings among lines, and the points on them.
pub(super) fn rings(lines: &[Line]) -> Vec<SmallRing> {
    let closed = lines.iter().flat_map(|line| &line.runs).filter(|run| run.closed || ends_meet(run));
    // filled ones on lines are beads there, and on lines of dots both kinds are dots of these
    let on_dots = lines.iter().flat_map(Line::row_points).map(|point| SmallRing { at: point.at, reach: point.radius });
    let beads = lines.iter().flat_map(Line::beads).filter_map(|run| {
        let extent = MmRect::from_points(run.points.iter().copied());
        run.points.first().map(|_| SmallRing { at: extent.center(), reach: 0.5 * run.width })
    });
    let ring = closed.filter_map(|run| {
        let extent = MmRect::from_points(run.points.iter().copied());
        let (width, height) = (extent.width(), extent.height());
        let is_ring = width.max(height) <= LARGEST && (width - height).abs() <= ROUND && width.min(height) > 0.0;
        is_ring.then(|| SmallRing { at: extent.center(), reach: 0.5 * width.max(height) })
    });
    // of dots beside all lines, in a square
    let alone = lines.iter().filter(|line| line.is_block_of_dots() || is_smallest_ring(line)).filter_map(|line| {
        let extent = MmRect::from_points(line.row()?.points.iter().copied());
        Some(SmallRing { at: extent.center(), reach: 0.5 * extent.width().max(extent.height()) })
    });
    ring.chain(on_dots).chain(beads).chain(alone).collect()
}

/// Whether a line is a point beside all lines, eight dots around one in its middle or around none.
fn is_smallest_ring(line: &Line) -> bool {
    let dots = |number: usize| line.runs.get(number).map_or(0, |run| run.points.len());
    line.is_ring_of_dots() && dots(0) == SMALLEST_RING && dots(1) <= 1
}

/// The smallest ring of dots on a grid.
const SMALLEST_RING: usize = 8;

/// So few dots are no ring.
const FEWEST_DOTS: usize = 6;
/// The first and the last dot of a ring are no further apart, mm: across the diagonal of a grid of 2.5 mm.
const NEXT_DOT: f32 = 3.6;

/// A dot so near to the corner of a box of dots, mm, is in it.
const AT_CORNER: f32 = 0.5;

/// Whether a run of dots comes back to where it begins, and has no corners, as the patches of a legend have.
fn ends_meet(run: &Run) -> bool {
    let ends = run.points.first().zip(run.points.last());
    let is_ring = run.points.len() >= FEWEST_DOTS && ends.is_some_and(|(a, b)| (*b - *a).length() <= NEXT_DOT);
    let corners = corners(MmRect::from_points(run.points.iter().copied()));
    let is_in_corner = |at: &MmPoint| corners.iter().any(|corner| (*corner - *at).length() <= AT_CORNER);
    is_ring && !run.points.iter().any(is_in_corner)
}

/// The place of a ring on a line that the page lacks: what stands beside it in the drawing names it still.
pub(super) fn missing(at: MmPoint) -> SmallRing {
    SmallRing { at, reach: 0.5 * SMALLEST }
}

/// What each label names: the middle of the ring that it stands beside, as an empty box, or else its own anchor. A word
/// of a row beyond a line, such as a month below an axis, is of that row. Each ring has one label, the nearest; those
/// along a time line have a second one on their other side. Whether nothing lies between is for `is_seen` to say.
pub(super) fn anchors(
    wanted: &[Wanted],
    rings: &[SmallRing],
    is_seen: impl Fn(MmPoint, &SmallRing) -> bool,
) -> Vec<MmRect> {
    let gap = |label: &Wanted, ring: &SmallRing| {
        let far = distance_to_box(ring.at, label.anchor);
        // a ring around a text is a shape with a text in it
        (far > 0.0 && far - ring.reach <= FARTHEST_RING.max(label.anchor.height())).then_some(far)
    };
    let mut pairs: Vec<(f32, usize, usize)> = Vec::new();
    for (number, label) in wanted.iter().enumerate() {
        if !label.anchor.is_empty() && label.lost_leader.is_none() {
            let of_ring = |(ring, at): (usize, &SmallRing)| {
                let far = gap(label, at)?;
                let is_of_axis = || is_word_of_row(number, wanted) && !is_seen(label.anchor.center(), at);
                (!is_of_axis()).then_some((far, number, ring))
            };
            pairs.extend(rings.iter().enumerate().filter_map(of_ring));
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut anchors: Vec<MmRect> = wanted.iter().map(|label| label.anchor).collect();
    let mut names = vec![None; rings.len()];
    for (_, number, ring) in pairs {
        if !anchors[number].is_empty() && names[ring].is_none() {
            anchors[number] = MmRect::new(rings[ring].at, rings[ring].at);
            names[ring] = Some(number);
        }
    }
    let is_free = |number: &usize| !anchors[*number].is_empty();
    let free: Vec<usize> = (0..wanted.len()).filter(is_free).collect();
    let named = rings.iter().zip(&names).filter_map(|(ring, name)| Some((ring, wanted[(*name)?].anchor)));
    let seconds: Vec<(usize, MmPoint)> =
        named.filter_map(|(ring, first)| Some((second(ring, first, &free, wanted, &is_seen)?, ring.at))).collect();
    // a text names one ring
    let mut taken = BTreeSet::new();
    let seconds: Vec<(usize, MmPoint)> = seconds.into_iter().filter(|(number, _)| taken.insert(*number)).collect();
    if seconds.len() >= FEWEST_WITH_TWO {
        seconds.into_iter().for_each(|(number, at)| anchors[number] = MmRect::new(at, at));
    }
    anchors
}

/// Whether a text is a word that stands level with others.
fn is_word_of_row(number: usize, wanted: &[Wanted]) -> bool {
    let middle = wanted[number].anchor.center().y;
    let is_level = |other: &&Wanted| !other.anchor.is_empty() && (other.anchor.center().y - middle).abs() <= IN_ROW;
    !scale::is_number(&wanted[number].text) && wanted.iter().filter(is_level).count() >= FEWEST_OF_ROW
}

/// The text that names a ring too, beside the one in the box `first`: both stand in its column, one above and one below
/// it, as the name and the year of an event on a time line.
fn second(
    ring: &SmallRing,
    first: MmRect,
    free: &[usize],
    wanted: &[Wanted],
    is_seen: &impl Fn(MmPoint, &SmallRing) -> bool,
) -> Option<usize> {
    let off = |place: MmRect| place.center() - ring.at;
    let is_in_column = |place: MmRect| off(place).x.abs() <= IN_COLUMN && off(place).y.abs() > ring.reach;
    if !is_in_column(first) {
        return None;
    }
    let far = |number: usize| distance_to_box(ring.at, wanted[number].anchor);
    let is_opposite = |number: &usize| {
        let Wanted { anchor, lost_leader, kept_leader, .. } = &wanted[*number];
        let is_led = lost_leader.is_some() || kept_leader.is_some();
        let is_beyond = is_in_column(*anchor) && off(*anchor).y * off(first).y < 0.0;
        !is_led && is_beyond && far(*number) <= FARTHEST_SECOND
    };
    let nearest = free.iter().copied().filter(is_opposite).min_by(|a, b| far(*a).total_cmp(&far(*b)))?;
    is_seen(wanted[nearest].anchor.center(), ring).then_some(nearest)
}

#[cfg(test)]
mod tests;
