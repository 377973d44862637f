//! What is left of a trail when it is known which of its vertices go to the middle of a bar and which give way.
//!
//! ```text
//!   ,---------------------.
//!   |                     |      ->      -----------------------     as long as the bar, without hooks
//!   `---------------------'
//! ```

use super::super::meet;
use super::super::trail::{Trail, Vertex};
use super::Fate;
use crate::geom::polyline::{arc_lengths, smooth};
use crate::units::{MmPoint, MmVector};

/// A line moves over to the middle of a bar within about this length (sigma), mm: a finger glides over it.
const TRANSITION: f32 = 2.0;
/// The longest blunt end, in clearances: the bar's width and the two corners, whose vertices have no opposites.
const BLUNT: f32 = 2.0;
/// The direction of a middle line is taken over this much of it, mm.
const HEADING: f32 = 3.0;

/// Moves a trail over to the middle where it is the side of a bar, and cuts out what is gone. Where a cut follows closely on
/// the end of a bar, what lies between is the bar's blunt end: the middle line goes straight on as far as that reaches
/// instead of hooking round it.
pub(super) fn cut(trail: &Trail, fate: &Fate, reach: f32, out: &mut Vec<Trail>) {
    let places = trail.places();
    if !fate.gone.contains(&true) {
        let mut indices: Vec<usize> = (0..places).collect();
        if trail.closed {
            indices.push(0);
        }
        out.push(Trail { vertices: shifted(trail, fate, &indices, trail.closed), closed: trail.closed });
        return;
    }
    let start = if trail.closed { fate.gone.iter().position(|gone| *gone).unwrap_or(0) } else { 0 };
    let mut piece: Vec<usize> = Vec::new();
    for k in 0..=places {
        let i = (start + k) % places;
        if k < places && !fate.gone[i] {
            piece.push(i);
        } else if !piece.is_empty() {
            let (cut_before, cut_after) = (trail.closed || piece[0] > 0, trail.closed || k < places);
            let from = if cut_before { blunt_end(trail, fate, reach, piece.iter()) } else { 0 };
            let after = if cut_after { blunt_end(trail, fate, reach, piece.iter().rev()) } else { 0 };
            let until = piece.len() - after;
            if from < until {
                let mut vertices = shifted(trail, fate, &piece[from..until], false);
                lead_to_the_end(&mut vertices, trail, &piece[until..]);
                vertices.reverse();
                lead_to_the_end(&mut vertices, trail, &piece[..from]);
                vertices.reverse();
                out.push(Trail { vertices, closed: false });
            }
            piece.clear();
        }
    }
}

/// The vertices with these numbers, moved over smoothly.
fn shifted(trail: &Trail, fate: &Fate, indices: &[usize], closed: bool) -> Vec<Vertex> {
    let mut vertices: Vec<Vertex> = indices.iter().map(|&i| trail.vertices[i]).collect();
    if indices.iter().all(|&i| fate.moved[i].is_none()) {
        return vertices;
    }
    let points: Vec<_> = vertices.iter().map(|vertex| vertex.at).collect();
    let shift = |k: usize| fate.moved[indices[k]].map_or([0.0, 0.0], |v| [v.x, v.y]);
    let smoothed = smooth(&arc_lengths(&points), closed, TRANSITION, shift);
    for ((vertex, [x, y]), &i) in vertices.iter_mut().zip(smoothed).zip(indices) {
        vertex.at += MmVector::new(x, y);
        // The middle has the same colour on both sides, so it goes on from either side of the bar.
        if fate.moved[i].is_some() {
            vertex.step = [0.0; 3];
        }
    }
    vertices
}

/// How many vertices, from a cut on, belong to the blunt end of the bar that follows; 0 if none follows within `reach`.
fn blunt_end<'a>(trail: &Trail, fate: &Fate, reach: f32, piece: impl Iterator<Item = &'a usize>) -> usize {
    let mut way = 0.0;
    let mut last: Option<MmPoint> = None;
    for (count, &i) in piece.enumerate() {
        let at = trail.vertices[i].at;
        way += last.map_or(0.0, |last| (at - last).length());
        if fate.moved[i].is_some() {
            return count;
        }
        if way > BLUNT * reach {
            break;
        }
        last = Some(at);
    }
    0
}

/// Leads a middle line straight on as far as the blunt end of its bar reaches.
fn lead_to_the_end(vertices: &mut Vec<Vertex>, trail: &Trail, blunt: &[usize]) {
    let Some(tip) = vertices.last().copied() else { return };
    let inner = vertices.iter().rev().find(|vertex| (vertex.at - tip.at).length() >= HEADING).or(vertices.first());
    let Some(heading) = inner.and_then(|inner| (tip.at - inner.at).try_normalize()) else { return };
    let reaches = blunt.iter().map(|&i| (trail.vertices[i].at - tip.at).dot(heading)).fold(0.0, f32::max);
    if reaches > 0.0 {
        vertices.extend(meet::way(&tip, tip.at + heading * reaches));
    }
}
