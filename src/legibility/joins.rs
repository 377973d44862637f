//! Where lines join: one ends on another, or they cross. Beside a join two lines may be near one another.

use std::collections::{BTreeMap, HashMap};

use super::limits::LAST_DIGIT;
use super::paths::{Path, PathKind, Paths, may_be_near, nearest};
use crate::geom::crossing;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::walk::arc_between;
use crate::units::MmPoint;

/// Where a line joins another it must have come from beyond the clearance within this length, in clearances: at 19.5
/// degrees or steeper, as the lines of drawings do.
pub(crate) const APPROACH: f32 = 3.0;
/// The same of two lines that join a third one at nearly one place: at 36 degrees or steeper.
pub(crate) const CLUSTER_APPROACH: f32 = 1.7;
/// A line that comes back to itself within this length is bent, not joined, mm.
pub(crate) const BEND_LEAST: f32 = 2.0;
/// Lines cross in a vertex of both if it is on both within this, mm: each is rounded to the
/// nearest number.
const VERTEX: f32 = 0.5 * LAST_DIGIT;
/// Two joins with one line are one where they are nearer along a path, mm.
const SAME_JOIN: f32 = 4.0 * VERTEX;
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
    /// How far along that, mm.
    there: f32,
    /// The line of that: it is joined as a whole.
    line: usize,
    /// Of a join by a third path: how far the two joins with that are apart along it, mm.
    by_third: Option<f32>,
}

impl Join {
    /// Of a place of a path with one of another, both with how far along them, mm.
    fn of(arc: f32, (other, there): (u32, f32), paths: &Paths) -> Self {
        Self { arc, other, there, line: paths.paths[other as usize].line, by_third: None }
    }

    /// How far from here along the path the two may be near, mm.
    fn reach(&self, clearance: f32) -> f32 {
        self.by_third.map_or(APPROACH * clearance, |apart| CLUSTER_APPROACH * clearance - apart)
    }
}

/// The joins of every path, by the lines that they join and along it. A line ends on another where their ink touches,
/// or is no farther apart than `touch` mm. Two lines that cross again before they have been apart only wind round one
/// another: these are no joins.
pub(super) fn joins(paths: &Paths, index: &Nearby, least: f32, touch: f32) -> Vec<Vec<Join>> {
    let widest = paths.widest();
    let mut found: Vec<Vec<Join>> =
        (0..paths.paths.len()).map(|path| joins_of(path, paths, index, (widest, touch))).collect();
    add_meetings_in_rings(&mut found, paths, least);
    // of a line of dots the last two dots may both touch another line: it ends there, and does not wind round it
    let apart = touch.max(1.0);
    for (number, list) in found.iter_mut().enumerate() {
        keep_straight(number, list, apart, |stretch, other| follows(paths, number, stretch, other, index, least));
    }
    add_corners(&mut found, paths, index);
    add_contacts(&mut found, paths, index, least);
    add_clusters(&mut found, paths, least + 2.0 * widest);
    for list in &mut found {
        list.sort_by(|a, b| a.line.cmp(&b.line).then(a.arc.total_cmp(&b.arc)));
    }
    found
}

/// Takes out the joins of a path from which it winds round the other line: up to the next join with that line which is
/// more than `apart` mm away, on either side, it follows that. What follows it farther follows it so far.
fn keep_straight(number: usize, list: &mut Vec<Join>, apart: f32, follows: impl Fn((f32, f32), u32) -> bool) {
    list.sort_by(|a, b| a.other.cmp(&b.other).then(a.arc.total_cmp(&b.arc)));
    let mut kept = Vec::with_capacity(list.len());
    for of_other in list.chunk_by(|a, b| a.other == b.other) {
        let winds = |join: &&Join| {
            let before = of_other.partition_point(|other| join.arc - other.arc > apart);
            let behind = of_other.partition_point(|other| other.arc - join.arc <= apart);
            let neighbours = [before.checked_sub(1), Some(behind)].into_iter().flatten();
            join.other as usize != number
                && neighbours.filter_map(|at| of_other.get(at)).any(|other| {
                    let stretch = (join.arc.min(other.arc), join.arc.max(other.arc));
                    follows(stretch, join.other)
                })
        };
        kept.extend(of_other.iter().filter(|join| !winds(join)).copied());
    }
    *list = kept;
}

