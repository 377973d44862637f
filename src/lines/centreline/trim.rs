//! What is left of a polyline when it is known which of its vertices go to the middle of a stroke and which are
//! removed.
//!
//! ```text
//!   ,---------------------.
//!   |                     |      ->      -----------------------     as long as the stroke, without hooks
//!   `---------------------'
//! ```

use super::assign::Assignment;
use crate::geom::polyline::{Polyline, smooth};
use crate::geom::walk::runs;
use crate::lines::junction;
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmVector};

/// A line moves over to the middle of a stroke within about this length (sigma), mm: a finger glides over it.
const TRANSITION: f32 = 2.0;
/// The longest blunt end, in clearances: the stroke's width and the two corners, whose vertices have no opposites.
const BLUNT: f32 = 2.0;
/// The direction of a centreline is taken over this much of it, mm.
const HEADING: f32 = 3.0;

/// Moves a polyline over to the middle where it is the side of a stroke, and cuts out what is removed. Where a cut
/// follows closely on the end of a stroke, what lies between is the stroke's blunt end: the centreline goes straight on
/// as far as that reaches instead of hooking round it.
pub(super) fn trim(polyline: &Polyline<Vertex>, assignment: &Assignment, reach: f32, out: &mut Vec<Polyline<Vertex>>) {
    let count = polyline.vertices.len();
    if !assignment.removed.contains(&true) {
        let indices: Vec<usize> = (0..count).collect();
        out.push(shifted(polyline, assignment, &indices, polyline.closed));
        return;
    }
    let removed = &assignment.removed;
    for piece in runs(count, polyline.closed, |a, b| removed[a] == removed[b]) {
        let (first, last) = (piece[0], piece[piece.len() - 1]);
        if removed[first] {
            continue;
        }
        let (cut_before, cut_after) = (polyline.closed || first > 0, polyline.closed || last + 1 < count);
        let from = if cut_before { blunt_end(polyline, assignment, reach, piece.iter()) } else { 0 };
        let after = if cut_after { blunt_end(polyline, assignment, reach, piece.iter().rev()) } else { 0 };
        let until = piece.len() - after;
        if from < until {
            let mut vertices = shifted(polyline, assignment, &piece[from..until], false).vertices;
            extend_to_the_end(&mut vertices, polyline, &piece[until..]);
            vertices.reverse();
            extend_to_the_end(&mut vertices, polyline, &piece[..from]);
            vertices.reverse();
            out.push(Polyline::open(vertices));
        }
    }
}

/// The vertices with these numbers, moved over smoothly.
fn shifted(polyline: &Polyline<Vertex>, assignment: &Assignment, indices: &[usize], closed: bool) -> Polyline<Vertex> {
    let mut part = Polyline { vertices: indices.iter().map(|&i| polyline.vertices[i]).collect(), closed };
    if indices.iter().all(|&i| assignment.offsets[i].is_none()) {
        return part;
    }
    let shift = |k: usize| assignment.offsets[indices[k]].map_or([0.0, 0.0], |v| [v.x, v.y]);
    let smoothed = smooth(&part.arc_lengths(), closed, TRANSITION, shift);
    for ((vertex, [x, y]), &i) in part.vertices.iter_mut().zip(smoothed).zip(indices) {
        vertex.at += MmVector::new(x, y);
        // The middle has the same colour on both sides, so it goes on from either side of the stroke.
        if assignment.offsets[i].is_some() {
            vertex.contrast = [0.0; 3];
        }
    }
    part
}

/// How many vertices, from a cut on, belong to the blunt end of the stroke that follows; 0 if none follows within
/// `reach`.
fn blunt_end<'a>(
    polyline: &Polyline<Vertex>,
    assignment: &Assignment,
    reach: f32,
    piece: impl Iterator<Item = &'a usize>,
) -> usize {
    let mut way = 0.0;
    let mut last: Option<MmPoint> = None;
    for (count, &i) in piece.enumerate() {
        let at = polyline.vertices[i].at;
        way += last.map_or(0.0, |last| (at - last).length());
        if assignment.offsets[i].is_some() {
            return count;
        }
        if way > BLUNT * reach {
            break;
        }
        last = Some(at);
    }
    0
}

/// Extends a centreline straight as far as the blunt end of its stroke reaches.
fn extend_to_the_end(vertices: &mut Vec<Vertex>, polyline: &Polyline<Vertex>, blunt: &[usize]) {
    let Some(tip) = vertices.last().copied() else { return };
    let inner = vertices.iter().rev().find(|vertex| (vertex.at - tip.at).length() >= HEADING).or(vertices.first());
    let Some(heading) = inner.and_then(|inner| (tip.at - inner.at).try_normalize()) else { return };
    let reaches = blunt.iter().map(|&i| (polyline.vertices[i].at - tip.at).dot(heading)).fold(0.0, f32::max);
    if reaches > 0.0 {
        vertices.extend(junction::straight(&tip, tip.at + heading * reaches));
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{bar, side};
    use super::*;

    /// What is left of a line without its vertices in a range of x.
    fn without(polyline: &Polyline<Vertex>, range: std::ops::Range<f32>) -> Vec<Polyline<Vertex>> {
        let removed = polyline.vertices.iter().map(|vertex| range.contains(&vertex.at.x)).collect();
        let assignment = Assignment { offsets: vec![None; polyline.vertices.len()], removed };
        let mut out = Vec::new();
        trim(polyline, &assignment, 4.7, &mut out);
        out
    }

    #[test]
    fn an_open_line_is_left_on_both_sides_of_a_cut_and_a_ring_is_opened_by_it() {
        let line = side(&[(10.0, 20.0), (50.0, 20.0)], false, 60.0);
        let lengths: Vec<f32> = without(&line, 19.9..30.1).iter().map(Polyline::length).collect();
        assert!(matches!(lengths[..], [a, b] if (a - 9.6).abs() < 0.1 && (b - 19.6).abs() < 0.1), "{lengths:?}");
        let ring = bar(20.0, 0);
        for start in 0..ring.vertices.len() {
            let left = without(&bar(20.0, start), 0.0..10.1);
            assert!(matches!(&left[..], [one] if !one.closed && (one.length() - 99.2).abs() < 0.1), "from {start}");
        }
        assert_eq!(without(&ring, 60.0..70.0), [ring]);
    }

    #[test]
    fn a_centreline_goes_over_to_the_middle_and_on_to_the_blunt_end() {
        let ring = bar(3.0, 0);
        let is_inner = |vertex: &Vertex| (12.0..=48.0).contains(&vertex.at.x);
        let upper = |vertex: &Vertex| vertex.at.y < 20.1;
        let offset = |vertex: &Vertex| (is_inner(vertex) && upper(vertex)).then_some(MmVector::new(0.0, 1.5));
        let assignment = Assignment {
            offsets: ring.vertices.iter().map(offset).collect(),
            removed: ring.vertices.iter().map(|vertex| is_inner(vertex) && !upper(vertex)).collect(),
        };
        let mut out = Vec::new();
        trim(&ring, &assignment, 4.7, &mut out);
        let [line] = &out[..] else { panic!("{} lines", out.len()) };
        let ends = [line.vertices.first(), line.vertices.last()].map(|end| end.expect("it has vertices").at);
        assert!((ends[0] - MmPoint::new(10.0, 21.5)).length() < 0.1, "{ends:?}");
        assert!((ends[1] - MmPoint::new(50.0, 21.5)).length() < 0.1, "{ends:?}");
        assert!(line.vertices.iter().all(|vertex| (vertex.at.y - 21.5).abs() < 0.01), "no hook at its ends");
    }
}
