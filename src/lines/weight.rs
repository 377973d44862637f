//! Width by strength, in runs of equal width, with as few points as the tolerance allows.

use super::{Line, Params, Run, Trail};
use crate::geom::polyline::{arc_lengths, smooth};
use crate::geom::simplify::simplify;
use crate::units::MmPoint;

/// Widths come in steps of this, mm: finer ones cannot be told by touch.
const STEP: f32 = 0.1;
/// Widths are smoothed along the line with this sigma, mm, so that a line swells and fades instead of twitching.
const SMOOTHING: f32 = 2.0;
/// A run is at least this long, mm; what is shorter is drawn with its neighbour's width. The first run of a line may be
/// shorter.
const MIN_RUN: f32 = 2.0;

/// Width of a line at a place of the given strength, mm: it grows with the strength and soon reaches its greatest value
/// (the paper: a repeated thickness is easier to find).
pub(super) fn width(strength: f32, params: &Params) -> f32 {
    let range = (params.full_strength - params.least_strength).max(f32::EPSILON);
    let share = ((strength - params.least_strength) / range).clamp(0.0, 1.0);
    params.width_min + (params.width_max - params.width_min) * share
}

/// The finished line of a trail; none if nothing is left of it.
pub(super) fn finish(trail: &Trail, params: &Params) -> Option<Line> {
    let points = trail.points();
    if points.len() < 2 {
        return None;
    }
    let arcs = arc_lengths(&points);
    let widths = smooth(&arcs, trail.closed, SMOOTHING, |i| [width(trail.vertices[i].strength, params)]);
    let steps: Vec<i32> = widths.iter().map(|[w]| (w / STEP).round() as i32).collect();
    let runs = runs(&steps, &arcs)
        .into_iter()
        .map(|(from, to, step)| Run {
            width: (step as f32 * STEP).clamp(params.width_min, params.width_max),
            points: thinned(&points[from..=to], params.tolerance),
        })
        .filter(|run| run.points.len() > 1)
        .collect::<Vec<_>>();
    (!runs.is_empty()).then(|| Line { strength: trail.mean_strength(), runs })
}

fn thinned(points: &[MmPoint], tolerance: f32) -> Vec<MmPoint> {
    simplify(points, tolerance).into_iter().map(|i| points[i]).collect()
}

/// Runs of equal width step as (first point, last point, step); neighbours share their point.
fn runs(steps: &[i32], arcs: &[f32]) -> Vec<(usize, usize, i32)> {
    let mut runs: Vec<(usize, usize, i32)> = Vec::new();
    for (i, &width) in steps[..steps.len() - 1].iter().enumerate() {
        match runs.last_mut() {
            // a run goes on until it is long enough; the first may be short, as the line's end may fade
            Some((_, to, step)) if *step == width => *to = i + 1,
            Some((from, to, _)) if arcs[*to] - arcs[*from] < MIN_RUN && *from > 0 => *to = i + 1,
            _ => runs.push((i, i + 1, width)),
        }
    }
    if let [.., before, last] = runs.as_mut_slice()
        && arcs[last.1] - arcs[last.0] < MIN_RUN
    {
        before.1 = last.1;
        runs.pop();
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lines::Vertex;

    fn params() -> Params {
        Params {
            width_min: 0.7,
            width_max: 1.5,
            least_strength: 10.0,
            full_strength: 30.0,
            min_length: 8.0,
            min_gap: 3.2,
            join_gap: 3.0,
            smoothing: 0.4,
            tolerance: 0.05,
        }
    }

    #[test]
    fn width_saturates_early_and_never_falls() {
        let widths: Vec<f32> = (0..100).map(|s| width(s as f32, &params())).collect();
        assert!(widths.is_sorted());
        assert!((widths[10] - 0.7).abs() < 1e-6 && (widths[30] - 1.5).abs() < 1e-6 && (widths[99] - 1.5).abs() < 1e-6);
    }

    #[test]
    fn a_fading_edge_is_drawn_in_runs_that_touch_and_thin_out() {
        let vertices = (0..=300)
            .map(|i| Vertex {
                at: MmPoint::new(i as f32 * 0.2, 5.0),
                strength: 40.0 - i as f32 * 0.1,
                step: [1.0, 0.0, 0.0],
            })
            .collect();
        let line = finish(&Trail { vertices, closed: false }, &params()).unwrap();
        assert!(line.runs.len() > 4);
        for pair in line.runs.windows(2) {
            assert_eq!(pair[0].points.last(), pair[1].points.first());
            assert!(pair[0].width > pair[1].width);
        }
        assert!((line.length() - 60.0).abs() < 0.01);
    }
}
