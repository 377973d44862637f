//! How near traced lines come to the truth. Lengths and distances in pixels of the scene.
//!
//! Traced lines are walked in steps of at most a quarter of a pixel, so every measure is weighted by length. What lies
//! nearer than [`BORDER`] to the picture's border is not judged, traced or true.

use crate::near::Near;
use crate::scene::{P, Scene};
use crate::shapes::SPACING;

/// Width of the strip along the picture's border that is not judged, px.
const BORDER: f64 = 10.0;
/// A traced place farther than this from every true contour is false and says nothing about place, px. It is wider than
/// the tolerance of 1 px so that a detector cannot gain by being just outside.
const GATE: f64 = 2.0;
/// A traced place this near to a true contour is right; a true place this near to a traced line is found, px.
const RIGHT: f64 = 1.0;
/// A chain is a piece of a contour if this much of it lies on the contour, px.
const PIECE: f64 = 3.0;
/// A ring is closed if one closed chain covers this share of it.
const COVERED: f64 = 0.9;

/// A traced line.
#[derive(Debug, Clone, Default)]
pub(crate) struct Traced {
    pub(crate) closed: bool,
    pub(crate) points: Vec<P>,
    pub(crate) strength: Vec<f64>,
}

/// Sums over scenes; the quotients are made at the end.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sums {
    /// Distances of traced places to the truth, those within [`GATE`].
    pub(crate) errors: Vec<f32>,
    pub(crate) true_length: f64,
    pub(crate) found_length: f64,
    pub(crate) traced_length: f64,
    pub(crate) right_length: f64,
    /// Contours that were found at all, and chains on them.
    pub(crate) contours: f64,
    pub(crate) pieces: f64,
    pub(crate) rings: f64,
    pub(crate) closed_rings: f64,
    /// Distances from true corners and junctions to the nearest traced line.
    pub(crate) corners: Vec<f64>,
    pub(crate) junctions: Vec<f64>,
    /// All traced length and the area, px; of use where nothing is true.
    pub(crate) all_length: f64,
    pub(crate) area: f64,
}

impl Sums {
    pub(crate) fn add(&mut self, other: &Self) {
        self.errors.extend(&other.errors);
        self.corners.extend(&other.corners);
        self.junctions.extend(&other.junctions);
        for (to, from) in [
            (&mut self.true_length, other.true_length),
            (&mut self.found_length, other.found_length),
            (&mut self.traced_length, other.traced_length),
            (&mut self.right_length, other.right_length),
            (&mut self.contours, other.contours),
            (&mut self.pieces, other.pieces),
            (&mut self.rings, other.rings),
            (&mut self.closed_rings, other.closed_rings),
            (&mut self.all_length, other.all_length),
            (&mut self.area, other.area),
        ] {
            *to += from;
        }
    }

    /// Root of the mean square distance of traced places to the truth.
    pub(crate) fn rms(&self) -> f64 {
        let squares: f64 = self.errors.iter().map(|&e| f64::from(e).powi(2)).sum();
        (squares / self.errors.len() as f64).sqrt()
    }

    /// The distance that 95 of 100 traced places do not exceed.
    pub(crate) fn p95(&self) -> f64 {
        let mut errors = self.errors.clone();
        let place = (0.95 * errors.len() as f64) as usize;
        if errors.is_empty() {
            return f64::NAN;
        }
        f64::from(*errors.select_nth_unstable_by(place, f32::total_cmp).1)
    }

    /// Mean of a list; not a number if it is empty.
    pub(crate) fn mean(list: &[f64]) -> f64 {
        list.iter().sum::<f64>() / list.len() as f64
    }
}

/// A place on a traced line, standing for `length` of it.
struct Place {
    at: P,
    length: f64,
    chain: usize,
    strength: f64,
}

