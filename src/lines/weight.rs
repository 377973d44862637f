//! Width by strength, in runs of equal width, with as few points as the tolerance allows.

use super::faint::is_faint;
use super::line::{Line, Run};
use super::params::{LineMedium, Params};
use super::vertex::Vertex;
use crate::geom::polyline::{Polyline, PolylineRef, smooth};
use crate::geom::{crossing, simplify::simplify};
use crate::units::MmPoint;

/// Widths come in steps of this, mm: finer ones cannot be told by touch.
const STEP: f32 = 0.1;
/// Widths are smoothed along the line with this sigma, mm, so that a line swells and fades instead of twitching.
const SMOOTHING: f32 = 2.0;
/// A run is at least this long, mm; what is shorter is drawn with its neighbour's width. The first and the last run of
/// a line may be shorter, where it fades out or is cut.
const MIN_RUN: f32 = 2.0;
/// Farthest that a line may lie from the curve of the vector drawing that it is, mm, beside what is lost by turning
/// that into a polyline: together 0.02.
const EXACT_TOLERANCE: f32 = 0.014;
/// Places of a line with more arc length than this between them, mm, are kept apart by the clearance.
const NEAR: f32 = 12.0;

/// Width of a line at a place of the given strength, mm: it grows with the strength and soon reaches its greatest value
/// (the paper: a repeated thickness is easier to find).
pub(super) fn width(strength: f32, params: &Params) -> f32 {
    let range = (params.full_strength - params.least_strength).max(f32::EPSILON);
    let share = ((strength - params.least_strength) / range).clamp(0.0, 1.0);
    params.width_min + (params.width_max - params.width_min) * share
}

/// The widest of the widths in steps that is no wider than this, mm.
pub(super) fn step_below(width: f32, params: &Params) -> f32 {
    params.width_min + ((width - params.width_min) / STEP).floor() * STEP
}

/// Gives every vertex the width that is drawn there, in steps.
pub(super) fn assign(polyline: &mut Polyline<Vertex>, params: &Params) {
    let arcs = polyline.arc_lengths();
    let widths = smooth(&arcs, polyline.closed, SMOOTHING, |i| [width(polyline.vertices[i].strength, params)]);
    let mut steps: Vec<i32> = widths.iter().map(|[w]| ((w - params.width_min) / STEP).round() as i32).collect();
    if polyline.closed {
        steps.push(steps[0]); // the runs of a ring end where they begin
    }
    for (from, to, step) in runs(&steps, &arcs) {
        for vertex in polyline.vertices.iter_mut().take(to + 1).skip(from) {
            vertex.width = (params.width_min + step as f32 * STEP).min(params.width_max);
        }
    }
}

/// Runs of equal step as (first vertex, last vertex, step), none of the inner ones too short.
fn runs(steps: &[i32], arcs: &[f32]) -> Vec<(usize, usize, i32)> {
    let mut runs: Vec<(usize, usize, i32)> = Vec::new();
    for (i, &step) in steps.iter().enumerate() {
        match runs.last_mut() {
            Some((_, to, last)) if *last == step => *to = i,
            _ => runs.push((i, i, step)),
        }
    }
    let length = |&(from, to, _): &(usize, usize, i32)| arcs[(to + 1).min(arcs.len() - 1)] - arcs[from];
    // the shortest goes first, to the neighbour that it is most like
    while let Some(short) = (1..runs.len().saturating_sub(1))
        .filter(|&k| length(&runs[k]) < MIN_RUN)
        .min_by(|&a, &b| length(&runs[a]).total_cmp(&length(&runs[b])))
    {
        let (from, to, step) = runs.remove(short);
        let (before, after) = (runs[short - 1], runs[short]);
        let closer = ((before.2 - step).abs(), -length(&before)) <= ((after.2 - step).abs(), -length(&after));
        if closer {
            runs[short - 1].1 = to;
        } else {
            runs[short].0 = from;
        }
        // two neighbours may now be alike
        let mut k = short.saturating_sub(1);
        while k + 1 < runs.len() && k <= short {
            if runs[k].2 == runs[k + 1].2 {
                runs[k].1 = runs[k + 1].1;
                runs.remove(k + 1);
            } else {
                k += 1;
            }
        }
    }
    runs
}

