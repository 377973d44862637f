//! The two sides of a thin bar become one line along its middle: a pole, a wire, a pen stroke, the rim of a cup.
//!
//! ```text
//!   colour A | colour B | colour A          A | A
//!            |          |           ->        |        (nearer than a finger can part)
//!          step       -step                 middle
//! ```
//!
//! Sides belong together when they run parallel, nearer than two lines may, and the colour steps back across the second
//! what it stepped across the first.

use super::Params;
use super::saliency::saliency;
use super::trail::{Trail, Vertex, dot};
use crate::geom::crossing;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::{arc_lengths, smooth};
use crate::units::{MmPoint, MmRect, MmVector};

/// Least cosine between the directions of two sides (about 37 degrees).
const PARALLEL: f32 = 0.8;
/// Least cosine between the step back and the step up, as directions in colour space: a black axis below a yellow bar steps
/// from white to black and from black to yellow, which have 0.45 in common.
const STEP_BACK: f32 = 0.3;
/// The smaller of the two steps is at least this share of the larger.
const ALIKE: f32 = 0.3;
/// The shortest stretch of two sides that counts as a bar, in widths of the bar; shorter ones are the ends of other shapes.
const MIN_STRETCH: f32 = 1.5;
/// Vertices of the other side between two opposites that follow one another belong to the bar up to this many (3 mm).
const SKIP: usize = 8;
/// On one line, opposite sides are parted by a bend: the way along it is longer than the way across by this factor (a half
/// circle's is 1.57), and by this length, mm.
const BEND: f32 = 1.4;
const BEND_LEAST: f32 = 0.8;
/// The longest blunt end, in clearances: the bar's width and the two corners, whose vertices have no opposites.
const BLUNT: f32 = 2.0;
/// A ring of which this share has become the middle line of another one goes altogether.
const MOST: f32 = 0.5;
/// A ring of which less than this share is a bar's side is no bar but a thing near another.
const LESSER: f32 = 0.3;
/// What rounding may change, as a share: where two sides have vertices straight across from one another, as on drawings, it
/// must not decide which of two segments or ends is the opposite.
const ROUNDING: f32 = 1e-3;
/// Cells in which the other side is looked for, mm: about two vertices.
const CELL: f32 = 1.0;
/// A line moves over to the middle of a bar within about this length (sigma), mm: a finger glides over it.
const TRANSITION: f32 = 2.0;

/// Where a vertex has its opposite.
#[derive(Clone, Copy)]
struct Opposite {
    trail: u32,
    index: u32,
    at: MmPoint,
}

/// A stretch of one trail along which it has opposites on one other.
struct Stretch {
    trail: usize,
    other: usize,
    from: usize,
    to: usize,
    /// Length times strength.
    saliency: f32,
}

impl Stretch {
    /// Its vertices that have opposites, with these.
    fn opposites(&self, all: &[Vec<Option<Opposite>>]) -> impl Iterator<Item = (usize, Opposite)> {
        let own = all[self.trail].iter().enumerate().take(self.to + 1).skip(self.from);
        own.filter_map(|(i, opposite)| opposite.map(|opposite| (i, opposite)))
    }
}

/// What becomes of the vertices.
struct Fate {
    /// How far a vertex moves over to the middle of its bar.
    moved: Vec<Vec<Option<MmVector>>>,
    /// Whether a vertex gives way to the other side of its bar.
    gone: Vec<Vec<bool>>,
}

pub(super) fn merge(trails: Vec<Trail>, area: MmRect, params: &Params) -> Vec<Trail> {
    let reach = params.min_gap + params.width_max;
    let opposites = opposites(&trails, area, reach);
    let stretches = stretches(&trails, &opposites);
    let fate = fates(&trails, &opposites, stretches, params);
    let mut merged = Vec::with_capacity(trails.len());
    for ((trail, moved), gone) in trails.into_iter().zip(&fate.moved).zip(&fate.gone) {
        if trail.closed && is_rest(&trail, moved, gone) {
            continue;
        }
        split(shifted(trail, moved), moved, gone, reach, &mut merged);
    }
    merged
}