/// Where one path ends on others, or on itself, and where it crosses them; each place once.
fn joins_of(number: usize, paths: &Paths, index: &Nearby, (widest, touch): (f32, f32)) -> Vec<Join> {
    let mut found: Vec<Join> = Vec::new();
    let path = &paths.paths[number];
    // where along it each other is joined, in stretches of [`SAME_JOIN`]
    let mut known: HashMap<(u32, i64), Vec<f32>> = HashMap::new();
    let mut add = |arc: f32, other: u32, there: f32| {
        let is_bent = other as usize == number && path.between(arc, there) <= BEND_LEAST;
        let stretch = (arc / SAME_JOIN).floor() as i64;
        let near = (stretch - 1..=stretch + 1).filter_map(|of| known.get(&(other, of))).flatten();
        if !is_bent && !near.into_iter().any(|at| (at - arc).abs() < SAME_JOIN) {
            known.entry((other, stretch)).or_default().push(arc);
            found.push(Join::of(arc, (other, there), paths));
        }
    };
    // an end first: where it also crosses, by a rounding, it is an end all the same; rows of dots also join where one
    // has a corner, as they have lost the dot that both would have there
    let tips = paths.tips(number).into_iter().map(|(own, tip, arc)| (own, tip, arc, true));
    let own = if touch > 0.0 { paths.segments_of(number) } else { &[] };
    let corners = own.iter().filter(|segment| paths.turns(number, segment.arc, touch));
    let corners = corners.map(|segment| (*segment, segment.a, segment.arc, false));
    for (own, at, arc, is_tip) in tips.chain(corners) {
        // with each other line at its nearest place: in which order its segments come depends on all other lines
        let mut nearest_of: BTreeMap<u32, (f32, f32)> = BTreeMap::new();
        index.around(at, at, own.half_width + widest + touch, |other| {
            let (distance, _, there) = nearest(other, at);
            let is_other = other.line as usize != number;
            let may_join = is_other || is_tip && path.between(arc, there) > BEND_LEAST;
            if may_join && distance <= own.half_width + other.half_width + touch {
                let known = nearest_of.entry(other.line).or_insert((distance, there));
                if (distance, there) < *known {
                    *known = (distance, there);
                }
            }
        });
        nearest_of.into_iter().for_each(|(other, (_, there))| add(arc, other, there));
    }
    for segment in paths.segments_of(number) {
        index.around(segment.a.min(segment.b), segment.a.max(segment.b), 0.0, |other| {
            if !may_be_near(segment, other, 0.0) {
                return;
            }
            // in a vertex of both, too
            if let Some(at) = crossing(longer(segment), longer(other)) {
                add(segment.arc + (at - segment.a).length(), other.line, nearest(other, at).2);
            }
        });
    }
    found
}

/// The corners of rings that stand on other lines, whichever way these go on there.
fn add_corners(joins: &mut [Vec<Join>], paths: &Paths, index: &Nearby) {
    let widest = paths.widest();
    for (number, found) in joins.iter_mut().enumerate() {
        for (own, corner, arc) in paths.corners_of_ring(number) {
            index.around(corner, corner, own.half_width + widest, |other| {
                let (distance, _, there) = nearest(other, corner);
                if other.line as usize != number && distance <= own.half_width + other.half_width {
                    found.push(Join::of(arc, (other.line, there), paths));
                }
            });
        }
    }
}

/// Where rings touch other lines without crossing them, as a wheel stands on the road: their ink overlaps there, and on
/// both sides of that place the ring is apart before long.
fn add_contacts(joins: &mut [Vec<Join>], paths: &Paths, index: &Nearby, least: f32) {
    let widest = paths.widest();
    for (number, found) in joins.iter_mut().enumerate() {
        let Path { closed, kind, length, .. } = paths.paths[number];
        if !closed || kind != PathKind::Stroke {
            continue;
        }
        let mut nearest_of: BTreeMap<u32, (f32, f32, f32)> = BTreeMap::new();
        for own in paths.segments_of(number) {
            index.around(own.a, own.a, own.half_width + widest, |other| {
                let (distance, _, there) = nearest(other, own.a);
                let touches =
                    other.line as usize != number && distance <= own.half_width + other.half_width - LAST_DIGIT;
                if touches && nearest_of.get(&other.line).is_none_or(|(known, ..)| distance < *known) {
                    nearest_of.insert(other.line, (distance, own.arc, there));
                }
            });
        }
        let half = paths.segments_of(number).first().map_or(0.0, |segment| segment.half_width);
        let reach = least + half;
        let leaves = |arc: f32, other: u32, way: f32| {
            let steps = (APPROACH * (reach + half) / STEP) as u32;
            let place = |k: u32| paths.at(number, (arc + way * STEP * k as f32).rem_euclid(length));
            (1..=steps).filter_map(place).any(|at| {
                let near = index.nearest_of_line(at, reach + widest, other);
                near.is_none_or(|(distance, _, segment)| distance >= reach + segment.half_width)
            })
        };
        for (other, (_, arc, there)) in nearest_of {
            let is_known = found.iter().any(|join| join.other == other);
            if !is_known && leaves(arc, other, 1.0) && leaves(arc, other, -1.0) {
                found.push(Join::of(arc, (other, there), paths));
            }
        }
    }
}

