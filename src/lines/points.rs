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
//!
//! Filled ones beside lines that are many and alike, as the points of a scatter plot, are small discs ([`cloud`]).

mod by_place;
mod cloud;
mod drawn;
mod point;
mod room;

use std::f32::consts::TAU;
use std::slice;

use self::by_place::{LineIndex, TakenPoints};
use self::cloud::scattered;
use self::point::{MAGNIFIED, MIDDLE, SOLID, disc_radius, is_drawn_twice, is_like};
use super::lead_on::{extend_to, heading};
use super::marks::SERIES;
use super::params::{HEADING, Params};
use super::vertex::{FoundIn, Tip, Vertex};
use crate::geom::polygon::roundness;
use crate::geom::polyline::{Blend, Polyline};
use crate::geom::{circle, nearest_on_segment};
use crate::units::{MmPoint, MmVector};

pub(super) use drawn::{DrawnPoints, draw};
pub(super) use point::Point;
pub(super) use room::make_room;

/// A filled point is drawn as many times as broad as the broadest line: sizes that differ by 30 percent are told apart
/// (BANA, as quoted by others), and three is more than any line.
pub(super) const BEAD: f32 = 3.0;
/// The smallest shape that is taken for a point, mm across: in a figure it is a dot, in an overview a sixth of one that
/// has room in the figure.
const SMALLEST: f32 = 0.6;
/// The largest filled point, in distances of two lines: a larger shape has room as it is.
const LARGEST: f32 = 1.25;
/// Where lines become dots, a filled point on a line is one as well if it is less broad than so many steps: a ring in
/// its place has no hollow. Measured on a pin display, where none was drawn at 3.6 steps, and one at 3.8; taken to hold
/// on all grids of dots, as it is counted in their steps.
const LEAST_HOLLOW: f32 = 3.75;
/// The largest hollow point, in the same: up to about here the lines that end at a ring would take its place.
pub(crate) const LARGEST_HOLLOW: f32 = 2.5;
/// Area of a point at least, as a share of that of a circle with its circumference: a square has 0.79, an equal-sided
/// triangle, as the head of an arrow, 0.60, a hexagon 0.91.
const ROUND: f32 = 0.85;
/// The same of a circle: an ellipse of 5 to 4 has 0.98, one of 3 to 2, as an eye, 0.94.
const CIRCLE: f32 = 0.98;
/// An end of a line lies no farther from the side of a point, or of another line, than this, mm: in a bitmap the two
/// are found apart.
const FROM_SIDE: f32 = 1.0;
/// A circle, or a part of one, keeps to it within this share of its radius.
const FROM_CIRCLE: f32 = 0.1;
/// Least part of a circle that is seen of a point which others hide in part, in turns; and least of one arc of it, as a
/// line that leads over it may divide them: of shorter ones the circle is not known.
const LEAST_ARC: f32 = 0.4;
const LEAST_PIECE: f32 = 0.1;
/// A ring that goes round in steps of a grid of dots, and of which others may hide a part, is at least so many times as
/// long as the shortest line.
const LEAST_RING: f32 = 1.5;

/// Takes the points on lines out of the contours of a drawing. Lines that end at their sides lead to their middles.
pub(super) fn take(polylines: &mut Vec<Polyline<Vertex>>, params: &Params) -> Vec<Point> {
    let found = found(polylines, params);
    if found.is_empty() {
        return Vec::new();
    }
    let mut is_ring = vec![false; polylines.len()];
    found.iter().for_each(|(number, _)| is_ring[*number] = true);
    let mut taken = vec![false; polylines.len()];
    let mut points = TakenPoints::none_of(&found, params);
    let mut lines = LineIndex::of(polylines, params);
    let (mut alone, mut pointed_at, mut by_itself) = (Vec::new(), Vec::new(), Vec::new());
    let (signs, found): (Vec<_>, Vec<_>) = found.into_iter().partition(|(_, point)| point.is_sign);
    for (number, point) in found {
        // the outline of a disc beside its stroke
        let again = points.has(&point);
        let arms: Vec<PointArm> = if again { Vec::new() } else { arms(&point, polylines, &lines, &is_ring) };
        if !again && arms.is_empty() && is_by_itself(&point, polylines, &lines, &is_ring, params) {
            by_itself.push((number, point));
        }
        // between two points the line may be short
        let is_on_line = arms.len() > 1 || arms.iter().any(|arm| polylines[arm.line].length() >= params.min_length);
        if is_too_large(&point, params) && !(is_on_line && is_without_hollow(&point, params)) {
            if params.on_dots() {
                arms.iter().for_each(|arm| arm.end_at_side(&point, polylines));
            }
            continue;
        }
        match arms[..] {
            // where one line leads to a shape that has room as it is, the shape is what it points at
            [arm @ PointArm { kind: Approach::End { .. }, .. }] if is_on_line && has_room(&point, params) => {
                pointed_at.push((number, point, arm));
                continue;
            }
            _ if !again && !is_on_line => {
                alone.push((number, point));
                continue;
            }
            _ => {}
        }
        taken[number] = true;
        if again {
            continue;
        }
        for arm in &arms {
            if let Some(tip) = arm.lead_to(point.at, polylines) {
                lines.lead_on(arm.line, tip, point.at);
            }
        }
        let through = arms.iter().find(|arm| arm.kind == Approach::Through).map(|arm| arm.line);
        points.push(number, Point { series: through, ..point });
    }
    alone.extend(take_leaves(pointed_at, &mut points, &mut taken, polylines, params));
    name_series(&mut points.all);
    let beside = beside_lines(&mut points.all, alone, &by_itself, polylines, params);
    take_others(beside, &mut points, &mut taken);
    take_others(signs, &mut points, &mut taken);
    let mut taken = taken.into_iter();
    polylines.retain(|_| taken.next() == Some(false));
    points.all
}

