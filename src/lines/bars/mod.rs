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

mod cut;
mod opposite;

use opposite::{Opposite, Opposites, opposites};

use super::Params;
use super::saliency::saliency;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::{MmRect, MmVector};

/// The shortest stretch of two sides that counts as a bar, in widths of the bar; shorter ones are the ends of other shapes.
const MIN_STRETCH: f32 = 1.5;
/// Vertices of the other side between two opposites that follow one another belong to the bar up to this many (3 mm).
const SKIP: usize = 8;
/// A ring of which this share has become the middle line of another one goes altogether; one of which less is a bar's side
/// may stay whole.
const MOST: f32 = 0.5;
/// A ring gives way by as much, mm: beside a line that is farther than clearance less this it can stay whole.
const GIVES_WAY: f32 = super::clear::RING_FARTHEST;

/// A stretch of one polyline along which it has opposites on one other.
struct Stretch {
    polyline: usize,
    other: usize,
    from: usize,
    /// Number of vertices; in a ring it may lead on over its first.
    count: usize,
    /// Length times strength.
    saliency: f32,
}

impl Stretch {
    /// Its vertices with their opposites.
    fn opposites(&self, all: &[Opposites]) -> impl Iterator<Item = (usize, Opposite)> {
        let own = &all[self.polyline];
        let place = |k: usize| (self.from + k) % own.len();
        (0..self.count).map(place).filter_map(|i| own[i].map(|opposite| (i, opposite)))
    }
}

/// What becomes of the vertices of a polyline (of a ring without the repeated one).
struct Fate {
    /// How far a vertex moves over to the middle of its bar.
    moved: Vec<Option<MmVector>>,
    /// Whether a vertex gives way to the other side of its bar.
    gone: Vec<bool>,
}

/// Two sides of a bar become one line along its middle.
pub(super) fn merge(polylines: Vec<Polyline<Vertex>>, area: MmRect, params: &Params) -> Vec<Polyline<Vertex>> {
    let reach = params.min_gap + params.width_max;
    let opposites = opposites(&polylines, area, reach);
    let stretches = stretches(&polylines, &opposites);
    let fates = fates(&polylines, &opposites, stretches, params);
    let mut merged = Vec::with_capacity(polylines.len());
    for (polyline, fate) in polylines.iter().zip(&fates) {
        if !(polyline.closed && is_rest(fate)) {
            cut::cut(polyline, fate, reach, &mut merged);
        }
    }
    merged
}

/// Decides for every two polylines which of them goes to the middle all along their bars and which gives way, so that two
/// rings that lie in one another become one ring and not a spiral of halves.
fn fates(
    polylines: &[Polyline<Vertex>],
    opposites: &[Opposites],
    mut stretches: Vec<Stretch>,
    params: &Params,
) -> Vec<Fate> {
    let mut by_rank: Vec<(f32, usize)> = polylines.iter().map(|polyline| saliency(polyline, params)).zip(0..).collect();
    by_rank.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut rank = vec![0; polylines.len()];
    by_rank.iter().enumerate().for_each(|(place, &(_, number))| rank[number] = place);

    let winner = |stretch: &Stretch| rank[stretch.polyline].min(rank[stretch.other]);
    // A ring that is a bar's side on its lesser part stays whole if it can give way: it is a thing beside another, as a pupil
    // in an eye.
    let (mut sides, mut close) = (vec![0; polylines.len()], vec![false; polylines.len()]);
    let nearest = params.min_gap + params.width_max - GIVES_WAY;
    for stretch in &stretches {
        sides[stretch.polyline] += stretch.count;
        let vertices = &polylines[stretch.polyline].vertices;
        let is_close = |(i, opposite): (usize, Opposite)| (opposite.at - vertices[i].at).length() < nearest;
        close[stretch.polyline] |= stretch.opposites(opposites).any(is_close);
    }
    let thing = |number: usize| {
        let share = sides[number] as f32 / polylines[number].vertices.len() as f32;
        polylines[number].closed && !close[number] && share < MOST
    };
    stretches.retain(|stretch| {
        let loser = if rank[stretch.polyline] == winner(stretch) { stretch.other } else { stretch.polyline };
        stretch.polyline == stretch.other || !thing(loser)
    });
    stretches.sort_by(|a, b| {
        let (first, second) = (winner(a), winner(b));
        let sides = (rank[a.polyline] != first).cmp(&(rank[b.polyline] != second)); // as the winner sees it comes first
        first
            .cmp(&second)
            .then(sides)
            .then(b.saliency.total_cmp(&a.saliency))
            .then((a.polyline, a.from).cmp(&(b.polyline, b.from)))
    });
    let fate = |polyline: &Polyline<Vertex>| Fate {
        moved: vec![None; polyline.vertices.len()],
        gone: vec![false; polyline.vertices.len()],
    };
    let mut fates: Vec<Fate> = polylines.iter().map(fate).collect();
    for stretch in &stretches {
        if rank[stretch.polyline] == winner(stretch) {
            take_middle(polylines, opposites, stretch, &mut fates);
        } else {
            give_way(polylines, opposites, stretch, &mut fates);
        }
    }
    fates
}

