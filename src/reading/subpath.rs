//! Paths as polylines on the sheet.

use lyon::geom::{CubicBezierSegment, QuadraticBezierSegment, point};
use resvg::tiny_skia::{Path, PathSegment, Point};

use crate::units::MmPoint;

/// Farthest that a polyline lies from its curve, mm.
const TOLERANCE: f32 = 0.01;

/// One part of a path.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Subpath {
    /// Its points, curves flattened; a ring of curves does not repeat its first.
    pub(super) points: Vec<MmPoint>,
    /// Those that the path itself names.
    pub(super) named: Vec<MmPoint>,
    /// Whether it goes back to where it began.
    pub(super) closed: bool,
    /// Whether there is a curve in it.
    pub(super) curved: bool,
}

/// A length in mm without the noise of transforms: in whole steps of 0.001 mm.
pub(super) fn clean(mm: f32) -> f32 {
    ((f64::from(mm) * 1000.0).round() / 1000.0) as f32
}

fn at(p: Point) -> MmPoint {
    MmPoint::new(clean(p.x), clean(p.y))
}

/// The parts of a path in mm.
pub(super) fn subpaths(path: &Path) -> Vec<Subpath> {
    let mut all = Vec::new();
    let mut open = Open::default();
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(to) => {
                all.extend(open.finished(false));
                open.begin(to);
            }
            PathSegment::LineTo(to) => open.line(to),
            PathSegment::QuadTo(control, to) => {
                let curve = QuadraticBezierSegment { from: open.here(), ctrl: of(control), to: of(to) };
                curve.for_each_flattened(TOLERANCE, &mut |piece| open.flat.push((piece.to.x, piece.to.y)));
                open.curve(to);
            }
            PathSegment::CubicTo(first, second, to) => {
                let (ctrl1, ctrl2) = (of(first), of(second));
                let curve = CubicBezierSegment { from: open.here(), ctrl1, ctrl2, to: of(to) };
                curve.for_each_flattened(TOLERANCE, &mut |piece| open.flat.push((piece.to.x, piece.to.y)));
                open.curve(to);
            }
            PathSegment::Close => {
                let start = open.flat.first().copied();
                all.extend(open.finished(true));
                // what follows without a move begins where the part began
                if let Some((x, y)) = start {
                    open.begin(Point::from_xy(x, y));
                }
            }
        }
    }
    all.extend(open.finished(false));
    all
}

fn of(p: Point) -> lyon::geom::Point<f32> {
    point(p.x, p.y)
}

/// A part in the making.
#[derive(Default)]
struct Open {
    flat: Vec<(f32, f32)>,
    named: Vec<MmPoint>,
    curved: bool,
}

impl Open {
    fn begin(&mut self, to: Point) {
        *self = Self { flat: vec![(to.x, to.y)], named: vec![at(to)], curved: false };
    }

    fn line(&mut self, to: Point) {
        self.flat.push((to.x, to.y));
        self.named.push(at(to));
    }

    fn curve(&mut self, to: Point) {
        self.curved = true;
        self.named.push(at(to));
    }

    fn here(&self) -> lyon::geom::Point<f32> {
        self.flat.last().map_or(point(0.0, 0.0), |&(x, y)| point(x, y))
    }

    /// Takes the part out; none if it has no length.
    fn finished(&mut self, closed: bool) -> Option<Subpath> {
        let Self { flat, mut named, curved } = std::mem::take(self);
        let mut points: Vec<MmPoint> = flat.into_iter().map(|(x, y)| at(Point::from_xy(x, y))).collect();
        named.dedup();
        if closed && curved && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if named.len() > 1 && named.first() == named.last() {
            named.pop();
        }
        let closed = closed && points.len() > 2;
        (points.len() > 1).then_some(Subpath { points, named, closed, curved })
    }
}
