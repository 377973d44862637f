//! Points on lines: small round shapes of a drawing that mark places on its lines, as the points of a number line, the
//! stations of a route or the corners of a graph.
//!
//! As contours they are too small for lines, and the line ends at their sides, so that there would be a gap in it and
//! nothing more. They are drawn in a size that fingers find:
//!
//! ```text
//!   filled:  ----(@)----  a bead three times as broad as the line, which goes on through it
//!   hollow:  ----( )----  a ring at which the line ends
//! ```

mod drawn;

use super::junction::{extend_to, heading};
use super::marks::PointMark;
use super::params::{HEADING, Params};
use super::series::SERIES;
use super::vertex::Vertex;
use crate::geom::nearest_on_segment;
use crate::geom::polygon::roundness;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmVector};

pub(super) use drawn::{DrawnPoints, draw};

/// A filled point is drawn as many times as broad as the broadest line: sizes that differ by 30 percent are told apart
/// (BANA, as quoted by others), and three is more than any line.
pub(super) const BEAD: f32 = 3.0;
/// The smallest shape that is taken for a point, mm across: in a figure it is a dot, in an overview a sixth of one that
/// has room in the figure.
const SMALLEST: f32 = 0.6;
/// The largest filled point, in distances of two lines: a larger shape has room as it is.
const LARGEST: f32 = 1.25;
/// The largest hollow point, in the same: up to about here the lines that end at a ring would take its place.
const LARGEST_HOLLOW: f32 = 2.5;
/// Area of a point at least, as a share of that of a circle with its circumference: a square has 0.79, an equal-sided
/// triangle, as the head of an arrow, 0.60, a hexagon 0.91.
const ROUND: f32 = 0.85;
/// A line leads to the middle of a point no farther from it than this share of its radius.
const MIDDLE: f32 = 0.4;
/// An end of a line lies no farther from the side of a point than this, mm: in a bitmap the two are found apart.
const BESIDE: f32 = 1.0;
/// Points are of one size if their radii differ by no more than this share.
const SAME_SIZE: f32 = 0.2;
/// A point on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) at: MmPoint,
    /// As it is in the drawing, mm.
    radius: f32,
    is_filled: bool,
    strength: f32,
    /// The line that it is a point of, with others that are alike.
    series: Option<usize>,
    /// Whether it lies beside all lines, and is like others on them.
    is_alone: bool,
}

impl Point {
    /// As it is handed on.
    pub(super) fn mark(&self) -> PointMark {
        PointMark { at: self.at, radius: self.radius, is_filled: self.is_filled, series: self.series }
    }
}

/// Takes the points on lines out of the contours of a drawing. Lines that end at their sides lead to their middles.
pub(super) fn take(polylines: &mut Vec<Polyline<Vertex>>, params: &Params) -> Vec<Point> {
    let is_size = |point: &Point| {
        let largest = if point.is_filled { LARGEST } else { LARGEST_HOLLOW };
        (0.5 * SMALLEST..=0.5 * largest * params.max_spacing()).contains(&point.radius)
    };
    let rings = polylines.iter().enumerate().filter(|(_, line)| line.closed);
    let found = rings.filter_map(|(number, ring)| Some((number, of_ring(ring)?)));
    let found: Vec<(usize, Point)> = found.filter(|(_, point)| is_size(point)).collect();
    let mut is_ring = vec![false; polylines.len()];
    found.iter().for_each(|(number, _)| is_ring[*number] = true);
    let mut taken = vec![false; polylines.len()];
    let mut points: Vec<Point> = Vec::new();
    let mut alone: Vec<(usize, Point)> = Vec::new();
    for (number, point) in found {
        // the outline of a disc beside its stroke
        let again = points.iter().any(|other| (other.at - point.at).length() <= other.radius.max(point.radius));
        let arms: Vec<PointArm> = if again { Vec::new() } else { arms(&point, polylines, &is_ring) };
        // between two points the line may be short
        let is_on_line = arms.len() > 1 || arms.iter().any(|arm| polylines[arm.line].length() >= params.min_length);
        // where one line leads to a shape that has room as it is, the shape is what it points at
        let around = std::f32::consts::TAU * point.radius;
        let has_room = match params.hands_marks_on {
            // without a hole a disc would be a ring
            true => !point.is_filled && !params.is_dot(around),
            false => around >= params.min_length,
        };
        let is_pointed_at = matches!(arms[..], [PointArm { kind: Approach::End { .. }, .. }]);
        if !again && (!is_on_line || has_room && is_pointed_at) {
            alone.push((number, point));
            continue;
        }
        taken[number] = true;
        if again {
            continue;
        }
        for arm in &arms {
            if let Approach::End { at_start } = arm.kind {
                extend_to(&mut polylines[arm.line], at_start, point.at);
            }
        }
        let through = arms.iter().find(|arm| arm.kind == Approach::Through).map(|arm| arm.line);
        points.push(Point { series: through, ..point });
    }
    name_series(&mut points);
    let mut beside = like_those_alone(&mut points, &alone, params);
    beside.retain(|(number, _)| !taken[*number]);
    for (number, point) in beside {
        taken[number] = true;
        // the outline of a disc beside its stroke
        if !points.iter().any(|other| (other.at - point.at).length() <= other.radius) {
            points.push(point);
        }
    }
    let mut number = 0;
    polylines.retain(|_| {
        number += 1;
        !taken[number - 1]
    });
    points
}

