//! What is left of a polyline when it is known which of its vertices go to the middle of a bar and which give way.
//!
//! ```text
//!   ,---------------------.
//!   |                     |      ->      -----------------------     as long as the bar, without hooks
//!   `---------------------'
//! ```

use super::super::meet;
use super::super::vertex::Vertex;
use super::Fate;
use crate::geom::polyline::{Polyline, smooth};
use crate::units::{MmPoint, MmVector};

/// A line moves over to the middle of a bar within about this length (sigma), mm: a finger glides over it.
const TRANSITION: f32 = 2.0;
/// The longest blunt end, in clearances: the bar's width and the two corners, whose vertices have no opposites.
const BLUNT: f32 = 2.0;
/// The direction of a middle line is taken over this much of it, mm.
const HEADING: f32 = 3.0;

/// Moves a polyline over to the middle where it is the side of a bar, and cuts out what is gone. Where a cut follows closely on
/// the end of a bar, what lies between is the bar's blunt end: the middle line goes straight on as far as that reaches
/// instead of hooking round it.
pub(super) fn cut(polyline: &Polyline<Vertex>, fate: &Fate, reach: f32, out: &mut Vec<Polyline<Vertex>>) {
    let places = polyline.vertices.len();
    if !fate.gone.contains(&true) {
        let indices: Vec<usize> = (0..places).collect();
        out.push(shifted(polyline, fate, &indices, polyline.closed));
        return;
    }
    let start = if polyline.closed { fate.gone.iter().position(|gone| *gone).unwrap_or(0) } else { 0 };
    let mut piece: Vec<usize> = Vec::new();
    for k in 0..=places {
        let i = (start + k) % places;
        if k < places && !fate.gone[i] {
            piece.push(i);
        } else if !piece.is_empty() {
            let (cut_before, cut_after) = (polyline.closed || piece[0] > 0, polyline.closed || k < places);
            let from = if cut_before { blunt_end(polyline, fate, reach, piece.iter()) } else { 0 };
            let after = if cut_after { blunt_end(polyline, fate, reach, piece.iter().rev()) } else { 0 };
            let until = piece.len() - after;
            if from < until {
                let mut vertices = shifted(polyline, fate, &piece[from..until], false).vertices;
                lead_to_the_end(&mut vertices, polyline, &piece[until..]);
                vertices.reverse();
                lead_to_the_end(&mut vertices, polyline, &piece[..from]);
                vertices.reverse();
                out.push(Polyline::open(vertices));
            }
            piece.clear();
        }
    }
}

/// The vertices with these numbers, moved over smoothly.
fn shifted(polyline: &Polyline<Vertex>, fate: &Fate, indices: &[usize], closed: bool) -> Polyline<Vertex> {
    let mut part = Polyline { vertices: indices.iter().map(|&i| polyline.vertices[i]).collect(), closed };
    if indices.iter().all(|&i| fate.moved[i].is_none()) {
        return part;
    }
    let shift = |k: usize| fate.moved[indices[k]].map_or([0.0, 0.0], |v| [v.x, v.y]);
    let smoothed = smooth(&part.arc_lengths(), closed, TRANSITION, shift);
    for ((vertex, [x, y]), &i) in part.vertices.iter_mut().zip(smoothed).zip(indices) {
        vertex.at += MmVector::new(x, y);
        // The middle has the same colour on both sides, so it goes on from either side of the bar.
        if fate.moved[i].is_some() {
            vertex.step = [0.0; 3];
        }
    }
    part
}

/// How many vertices, from a cut on, belong to the blunt end of the bar that follows; 0 if none follows within `reach`.
fn blunt_end<'a>(
    polyline: &Polyline<Vertex>,
    fate: &Fate,
    reach: f32,
    piece: impl Iterator<Item = &'a usize>,
) -> usize {
    let mut way = 0.0;
    let mut last: Option<MmPoint> = None;
    for (count, &i) in piece.enumerate() {
        let at = polyline.vertices[i].at;
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
fn lead_to_the_end(vertices: &mut Vec<Vertex>, polyline: &Polyline<Vertex>, blunt: &[usize]) {
    let Some(tip) = vertices.last().copied() else { return };
    let inner = vertices.iter().rev().find(|vertex| (vertex.at - tip.at).length() >= HEADING).or(vertices.first());
    let Some(heading) = inner.and_then(|inner| (tip.at - inner.at).try_normalize()) else { return };
    let reaches = blunt.iter().map(|&i| (polyline.vertices[i].at - tip.at).dot(heading)).fold(0.0, f32::max);
    if reaches > 0.0 {
        vertices.extend(meet::way(&tip, tip.at + heading * reaches));
    }
}