/// Decides for every two trails which of them goes to the middle all along their bars and which gives way, so that two
/// rings that lie in one another become one ring and not a spiral of halves.
fn fates(trails: &[Trail], opposites: &[Vec<Option<Opposite>>], mut stretches: Vec<Stretch>, params: &Params) -> Fate {
    let mut by_rank: Vec<(f32, usize)> = trails.iter().map(|trail| saliency(trail, params)).zip(0..).collect();
    by_rank.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut rank = vec![0; trails.len()];
    by_rank.iter().enumerate().for_each(|(place, &(_, number))| rank[number] = place);

    let winner = |stretch: &Stretch| rank[stretch.trail].min(rank[stretch.other]);
    // A ring that is a bar's side on its lesser part stays whole: it is a thing beside another, as a pupil in an eye.
    let mut sides = vec![0; trails.len()];
    stretches.iter().for_each(|stretch| sides[stretch.trail] += stretch.to - stretch.from + 1);
    let thing =
        |number: usize| trails[number].closed && (sides[number] as f32) < LESSER * trails[number].vertices.len() as f32;
    stretches.retain(|stretch| {
        let loser = if rank[stretch.trail] == winner(stretch) { stretch.other } else { stretch.trail };
        stretch.trail == stretch.other || !thing(loser)
    });
    stretches.sort_by(|a, b| {
        let (first, second) = (winner(a), winner(b));
        let sides = (rank[a.trail] != first).cmp(&(rank[b.trail] != second)); // as the winner sees it comes first
        first
            .cmp(&second)
            .then(sides)
            .then(b.saliency.total_cmp(&a.saliency))
            .then((a.trail, a.from).cmp(&(b.trail, b.from)))
    });
    let mut fate = Fate {
        moved: trails.iter().map(|t| vec![None; t.vertices.len()]).collect(),
        gone: trails.iter().map(|t| vec![false; t.vertices.len()]).collect(),
    };
    for stretch in &stretches {
        if rank[stretch.trail] == winner(stretch) {
            take_middle(trails, opposites, stretch, &mut fate);
        } else {
            give_way(trails, opposites, stretch, &mut fate);
        }
    }
    fate
}

/// A stretch goes to the middle; the other side goes.
fn take_middle(trails: &[Trail], opposites: &[Vec<Option<Opposite>>], stretch: &Stretch, fate: &mut Fate) {
    let mut last: Option<usize> = None;
    for (i, opposite) in stretch.opposites(opposites) {
        let (other, j) = (stretch.other, opposite.index as usize);
        if fate.gone[stretch.trail][i] || fate.moved[stretch.trail][i].is_some() || fate.moved[other][j].is_some() {
            last = None;
            continue;
        }
        fate.moved[stretch.trail][i] = Some((opposite.at - trails[stretch.trail].vertices[i].at) * 0.5);
        // All that the other side has between the last opposite and this one goes.
        let from = last.filter(|k| k.abs_diff(j) <= SKIP).unwrap_or(j);
        for k in from.min(j)..=from.max(j) {
            if fate.moved[other][k].is_none() {
                fate.gone[other][k] = true;
            }
        }
        last = Some(j);
    }
}

/// A stretch goes, and the other side to the middle where it has not yet.
fn give_way(trails: &[Trail], opposites: &[Vec<Option<Opposite>>], stretch: &Stretch, fate: &mut Fate) {
    for (i, opposite) in stretch.opposites(opposites) {
        let (other, j) = (stretch.other, opposite.index as usize);
        if fate.gone[other][j] || fate.moved[stretch.trail][i].is_some() {
            continue;
        }
        fate.gone[stretch.trail][i] = true;
        let way = trails[stretch.trail].vertices[i].at - opposite.at;
        fate.moved[other][j].get_or_insert(way * 0.5);
    }
}