/// Of points that are no series each is by itself.
fn name_series(points: &mut [Point]) {
    let all = points.to_vec();
    for point in points {
        let is_of = |other: &&Point| other.series == point.series && is_like(point, other);
        point.series = point.series.filter(|_| all.iter().filter(is_of).count() >= SERIES);
    }
}

/// Whether two points look alike.
fn is_like(point: &Point, other: &Point) -> bool {
    point.is_filled == other.is_filled && (point.radius / other.radius - 1.0).abs() <= SAME_SIZE
}

/// Discs that are drawn alike in a picture, such as the towns of a map, are drawn alike on a page: those beside lines
/// are rings, and so are those on lines then, unless hollow points are told from filled ones. Gives those beside lines
/// that are like others on lines, with their numbers; where lines become dots, these are shapes by themselves.
fn like_those_alone(points: &mut [Point], alone: &[(usize, Point)], params: &Params) -> Vec<(usize, Point)> {
    let on_lines = points.to_vec();
    let of_alone = || alone.iter().map(|(_, point)| *point);
    let is_ring = |other: &Point| !params.hands_marks_on || !params.is_dot(std::f32::consts::TAU * other.radius);
    let are_all_filled = on_lines.iter().copied().chain(of_alone()).all(|point| point.is_filled);
    if are_all_filled {
        for point in points {
            point.is_filled = !of_alone().any(|other| is_like(point, &other) && is_ring(&other));
        }
    }
    let is_shown = |point: &Point| !point.is_filled || are_all_filled;
    let beside =
        alone.iter().filter(|(_, point)| is_shown(point) && on_lines.iter().any(|other| is_like(point, other)));
    let ring = |(number, point): &(usize, Point)| (*number, Point { is_filled: false, is_alone: true, ..*point });
    if params.hands_marks_on { Vec::new() } else { beside.map(ring).collect() }
}

/// A line that comes to a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct PointArm {
    line: usize,
    kind: Approach,
}

/// How it comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Approach {
    Through,
    End { at_start: bool },
}

/// The lines that lead to the middle of a point.
fn arms(point: &Point, polylines: &[Polyline<Vertex>], is_ring: &[bool]) -> Vec<PointArm> {
    let aside = MIDDLE * point.radius;
    let reach = point.radius + BESIDE;
    let mut arms = Vec::new();
    for (line, polyline) in polylines.iter().enumerate().filter(|(line, _)| !is_ring[*line]) {
        let near = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(point.at, a.at, b.at).0 <= reach;
        if polyline.length() < SMALLEST || !polyline.segments().any(near) {
            continue;
        }
        let is_near = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(point.at, a.at, b.at).0 <= aside;
        if polyline.segments().any(is_near) {
            arms.push(PointArm { line, kind: Approach::Through });
            continue;
        }
        for at_start in [true, false].into_iter().filter(|_| !polyline.closed) {
            let tip = if at_start { polyline.vertices.first() } else { polyline.vertices.last() };
            let (Some(tip), Some(heading)) = (tip, heading(polyline, at_start, HEADING)) else {
                continue;
            };
            let to_middle = point.at - tip.at;
            let leads = to_middle.dot(heading) > 0.0 && to_middle.cross(heading).abs() <= aside;
            if to_middle.length() <= reach && leads {
                arms.push(PointArm { line, kind: Approach::End { at_start } });
            }
        }
    }
    arms
}

