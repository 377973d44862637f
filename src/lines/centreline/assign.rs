//! Which of two sides becomes the centreline of a stroke, and which is removed.

use std::cmp::Ordering;

use super::opposite::{Opposite, Opposites};
use super::stretch::{MIN_STRETCH, StrokeSide};
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::saliency::saliency;
use crate::lines::vertex::Vertex;
use crate::units::MmVector;

/// Vertices of the other side between two opposites that follow one another belong to the stroke up to this many (3
/// mm).
const SKIP: usize = 8;
/// A ring of which this share has become the centreline of another one goes altogether; one of which less is a stroke's
/// side may stay whole.
const MOST: f32 = 0.5;

/// What becomes of the vertices of a polyline.
pub(super) struct Assignment {
    /// How far a vertex moves to the middle of its stroke.
    pub(super) offsets: Vec<Option<MmVector>>,
    /// Whether a vertex is removed, because the other side of its stroke becomes the centreline.
    pub(super) removed: Vec<bool>,
}

/// Decides for every pair of polylines which one becomes the centreline all along their strokes; the other is removed.
/// Decided for a pair as a whole, so that two nested rings become one ring and not two halves of a spiral.
pub(super) fn assign(
    polylines: &[Polyline<Vertex>],
    opposites: &[Opposites],
    mut stretches: Vec<StrokeSide>,
    params: &Params,
) -> Vec<Assignment> {
    let rank = ranks(polylines, params);
    let winner = |stretch: &StrokeSide| rank[stretch.polyline].min(rank[stretch.other]);
    let stays_whole = rings_that_stay(polylines, opposites, &stretches, params);
    stretches.retain(|stretch| {
        let loser = if rank[stretch.polyline] == winner(stretch) { stretch.other } else { stretch.polyline };
        stretch.polyline == stretch.other || !stays_whole[loser]
    });
    stretches.sort_by(|a, b| decided_first(a, b, &rank));
    let assignment = |polyline: &Polyline<Vertex>| Assignment {
        offsets: vec![None; polyline.vertices.len()],
        removed: vec![false; polyline.vertices.len()],
    };
    let mut assignments: Vec<Assignment> = polylines.iter().map(assignment).collect();
    for stretch in &stretches {
        if rank[stretch.polyline] == winner(stretch) {
            take_middle(polylines, opposites, stretch, &mut assignments);
        } else {
            remove_side(polylines, opposites, stretch, &mut assignments);
        }
    }
    assignments
}

/// The rank of each polyline by its saliency: 0 is the most salient.
fn ranks(polylines: &[Polyline<Vertex>], params: &Params) -> Vec<usize> {
    let mut by_rank: Vec<(f32, usize)> = polylines.iter().map(|polyline| saliency(polyline, params)).zip(0..).collect();
    by_rank.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut rank = vec![0; polylines.len()];
    by_rank.iter().enumerate().for_each(|(place, &(_, number))| rank[number] = place);
    rank
}

/// Which polylines are rings that are a stroke's side on their lesser part and can give way. Such a ring stays
/// whole: it is a thing beside another, as a pupil in an eye.
fn rings_that_stay(
    polylines: &[Polyline<Vertex>],
    opposites: &[Opposites],
    stretches: &[StrokeSide],
    params: &Params,
) -> Vec<bool> {
    let (mut sides, mut close) = (vec![0; polylines.len()], vec![false; polylines.len()]);
    let nearest = params.too_narrow();
    for stretch in stretches {
        sides[stretch.polyline] += stretch.count;
        let vertices = &polylines[stretch.polyline].vertices;
        let is_close = |(i, opposite): (usize, Opposite)| (opposite.at - vertices[i].at).length() < nearest;
        close[stretch.polyline] |= stretch.opposites(opposites).any(is_close);
    }
    let is_thing = |(number, polyline): (usize, &Polyline<Vertex>)| {
        let share = sides[number] as f32 / polyline.vertices.len() as f32;
        polyline.closed && !close[number] && share < MOST
    };
    polylines.iter().enumerate().map(is_thing).collect()
}