/// A stretch goes to the middle; the other side goes. What stronger stretches have left of it must be long enough itself.
fn take_middle(polylines: &[Polyline<Vertex>], opposites: &[Opposites], stretch: &Stretch, fates: &mut [Fate]) {
    let vertices = &polylines[stretch.polyline].vertices;
    let free = |fates: &[Fate], i: usize, j: usize| {
        let (own, other) = (&fates[stretch.polyline], &fates[stretch.other]);
        !own.gone[i] && own.moved[i].is_none() && other.moved[j].is_none()
    };
    let pairs: Vec<(usize, Opposite)> = stretch.opposites(opposites).collect();
    for left in pairs.chunk_by(|a, b| free(fates, a.0, a.1.index) == free(fates, b.0, b.1.index)).collect::<Vec<_>>() {
        let length: f32 = left.windows(2).map(|pair| (vertices[pair[1].0].at - vertices[pair[0].0].at).length()).sum();
        let across: f32 = left.iter().map(|(i, opposite)| (opposite.at - vertices[*i].at).length()).sum();
        if length < MIN_STRETCH * across / left.len() as f32 {
            continue;
        }
        let mut last: Option<usize> = None;
        for &(i, opposite) in left {
            let j = opposite.index;
            if !free(fates, i, j) {
                last = None;
                continue;
            }
            fates[stretch.polyline].moved[i] = Some((opposite.at - vertices[i].at) * 0.5);
            // All that the other side has between the last opposite and this one goes.
            let Fate { moved, gone } = &mut fates[stretch.other];
            for k in last.map_or(j..=j, |last| between(last, j, &polylines[stretch.other])) {
                let k = k % moved.len();
                gone[k] |= moved[k].is_none();
            }
            last = Some(j);
        }
    }
}

/// The vertices from one to another, in a ring the shorter way round, as numbers that may go on beyond its last; the second
/// alone if there are too many.
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
fn give_way(polylines: &[Polyline<Vertex>], opposites: &[Opposites], stretch: &Stretch, fates: &mut [Fate]) {
    for (i, opposite) in stretch.opposites(opposites) {
        let (other, j) = (stretch.other, opposite.index);
        if fates[other].gone[j] || fates[stretch.polyline].moved[i].is_some() {
            continue;
        }
        fates[stretch.polyline].gone[i] = true;
        let way = polylines[stretch.polyline].vertices[i].at - opposite.at;
        fates[other].moved[j].get_or_insert(way * 0.5);
    }
}

/// Whether a ring has for the most part become the middle line of a stronger one: the rest of it would be an arc beside
/// that, which says nothing.
fn is_rest(fate: &Fate) -> bool {
    let share = |count: usize| count as f32 / fate.gone.len().max(1) as f32;
    let (gone, moved) = (fate.gone.iter().filter(|gone| **gone).count(), fate.moved.iter().flatten().count());
    share(gone) >= MOST && share(moved) < 0.2 * MOST
}

/// Stretches of vertices with opposites on the same polyline that are long enough for a bar.
fn stretches(polylines: &[Polyline<Vertex>], opposites: &[Opposites]) -> Vec<Stretch> {
    let mut found = Vec::new();
    for (number, (polyline, opposites)) in polylines.iter().zip(opposites).enumerate() {
        let places = opposites.len();
        let other = |k: usize| opposites[k % places].map(|opposite| opposite.polyline);
        // a ring is gone round from where a stretch begins
        let goes_on = |k: usize| other(k).is_some() && other(k) == other(k + places - 1);
        let start = if polyline.closed { (0..places).find(|&k| !goes_on(k)).unwrap_or(0) } else { 0 };
        let mut k = start;
        while k < start + places {
            let Some(first) = other(k) else {
                k += 1;
                continue;
            };
            let from = k;
            let (mut length, mut across, mut saliency) = (0.0, 0.0, 0.0);
            while k < start + places && other(k) == Some(first) {
                let here = &polyline.vertices[k % places];
                if k > from {
                    let before = &polyline.vertices[(k - 1) % places];
                    let step = (here.at - before.at).length();
                    length += step;
                    saliency += step * here.strength.min(before.strength);
                }
                across += opposites[k % places].map_or(0.0, |opposite| (opposite.at - here.at).length());
                k += 1;
            }
            let count = k - from;
            if length >= MIN_STRETCH * across / count as f32 {
                found.push(Stretch { polyline: number, other: first, from: from % places, count, saliency });
            }
        }
    }
    found
}
