//! Curves become polylines: outlines of filled paths, centre lines of thin strokes, both sides of wide ones.

use lyon::geom::{CubicBezierSegment, QuadraticBezierSegment, point};
use resvg::tiny_skia::{Path, PathSegment, Point};

use super::proposal::Proposal;
use crate::geom::polygon::{area, roundness};
use crate::geom::polyline::Polyline;
use crate::raster::vector::PaintedPath;
use crate::units::{PxPoint, PxVector, Size};

/// Distance of the points of a contour, px: the pixels are asked at the middle between two of them.
const SPACING: f32 = 1.0;
/// Farthest that a polyline lies from its curve, px: on a page of 4 px/mm, 0.005 mm.
const TOLERANCE: f32 = 0.02;
/// A path shorter than this is not seen, px.
const SHORTEST: f32 = 1.0;
/// What is filled and nowhere wider than this, px, is not seen: documents fill lines too, as those of a grid, which
/// have no inside. What is seen there is the stroke.
const FLAT: f32 = 0.01;
/// A line longer than this, in widths and heights of the picture together, has points only where it is in sight.
/// Outlines of whole coasts are shorter.
const FAR: f32 = 8.0;
/// What a path may reach beyond the picture and still be looked at, px.
const MARGIN: f32 = 2.0;

/// All that paths of a drawing propose: strokes first, since of a filled and stroked area the stroke is the contour.
pub(super) fn proposals<'p>(
    paths: impl IntoIterator<Item = &'p PaintedPath>,
    widest_stroke: f32,
    size: Size,
) -> Vec<Proposal> {
    let mut strokes = Vec::new();
    let mut outlines = Vec::new();
    for PaintedPath { path, stroke, dashed, filled_alike, .. } in paths {
        match stroke {
            Some(stroke) if stroke.width <= widest_stroke => {
                let of_path = of_path(path, Some(stroke.width), size);
                if *filled_alike && of_path.iter().all(is_round) {
                    let sides = path.stroke(stroke, 1.0);
                    outlines.extend(sides.iter().flat_map(|sides| self::of_path(sides, None, size)));
                    continue;
                }
                strokes.extend(of_path.into_iter().map(|proposal| Proposal { dashed: *dashed, ..proposal }));
            }
            Some(stroke) => {
                let sides = path.stroke(stroke, 1.0);
                outlines.extend(sides.iter().flat_map(|sides| of_path(sides, None, size)));
            }
            None => outlines.extend(of_path(path, None, size)),
        }
    }
    strokes.append(&mut outlines);
    strokes
}

/// A shape at least so round is a disc: of one with an outline of its own colour the contour is the outer side of that.
/// A square has 0.79: those of a board share their borders.
const ROUND: f32 = 0.85;

fn is_round(Proposal { line, .. }: &Proposal) -> bool {
    line.closed && roundness(area(&line.vertices), line.length()) >= ROUND
}

/// The parts of a path that is drawn with a stroke of this width, px, or else filled; those of a filled one are all
/// closed.
fn of_path(path: &Path, stroke: Option<f32>, size: Size) -> Vec<Proposal> {
    let bounds = path.bounds();
    let margin = MARGIN + stroke.unwrap_or(0.0);
    let seen = bounds.right() >= -margin
        && bounds.bottom() >= -margin
        && bounds.left() <= size.width as f32 + margin
        && bounds.top() <= size.height as f32 + margin;
    if !seen {
        return Vec::new();
    }
    let is_seen = |line: &Polyline<PxPoint>| line.length() >= SHORTEST && (stroke.is_some() || !is_flat(line));
    let lines = polylines(path, stroke.is_none()).into_iter().filter(is_seen);
    lines
        .map(|mut line| {
            subdivide(&mut line, margin, size);
            Proposal { line, stroke, dashed: false }
        })
        .collect()
}

/// Whether all points lie on one straight line.
fn is_flat(line: &Polyline<PxPoint>) -> bool {
    let Some(&first) = line.vertices.first() else { return true };
    let offsets = || line.vertices.iter().map(|at| *at - first);
    let farthest = offsets().max_by(|a, b| a.square_length().total_cmp(&b.square_length()));
    let along = farthest.and_then(PxVector::try_normalize).unwrap_or_default();
    offsets().all(|offset| along.cross(offset).abs() <= FLAT)
}

