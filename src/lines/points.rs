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

use super::junction::{extend_to, heading};
use super::marks::PointMark;
use super::params::{HEADING, Params, RING_FARTHEST};
use super::vertex::{FoundIn, SPACING, Vertex, nearby};
use crate::geom::nearest_on_segment;
use crate::geom::polygon::{circle_points, roundness};
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, MmVector};

/// A filled point is drawn as many times as broad as the broadest line: sizes that differ by 30 percent are told apart
/// (BANA, as quoted by others), and three is more than any line.
pub(super) const BEAD: f32 = 3.0;
/// A filled point is a piece of its line of this length, mm: with its round ends it is a disc.
const BEAD_LENGTH: f32 = 0.1;
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
}

impl Point {
    /// As it is handed on.
    pub(super) fn mark(&self) -> PointMark {
        PointMark { at: self.at, radius: self.radius, is_filled: self.is_filled }
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
    let mut alone: Vec<Point> = Vec::new();
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
            alone.push(point);
            continue;
        }
        taken[number] = true;
        if again {
            continue;
        }
        for arm in arms {
            if let Approach::End { at_start } = arm.kind {
                extend_to(&mut polylines[arm.line], at_start, point.at);
            }
        }
        points.push(point);
    }
    let mut number = 0;
    polylines.retain(|_| {
        number += 1;
        !taken[number - 1]
    });
    like_those_alone(&mut points, &alone, params);
    points
}

/// Discs that are drawn alike in a picture, such as the towns of a map, are drawn alike on a page: those beside lines
/// are rings, and so are those on lines then, unless hollow points are told from filled ones.
fn like_those_alone(points: &mut [Point], alone: &[Point], params: &Params) {
    let is_hollow = |point: &Point| !point.is_filled;
    if points.iter().chain(alone).any(is_hollow) {
        return;
    }
    let is_like = |point: &Point, other: &Point| (point.radius / other.radius - 1.0).abs() <= SAME_SIZE;
    let is_ring = |other: &Point| !params.hands_marks_on || !params.is_dot(std::f32::consts::TAU * other.radius);
    for point in points {
        point.is_filled = !alone.iter().any(|other| is_like(point, other) && is_ring(other));
    }
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
    };
    (ring.vertices.len() > 3 && is_round).then_some(point)
}

/// Whether a contour is the side of an area: in the middle of a stroke there is no step.
fn has_step(line: &Polyline<Vertex>) -> bool {
    let steps = line.vertices.iter().filter(|vertex| vertex.contrast.iter().any(|step| step.abs() > 0.0));
    2 * steps.count() > line.vertices.len()
}

/// The marks of those points that have room on the lines that are drawn.
#[derive(Debug, Default)]
pub(super) struct DrawnPoints {
    /// Of the line of each filled one its number, and where its bead is.
    beads: Vec<(usize, MmPoint)>,
    /// Where lines end at hollow ones, and how far from their middles, mm.
    holes: Vec<(MmPoint, f32)>,
    /// The rings of those.
    pub(super) rings: Vec<Polyline<Vertex>>,
    /// How many have no room.
    pub(super) lost: usize,
}

/// Draws points on `lines`.
pub(super) fn draw(points: &[Point], lines: &[&Polyline<Vertex>], area: MmRect, params: &Params) -> DrawnPoints {
    let mut drawn = DrawnPoints::default();
    if points.is_empty() {
        return drawn;
    }
    let segments = nearby(lines.iter().copied(), area, params);
    // on the line that goes through it, wherever that was moved
    let place = |point: &Point| {
        let (_, at, segment) = segments.nearest(point.at, RING_FARTHEST + MIDDLE * point.radius, |_| true)?;
        Some((at, segment.line, radius(point, params)))
    };
    let half = 0.5 * params.width_max;
    let mut taken: Vec<(MmPoint, f32)> = Vec::new();
    for point in points {
        let Some((at, line, radius)) = place(point) else {
            drawn.lost += 1;
            continue;
        };
        let is_near = |(other, its): &(MmPoint, f32)| (*other - at).length() < radius + its + params.min_gap;
        let beside = radius + params.min_gap + half;
        let mut near: Vec<u32> = Vec::new();
        segments.around_point(at, beside, |segment| {
            if nearest_on_segment(at, segment.a, segment.b).0 < beside {
                near.push(segment.line);
            }
        });
        let passes = |line: u32| segments.nearest_of_line(at, radius, line).is_some();
        if taken.iter().any(is_near) || !near.into_iter().all(passes) {
            drawn.lost += 1;
            continue;
        }
        taken.push((at, radius));
        if point.is_filled {
            drawn.beads.push((line as usize, at));
        } else {
            drawn.rings.push(ring(point, at, radius - half, params));
            drawn.holes.push((at, radius - half));
        }
    }
    drawn
}

/// Radius of what is drawn for a point, mm, with its ink.
fn radius(point: &Point, params: &Params) -> f32 {
    let half = 0.5 * params.width_max;
    if point.is_filled { BEAD * half } else { point.radius.max(0.5 * params.max_spacing()) + half }
}

