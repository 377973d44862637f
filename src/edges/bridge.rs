//! Ends that belong together are joined: over weak spots of a contour, and round corners so sharp that the gradient
//! loses its direction there.

use super::path::{Mark, Path};
use crate::units::{PxPoint, PxVector};

/// Ends that point at one another are joined over this many scales.
const FAR: f32 = 6.0;
/// ... if the cosine between each one's heading and the way across is at least this (37 degrees),
const AHEAD: f32 = 0.8;
/// Other ends, as at a corner, over this many scales if both edges have the same colours on the same sides,
const NEAR: f32 = 3.2;
/// ... and neither end has the other behind it: least cosine between its heading and the way across.
const BESIDE: f32 = -0.35;
/// ... unless they just ran past one another at a sharp corner, by no more than this many scales.
const PAST: f32 = 1.3;
/// Ends nearer than this are one place whatever their headings, px.
const TOUCHING: f32 = 0.8;
/// A path whose own ends are joined is at least this many times as long as the gap.
const RING: f32 = 3.0;
/// The heading of an end is taken over this many scales.
const HEADING: f32 = 3.0;

struct End {
    path: usize,
    at_start: bool,
    at: PxPoint,
    heading: PxVector,
    /// Colour step as seen when leaving the path through this end.
    step: [f32; 3],
}

/// Joins open paths end to end and closes those whose own ends meet. `scale` is the sigma of the derivative, px.
pub(super) fn join(paths: Vec<Path>, scale: f32) -> Vec<Path> {
    let ends = ends(&paths, scale);
    let lengths: Vec<f32> = paths.iter().map(Path::length).collect();
    let mut by_x: Vec<usize> = (0..ends.len()).collect();
    by_x.sort_by(|&a, &b| ends[a].at.x.total_cmp(&ends[b].at.x).then(a.cmp(&b)));
    let mut joints = Vec::new();
    for (k, &i) in by_x.iter().enumerate() {
        for &j in by_x[k + 1..].iter().take_while(|&&j| ends[j].at.x - ends[i].at.x <= FAR * scale) {
            let (i, j) = (i.min(j), i.max(j));
            if let Some(cost) = cost(&ends[i], &ends[j], &lengths, scale) {
                joints.push((cost, i, j));
            }
        }
    }
    joints.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut partner = vec![None; ends.len()];
    for (_, i, j) in joints {
        if partner[i].is_none() && partner[j].is_none() {
            (partner[i], partner[j]) = (Some(j), Some(i));
        }
    }
    thread(paths, &ends, &partner)
}

fn ends(paths: &[Path], scale: f32) -> Vec<End> {
    let mut ends = Vec::new();
    for (number, path) in paths.iter().enumerate().filter(|(_, path)| !path.closed && path.marks.len() > 2) {
        for at_start in [true, false] {
            let tip = if at_start { 0 } else { path.marks.len() - 1 };
            let inner = path.walk(tip, at_start).take_while(|(_, way)| *way <= HEADING * scale).last();
            let mark = &path.marks[tip];
            let heading = inner.and_then(|(inner, _)| (mark.at - path.marks[inner].at).try_normalize());
            let step = if at_start { mark.step.map(|v| -v) } else { mark.step };
            ends.push(End { path: number, at_start, at: mark.at, heading: heading.unwrap_or_default(), step });
        }
    }
    ends
}

/// How far two ends are from being one contour, if they can be.
fn cost(a: &End, b: &End, lengths: &[f32], scale: f32) -> Option<f32> {
    let way = b.at - a.at;
    let distance = way.length();
    if distance > FAR * scale || (a.path == b.path && lengths[a.path] < RING * distance + 2.0 * scale) {
        return None;
    }
    if distance < TOUCHING {
        return Some(distance);
    }
    let way = way / distance;
    let (ahead_a, ahead_b) = (a.heading.dot(way), -b.heading.dot(way));
    let cost = distance * (3.0 - ahead_a - ahead_b);
    if ahead_a.min(ahead_b) >= AHEAD {
        return Some(cost);
    }
    // Leaving through one end enters through the other, where right and left change places.
    let same_sides = a.step.iter().zip(&b.step).map(|(a, b)| a * b).sum::<f32>() < 0.0;
    let in_front = ahead_a.min(ahead_b) >= BESIDE || distance <= PAST * scale;
    (same_sides && distance <= NEAR * scale && in_front).then_some(cost)
}

/// Strings paths together end by end.
fn thread(paths: Vec<Path>, ends: &[End], partner: &[Option<usize>]) -> Vec<Path> {
    let mut end_of = vec![None; paths.len()];
    for (number, pair) in ends.chunks_exact(2).enumerate() {
        end_of[pair[0].path] = Some([2 * number, 2 * number + 1]);
    }
    let mut left: Vec<Option<Path>> = paths.into_iter().map(Some).collect();
    let mut joined = Vec::with_capacity(left.len());
    for rings in [false, true] {
        for first in 0..left.len() {
            let Some(own) = end_of[first] else {
                joined.extend(left[first].take());
                continue;
            };
            let entry = match own.map(|end| partner[end].is_none()) {
                [true, _] => own[0],
                [_, true] => own[1],
                _ if rings => own[0],
                _ => continue,
            };
            let mut marks: Vec<Mark> = Vec::new();
            let mut next = Some(entry);
            while let Some(end) = next.map(|number| &ends[number])
                && let Some(mut path) = left[end.path].take()
            {
                if !end.at_start {
                    path.reverse();
                }
                if let Some(last) = marks.last().copied()
                    && let Some(first) = path.marks.first()
                {
                    marks.extend(between(&last, first));
                }
                marks.extend(path.marks);
                next = end_of[end.path].and_then(|own| partner[own[usize::from(end.at_start)]]);
            }
            let closed = next.is_some() && marks.len() > 3;
            if closed && let [first, .., last] = marks.as_slice() {
                let gap: Vec<Mark> = between(last, first).collect();
                marks.extend(gap);
            }
            if !marks.is_empty() {
                joined.push(Path { marks, closed });
            }
        }
    }
    joined
}

/// Marks about a pixel apart that lead over a gap.
fn between(from: &Mark, to: &Mark) -> impl Iterator<Item = Mark> + use<> {
    let (from, to) = (*from, *to);
    let steps = (to.at - from.at).length().round() as usize;
    (1..steps).map(move |k| {
        let share = k as f32 / steps as f32;
        let mix = |a: f32, b: f32| a + (b - a) * share;
        Mark {
            at: from.at.lerp(to.at, share),
            strength: mix(from.strength, to.strength),
            step: std::array::from_fn(|i| mix(from.step[i], to.step[i])),
            blur: mix(from.blur, to.blur),
            // nothing was seen here
            doubt: from.doubt.max(to.doubt).max(0.3),
        }
    })
}
