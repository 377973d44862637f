//! No two lines nearer than fingers can part them: of two rivals the more salient stays, the other is trimmed where it
//! comes too near. Lines that truly join may meet.

use std::ops::Range;

use super::{Params, Trail, Vertex, weight};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::arc_lengths;
use crate::units::MmRect;

/// A line that comes back to itself is its own rival where the way along it is longer than the way across by this factor,
/// and by this length, mm. A corner of 30 degrees or more is none (its factor is 1 / sin 15 = 3.9).
const BEND: f32 = 4.0;
const BEND_LEAST: f32 = 2.0;
/// A line joins another if it comes this near, in join gaps.
const MEETS: f32 = 0.5;
/// ... and comes nearer by at least this share of its way (30 degrees), mm per mm; flatter is a rival, not a junction.
const STEEP: f32 = 0.5;
/// ... within this way, in clearances.
const APPROACH: f32 = 2.5;

/// Clears lines, weightiest first; the result is in that order.
pub(super) fn clear(mut trails: Vec<Trail>, area: MmRect, params: &Params) -> Vec<Trail> {
    trails.retain(|trail| trail.vertices.len() > 1);
    let mut order: Vec<(f32, usize)> = trails.iter().map(Trail::saliency).zip(0..).collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let reach = params.min_gap + params.width_max;
    let mut accepted = Nearby::new(area, reach);
    let mut cleared: Vec<Trail> = Vec::new();
    for (_, number) in order {
        let trail = stronger_half_first(trails[number].clone());
        let taken = taken(&trail, &accepted, area, params);
        let mut add = |piece: Trail, accepted: &mut Nearby| {
            if is_worth_it(&piece, params) {
                insert(accepted, &piece, cleared.len() as u32, params);
                cleared.push(piece);
            }
        };
        if !taken.contains(&true) {
            add(trail, &mut accepted);
            continue;
        }
        // One after the other, so that a later piece can join an earlier one of its own line.
        let (vertices, taken) = opened(&trail, taken);
        for range in free_ranges(&taken) {
            add(with_junctions(&vertices, range, &accepted, params), &mut accepted);
        }
    }
    cleared
}

/// A line must be the longer the weaker it is: a faint short line costs a finger more than it tells. At full strength it is
/// `min_length`, at half of it twice as much.
fn is_worth_it(piece: &Trail, params: &Params) -> bool {
    piece.weighted_length(params) >= params.min_length
}

/// Where a line comes near itself its earlier part stays; which that is must not hang on the direction it was found in.
fn stronger_half_first(trail: Trail) -> Trail {
    let half = trail.vertices.len() / 2;
    let sum = |vertices: &[Vertex]| vertices.iter().map(|v| v.strength).sum::<f32>();
    let (first, second) = (sum(&trail.vertices[..half]), sum(&trail.vertices[trail.vertices.len() - half..]));
    if second > first { trail.reversed() } else { trail }
}

fn insert(nearby: &mut Nearby, trail: &Trail, line: u32, params: &Params) {
    let arcs = arc_lengths(&trail.points());
    for (i, pair) in trail.vertices.windows(2).enumerate() {
        nearby.insert(segment(pair, i, line, arcs[i], params));
    }
}

fn segment(pair: &[Vertex], i: usize, line: u32, arc: f32, params: &Params) -> Segment {
    let width = weight::width(pair[0].strength.max(pair[1].strength), params);
    Segment { a: pair[0].at, b: pair[1].at, half_width: 0.5 * width, line, index: i as u32, arc }
}