fn ring(point: &Point, at: MmPoint, radius: f32, params: &Params) -> Polyline<Vertex> {
    let count = ((std::f32::consts::TAU * radius / SPACING).ceil() as usize).max(12);
    let vertex = |at: MmPoint| Vertex {
        at,
        strength: point.strength.max(params.full_strength),
        contrast: [0.0; 3],
        width: params.width_max,
        source: FoundIn::Vector,
    };
    Polyline { vertices: circle_points(at, radius, count).map(vertex).collect(), closed: true }
}

impl DrawnPoints {
    /// A line, of this number among those that are drawn, with its beads, and in parts where it ends at hollow points;
    /// with what of it is anchored.
    pub(super) fn parts(
        &self,
        number: usize,
        line: &Polyline<Vertex>,
        anchored: &[bool],
        params: &Params,
    ) -> Vec<(Polyline<Vertex>, Vec<bool>)> {
        let (mut line, mut anchored) = (line.clone(), anchored.to_vec());
        for (_, at) in self.beads.iter().filter(|(of, _)| *of == number) {
            add_bead(&mut line, &mut anchored, *at, BEAD * params.width_max);
        }
        match self.holes[..] {
            [] => vec![(line, anchored)],
            // what sticks out of a ring for less than a gap, as the ends of a tick, is felt as a fault in the ring
            ref holes => outside(&line, &anchored, holes, params.min_gap),
        }
    }
}

/// Makes a line as broad as this for a moment.
fn add_bead(line: &mut Polyline<Vertex>, anchored: &mut Vec<bool>, at: MmPoint, width: f32) {
    let distance = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(at, a.at, b.at).0;
    let distances: Vec<f32> = line.segments().map(distance).collect();
    let Some(nearest) = (0..distances.len()).min_by(|&a, &b| distances[a].total_cmp(&distances[b])) else { return };
    let (a, b) = (line.vertices[nearest], line.vertices[(nearest + 1) % line.vertices.len()]);
    let (chord, half) = (b.at - a.at, 0.5 * BEAD_LENGTH);
    let Some(along) = chord.try_normalize() else { return };
    // within the segment, so that the line does not go back
    let middle = (at - a.at).dot(along).clamp(half, (chord.length() - half).max(half));
    let bead = |ahead: f32| Vertex { at: a.at + along * (middle + ahead), width, ..a };
    line.vertices.splice(nearest + 1..nearest + 1, [bead(-half), bead(half)]);
    anchored.splice(nearest + 1..nearest + 1, [true, true]);
}

/// The parts of a line, with what is anchored of it, that lie in none of the holes. An end of the line shorter than
/// `least`, mm, is none of them.
fn outside(
    line: &Polyline<Vertex>,
    anchored: &[bool],
    holes: &[(MmPoint, f32)],
    least: f32,
) -> Vec<(Polyline<Vertex>, Vec<bool>)> {
    let hole_at = |vertex: &Vertex| holes.iter().find(|(at, radius)| (vertex.at - *at).length() < *radius);
    let Some(inside) = line.vertices.iter().position(|vertex| hole_at(vertex).is_some()) else {
        return vec![(line.clone(), anchored.to_vec())];
    };
    let count = line.vertices.len();
    // a ring is gone round from a hole to the same hole
    let (start, steps) = if line.closed { (inside, count + 1) } else { (0, count) };
    let mut parts: Vec<(Vec<Vertex>, Vec<bool>)> = vec![Default::default()];
    let mut before: Option<&Vertex> = None;
    for i in (start..start + steps).map(|i| i % count) {
        let vertex = &line.vertices[i];
        let side = |inner: &Vertex, outer: &Vertex| -> Option<Vertex> {
            let (at, radius) = hole_at(inner)?;
            let away = (outer.at - *at).try_normalize()?;
            Some(Vertex { at: *at + away * *radius, ..*outer })
        };
        let part = parts.last_mut();
        match (before.and_then(hole_at).is_some(), hole_at(vertex).is_some(), part) {
            (true, false, Some(part)) => {
                part.0.extend(before.and_then(|before| side(before, vertex)).into_iter().chain([*vertex]));
                part.1.extend([true, anchored[i]]);
            }
            (false, true, Some(part)) => {
                part.0.extend(before.and_then(|before| side(vertex, before)));
                part.1.resize(part.0.len(), true);
                parts.push(Default::default());
            }
            (false, false, Some(part)) => {
                part.0.push(*vertex);
                part.1.push(anchored[i]);
            }
            // within a hole nothing is drawn
            (true, true, _) | (_, _, None) => {}
        }
        before = Some(vertex);
    }
    let last = parts.len() - 1;
    let parts = parts.into_iter().enumerate().filter(|(_, (vertices, _))| vertices.len() > 1);
    let parts = parts.map(|(number, (vertices, anchored))| (number, Polyline::open(vertices), anchored));
    let is_end = |number: usize| !line.closed && (number == 0 || number == last);
    let stays = |(number, part, anchored): (usize, Polyline<Vertex>, Vec<bool>)| {
        (!is_end(number) || part.length() >= least).then_some((part, anchored))
    };
    parts.filter_map(stays).collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::area;
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
            take(&mut lines, &PARAMS).iter().map(|point| point.is_filled).collect::<Vec<_>>()
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
}