/// A path that ends on another no farther than two lines may be apart from where a third one joins that, and does not
/// run beside the third, joins it as well: fingers feel one meeting of all three.
fn add_clusters(joins: &mut [Vec<Join>], paths: &Paths, spacing: f32) {
    // of every path: where along it which other is joined, and where along that, whichever of the two ends there
    let mut meetings: Vec<Vec<(f32, usize, f32)>> = vec![Vec::new(); paths.paths.len()];
    for (number, own) in joins.iter().enumerate() {
        for join in own {
            meetings[number].push((join.arc, join.other as usize, join.there));
            meetings[join.other as usize].push((join.there, number, join.arc));
        }
    }
    let ends = |number: usize, arc: f32| {
        let path = &paths.paths[number];
        !path.closed && (arc <= VERTEX || arc >= path.length - VERTEX)
    };
    let leaves = |number: usize, arc: f32, step: f32| {
        let path = &paths.paths[number];
        let to = arc + step;
        let to = if path.closed { to.rem_euclid(path.length) } else { to.clamp(0.0, path.length) };
        (paths.at(number, to)? - paths.at(number, arc)?).try_normalize()
    };
    let is_apart = |one: (usize, f32), other: (usize, f32)| {
        let both = |(number, arc): (usize, f32)| [spacing, -spacing].map(|step| leaves(number, arc, step));
        let others = both(other);
        both(one).iter().flatten().all(|way| others.iter().flatten().all(|with| way.dot(*with) <= APART))
    };
    for (third, of_third) in meetings.iter().enumerate() {
        for &(here, number, arc) in of_third.iter().filter(|(_, number, arc)| ends(*number, *arc)) {
            let near =
                of_third.iter().map(|(there, other, at)| (paths.paths[third].between(here, *there), *other, *at));
            let near = near.filter(|(apart, other, _)| *other != number && *apart <= spacing);
            let others = near.filter(|(_, other, there)| is_apart((number, arc), (*other, *there)));
            joins[number].extend(others.map(|(apart, other, there)| {
                let join = Join::of(arc, (other as u32, there), paths);
                Join { by_third: Some(apart), ..join }
            }));
        }
    }
}

/// The greatest cosine of two directions that are not those of lines beside one another (30 degrees; lines are drawn so
/// from 36 on).
pub(crate) const APART: f32 = 0.866;

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
            let others = of_ring.iter().map(|(_, other, there)| (*other, *there)).filter(|other| other.0 != number);
            joins[number].extend(others.map(|(other, there)| Join::of(arc, (other as u32, there), paths)));
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
    let near = |at: MmPoint| index.is_near_line(at, least, other);
    let steps = ((to - from) / STEP).ceil().max(1.0) as u32;
    let place_at = |k: u32| paths.at(path, from + (to - from) * k as f32 / steps as f32);
    (1..steps).filter_map(place_at).all(near)
}

/// The joins with `line` that may reach a part of a path, each with how far it is moved for that: of a ring, a join
/// near the beginning is near the end as well. `joins` are sorted, as [`joins`] gives them.
fn joins_around(
    joins: &[Join],
    ring_length: Option<f32>,
    (from, to): (f32, f32),
    line: usize,
    clearance: f32,
) -> impl Iterator<Item = (&Join, f32)> {
    let farthest = APPROACH * clearance + VERTEX;
    let rounds = ring_length.map_or([Some(0.0), None, None], |length| [Some(-length), Some(0.0), Some(length)]);
    rounds.into_iter().flatten().flat_map(move |round| {
        let (low, high) = (from - farthest - round, to + farthest - round);
        let first = joins.partition_point(|join| join.line < line || join.line == line && join.arc < low);
        let near = joins[first..].iter().take_while(move |join| join.line == line && join.arc <= high);
        near.map(move |join| (join, round))
    })
}

/// Whether a place of a path is on the stretch to a join with `line`.
pub(super) fn arrives(joins: &[Join], ring_length: Option<f32>, arc: f32, line: usize, clearance: f32) -> bool {
    joins_around(joins, ring_length, (arc, arc), line, clearance)
        .any(|(join, _)| arc_between(join.arc, arc, ring_length) <= join.reach(clearance))
}

/// The parts of a segment, as places along its path, that are not on the stretch to a join with `line`.
pub(super) fn free_parts(
    joins: &[Join],
    ring_length: Option<f32>,
    segment: &Segment,
    line: usize,
    clearance: f32,
) -> Vec<(f32, f32)> {
    let whole = (segment.arc, segment.arc + (segment.b - segment.a).length());
    let joined = joins.binary_search_by_key(&line, |join| join.line).is_ok();
    // of a dot on its own that joins there is no part
    let mut parts = if joined && whole.1 <= whole.0 { Vec::new() } else { vec![whole] };
    for (join, round) in joins_around(joins, ring_length, whole, line, clearance) {
        let limit = join.reach(clearance);
        let (low, high) = (join.arc + round - limit, join.arc + round + limit);
        let cut = parts.into_iter().flat_map(|(from, to)| [(from, to.min(low)), (from.max(high), to)]);
        parts = cut.filter(|(from, to)| to > from).collect();
        if parts.is_empty() {
            break;
        }
    }
    parts
}

#[cfg(test)]
mod tests;
