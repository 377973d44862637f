//! How near traced lines come to the truth. Lengths and distances in pixels of the scene.
//!
//! Traced lines are walked in steps of at most a quarter of a pixel, so every measure is weighted by length. What lies
//! nearer than [`BORDER`] to the picture's border is not judged, traced or true.

use crate::scene::{Curve, Family, P, Scene};
use crate::shapes::{SPACING, moved};
use crate::sums::{STEP_CLASS, Sums, rank_correlation};
use tactograph_tools::near::Near;

/// Width of the strip along the picture's border that is not judged, px.
const BORDER: f64 = 10.0;
/// A traced place farther than this from every true contour is false and says nothing about place, px. It is wider than
/// the tolerance of 1 px so that a detector cannot gain by being just outside.
const GATE: f64 = 2.0;
/// A traced place this near to a true contour is right; a true place this near to a traced line is found, px.
const RIGHT: f64 = 1.0;
/// A chain is a piece of a contour if this much of it lies on the contour, px.
const PIECE: f64 = 3.0;
/// How far around a junction its branches are looked at, px.
const BRANCH: f64 = 8.0;
/// Strength is compared with the true step by the means over stretches of a contour of about this length, px: a line's
/// width, which is made of it, is smoothed along the line as well.
const STRETCH: f64 = 10.0;
/// A ring is closed if one closed chain covers this share of it.
const COVERED: f64 = 0.9;

/// A traced line.
#[derive(Debug, Clone, Default)]
pub(crate) struct Traced {
    pub(crate) closed: bool,
    pub(crate) points: Vec<P>,
    pub(crate) strength: Vec<f64>,
}

/// A place on a traced line, standing for `length` of it.
struct Place {
    at: P,
    length: f64,
    chain: usize,
    strength: f64,
}

/// Sums over the found places of a stretch of a true contour.
struct Stretch {
    /// Which contour, and which of its stretches.
    number: (usize, usize),
    places: f64,
    step: f64,
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
    let found = |p: P, tolerance: f64| near_traced.nearest(p).filter(|(_, distance)| *distance <= tolerance);
    let mut steps: Vec<Stretch> = Vec::new();
    for (c, curve) in scene.curves.iter().enumerate() {
        let mut length = 0.0;
        for (i, &p) in curve.points.iter().enumerate().filter(|(_, p)| judged(**p)) {
            let spacing = spacing(curve, i);
            length += spacing;
            let class = (curve.contrast[i] / STEP_CLASS).round() as usize;
            let class = &mut sums.by_step[class.min(23)];
            class[0] += spacing;
            if let Some((place, _)) = found(p, scene.tolerance) {
                sums.found_length += spacing;
                class[1] += spacing;
                let number = (c, (i as f64 * SPACING / STRETCH) as usize);
                if steps.last().is_none_or(|stretch| stretch.number != number) {
                    steps.push(Stretch { number, places: 0.0, step: 0.0, strength: 0.0 });
                }
                if let Some(stretch) = steps.last_mut() {
                    stretch.places += 1.0;
                    stretch.step += curve.contrast[i];
                    stretch.strength += traced[place].strength;
                }
            }
        }
        sums.true_length += length;
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
    if scene.family == Family::Ramp {
        let pairs: Vec<_> = steps.iter().map(|s| (s.step / s.places, s.strength / s.places)).collect();
        sums.ranks.push(if pairs.len() > 5 { rank_correlation(&pairs) } else { 0.0 });
    }
    sums.corners = scene.corners.iter().map(|&corner| distance_to_lines(&all, corner)).collect();
    sums.junctions = scene.junctions.iter().map(|junction| distance_to_lines(&all, junction.at)).collect();
    for junction in &scene.junctions {
        for along in &junction.branches {
            let places = (0..(BRANCH / SPACING) as usize).map(|i| (i as f64 + 0.5) * SPACING);
            let missing = places.filter(|&t| found(moved(junction.at, *along, t, 0.0), RIGHT).is_none()).count();
            sums.branches.push(missing as f64 * SPACING);
        }
    }
    sums
}

/// The length that point `i` of a true curve stands for.
fn spacing(curve: &Curve, i: usize) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Fill;
    use crate::shapes::{ellipse, whole_line};

    fn close(got: f64, want: f64, within: f64) {
        assert!((got - want).abs() <= within, "{got} is not {want}");
    }

    /// A straight edge at y = 50 in a sheet of 100 x 100, of which x and y from 10 to 90 are judged.
    fn straight() -> Scene {
        let truth = whole_line([50.0, 50.0], [1.0, 0.0], [100, 100]);
        Scene::new(String::new(), Family::Straight, [100, 100], Fill::grey(0.0)).contour(truth, false, 40.0)
    }

    fn line(points: &[P]) -> Traced {
        Traced { closed: false, points: points.to_vec(), strength: vec![1.0; points.len()] }
    }

    #[test]
    fn a_line_beside_the_truth_is_off_by_its_distance() {
        let sums = measure(&straight(), &[line(&[[0.0, 50.3], [100.0, 50.3]])]);
        close(sums.rms(), 0.3, 1e-6);
        close(sums.p95(), 0.3, 1e-6);
        close(sums.found_length / sums.true_length, 1.0, 1e-9);
        close(sums.right_length / sums.traced_length, 1.0, 1e-9);
        close(sums.true_length, 80.0, 0.3);
        close(sums.traced_length, 80.0, 0.3);
        close(sums.pieces / sums.contours, 1.0, 0.0);
    }

    #[test]
    fn gaps_cost_recall_and_false_lines_precision() {
        let lines = [
            line(&[[0.0, 50.0], [40.0, 50.0]]),
            line(&[[60.0, 50.0], [90.0, 50.0]]),
            line(&[[20.0, 20.0], [40.0, 20.0]]),
        ];
        let sums = measure(&straight(), &lines);
        close(sums.found_length / sums.true_length, 62.0 / 80.0, 0.01); // a pixel beyond each end counts as found
        close(sums.right_length / sums.traced_length, 60.0 / 80.0, 0.01);
        close(sums.pieces / sums.contours, 2.0, 0.0);
    }

    #[test]
    fn a_ring_is_closed_only_if_one_closed_chain_covers_it() {
        let (_, truth) = ellipse([50.0, 50.0], 30.0, 30.0, [1.0, 0.0]);
        let scene = Scene::new(String::new(), Family::LargeDisc, [100, 100], Fill::grey(0.0)).contour(
            truth.clone(),
            true,
            40.0,
        );
        let mut ring = line(&truth);
        ring.points.push(truth[0]);
        ring.strength.push(1.0);
        for closed in [false, true] {
            let sums = measure(&scene, &[Traced { closed, ..ring.clone() }]);
            close(sums.closed_rings / sums.rings, f64::from(u8::from(closed)), 0.0);
            close(sums.true_length, std::f64::consts::TAU * 30.0, 0.01);
        }
        let half = Traced { closed: true, points: ring.points[..200].to_vec(), strength: vec![1.0; 200] };
        close(measure(&scene, &[half]).closed_rings, 0.0, 0.0);
    }
}
