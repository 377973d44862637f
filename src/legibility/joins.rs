//! Where lines join: one ends on another, or they cross. Beside a join two lines may be near one another.

use super::paths::{Paths, may_be_near, nearest, point_at};
use crate::geom::crossing;
use crate::geom::nearby::{Nearby, Segment};
use crate::units::MmPoint;

/// Where a line joins another it must have come from beyond the clearance within this length, in clearances: at 19.5
/// degrees or steeper, as the lines of drawings do.
pub(crate) const APPROACH: f32 = 3.0;
/// A line that comes back to itself within this length is bent, not joined, mm.
pub(crate) const BEND_LEAST: f32 = 2.0;
/// Lines cross in a vertex of both if it is on both within this, mm: a page has hundredths.
const VERTEX: f32 = 0.005;
/// The largest ring that stands for a point of a drawing, across in distances of two lines.
pub(crate) const SMALL_RING: f32 = 2.5;
/// Lines that cross twice are looked at this often between the crossings, mm.
const STEP: f32 = 0.5;

/// A place of a path where it joins another, or itself.
#[derive(Debug, Clone, Copy)]
pub(super) struct Join {
    arc: f32,
    /// The path that it joins.
    other: u32,
    /// The line of that: it is joined as a whole.
    line: usize,
}

/// The joins of every path. A line ends on another where their ink touches, or is no farther apart than `touch` mm. Two
/// lines that cross again before they have been apart only wind round one another: these are no joins.
pub(super) fn joins(paths: &Paths, index: &Nearby, least: f32, touch: f32) -> Vec<Vec<Join>> {
    let widest = paths.widest();
    let of = |number: usize| {
        let mut found: Vec<Join> = Vec::new();
        let path = &paths.paths[number];
        let mut add = |arc: f32, there: f32, other: u32| {
            let bent = other as usize == number && path.between(arc, there) <= BEND_LEAST;
            if !bent && !found.iter().any(|join| join.other == other && (join.arc - arc).abs() < 4.0 * VERTEX) {
                found.push(Join { arc, other, line: paths.paths[other as usize].line });
            }
        };
        for segment in paths.segments_of(number) {
            index.around(segment.a.min(segment.b), segment.a.max(segment.b), 0.0, |other| {
                if !may_be_near(segment, other, 0.0) {
                    return;
                }
                // in a vertex of both, too
                if let Some(at) = crossing(longer(segment), longer(other)) {
                    add(segment.arc + (at - segment.a).length(), nearest(other, at).2, other.line);
                }
            });
        }
        for (own, tip, arc) in paths.tips(number) {
            index.around(tip, tip, own.half_width + widest + touch, |other| {
                let (distance, _, there) = nearest(other, tip);
                if distance <= own.half_width + other.half_width + touch {
                    add(arc, there, other.line);
                }
            });
        }
        found
    };
    let mut found: Vec<Vec<Join>> = (0..paths.paths.len()).map(of).collect();
    add_meetings_in_rings(&mut found, paths, least);
    // two dots beside a line both touch it: they end on it, and do not wind round it
    let winds = |number: usize, join: &Join| {
        join.other as usize != number
            && found[number].iter().any(|other| {
                let (from, to) = (join.arc.min(other.arc), join.arc.max(other.arc));
                other.other == join.other
                    && to - from > touch.max(1.0)
                    && follows(paths, number, (from, to), join.other, index, least)
            })
    };
    let kept = |(number, list): (usize, &Vec<Join>)| list.iter().filter(|join| !winds(number, join)).copied().collect();
    found.iter().enumerate().map(kept).collect()
}

/// Lines that end on one small ring, as the roads at a town, meet in it as they would in its middle.
fn add_meetings_in_rings(joins: &mut [Vec<Join>], paths: &Paths, least: f32) {
    let is_small = |ring: usize| {
        let half_width = paths.segments_of(ring).first().map_or(0.0, |segment| segment.half_width);
        paths.paths[ring].closed
            && paths.paths[ring].length <= SMALL_RING * std::f32::consts::PI * (least + 2.0 * half_width)
    };
    let mut ends: Vec<(u32, usize, f32)> = Vec::new();
    for (number, (path, own)) in paths.paths.iter().zip(joins.iter()).enumerate() {
        let is_end = |join: &&Join| join.arc <= VERTEX || join.arc >= path.length - VERTEX;
        let on_rings = own.iter().filter(is_end).filter(|join| !path.closed && is_small(join.other as usize));
        ends.extend(on_rings.map(|join| (join.other, number, join.arc)));
    }
    ends.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
    for of_ring in ends.chunk_by(|a, b| a.0 == b.0) {
        for &(_, number, arc) in of_ring {
            let others = of_ring.iter().map(|(_, other, _)| *other).filter(|other| *other != number);
            joins[number].extend(others.map(|other| Join { arc, other: other as u32, line: paths.paths[other].line }));
        }
    }
}

/// The ends of a segment that is longer by [`VERTEX`] at both.
fn longer(segment: &Segment) -> (MmPoint, MmPoint) {
    let over = (segment.b - segment.a).try_normalize().unwrap_or_default() * VERTEX;
    (segment.a - over, segment.b + over)
}

/// Whether a path stays within the least blank of another between two of its places.
fn follows(paths: &Paths, path: usize, (from, to): (f32, f32), other: u32, index: &Nearby, least: f32) -> bool {
    let segments = paths.segments_of(path);
    let place = |arc: f32| {
        let at = segments.partition_point(|segment| segment.arc <= arc).saturating_sub(1);
        segments.get(at).map(|segment| point_at(segment, arc))
    };
    let near = |at: MmPoint| index.nearest(at, least, |segment| segment.line == other).is_some();
    let steps = ((to - from) / STEP).ceil().max(1.0) as u32;
    (1..steps).filter_map(|k| place(from + (to - from) * k as f32 / steps as f32)).all(near)
}

/// Whether a place of a path is on the stretch to a join with `line`.
pub(super) fn arrives(joins: &[Join], length: Option<f32>, arc: f32, line: usize, clearance: f32) -> bool {
    let apart = |join: &Join| {
        let apart = (join.arc - arc).abs();
        length.map_or(apart, |length| apart.min(length - apart))
    };
    joins.iter().any(|join| join.line == line && apart(join) <= APPROACH * clearance)
}

/// The parts of a segment, as places along its path, that are not on the stretch to a join with `line`.
pub(super) fn free_parts(
    joins: &[Join],
    length: Option<f32>,
    segment: &Segment,
    line: usize,
    clearance: f32,
) -> Vec<(f32, f32)> {
    let whole = (segment.arc, segment.arc + (segment.b - segment.a).length());
    let mut parts = vec![whole];
    let limit = APPROACH * clearance;
    // of a ring, a join near the beginning is near the end as well
    let rounds = length.map_or(vec![0.0], |length| vec![-length, 0.0, length]);
    let mut joined = false;
    for join in joins.iter().filter(|join| join.line == line) {
        joined = true;
        for round in &rounds {
            let (low, high) = (join.arc + round - limit, join.arc + round + limit);
            parts = parts
                .into_iter()
                .flat_map(|(from, to)| [(from, to.min(low)), (from.max(high), to)])
                .filter(|(from, to)| to > from)
                .collect();
        }
    }
    // of a dot on its own there is no part
    if joined { parts } else { vec![whole] }
}