/// For every vertex whether it comes too near to what is accepted or to an earlier part of its own trail.
fn taken(trail: &Trail, accepted: &Nearby, area: MmRect, params: &Params) -> Vec<bool> {
    let reach = params.min_gap + params.width_max;
    let arcs = arc_lengths(&trail.points());
    let total = arcs.last().copied().unwrap_or(0.0);
    let mut own = (total > BEND_LEAST).then(|| Nearby::new(area, reach));
    let mut taken: Vec<bool> = Vec::with_capacity(arcs.len());
    for (i, vertex) in trail.vertices.iter().enumerate() {
        let half = 0.5 * weight::width(vertex.strength, params);
        let near = |found: Option<(f32, _, Segment)>| {
            found.is_some_and(|(distance, _, rival)| distance < params.min_gap + half + rival.half_width)
        };
        let rival = near(accepted.nearest(vertex.at, reach, |_| true))
            || near(own.as_ref().and_then(|own| {
                own.nearest(vertex.at, reach, |segment| {
                    let apart = (arcs[i] - segment.arc).abs();
                    let apart = if trail.closed { apart.min(total - apart) } else { apart };
                    let across = nearest_on_segment(vertex.at, segment.a, segment.b).0;
                    apart > BEND * across + BEND_LEAST
                })
            }));
        if i > 0
            && !rival
            && !taken[i - 1]
            && let Some(own) = &mut own
        {
            own.insert(segment(&trail.vertices[i - 1..=i], i - 1, 0, arcs[i - 1], params));
        }
        taken.push(rival);
    }
    taken
}

/// Ranges of vertices that are not taken.
fn free_ranges(taken: &[bool]) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for i in (0..taken.len()).filter(|&i| !taken[i]) {
        match ranges.last_mut() {
            Some(range) if range.end == i => range.end = i + 1,
            _ => ranges.push(i..i + 1),
        }
    }
    ranges
}

/// A free part of a line, led on at both ends to the lines that it meets.
fn with_junctions(vertices: &[Vertex], free: Range<usize>, accepted: &Nearby, params: &Params) -> Trail {
    let before = junction(vertices[..=free.start].iter().rev(), accepted, params).unwrap_or_default();
    let after = junction(vertices[free.end - 1..].iter(), accepted, params).unwrap_or_default();
    let vertices = before.into_iter().rev().chain(vertices[free].iter().copied()).chain(after).collect();
    Trail { vertices, closed: false }
}

/// A ring with taken parts, cut open inside one of them.
fn opened(trail: &Trail, taken: Vec<bool>) -> (Vec<Vertex>, Vec<bool>) {
    if !trail.closed {
        return (trail.vertices.clone(), taken);
    }
    let ring = trail.vertices.len() - 1;
    let start = taken.iter().position(|&t| t).unwrap_or(0) % ring;
    (0..=ring).map(|k| (trail.vertices[(start + k) % ring], taken[(start + k) % ring])).unzip()
}

/// If a line, going on from its last free vertex (the first of `on`), soon meets an accepted line at a steep angle: the
/// vertices up to the meeting, which is the last.
fn junction<'a>(mut on: impl Iterator<Item = &'a Vertex>, accepted: &Nearby, params: &Params) -> Option<Vec<Vertex>> {
    let reach = params.min_gap + params.width_max;
    let first = on.next()?;
    let (start, ..) = accepted.nearest(first.at, 2.0 * reach, |_| true)?;
    let mut way = 0.0;
    let mut last = first;
    let mut path = Vec::new();
    // the nearest approach so far: distance, where on the other line, how many vertices of the path, way
    let mut best = (start, None, 0, 0.0);
    for vertex in on {
        way += (vertex.at - last.at).length();
        if way > APPROACH * reach {
            break;
        }
        path.push(*vertex);
        last = vertex;
        let Some((distance, at, _)) = accepted.nearest(vertex.at, reach, |_| true) else { continue };
        if distance < best.0 {
            best = (distance, Some(at), path.len(), way);
            if distance <= 0.5 * params.width_max {
                break; // they touch; going on would run beside or across the other line
            }
        } else if best.0 <= MEETS * params.join_gap {
            break; // it was near enough, and leads away again
        }
    }
    let (distance, at, count, way) = best;
    let at = at?;
    if distance > MEETS * params.join_gap || start - distance < STEEP * way {
        return None;
    }
    path.truncate(count);
    let tip = *path.last()?;
    path.push(Vertex { at, ..tip });
    Some(path)
}