/// Puts points along a line. Of one that is far longer than the picture is large only what is in sight gets any: a side
/// of a rectangle that is a billion pixels high would take more memory than there is.
fn subdivide(line: &mut Polyline<PxPoint>, margin: f32, size: Size) {
    if line.length() <= FAR * (size.width + size.height) as f32 {
        line.subdivide(SPACING);
        return;
    }
    let mut vertices = Vec::new();
    for (&a, &b) in line.segments() {
        vertices.push(a);
        let Some([enter, leave]) = in_sight(a, b, margin, size) else { continue };
        let mut part = Polyline::open(vec![enter, leave]);
        part.subdivide(SPACING);
        vertices.extend(part.vertices);
        vertices.pop_if(|last| *last == b); // it comes with the next segment
    }
    if !line.closed {
        vertices.extend(line.vertices.last());
    }
    vertices.dedup();
    line.vertices = vertices;
}

/// Where a segment enters the picture with its margin, and where it leaves it (Liang and Barsky 1984). In f64, as of
/// places a billion pixels away f32 knows only every 64th.
fn in_sight(a: PxPoint, b: PxPoint, margin: f32, size: Size) -> Option<[PxPoint; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for [start, end, side] in [[a.x, b.x, size.width as f32], [a.y, b.y, size.height as f32]] {
        let [start, end, low, high] = [start, end, -margin, side + margin].map(f64::from);
        let extent = end - start;
        if extent.abs() <= f64::MIN_POSITIVE {
            if start < low || start > high {
                return None;
            }
            continue;
        }
        let (one, other) = ((low - start) / extent, (high - start) / extent);
        from = from.max(one.min(other));
        to = to.min(one.max(other));
    }
    let at = |share: f64| {
        let on = |a: f32, b: f32| (f64::from(a) + share * (f64::from(b) - f64::from(a))) as f32;
        PxPoint::new(on(a.x, b.x), on(a.y, b.y))
    };
    (from <= to).then(|| [if from > 0.0 { at(from) } else { a }, if to < 1.0 { at(to) } else { b }])
}

/// The parts of a path as polylines.
fn polylines(path: &Path, filled: bool) -> Vec<Polyline<PxPoint>> {
    let mut lines = Vec::new();
    let mut points: Vec<PxPoint> = Vec::new();
    let at = |p: Point| PxPoint::new(p.x, p.y);
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(to) => {
                lines.extend(polyline(std::mem::take(&mut points), filled));
                points.push(at(to));
            }
            PathSegment::LineTo(to) => points.push(at(to)),
            PathSegment::QuadTo(control, to) => {
                let from = points.last().copied().unwrap_or(at(to));
                let curve = QuadraticBezierSegment {
                    from: point(from.x, from.y),
                    ctrl: point(control.x, control.y),
                    to: point(to.x, to.y),
                };
                curve.for_each_flattened(TOLERANCE, &mut |piece| points.push(PxPoint::new(piece.to.x, piece.to.y)));
            }
            PathSegment::CubicTo(first, second, to) => {
                let from = points.last().copied().unwrap_or(at(to));
                let curve = CubicBezierSegment {
                    from: point(from.x, from.y),
                    ctrl1: point(first.x, first.y),
                    ctrl2: point(second.x, second.y),
                    to: point(to.x, to.y),
                };
                curve.for_each_flattened(TOLERANCE, &mut |piece| points.push(PxPoint::new(piece.to.x, piece.to.y)));
            }
            PathSegment::Close => {
                let start = points.first().copied();
                lines.extend(polyline(std::mem::take(&mut points), true));
                // what follows without a move begins where the part began
                points.extend(start);
            }
        }
    }
    lines.extend(polyline(points, filled));
    lines
}

/// A polyline through points that are not the same one after the other.
fn polyline(mut points: Vec<PxPoint>, closed: bool) -> Option<Polyline<PxPoint>> {
    points.dedup();
    if !closed {
        return (points.len() > 1).then(|| Polyline::from_path(points));
    }
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    match points.len() {
        0 | 1 => None,
        2 => Some(Polyline::open(points)),
        _ => Some(Polyline { vertices: points, closed: true }),
    }
}

#[cfg(test)]
mod tests;