/// Takes those points that have not been taken, each place once.
fn take_others(found: Vec<(usize, Point)>, points: &mut TakenPoints, taken: &mut [bool]) {
    for (number, point) in found {
        if !std::mem::replace(&mut taken[number], true) && !points.has(&point) {
            points.push(number, point);
        }
    }
}

/// Whether a shape has room as it is: where one line leads to it, it is what the line points at.
fn has_room(point: &Point, params: &Params) -> bool {
    let around = TAU * point.radius;
    match params.on_dots() {
        // without a hole a disc would be a ring
        true => !point.is_filled && !params.is_dot(around),
        false => around >= params.min_length,
    }
}

/// The points beside lines, with their numbers, of those that are alone and those that are by themselves; some may be
/// there twice. On lines, those like them are drawn alike.
fn beside_lines(
    points: &mut [Point],
    mut alone: Vec<(usize, Point)>,
    by_itself: &[(usize, Point)],
    polylines: &[Polyline<Vertex>],
    params: &Params,
) -> Vec<(usize, Point)> {
    let mut beside = scattered(points, &alone, polylines, params);
    let mut is_scattered = vec![false; polylines.len()];
    beside.iter().for_each(|(number, _)| is_scattered[*number] = true);
    alone.retain(|(number, _)| !is_scattered[*number]);
    beside.extend(like_those_alone(points, &alone, params));
    beside.extend(by_themselves(by_itself, params));
    beside
}

/// The round shapes among lines that are as small as points, with their numbers.
fn found(polylines: &[Polyline<Vertex>], params: &Params) -> Vec<(usize, Point)> {
    let is_size = |point: &Point| {
        (0.5 * SMALLEST..=0.5 * LARGEST_HOLLOW * params.max_spacing()).contains(&point.radius)
            && (params.on_dots() || !is_too_large(point, params))
    };
    let rings = polylines.iter().enumerate().filter(|(_, line)| line.closed);
    let found = rings.filter_map(|(number, ring)| Some((number, of_ring(ring)?)));
    let mut found: Vec<(usize, Point)> = found.filter(|(_, point)| is_size(point)).collect();
    if !params.on_dots() {
        found.extend(hidden_in_part(polylines, &found));
    }
    found
}

/// Whether a filled shape is too large for a point on a line: it has room as it is.
fn is_too_large(point: &Point, params: &Params) -> bool {
    point.is_filled && point.radius > 0.5 * LARGEST * params.max_spacing()
}

/// Whether a ring of dots in its place would have no hollow.
fn is_without_hollow(point: &Point, params: &Params) -> bool {
    2.0 * point.radius < LEAST_HOLLOW * params.dot_pitch()
}

/// Filled points that others of their kind hide in part, or are one with, as two of a scatter plot that overlap: a
/// large part of their outline is seen. Only where whole ones are many, as anything else has an arc.
fn hidden_in_part(polylines: &[Polyline<Vertex>], whole: &[(usize, Point)]) -> Vec<(usize, Point)> {
    let is_of_many = |point: &Point| {
        let alike = || whole.iter().filter(|(_, other)| is_like(point, other)).take(SERIES).count();
        point.is_filled && point.is_exact && alike() == SERIES
    };
    let open = polylines.iter().enumerate().filter(|(_, line)| !line.closed);
    let arcs = open.filter_map(|(number, line)| Some((number, of_arc(line).filter(|(_, arc)| is_of_many(arc))?)));
    let arcs: Vec<(usize, (f32, Point))> = arcs.collect();
    let seen = |point: &Point| -> f32 {
        let is_of_it = |other: &Point| is_like(point, other) && is_drawn_twice(point, slice::from_ref(other));
        arcs.iter().filter(|(_, (_, other))| is_of_it(other)).map(|(_, (turns, _))| turns).sum()
    };
    arcs.iter()
        .filter(|(_, (_, point))| seen(point) >= LEAST_ARC)
        .map(|(number, (_, point))| (*number, *point))
        .collect()
}