/// Whether a ring has for the most part become the middle line of a stronger one: the rest of it would be an arc beside
/// that, which says nothing.
fn is_rest(trail: &Trail, moved: &[Option<MmVector>], gone: &[bool]) -> bool {
    let count = |flags: usize| flags as f32 / trail.vertices.len() as f32;
    count(gone.iter().filter(|gone| **gone).count()) >= MOST && count(moved.iter().flatten().count()) < 0.2 * MOST
}

/// Finds for every vertex the nearest place on the opposite side of a bar, if it lies on one: straight across, on either
/// side of the line.
fn opposites(trails: &[Trail], area: MmRect, reach: f32) -> Vec<Vec<Option<Opposite>>> {
    let mut nearby = Nearby::new(area, CELL);
    let mut all_arcs = Vec::with_capacity(trails.len());
    for (number, trail) in trails.iter().enumerate() {
        let arcs = arc_lengths(&trail.points());
        if !is_dot(trail, &arcs, reach) {
            for (i, pair) in trail.vertices.windows(2).enumerate() {
                let (a, b) = (pair[0].at, pair[1].at);
                nearby.insert(Segment { a, b, half_width: 0.0, line: number as u32, index: i as u32, arc: arcs[i] });
            }
        }
        all_arcs.push(arcs);
    }
    let opposite = |number: usize, i: usize| -> Option<Opposite> {
        let trail = &trails[number];
        let here: &Vertex = &trail.vertices[i];
        let (arc, total) = (all_arcs[number][i], all_arcs[number].last().copied().unwrap_or(0.0));
        let tangent = trail.tangent(i);
        let up = dot(here.step, here.step).sqrt();
        let mut best: Option<(f32, Opposite)> = None;
        for side in [1.0, -1.0] {
            let across = MmVector::new(-tangent.y, tangent.x) * (side * best.map_or(reach, |(distance, _)| distance));
            let way = (here.at, here.at + across);
            nearby.along(way.0, way.1, |segment| {
                // longer by a rounding: a way that leads through a vertex exactly crosses both segments, not neither
                let over = (segment.b - segment.a) * ROUNDING;
                let Some(at) = crossing(way, (segment.a - over, segment.b + over)) else { return };
                let distance = (at - here.at).length();
                if best.is_some_and(|(least, _)| distance >= least * (1.0 - ROUNDING)) {
                    return;
                }
                if segment.line as usize == number {
                    // Along the same line: not this place itself, only what lies beyond a bend.
                    let apart = (segment.arc - arc).abs();
                    let apart = if trail.closed { apart.min(total - apart) } else { apart };
                    if apart < BEND * distance + BEND_LEAST {
                        return;
                    }
                }
                let Some(direction) = (segment.b - segment.a).try_normalize() else { return };
                let along = direction.dot(tangent);
                if along.abs() < PARALLEL {
                    return;
                }
                let sides = [0, 1].map(|end| trails[segment.line as usize].vertices[segment.index as usize + end].step);
                let there = std::array::from_fn(|i| 0.5 * (sides[0][i] + sides[1][i]) * along.signum());
                let down = dot(there, there).sqrt();
                // a faint ghost beside a strong contour is no bar
                let alike = up.min(down) >= ALIKE * up.max(down);
                if alike && dot(here.step, there) < -STEP_BACK * up * down {
                    let (first, second) = ((segment.a - at).length(), (segment.b - at).length());
                    let nearer_end = u32::from(second < first * (1.0 - ROUNDING));
                    best = Some((distance, Opposite { trail: segment.line, index: segment.index + nearer_end, at }));
                }
            });
        }
        best.map(|(_, opposite)| opposite)
    };
    trails
        .iter()
        .enumerate()
        .map(|(number, trail)| match is_dot(trail, &all_arcs[number], reach) {
            true => vec![None; trail.vertices.len()],
            false => (0..trail.vertices.len()).map(|i| opposite(number, i)).collect(),
        })
        .collect()
}

/// A small ring (an eye, a button) is felt as a dot and stays whole.
fn is_dot(trail: &Trail, arcs: &[f32], reach: f32) -> bool {
    trail.closed && arcs.last().is_none_or(|&total| total < std::f32::consts::PI * reach)
}

