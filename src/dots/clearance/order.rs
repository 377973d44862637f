//! In which order lines take their dots: the strongest first, but a line on which others end before them, such as an
//! axis before the bars that stand on it, or a stem before leaves whose tips touch it. They end on it whenever it is
//! drawn; were they first, it would have to keep the gap from their ends, and be interrupted there.

use crate::dots::params::polyline_of;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::{CORNER, HIGHEST_STACK, Line, TOUCH};
use crate::units::{MmPoint, MmRect};

/// The numbers of the lines of a part of the sheet, the strongest given first, in this order. Ends that meet other ends
/// within `corner` mm are corners, and change nothing. Weak lines, such as those of a grid on which the corners of a
/// shape lie, go before no stronger ones.
pub(super) fn order(lines: &[Line], weak: &[bool], part: MmRect, corner: f32) -> Vec<usize> {
    let mut on_bases = lines_on_bases(lines, part, corner);
    on_bases.retain(|&(stem, base)| weak[stem] || !weak[base]);
    // the place of each line, and how many stand above one another on it there
    let mut places: Vec<(usize, usize)> = (0..lines.len()).map(|number| (number, 0)).collect();
    for _ in 0..HIGHEST_STACK {
        let before = places.clone();
        for &(stem, base) in &on_bases {
            let (place, above) = before[stem];
            if (place, HIGHEST_STACK - above) <= (places[base].0, HIGHEST_STACK - places[base].1) {
                places[base] = (place, above + 1);
            }
        }
        if places == before {
            break;
        }
    }
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by_key(|&number| (places[number].0, HIGHEST_STACK.saturating_sub(places[number].1), number));
    order
}

/// Which lines end on which others.
fn lines_on_bases(lines: &[Line], part: MmRect, corner: f32) -> Vec<(usize, usize)> {
    let polylines: Vec<_> = lines.iter().map(polyline_of).collect();
    let mut segments = Nearby::new(part, corner.max(1.0));
    for (line, polyline) in (0..).zip(&polylines) {
        for ((index, (a, b)), arc) in (0..).zip(polyline.segments()).zip(polyline.arc_lengths()) {
            segments.insert(Segment { a: *a, b: *b, half_width: 0.0, line, index, arc });
        }
    }
    let is_between = |segment: &Segment, arc: f32| {
        let base = &polylines[segment.line as usize];
        base.closed || (corner..base.length() - corner).contains(&arc)
    };
    let tips_of = |(stem, polyline)| tips(polyline).into_iter().map(move |at| (stem, at));
    segments.which_end_on(polylines.iter().enumerate().flat_map(tips_of), TOUCH, is_between)
}

/// Where a line may stand on others: at its ends, or at the corners of a ring. The line is simplified by now, so that
/// it turns at one vertex where it turns at all; before that `corners_of_ring` of `lines/vertex` looks along two arms,
/// and so does that of `legibility/paths`, as a person may have drawn the page.
fn tips(line: &Polyline<MmPoint>) -> Vec<MmPoint> {
    if !line.closed {
        return [line.vertices.first(), line.vertices.last()].into_iter().flatten().copied().collect();
    }
    let turns = |i: &usize| {
        let [before, at, after] = [-1, 0, 1].map(|step| line.view().next(*i, step).map(|i| line.vertices[i]));
        let cosine = |before: MmPoint, at: MmPoint, after: MmPoint| {
            let [to, from] = [at - before, after - at].map(|way| way.try_normalize().unwrap_or_default());
            to.dot(from)
        };
        before.zip(at).zip(after).is_some_and(|((before, at), after)| cosine(before, at, after) <= CORNER)
    };
    (0..line.vertices.len()).filter(turns).map(|i| line.vertices[i]).collect()
}

#[cfg(test)]
mod tests;