/// Takes those of the shapes that one line points at that are like points on lines, as the leaves of a tree are like
/// its other nodes. Gives the others.
fn take_leaves(
    pointed_at: Vec<(usize, Point, PointArm)>,
    points: &mut TakenPoints,
    taken: &mut [bool],
    polylines: &mut [Polyline<Vertex>],
    params: &Params,
) -> Vec<(usize, Point)> {
    let on_lines = points.all.clone();
    let mut others = Vec::new();
    for (number, point, arm) in pointed_at {
        if params.on_dots() || !on_lines.iter().any(|other| is_like(&point, other)) {
            others.push((number, point));
            continue;
        }
        taken[number] = true;
        if !points.has(&point) {
            arm.lead_to(point.at, polylines);
            points.push(number, point);
        }
    }
    others
}

/// Of points that are no series each is by itself.
fn name_series(points: &mut [Point]) {
    let all = points.to_vec();
    for point in points {
        let is_of = |other: &&Point| other.series == point.series && is_like(point, other);
        point.series = point.series.filter(|_| all.iter().filter(is_of).take(SERIES).count() == SERIES);
    }
}

/// Discs that are drawn alike in a picture, such as the towns of a map, are drawn alike on a page: those beside lines
/// are rings, and so are those on lines then, unless hollow points are told from filled ones. Gives those beside lines
/// that are like others on lines, with their numbers; where lines become dots, these are shapes by themselves.
fn like_those_alone(points: &mut [Point], alone: &[(usize, Point)], params: &Params) -> Vec<(usize, Point)> {
    let on_lines = points.to_vec();
    let of_alone = || alone.iter().map(|(_, point)| *point);
    let is_ring = |other: &Point| !params.on_dots() || !params.is_dot(TAU * other.radius);
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
    if params.on_dots() { Vec::new() } else { beside.map(ring).collect() }
}

/// Whether a round shape to which no line leads is a sign by itself if there is room for it: apart from all lines, as
/// it may have to move away from them otherwise. Where lines become dots, one too small for a line is that in any case,
/// and other small shapes do not count, as those of one size are to be alike.
fn is_by_itself(
    point: &Point,
    polylines: &[Polyline<Vertex>],
    lines: &LineIndex,
    is_ring: &[bool],
    params: &Params,
) -> bool {
    let reach = point.radius + params.max_spacing();
    let is_own = |line: &Polyline<Vertex>| of_ring(line).is_some_and(|other| is_drawn_twice(&other, &[*point]));
    let is_near = |line: &Polyline<Vertex>| {
        line.segments().any(|(a, b)| nearest_on_segment(point.at, a.at, b.at).0 <= reach) && !is_own(line)
    };
    let on_dots = params.on_dots();
    let is_other = |line: &usize| (!on_dots || !is_ring[*line]) && is_near(&polylines[*line]);
    let is_small = on_dots && TAU * point.radius < LEAST_RING * params.min_length;
    is_small || point.is_circle && !lines.around(point.at, reach).iter().any(is_other)
}

/// The signs among points by themselves. Where lines become dots all are, so that those of one size are alike. On paper
/// those that are too short for lines are discs; what is near to another there is a dot of a dotted line or of a shade.
fn by_themselves(points: &[(usize, Point)], params: &Params) -> Vec<(usize, Point)> {
    let is_disc = |point: &Point| {
        let is_apart = |other: &Point| {
            is_drawn_twice(point, slice::from_ref(other))
                || (other.at - point.at).length() >= 2.0 * params.max_spacing()
        };
        let is_seen = point.is_exact && point.radius >= disc_radius(params) / MAGNIFIED;
        is_seen && TAU * point.radius < params.min_length && points.iter().all(|(_, other)| is_apart(other))
    };
    let signs = points.iter().filter(|(_, point)| params.on_dots() || is_disc(point));
    signs.map(|(number, point)| (*number, Point { is_alone: true, is_disc: true, ..*point })).collect()
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
    End { which: Tip },
}

impl PointArm {
    /// Makes the line lead to this place, the middle of the point, if it ends at the point. Gives where it ended.
    fn lead_to(&self, at: MmPoint, polylines: &mut [Polyline<Vertex>]) -> Option<MmPoint> {
        let Approach::End { which } = self.kind else { return None };
        let line = &mut polylines[self.line];
        let ended = which.of(line).map(|tip| tip.at);
        extend_to(line, which, at);
        ended
    }