/// A small round ring.
fn of_ring(ring: &Polyline<Vertex>) -> Option<Point> {
    let count = ring.vertices.len() as f32;
    let at =
        (ring.vertices.iter().fold(MmVector::zero(), |sum, vertex| sum + vertex.at.to_vector()) / count).to_point();
    let twice: f32 = ring.segments().map(|(a, b)| (a.at - at).cross(b.at - at)).sum();
    let (area, length) = (0.5 * twice.abs(), ring.length());
    let is_round = roundness(area, length) >= ROUND;
    let point = Point {
        at,
        radius: (area / std::f32::consts::PI).sqrt(),
        is_filled: has_step(ring),
        strength: ring.mean_strength(),
        series: None,
        is_alone: false,
    };
    (ring.vertices.len() > 3 && is_round).then_some(point)
}

/// Whether a contour is the side of an area: in the middle of a stroke there is no step.
fn has_step(line: &Polyline<Vertex>) -> bool {
    let steps = line.vertices.iter().filter(|vertex| vertex.contrast.iter().any(|step| step.abs() > 0.0));
    2 * steps.count() > line.vertices.len()
}

#[cfg(test)]
mod tests {
    use super::super::tests::area;
    use super::super::vertex::{FoundIn, SPACING};
    use super::*;

    const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

    fn line(points: &[(f32, f32)], closed: bool, step: f32, source: FoundIn) -> Polyline<Vertex> {
        let vertex = |&(x, y): &(f32, f32)| Vertex {
            at: MmPoint::new(x, y),
            strength: 60.0,
            contrast: [step, 0.0, 0.0],
            width: PARAMS.width_max,
            source,
        };
        let mut line = Polyline { vertices: points.iter().map(vertex).collect(), closed };
        line.subdivide(SPACING);
        line
    }

    /// A part of a circle around a place, from one share of a turn to another.
    fn arc(middle: (f32, f32), radius: f32, turns: (f32, f32)) -> Vec<(f32, f32)> {
        let turn = |k: u32| std::f32::consts::TAU * (turns.0 + (turns.1 - turns.0) * k as f32 / 40.0);
        (0..40).map(|k| (middle.0 + radius * turn(k).cos(), middle.1 + radius * turn(k).sin())).collect()
    }

    fn disc(x: f32, step: f32) -> Polyline<Vertex> {
        line(&arc((x, 50.0), 2.0, (0.0, 1.0)), true, step, FoundIn::Vector)
    }

    fn axis(from: f32, to: f32) -> Polyline<Vertex> {
        line(&[(from, 50.0), (to, 50.0)], false, 0.0, FoundIn::Vector)
    }

    #[test]
    fn a_disc_between_two_ends_is_a_point_and_the_line_goes_on_to_its_middle() {
        let mut lines = vec![axis(10.0, 48.0), disc(50.0, 60.0), axis(52.0, 54.5), disc(56.5, 60.0), axis(58.5, 90.0)];
        let points = take(&mut lines, &PARAMS);
        assert!(points.len() == 2 && points.iter().all(|point| point.is_filled), "{points:?}");
        let length: f32 = lines.iter().map(Polyline::length).sum();
        assert!(lines.len() == 3 && (length - 80.0).abs() < 0.05, "{length}");
    }

    #[test]
    fn what_lies_beside_a_line_or_is_pointed_at_or_is_no_disc_stays() {
        let triangle = line(&[(48.0, 48.0), (52.0, 50.0), (48.0, 52.0)], true, 60.0, FoundIn::Vector);
        let beside = line(&arc((50.0, 48.0), 2.0, (0.0, 1.0)), true, 60.0, FoundIn::Vector);
        for ring in [triangle, beside, line(&arc((50.0, 50.0), 4.0, (0.0, 1.0)), true, 60.0, FoundIn::Vector)] {
            let mut lines = vec![axis(10.0, 90.0), ring];
            assert!(take(&mut lines, &PARAMS).is_empty() && lines.len() == 2);
        }
        assert!(take(&mut vec![axis(10.0, 48.0), disc(50.0, 60.0)], &PARAMS).is_empty(), "pointed at");
    }

    #[test]
    fn discs_on_lines_are_rings_where_others_beside_lines_are() {
        let away = |step: f32| line(&arc((60.0, 30.0), 2.0, (0.0, 1.0)), true, step, FoundIn::Vector);
        let taken = |others: &[Polyline<Vertex>]| {
            let mut lines = [&[axis(10.0, 90.0), disc(50.0, 60.0)], others].concat();
            let points = take(&mut lines, &PARAMS);
            points.iter().filter(|point| !point.is_alone).map(|point| point.is_filled).collect::<Vec<_>>()
        };
        assert_eq!(taken(&[]), [true]);
        assert_eq!(taken(&[away(60.0)]), [false], "towns of a map, of which one lies on a river");
        assert_eq!(taken(&[away(60.0), disc(70.0, 0.0)]), [true, false], "hollow points mean something else");
        assert_eq!(taken(&[line(&arc((60.0, 30.0), 2.7, (0.0, 1.0)), true, 60.0, FoundIn::Vector)]), [true]);
    }