/// Width of the piece of a line between two vertices that follow one another: that of the thinner, so that no place is
/// wider than its vertex said when distances were looked at.
pub(super) fn between(a: &Vertex, b: &Vertex) -> f32 {
    a.width.min(b.width)
}

/// The finished line of a polyline whose widths are assigned; none if nothing is left of it. `anchored` tells the
/// vertices that stay, because other lines end there.
pub(super) fn finish(polyline: &Polyline<Vertex>, anchored: &[bool], params: &Params) -> Option<Line> {
    let points: Vec<MmPoint> = polyline.path().map(|vertex| vertex.at).collect();
    if points.len() < 2 {
        return None;
    }
    let exact = polyline.vertices.iter().all(|vertex| vertex.source.is_exact());
    let mut tolerance = if exact { params.tolerance.min(EXACT_TOLERANCE) } else { params.tolerance };
    let mut runs = drawn(polyline, &points, anchored, tolerance);
    // Where a line bends sharply its simplified sides may cross: there it stays nearer to what it was.
    for _ in 0..3 {
        if !crosses_itself(&runs) {
            break;
        }
        tolerance *= 0.25;
        runs = drawn(polyline, &points, anchored, tolerance);
    }
    let own = polyline.mean_strength();
    let strength = match (params.medium, polyline.stroke()) {
        (LineMedium::Dots(heavy), Some(width)) if !is_faint(polyline) => heavy.strength(width, own),
        (LineMedium::Dots(_) | LineMedium::Print, _) => own,
    };
    (!runs.is_empty()).then_some(Line { strength, runs })
}

/// The runs of a line along its path of `points`.
fn drawn(polyline: &Polyline<Vertex>, points: &[MmPoint], anchored: &[bool], tolerance: f32) -> Vec<Run> {
    let mut runs: Vec<(f32, Vec<MmPoint>)> = Vec::new();
    let mut from = 0;
    let width = |i: usize| between(&polyline.vertices[i], &polyline.vertices[(i + 1) % polyline.vertices.len()]);
    for i in 0..points.len() - 1 {
        let last = i + 2 == points.len();
        let same = !last && (width(i + 1) - width(i)).abs() < 0.5 * STEP;
        if same && !anchored[i + 1] {
            continue;
        }
        let kept = simplified(&points[from..=i + 1], tolerance);
        match runs.last_mut() {
            Some((before, path)) if (*before - width(i)).abs() < 0.5 * STEP => path.extend(&kept[1..]),
            _ => runs.push((width(i), kept)),
        }
        from = i + 1;
    }
    runs.into_iter().map(|(width, path)| Run::stroke(width, path)).collect()
}

/// A path with as few points as the tolerance allows, its first and its last among them.
fn simplified(path: &[MmPoint], tolerance: f32) -> Vec<MmPoint> {
    let closed = path.len() > 2 && path.first() == path.last();
    let vertices = &path[..path.len() - usize::from(closed)];
    let mut kept: Vec<MmPoint> =
        simplify(PolylineRef { vertices, closed }, tolerance).into_iter().map(|i| vertices[i]).collect();
    if closed {
        kept.push(vertices[0]);
    }
    kept
}

/// Whether a line crosses itself at a bend.
fn crosses_itself(runs: &[Run]) -> bool {
    let segments: Vec<_> = runs.iter().flat_map(|run| run.polyline().segments()).map(|(a, b)| (*a, *b)).collect();
    segments.iter().enumerate().any(|(i, &segment)| {
        let mut arc = 0.0;
        segments[i + 1..].iter().skip(1).any(|&other| {
            let near = arc <= NEAR;
            arc += (other.1 - other.0).length();
            near && crossing(segment, other).is_some()
        })
    })
}

#[cfg(test)]
mod tests;
