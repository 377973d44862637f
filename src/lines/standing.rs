//! Ends of lines that stand on other lines, and two such lines with a gap between them: the plates of a capacitor at
//! the ends of its wires. The gap is what the symbol says, so that it is never closed, and made wide enough for
//! fingers.

use super::faint::is_faint;
use super::lead_on::heading;
use super::params::{HEADING, Params};
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::{Index, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::units::{Mm, MmPoint, MmRect, MmVector};

/// An end this near to another line stands on it, mm.
const TOUCHES: f32 = 0.05;
/// It does if that goes on for this much on both sides, mm: else the two meet at a corner.
const GOES_ON: f32 = 2.0;
/// Plates are no longer than so many least lengths of lines: longer ones are lines by themselves.
const LONGEST: f32 = 3.0;
/// Wires lead straight towards one another (the cosine).
const TOWARDS: f32 = 0.9;
/// A plate is moved by at most this, mm: that there are two says more than where exactly they lie. Chosen by us: on a
/// grid of 2 mm a gap of one is made wide enough.
const FARTHEST: f32 = 3.0;
/// More than two lines have to be apart, mm, so that they need not be moved again.
const MORE: f32 = 0.05;
/// An end is on one side of the line on which it stands if it leads there at 9 degrees at least (the sine): a flatter
/// one may have come along that line.
const ASIDE: f32 = 0.15;

/// An end of a line that stands on another.
#[derive(Debug, Clone, Copy)]
struct Standing {
    line: usize,
    which: Tip,
    at: MmPoint,
    /// The number of the line on which it stands.
    base: u32,
    /// The direction of that.
    along: MmVector,
    /// Whether that is thin and pale.
    is_faint: bool,
}

/// The ends of lines that stand on others, by place; none in a photograph.
#[derive(Debug, Default)]
pub(super) struct StandingEnds {
    ends: Vec<Standing>,
    by_place: Option<Index<usize, Mm>>,
    /// Length of the shortest line, mm.
    pub(super) least: f32,
}

impl StandingEnds {
    /// Those of the lines of a drawing, of which plates are moved apart.
    pub(super) fn of(polylines: &mut [Polyline<Vertex>], area: MmRect, params: &Params) -> Self {
        if !params.of_drawing {
            return Self::default();
        }
        let mut ends = standing(polylines, area, params);
        part_plates(polylines, &mut ends, area, params);
        let by_place = (!ends.is_empty()).then(|| by_place(&ends, 0..ends.len(), area, params));
        Self { ends, by_place, least: params.min_length }
    }

    /// The number of the line on which an end stands that is no farther than `reach` from a place, if one does: the
    /// lines are those among which the ends were found.
    pub(super) fn base(&self, at: MmPoint, reach: f32) -> Option<u32> {
        self.first(at, reach).map(|end| end.base)
    }

    /// Whether both of two ends stand on one line, and on the same side of it, as the strokes of a fan that lead from
    /// one box to the next ones. Each is given as its place and the direction in which it leaves its own line. A thin,
    /// pale line does not count: a curve may touch a gridline.
    pub(super) fn are_on_one_side(&self, ends: [(MmPoint, MmVector); 2], reach: f32) -> bool {
        let side = |(at, direction): (MmPoint, MmVector)| {
            let end = self.first(at, reach).filter(|end| !end.is_faint)?;
            let sine = end.along.cross(direction);
            (sine.abs() >= ASIDE).then_some((end.base, sine > 0.0))
        };
        let [one, other] = ends.map(side);
        one.is_some() && one == other
    }

    /// The first of the ends that are no farther than `reach` from a place.
    fn first(&self, at: MmPoint, reach: f32) -> Option<&Standing> {
        let mut first: Option<usize> = None;
        self.by_place.as_ref()?.around(at, at, reach, |&number| {
            if (self.ends[number].at - at).length() <= reach {
                first = Some(first.map_or(number, |first| first.min(number)));
            }
        });
        first.map(|number| &self.ends[number])
    }
}

/// Those ends whose numbers are given, by place.
fn by_place(
    ends: &[Standing],
    numbers: impl IntoIterator<Item = usize>,
    area: MmRect,
    params: &Params,
) -> Index<usize, Mm> {
    let mut index = Index::new(area, params.max_spacing());
    numbers.into_iter().for_each(|number| index.put_at(ends[number].at, number));
    index
}

/// The ends of lines that stand on others.
fn standing(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Standing> {
    let lines = nearby(polylines.iter(), area, params);
    let lengths: Vec<f32> = polylines.iter().map(Polyline::length).collect();
    let ends = polylines.iter().enumerate().filter(|(_, line)| !line.closed);
    let ends = ends.flat_map(|(line, polyline)| Tip::BOTH.map(|which| (line, which, which.of(polyline))));
    let stands = |(line, which, end): (usize, Tip, Option<&Vertex>)| {
        let at = end?.at;
        let goes_on = |segment: &Segment| {
            let base = segment.line as usize;
            let arc = segment.arc + (nearest_on_segment(at, segment.a, segment.b).1 - segment.a).length();
            base != line && (polylines[base].closed || (GOES_ON..lengths[base] - GOES_ON).contains(&arc))
        };
        let (_, _, segment) = lines.nearest(at, TOUCHES, goes_on)?;
        let base = segment.line;
        let along = (segment.b - segment.a).try_normalize().unwrap_or_default();
        Some(Standing { line, which, at, base, along, is_faint: is_faint(&polylines[base as usize]) })
    };
    ends.filter_map(stands).collect()
}

/// Moves two short lines on which the ends of others stand that lead towards one another apart, with these ends, so
/// that there is room for both.
fn part_plates(polylines: &mut [Polyline<Vertex>], ends: &mut [Standing], area: MmRect, params: &Params) {
    let spacing = params.max_clearance() + MORE;
    let mut count_on = vec![0_usize; polylines.len()];
    ends.iter().for_each(|end| count_on[end.base as usize] += 1);
    let is_plate = |of: &usize| {
        let base = ends[*of].base as usize;
        let plate = &polylines[base];
        count_on[base] == 1 && !plate.closed && plate.length() <= LONGEST * params.min_length
    };
    let plates: Vec<usize> = (0..ends.len()).filter(is_plate).collect();
    if plates.len() < 2 {
        return;
    }
    let index = by_place(ends, plates.iter().copied(), area, params);
    for first in plates {
        // both may have been moved already
        let (at, reach, mut near) = (ends[first].at, spacing + 2.0 * FARTHEST, Vec::new());
        index.around(at, at, reach, |&second| near.extend((second > first).then_some(second)));
        near.sort_unstable();
        for second in near {
            part(first, second, polylines, ends, spacing, params);
        }
    }
}

/// Moves the plates of two ends apart if the ends face one another and are nearer than `spacing`.
fn part(
    first: usize,
    second: usize,
    polylines: &mut [Polyline<Vertex>],
    ends: &mut [Standing],
    spacing: f32,
    params: &Params,
) {
    let [a, b] = [ends[first], ends[second]];
    let gap = b.at - a.at;
    let shift = 0.5 * (spacing - gap.length());
    let Some(ahead) = gap.try_normalize() else { return };
    // a circuit drawn in one go has both ends of one wire at its battery
    let shortened_by = if a.line == b.line { 2.0 * shift } else { shift };
    let leads = |of: &Standing, sign: f32| {
        let wire = &polylines[of.line];
        heading(wire, of.which, HEADING).is_some_and(|way| sign * way.dot(ahead) >= TOWARDS)
            && wire.length() - shortened_by >= params.min_length
    };
    if !(0.0..=FARTHEST).contains(&shift) || !leads(&a, 1.0) || !leads(&b, -1.0) {
        return;
    }
    for (of, step) in [(first, ahead * -shift), (second, ahead * shift)] {
        let end = &mut ends[of];
        let Standing { line, which, base, .. } = *end;
        polylines[line] = polylines[line].shortened(which, shift);
        polylines[base as usize].vertices.iter_mut().for_each(|vertex| vertex.at += step);
        end.at += step;
        // the wire may lead there at a small angle
        if let Some(tip) = which.of_mut(&mut polylines[line]) {
            tip.at = end.at;
        }
    }
}

#[cfg(test)]
mod tests;
