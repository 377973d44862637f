//! Ends that continue one another are joined: a contour that noise or a highlight broke is one line again.

use super::vertex::{Vertex, dot};
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmVector};

/// The direction of an end is taken over this much of its line, mm.
const HEADING: f32 = 1.5;
/// Least cosine between an end's heading and the way to the other end (45 degrees).
const AHEAD: f32 = 0.7;
/// Least cosine between the headings of two ends, one of them turned round (60 degrees).
const FACING: f32 = 0.5;
/// A line whose own ends are joined is at least this many times as long as the gap between them.
const RING: f32 = 4.0;
/// Ends nearer than this need not point at one another, mm: their headings alone decide.
const TOUCHING: f32 = 0.5;

/// Ends that do not meet exactly bend towards one another over this length, mm.
const BEND: f32 = 4.0;

struct End {
    polyline: usize,
    at_start: bool,
    at: MmPoint,
    heading: MmVector,
    /// Colour step as seen when leaving the line through this end.
    step: [f32; 3],
}

/// Joins open polylines over gaps of at most `gap` millimetres and closes those whose own ends meet.
pub(super) fn join(polylines: Vec<Polyline<Vertex>>, gap: f32) -> Vec<Polyline<Vertex>> {
    let ends = ends(&polylines);
    let lengths: Vec<f32> = polylines.iter().map(Polyline::length).collect();
    let mut joints = Vec::new();
    let mut by_x: Vec<usize> = (0..ends.len()).collect();
    by_x.sort_by(|&a, &b| ends[a].at.x.total_cmp(&ends[b].at.x));
    for (k, &i) in by_x.iter().enumerate() {
        for &j in by_x[k + 1..].iter().take_while(|&&j| ends[j].at.x - ends[i].at.x <= gap) {
            let (i, j) = (i.min(j), i.max(j));
            if let Some(cost) = cost(&ends[i], &ends[j], &lengths, gap) {
                joints.push((cost, i, j));
            }
        }
    }
    joints.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut partner = vec![None; ends.len()];
    for (_, i, j) in joints {
        if partner[i].is_none() && partner[j].is_none() {
            partner[i] = Some(j);
            partner[j] = Some(i);
        }
    }
    thread(polylines, &ends, &partner)
}

fn ends(polylines: &[Polyline<Vertex>]) -> Vec<End> {
    let mut ends = Vec::new();
    for (number, polyline) in
        polylines.iter().enumerate().filter(|(_, polyline)| !polyline.closed && polyline.vertices.len() > 1)
    {
        for at_start in [true, false] {
            let from_end = |i: usize| &polyline.vertices[if at_start { i } else { polyline.vertices.len() - 1 - i }];
            let tip = from_end(0);
            let inner = (1..polyline.vertices.len())
                .map(from_end)
                .find(|v| (v.at - tip.at).length() >= HEADING)
                .unwrap_or_else(|| from_end(polyline.vertices.len() - 1));
            let heading = (tip.at - inner.at).try_normalize().unwrap_or(MmVector::zero());
            let step = if at_start { tip.step.map(|v| -v) } else { tip.step };
            ends.push(End { polyline: number, at_start, at: tip.at, heading, step });
        }
    }
    ends
}

/// How far two ends are from being one line, if they can be joined at all.
fn cost(a: &End, b: &End, lengths: &[f32], gap: f32) -> Option<f32> {
    let way = b.at - a.at;
    let distance = way.length();
    if distance > gap || (a.polyline == b.polyline && lengths[a.polyline] < RING * distance) {
        return None;
    }
    // Leaving through a one enters through b, where right and left change places. The middle of a bar has no step.
    if dot(a.step, b.step) > 0.0 || a.heading.dot(b.heading) > -FACING {
        return None;
    }
    if distance <= TOUCHING {
        return Some(distance);
    }
    let way = way / distance;
    let (ahead_a, ahead_b) = (a.heading.dot(way), -b.heading.dot(way));
    (ahead_a >= AHEAD && ahead_b >= AHEAD).then_some(distance * (3.0 - ahead_a - ahead_b))
}

/// Two joined ends that lie beside one another (one came from the middle of a bar, the other from its side) bend towards
/// one another over [`BEND`] millimetres, so that the line has no step there. `seam` is the first vertex of the second.
fn meet_halfway(vertices: &mut [Vertex], seam: usize) {
    let (first, second) = vertices.split_at_mut(seam);
    let inner = |side: &[Vertex], at: usize| side[at].at;
    let ahead = inner(second, second.len().min(4) - 1) - inner(first, first.len().saturating_sub(4));
    let Some(ahead) = ahead.try_normalize() else { return };
    let gap = second[0].at - first[first.len() - 1].at;
    let aside = (gap - ahead * gap.dot(ahead)) * 0.5;
    let tips = (first[first.len() - 1].at, second[0].at);
    for vertex in first.iter_mut().rev() {
        let share = 1.0 - (vertex.at - tips.0).length() / BEND;
        if share <= 0.0 {
            break;
        }
        vertex.at += aside * share;
    }
    for vertex in second {
        let share = 1.0 - (vertex.at - tips.1).length() / BEND;
        if share <= 0.0 {
            break;
        }
        vertex.at -= aside * share;
    }
}

/// Strings polylines together end by end.
fn thread(polylines: Vec<Polyline<Vertex>>, ends: &[End], partner: &[Option<usize>]) -> Vec<Polyline<Vertex>> {
    // end_of[t] = the numbers of the start and the end of polyline t
    let mut end_of = vec![[usize::MAX; 2]; polylines.len()];
    for (number, end) in ends.iter().enumerate() {
        end_of[end.polyline][usize::from(!end.at_start)] = number;
    }
    let mut left: Vec<Option<Polyline<Vertex>>> = polylines.into_iter().map(Some).collect();
    let mut joined = Vec::with_capacity(left.len());
    for rings in [false, true] {
        for first in 0..left.len() {
            let Some(polyline) = &left[first] else { continue };
            if polyline.closed || end_of[first][0] == usize::MAX {
                joined.extend(left[first].take());
                continue;
            }
            let free = |side: usize| partner[end_of[first][side]].is_none();
            let entry = match (free(0), free(1)) {
                (true, _) => 0,
                (false, true) => 1,
                (false, false) if rings => 0,
                (false, false) => continue,
            };
            let mut vertices = Vec::new();
            let mut next = Some(end_of[first][entry]);
            while let Some(end) = next.map(|number| &ends[number])
                && let Some(polyline) = left[end.polyline].take()
            {
                let polyline = if end.at_start { polyline } else { polyline.reversed() };
                let seam = vertices.len();
                vertices.extend(polyline.vertices);
                if seam > 0 {
                    meet_halfway(&mut vertices, seam);
                }
                next = partner[end_of[end.polyline][usize::from(end.at_start)]];
            }
            let closed = next.is_some() && vertices.len() > 3;
            let mut polyline = Polyline { vertices, closed };
            polyline.fill();
            joined.push(polyline);
        }
    }
    joined
}