    #[test]
    fn a_filled_point_is_a_bead_and_a_hollow_one_a_ring_at_which_the_line_ends() {
        let mut lines = vec![axis(10.0, 90.0), disc(30.0, 60.0), disc(60.0, 0.0)];
        let points = take(&mut lines, &PARAMS);
        let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
        assert!(drawn.rings.len() == 1 && drawn.lost == 0);
        let count = lines[0].vertices.len();
        let parts = drawn.parts(0, &lines[0], &vec![false; count], &PARAMS);
        let [(before, anchored), (after, _)] = &parts[..] else { panic!("{} parts", parts.len()) };
        let radius = 0.5 * PARAMS.max_spacing();
        assert!((before.length() - (50.0 - radius)).abs() < 0.02 && (after.length() - (30.0 - radius)).abs() < 0.02);
        let bead: Vec<f32> = before.vertices.iter().filter(|at| at.width > 4.0).map(|at| at.at.x).collect();
        assert!(matches!(bead[..], [a, b] if (a + b - 60.0).abs() < 0.15), "{bead:?}");
        assert_eq!(anchored.len(), before.vertices.len());
    }

    #[test]
    fn of_a_tick_under_a_hollow_point_nothing_sticks_out() {
        let drawn = |length: f32| {
            let tick = line(&[(60.0, 50.0 - 0.5 * length), (60.0, 50.0 + 0.5 * length)], false, 0.0, FoundIn::Vector);
            let drawn = DrawnPoints { holes: vec![(MmPoint::new(60.0, 50.0), 2.5)], ..DrawnPoints::default() };
            drawn.parts(0, &tick, &vec![false; tick.vertices.len()], &PARAMS).len()
        };
        assert_eq!((drawn(8.0), drawn(40.0)), (0, 2));
    }

    #[test]
    fn points_without_room_are_counted() {
        let mut lines = vec![axis(10.0, 90.0), disc(30.0, 60.0), disc(36.0, 60.0), disc(70.0, 60.0)];
        let points = take(&mut lines, &PARAMS);
        let beside = line(&[(60.0, 55.0), (80.0, 55.0)], false, 0.0, FoundIn::Vector);
        let drawn = draw(&points, &[&lines[0], &beside], area(), &PARAMS);
        // of two that are too near to one another the first is drawn
        assert!(points.len() == 3 && drawn.lost == 2 && drawn.beads.len() == 1, "{drawn:?}");
    }

    #[test]
    fn points_beside_lines_are_drawn_like_those_on_them() {
        let beside = |y: f32| line(&arc((50.0, y), 2.0, (0.0, 1.0)), true, 0.0, FoundIn::Vector);
        let mut lines = vec![axis(10.0, 90.0), disc(30.0, 0.0), beside(70.0), beside(55.0)];
        let points = take(&mut lines, &PARAMS);
        assert!(points.len() == 3 && lines.len() == 1, "{points:?}");
        let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
        let lengths: Vec<f32> = drawn.rings.iter().map(Polyline::length).collect();
        let [on_line, beside] = lengths[..] else { panic!("one is too near to the axis: {lengths:?}") };
        assert!((on_line - beside).abs() < 0.01 && drawn.lost == 1);
        let on_dots = Params { hands_marks_on: true, ..PARAMS };
        let alone = line(&arc((50.0, 70.0), 2.0, (0.0, 1.0)), true, 0.0, FoundIn::Vector);
        let mut lines = vec![axis(10.0, 90.0), disc(30.0, 0.0), alone];
        assert_eq!((take(&mut lines, &on_dots).len(), lines.len()), (1, 2), "there it is a shape");
    }

    #[test]
    fn points_of_a_series_are_drawn_all_or_none() {
        let drawn = |xs: &[f32]| {
            let mut lines = vec![axis(5.0, 95.0)];
            lines.extend(xs.iter().map(|&x| disc(x, 60.0)));
            let points = take(&mut lines, &PARAMS);
            let drawn = draw(&points, &[&lines[0]], area(), &PARAMS);
            (drawn.beads.len(), drawn.lost)
        };
        assert_eq!(drawn(&[10.0, 25.0, 40.0, 55.0, 70.0]), (5, 0));
        assert_eq!(drawn(&[10.0, 15.0, 20.0, 25.0, 30.0]), (0, 5), "every second one would be a special one");
        assert_eq!(drawn(&[10.0, 15.0, 40.0]), (2, 1), "three are no series");
    }
}