/// Compares what was traced with the truth about a scene.
pub(crate) fn measure(scene: &Scene, lines: &[Traced]) -> Sums {
    let judged = |p: P| (0..2).all(|i| p[i] >= BORDER && p[i] <= scene.size[i] as f64 - BORDER);
    let all = places(lines);
    let traced: Vec<&Place> = all.iter().filter(|place| judged(place.at)).collect();
    let mut sums = Sums {
        all_length: all.iter().map(|place| place.length).sum(),
        area: (scene.size[0] * scene.size[1]) as f64,
        ..Sums::default()
    };
    if scene.curves.is_empty() {
        return sums;
    }

    let truth: Vec<(P, usize)> =
        scene.curves.iter().enumerate().flat_map(|(c, curve)| curve.points.iter().map(move |&p| (p, c))).collect();
    let near_truth = Near::new(truth.iter().map(|(p, _)| *p).collect(), scene.size, GATE);
    // on[chain][curve]: how much of the chain lies on the curve
    let mut on = vec![vec![0.0; scene.curves.len()]; lines.len()];
    for place in &traced {
        sums.traced_length += place.length;
        let Some((nearest, _)) = near_truth.nearest(place.at) else { continue };
        let distance = distance_to_curve(scene, &truth, nearest, place.at);
        if distance <= GATE {
            sums.errors.push(distance as f32);
        }
        if distance <= RIGHT {
            sums.right_length += place.length;
            on[place.chain][truth[nearest].1] += place.length;
        }
    }

    let near_traced = Near::new(traced.iter().map(|place| place.at).collect(), scene.size, GATE);
    for (c, curve) in scene.curves.iter().enumerate() {
        let (mut length, mut found) = (0.0, 0.0);
        for (i, &p) in curve.points.iter().enumerate() {
            if !judged(p) {
                continue;
            }
            let step = spacing(curve, i);
            length += step;
            if near_traced.nearest(p).is_some_and(|(_, distance)| distance <= scene.tolerance) {
                found += step;
            }
        }
        sums.true_length += length;
        sums.found_length += found;
        let pieces = on.iter().filter(|on| on[c] >= PIECE).count();
        if pieces > 0 {
            sums.contours += 1.0;
            sums.pieces += pieces as f64;
        }
        if curve.closed {
            sums.rings += 1.0;
            let closed = lines.iter().zip(&on).any(|(line, on)| line.closed && on[c] >= COVERED * length);
            sums.closed_rings += f64::from(u8::from(closed));
        }
    }
    sums.corners = scene.corners.iter().map(|&corner| distance_to_lines(&all, corner)).collect();
    sums.junctions = scene.junctions.iter().map(|&at| distance_to_lines(&all, at)).collect();
    sums
}

/// The length that point `i` of a true curve stands for.
fn spacing(curve: &crate::scene::Curve, i: usize) -> f64 {
    let n = curve.points.len();
    let next = if i + 1 < n {
        i + 1
    } else if curve.closed {
        0
    } else {
        return 0.0;
    };
    distance(curve.points[i], curve.points[next])
}

/// Walks lines in steps of at most [`SPACING`].
fn places(lines: &[Traced]) -> Vec<Place> {
    let mut places = Vec::new();
    for (chain, line) in lines.iter().enumerate() {
        for (i, pair) in line.points.windows(2).enumerate() {
            let length = distance(pair[0], pair[1]);
            let steps = (length / SPACING).ceil().max(1.0);
            places.extend((0..steps as usize).map(|k| {
                let t = (k as f64 + 0.5) / steps;
                let mix = |a: f64, b: f64| a + t * (b - a);
                Place {
                    at: [mix(pair[0][0], pair[1][0]), mix(pair[0][1], pair[1][1])],
                    length: length / steps,
                    chain,
                    strength: mix(line.strength[i], line.strength[i + 1]),
                }
            }));
        }
    }
    places
}

/// Exact distance to the two pieces of the true curve that meet in its nearest point.
fn distance_to_curve(scene: &Scene, truth: &[(P, usize)], nearest: usize, p: P) -> f64 {
    let (at, c) = truth[nearest];
    let curve = &scene.curves[c];
    let first = truth.partition_point(|&(_, other)| other < c);
    let (i, n) = (nearest - first, curve.points.len());
    let before = if i > 0 {
        Some(i - 1)
    } else if curve.closed {
        Some(n - 1)
    } else {
        None
    };
    let after = if i + 1 < n {
        Some(i + 1)
    } else if curve.closed {
        Some(0)
    } else {
        None
    };
    let pieces = [before, after].into_iter().flatten().map(|k| distance_to_piece(p, at, curve.points[k]));
    pieces.fold(distance(p, at), f64::min)
}

fn distance_to_lines(places: &[Place], p: P) -> f64 {
    places.iter().map(|place| distance(p, place.at)).fold(f64::INFINITY, f64::min)
}

fn distance(a: P, b: P) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn distance_to_piece(p: P, a: P, b: P) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let t = if square > 0.0 { ((to[0] * along[0] + to[1] * along[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    (to[0] - t * along[0]).hypot(to[1] - t * along[1])
}