/// Stretches of vertices with opposites on the same trail that are long enough for a bar.
fn stretches(trails: &[Trail], opposites: &[Vec<Option<Opposite>>]) -> Vec<Stretch> {
    let mut found = Vec::new();
    for (number, (trail, opposites)) in trails.iter().zip(opposites).enumerate() {
        let mut i = 0;
        while i < opposites.len() {
            let Some(first) = opposites[i] else {
                i += 1;
                continue;
            };
            let from = i;
            let (mut length, mut across, mut saliency) = (0.0, 0.0, 0.0);
            while let Some(opposite) = opposites.get(i).copied().flatten().filter(|o| o.trail == first.trail) {
                if i > from {
                    let step = (trail.vertices[i].at - trail.vertices[i - 1].at).length();
                    length += step;
                    saliency += step * trail.vertices[i].strength.min(trail.vertices[i - 1].strength);
                }
                across += (opposite.at - trail.vertices[i].at).length();
                i += 1;
            }
            if length >= MIN_STRETCH * across / (i - from) as f32 {
                found.push(Stretch { trail: number, other: first.trail as usize, from, to: i - 1, saliency });
            }
        }
    }
    found
}

/// Moves a trail over to the middle where it is the side of a bar, smoothly.
fn shifted(mut trail: Trail, moved: &[Option<MmVector>]) -> Trail {
    if moved.iter().all(Option::is_none) {
        return trail;
    }
    let arcs = arc_lengths(&trail.points());
    let shift = |i: usize| moved[i].map_or([0.0, 0.0], |v| [v.x, v.y]);
    let smoothed = smooth(&arcs, trail.closed, TRANSITION, shift);
    for (vertex, [x, y]) in trail.vertices.iter_mut().zip(smoothed) {
        vertex.at += MmVector::new(x, y);
    }
    // The middle has the same colour on both sides, so it goes on from either side of the bar.
    for (vertex, moved) in trail.vertices.iter_mut().zip(moved) {
        if moved.is_some() {
            vertex.step = [0.0; 3];
        }
    }
    trail
}

/// Cuts out what is gone. Where a cut follows closely on the end of a bar, what lies between is the bar's blunt end: the
/// middle line stops before it instead of hooking round it.
fn split(trail: Trail, moved: &[Option<MmVector>], gone: &[bool], reach: f32, out: &mut Vec<Trail>) {
    if !gone.contains(&true) {
        out.push(trail);
        return;
    }
    let ring = if trail.closed { trail.vertices.len() - 1 } else { trail.vertices.len() };
    let start = if trail.closed { (0..ring).find(|&i| gone[i]).unwrap_or(0) } else { 0 };
    let mut piece: Vec<usize> = Vec::new();
    for k in 0..=ring {
        let i = (start + k) % ring;
        if k < ring && !gone[i] {
            piece.push(i);
        } else if !piece.is_empty() {
            let blunt = |piece: &mut dyn Iterator<Item = &usize>| blunt_end(&trail, moved, reach, piece);
            let (cut_before, cut_after) = (trail.closed || piece[0] > 0, trail.closed || k < ring);
            let from = if cut_before { blunt(&mut piece.iter()) } else { 0 };
            let until = piece.len() - if cut_after { blunt(&mut piece.iter().rev()) } else { 0 };
            if from < until {
                let vertices = piece[from..until].iter().map(|&i| trail.vertices[i]).collect();
                out.push(Trail { vertices, closed: false });
            }
            piece.clear();
        }
    }
}

/// How many vertices, from a cut on, belong to the blunt end of the bar that follows; 0 if none follows within `reach`.
fn blunt_end(trail: &Trail, moved: &[Option<MmVector>], reach: f32, piece: &mut dyn Iterator<Item = &usize>) -> usize {
    let mut way = 0.0;
    let mut last: Option<MmPoint> = None;
    for (count, &i) in piece.enumerate() {
        let at = trail.vertices[i].at;
        way += last.map_or(0.0, |last| (at - last).length());
        if moved[i].is_some() {
            return count;
        }
        if way > BLUNT * reach {
            break;
        }
        last = Some(at);
    }
    0
}