/// The order in which stretches are decided: by their winner, first as that sees it, and the most salient first.
fn decided_first(a: &StrokeSide, b: &StrokeSide, rank: &[usize]) -> Ordering {
    let winner = |stretch: &StrokeSide| rank[stretch.polyline].min(rank[stretch.other]);
    let is_loser = |stretch: &StrokeSide| rank[stretch.polyline] != winner(stretch);
    (winner(a), is_loser(a))
        .cmp(&(winner(b), is_loser(b)))
        .then(b.saliency.total_cmp(&a.saliency))
        .then((a.polyline, a.from).cmp(&(b.polyline, b.from)))
}

/// Makes a stretch the centreline and removes the opposite side. If stronger stretches took a part of it, the remainder
/// must have the least length, too.
fn take_middle(
    polylines: &[Polyline<Vertex>],
    opposites: &[Opposites],
    stretch: &StrokeSide,
    assignments: &mut [Assignment],
) {
    let vertices = &polylines[stretch.polyline].vertices;
    let free = |assignments: &[Assignment], i: usize, j: usize| {
        let (own, other) = (&assignments[stretch.polyline], &assignments[stretch.other]);
        !own.removed[i] && own.offsets[i].is_none() && other.offsets[j].is_none()
    };
    let pairs: Vec<(usize, Opposite)> = stretch.opposites(opposites).collect();
    for left in pairs
        .chunk_by(|a, b| free(assignments, a.0, a.1.index) == free(assignments, b.0, b.1.index))
        .collect::<Vec<_>>()
    {
        let length: f32 = left.windows(2).map(|pair| (vertices[pair[1].0].at - vertices[pair[0].0].at).length()).sum();
        let across: f32 = left.iter().map(|(i, opposite)| (opposite.at - vertices[*i].at).length()).sum();
        if length < MIN_STRETCH * across / left.len() as f32 {
            continue;
        }
        let mut last: Option<usize> = None;
        for &(i, opposite) in left {
            let j = opposite.index;
            if !free(assignments, i, j) {
                last = None;
                continue;
            }
            assignments[stretch.polyline].offsets[i] = Some((opposite.at - vertices[i].at) * 0.5);
            // All that the other side has between the last opposite and this one goes.
            let Assignment { offsets, removed } = &mut assignments[stretch.other];
            for k in last.map_or(j..=j, |last| between(last, j, &polylines[stretch.other])) {
                let k = k % offsets.len();
                removed[k] |= offsets[k].is_none();
            }
            last = Some(j);
        }
    }
}

/// The vertices from one to another, in a ring along the shorter arc, as numbers that may go on beyond its last; the
/// second alone if there are too many.
fn between(i: usize, j: usize, polyline: &Polyline<Vertex>) -> std::ops::RangeInclusive<usize> {
    let (low, high) = (i.min(j), i.max(j));
    if high - low <= SKIP {
        low..=high
    } else if polyline.closed && low + polyline.vertices.len() - high <= SKIP {
        high..=low + polyline.vertices.len()
    } else {
        j..=j
    }
}

/// A stretch goes, and the other side to the middle where it has not yet.
fn remove_side(
    polylines: &[Polyline<Vertex>],
    opposites: &[Opposites],
    stretch: &StrokeSide,
    assignments: &mut [Assignment],
) {
    for (i, opposite) in stretch.opposites(opposites) {
        let (other, j) = (stretch.other, opposite.index);
        if assignments[other].removed[j] || assignments[stretch.polyline].offsets[i].is_some() {
            continue;
        }
        assignments[stretch.polyline].removed[i] = true;
        let across = polylines[stretch.polyline].vertices[i].at - opposite.at;
        assignments[other].offsets[j].get_or_insert(across * 0.5);
    }
}

/// Whether a ring has for the most part become the centreline of a stronger one: the rest of it would be an arc beside
/// that, which says nothing.
pub(super) fn is_rest(assignment: &Assignment) -> bool {
    let share = |count: usize| count as f32 / assignment.removed.len().max(1) as f32;
    let (gone, moved) =
        (assignment.removed.iter().filter(|gone| **gone).count(), assignment.offsets.iter().flatten().count());
    share(gone) >= MOST && share(moved) < 0.2 * MOST
}

#[cfg(test)]
mod tests;