    /// Takes off the line what lies under a point at one of its ends: of a path of a drawing a short stretch that is
    /// hidden is there, and in the way of the point's ring.
    fn end_at_side(&self, point: &Point, polylines: &mut [Polyline<Vertex>]) {
        let line = &mut polylines[self.line];
        if line.closed {
            return;
        }
        let far = |vertex: &Vertex| (vertex.at - point.at).length();
        for which in Tip::BOTH {
            line.change_tip(which, |vertices| {
                let hidden = vertices.iter().rev().take_while(|vertex| far(vertex) < point.radius).count();
                let shown = vertices.len() - hidden;
                if let ([.., outside], [inside, ..]) = vertices.split_at(shown) {
                    let share = (point.radius - far(inside)) / (far(outside) - far(inside));
                    let side = inside.between(outside, share);
                    vertices.truncate(shown);
                    vertices.push(side);
                }
            });
        }
    }
}

/// The lines that lead to the middle of a point.
fn arms(point: &Point, polylines: &[Polyline<Vertex>], lines: &LineIndex, is_ring: &[bool]) -> Vec<PointArm> {
    let aside = MIDDLE * point.radius;
    let reach = point.radius + FROM_SIDE;
    let mut arms = Vec::new();
    for line in lines.around(point.at, reach).into_iter().filter(|line| !is_ring[*line]) {
        let polyline = &polylines[line];
        let near = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(point.at, a.at, b.at).0 <= reach;
        if polyline.length() < SMALLEST || !polyline.segments().any(near) {
            continue;
        }
        let is_near = |(a, b): (&Vertex, &Vertex)| nearest_on_segment(point.at, a.at, b.at).0 <= aside;
        if polyline.segments().any(is_near) {
            arms.push(PointArm { line, kind: Approach::Through });
            continue;
        }
        for which in Tip::BOTH.into_iter().filter(|_| !polyline.closed) {
            let (Some(tip), Some(heading)) = (which.of(polyline), heading(polyline, which, HEADING)) else {
                continue;
            };
            let to_middle = point.at - tip.at;
            let leads = to_middle.dot(heading) > 0.0 && to_middle.cross(heading).abs() <= aside;
            if to_middle.length() <= reach && leads {
                arms.push(PointArm { line, kind: Approach::End { which } });
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
    let (radius, is_circle) = ((area / std::f32::consts::PI).sqrt(), roundness(area, length) >= CIRCLE);
    let is_on = |vertex: &Vertex| ((vertex.at - at).length() / radius - 1.0).abs() <= FROM_CIRCLE;
    let is_sign = ring.vertices.iter().all(|vertex| vertex.source == FoundIn::Sign);
    let point = Point {
        at,
        radius,
        is_filled: is_edge(ring),
        strength: ring.mean_strength(),
        series: None,
        is_alone: is_sign,
        is_disc: is_sign,
        is_exact: is_exact(ring),
        is_sure: is_exact(ring) || is_circle && ring.vertices.iter().all(is_on),
        is_circle,
        is_sign,
    };
    (ring.vertices.len() > 3 && is_round).then_some(point)
}

/// A circle of which an open line is a part, and how large a part, in turns.
fn of_arc(line: &Polyline<Vertex>) -> Option<(f32, Point)> {
    let (middle, radius) = circle(line.vertices.iter().map(|vertex| vertex.at))?;
    let is_on = |vertex: &Vertex| ((vertex.at - middle).length() / radius - 1.0).abs() <= FROM_CIRCLE;
    let length = line.length() / (TAU * radius);
    let is_arc = (LEAST_PIECE..=1.0).contains(&length) && line.vertices.iter().all(is_on);
    let point = Point {
        at: middle,
        radius,
        is_filled: is_edge(line),
        strength: line.mean_strength(),
        series: None,
        is_alone: false,
        is_disc: false,
        is_exact: is_exact(line),
        is_sure: is_exact(line),
        is_circle: true,
        is_sign: false,
    };
    is_arc.then_some((length, point))
}

/// Whether all of a contour is of a path.
fn is_exact(line: &Polyline<Vertex>) -> bool {
    line.vertices.iter().all(|vertex| vertex.source.is_exact())
}

/// Whether a contour is for the most part the side of an area, and not the middle of a stroke.
fn is_edge(line: &Polyline<Vertex>) -> bool {
    2 * line.vertices.iter().filter(|vertex| !vertex.is_in_stroke()).count() > line.vertices.len()
}

#[cfg(test)]
mod tests;
