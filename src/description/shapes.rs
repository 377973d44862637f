//! Lines in words: form, place and size, as far as they are certain.

use std::f32::consts::FRAC_PI_4;

use crate::geom::form::{Form, OpenForm, SLACK};
use crate::geom::ninths::ninth;
use crate::geom::{nearest_on_segment, polygon};
use crate::lines::{Arrow, arrows};
use crate::page::Line;
use crate::units::{MmPoint, MmRect, MmVector};
use crate::wording::{Value, Wording};

/// A closed line is round if its area is so much of that of a circle of its length; a square has 0.785.
const ROUND: f32 = 0.88;
/// A round line has at least this ratio of its narrower to its wider side.
const AS_WIDE: f32 = 0.84;
/// A line is long from this share of the figure's side on.
const LONG: f32 = 0.6;
/// Ends nearer than this close a line, mm.
const CLOSED: f32 = 0.05;

/// A side at which a rectangle may be open: its name, its ends, the length of the other three, and the distance of a
/// point to these.
type OpenBox = (&'static str, [MmPoint; 2], f32, fn(MmPoint, MmRect) -> f32);

/// An end of a line lies on another one that is so near to it, mm, beside what both may be off straight.
const ENDS_ON: f32 = 0.5;
/// Least side of one, mm: as narrow a bend is a hook.
const LEAST_BOX: f32 = 4.0;
/// How much its length may differ from that of three sides, as a share.
const AS_LONG: f32 = 0.12;

/// The widest point of dots, mm from middle to middle: what is wider is felt as a shape. Chosen by us.
const WIDEST_POINT: f32 = 10.0;
/// So many points are told with their places; of more, only how many there are.
const MOST_POINTS: usize = 3;

/// What lies so near to a border between two parts of a figure lies on it, mm: coordinates are written in steps of half
/// of that.
const ON_BORDER: f32 = 0.02;

/// The part of a figure in which a place is: of one on a border the right or lower one, before it is written and after
/// it is read.
pub(super) fn part_of(at: MmPoint, figure: MmRect) -> usize {
    ninth(at + MmVector::new(ON_BORDER, ON_BORDER), figure)
}

struct LineShape {
    path: Vec<MmPoint>,
    length: f32,
    closed: bool,
    extent: MmRect,
    /// How far it may lie off a straight side, mm.
    slack: f32,
    /// Whether its two ends lie on another line, as those of a bar on its axis.
    stands: bool,
    /// Which way each of its arrowheads points.
    ways: Vec<&'static str>,
}

impl LineShape {
    fn of(line: &Line) -> Option<Self> {
        let path: Vec<MmPoint> = line.own_path().into_iter().map(written).collect();
        let (first, last) = (*path.first()?, *path.last()?);
        let length = path.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum();
        let steps = line.row().map_or(0.0, |row| row.points.len().max(2) as f32 - 1.0);
        let step = if steps > 0.0 { length / steps } else { 0.0 };
        let closed = path.len() > 3 && ((first - last).length() <= CLOSED || line.is_ring_of_dots());
        let extent = path
            .iter()
            .fold(MmRect::new(first, first), |extent, &at| MmRect::new(extent.min.min(at), extent.max.max(at)));
        Some(Self { path, length, closed, extent, slack: SLACK.max(0.8 * step), stands: false, ways: Vec::new() })
    }

    fn area(&self) -> f32 {
        polygon::area(&self.path)
    }

    /// Whether another closed shape lies within this one.
    fn holds(&self, other: &Self) -> bool {
        // a ring of dots ends one step before its first dot
        let last_side = self.path.last().zip(self.path.first());
        let sides = self.path.iter().zip(&self.path[1..]).chain(last_side);
        self.extent.contains_box(&other.extent) && polygon::is_inside(sides, other.path[0])
    }

    /// The side at which it is an open rectangle, such as a bar of a chart that stands on its axis.
    fn open_side(&self) -> Option<&'static str> {
        let MmRect { min, max } = self.extent;
        let (width, height) = (max.x - min.x, max.y - min.y);
        if self.closed || width.min(height) < LEAST_BOX {
            return None;
        }
        let [first, last] = [self.path[0], self.path[self.path.len() - 1]];
        let near = |a: f32, b: f32| (a - b).abs() <= self.slack;
        // the side's ends, the length of the other three, and whether a point lies on one of these
        let at = |x: f32, y: f32| MmPoint::new(x, y);
        let sides: [OpenBox; 4] = [
            ("below", [at(min.x, max.y), max], width + 2.0 * height, |p, e| {
                off([p.x - e.min.x, p.x - e.max.x, p.y - e.min.y])
            }),
            ("above", [min, at(max.x, min.y)], width + 2.0 * height, |p, e| {
                off([p.x - e.min.x, p.x - e.max.x, p.y - e.max.y])
            }),
            ("right", [at(max.x, min.y), max], 2.0 * width + height, |p, e| {
                off([p.x - e.min.x, p.y - e.min.y, p.y - e.max.y])
            }),
            ("left", [min, at(min.x, max.y)], 2.0 * width + height, |p, e| {
                off([p.x - e.max.x, p.y - e.min.y, p.y - e.max.y])
            }),
        ];
        let is_end = |end: MmPoint, corner: MmPoint| near(end.x, corner.x) && near(end.y, corner.y);
        sides.into_iter().find_map(|(name, [a, b], length, off)| {
            let ends = is_end(first, a) && is_end(last, b) || is_end(first, b) && is_end(last, a);
            let along = self.path.iter().all(|point| off(*point, self.extent) <= self.slack);
            (ends && along && (self.length / length - 1.0).abs() <= AS_LONG).then_some(name)
        })
    }

    /// The sentence on it. `holds` is how many other closed shapes lie inside.
    fn told(&self, holds: usize, figure: MmRect, wording: &Wording) -> String {
        let (width, height) = (self.extent.width(), self.extent.height());
        let place = ("place", wording.place(part_of(self.extent.center(), figure)).into());
        let mm = |name: &'static str, length: f32| (name, Value::from(length.round()));
        if self.closed {
            let holds = ("holds", holds.into());
            let roundness = polygon::roundness(self.area(), self.length);
            let as_wide = width.min(height) >= AS_WIDE * width.max(height);
            return match roundness >= ROUND && as_wide {
                true => wording.say("shape-round", &[place, mm("across", 0.5 * (width + height)), holds]),
                false => wording.say("shape-closed", &[place, mm("width", width), mm("height", height), holds]),
            };
        }
        match self.ways[..] {
            [] => {}
            [way] => return wording.say("arrow", &[place, mm("length", self.length), ("way", way.into())]),
            _ => return wording.say("arrow-both", &[place, mm("length", self.length)]),
        }
        if let Some(side) = self.open_side() {
            let message = if self.stands { "shape-stands" } else { "shape-open" };
            return wording.say(message, &[place, mm("width", width), mm("height", height), ("side", side.into())]);
        }
        let (form, off, way) = self.form();
        let across = match form {
            "line-level" => width / figure.width(),
            "line-upright" => height / figure.height(),
            _ => 0.0,
        };
        let long = ("long", if across >= LONG { "yes" } else { "no" }.into());
        wording.say(form, &[place, mm("length", self.length), long, mm("off", off), ("way", way.into())])
    }

    /// The message on an open line, how far it lies off the straight between its ends, mm, and on which side.
    fn form(&self) -> (&'static str, f32, &'static str) {
        let OpenForm { form, off, aside } = OpenForm::of(&self.path, self.length, self.slack);
        let is_beside = aside.x.abs() > aside.y.abs();
        let way = match is_beside {
            true if aside.x < 0.0 => "left",
            true => "right",
            false if aside.y < 0.0 => "up",
            false => "down",
        };
        let message = match form {
            Form::Level => "line-level",
            Form::Upright => "line-upright",
            Form::Slanting => "line-slanting",
            Form::Bent => "line-bent",
            Form::Winding => "line-winding",
            Form::Bowed => "line-bowed",
        };
        (message, off, way)
    }
}

/// Which way an arrow points, in steps of 45 degrees.
fn way(arrow: &Arrow) -> &'static str {
    let eighths = (arrow.toward.angle_from_x_axis().radians / FRAC_PI_4).round() as i32;
    match eighths.rem_euclid(8) {
        0 => "right",
        1 => "down-right",
        2 => "down",
        3 => "down-left",
        4 => "left",
        5 => "up-left",
        6 => "up",
        _ => "up-right",
    }
}

/// How many of lines are told as themselves: the head of an arrow is part of it, and a point is no line.
pub(super) fn count(lines: &[Line]) -> usize {
    let heads = arrows(lines).iter().filter(|arrow| arrow.head.is_some()).count();
    lines.len() - heads - lines.iter().filter(|line| point(line).is_some()).count()
}

/// The middle of a point and how wide it is to its edges, mm, if a line is one: a disc, or dots that fill a small ring
/// or a square.
fn point(line: &Line) -> Option<(MmPoint, f32)> {
    let points: Vec<MmPoint> = line.runs.iter().flat_map(|run| run.points.iter().copied().map(written)).collect();
    let (extent, width) = (MmRect::from_points(&points), line.runs.first()?.width);
    let (middle, across) = (extent.center(), 0.5 * (extent.width() + extent.height()));
    let is_filled = || line.runs.iter().skip(1).flat_map(|run| &run.points).any(|at| (*at - middle).length() < width);
    let is_filled_ring = || line.is_ring_of_dots() && across <= WIDEST_POINT && is_filled();
    (line.is_disc() || line.is_block_of_dots() || is_filled_ring()).then_some((middle, across + width))
}

/// Sentences on the points that lie beside all lines, such as towns.
pub(super) fn points(lines: &[Line], figure: MmRect, wording: &Wording) -> Vec<String> {
    let all: Vec<(MmPoint, f32)> = lines.iter().filter_map(point).collect();
    let across = |width: f32| ("across", Value::from(width.round()));
    if all.len() > MOST_POINTS {
        let widest = all.iter().map(|(_, width)| *width).fold(0.0, f32::max);
        return vec![wording.say("points", &[("count", all.len().into()), across(widest)])];
    }
    let place = |at: MmPoint| ("place", wording.place(part_of(at, figure)).into());
    all.iter().map(|(at, width)| wording.say("point", &[place(*at), across(*width)])).collect()
}

/// The least of some distances, whatever their sign.
fn off(distances: [f32; 3]) -> f32 {
    distances.into_iter().map(f32::abs).fold(f32::MAX, f32::min)
}

/// A point as it is written, in steps of 0.01 mm.
fn written(at: MmPoint) -> MmPoint {
    MmPoint::new((100.0 * at.x).round() / 100.0, (100.0 * at.y).round() / 100.0)
}

/// Whether both ends of an open rectangle lie on one other line.
fn stands(number: usize, shapes: &[LineShape]) -> bool {
    let shape = &shapes[number];
    if shape.open_side().is_none() {
        return false;
    }
    let ends = [shape.path[0], shape.path[shape.path.len() - 1]];
    // rows of dots end a step before one another
    let reach = shape.slack + ENDS_ON;
    let lies_on = |at: MmPoint, other: &LineShape| {
        other.path.windows(2).any(|pair| nearest_on_segment(at, pair[0], pair[1]).0 <= reach)
    };
    let mut others = shapes.iter().enumerate().filter(|(other, _)| *other != number);
    others.any(|(_, other)| ends.iter().all(|end| lies_on(*end, other)))
}

/// A line that is shorter by less than this is told as as long, mm.
const SAME_LENGTH: f32 = 0.5;

/// Whether all lines beside the `most` longest are shorter than these.
pub(super) fn others_are_shorter(lines: &[Line], most: usize) -> bool {
    let lengths: Vec<f32> = longest_first(lines).iter().map(|shape| shape.length).collect();
    lengths.windows(2).nth(most.saturating_sub(1)).is_none_or(|pair| pair[0] - pair[1] >= SAME_LENGTH)
}

/// The shapes of lines, the longest first: an arrowhead is a part of its line, and a point is none.
fn longest_first(lines: &[Line]) -> Vec<LineShape> {
    let arrows = arrows(lines);
    let is_head = |number: usize| arrows.iter().any(|arrow| arrow.head == Some(number));
    let ways = |number: usize| -> Vec<&str> {
        arrows.iter().filter(|arrow| arrow.line == number).map(|arrow| way(arrow)).collect()
    };
    let of_line = |(number, line)| Some(LineShape { ways: ways(number), ..LineShape::of(line)? });
    let others = lines.iter().enumerate().filter(|(number, line)| !is_head(*number) && point(line).is_none());
    let mut shapes: Vec<LineShape> = others.filter_map(of_line).collect();
    shapes.sort_by(|a, b| b.length.total_cmp(&a.length));
    shapes
}

/// Sentences on the longest lines, the longest first.
pub(super) fn told(lines: &[Line], figure: MmRect, most: usize, wording: &Wording) -> Vec<String> {
    let mut shapes = longest_first(lines);
    let stands: Vec<bool> = (0..shapes.len()).map(|number| stands(number, &shapes)).collect();
    shapes.iter_mut().zip(stands).for_each(|(shape, stands)| shape.stands = stands);
    let text = |(number, shape): (usize, &LineShape)| {
        let others = shapes.iter().enumerate().filter(|(other, _)| *other != number && shape.closed);
        let holds = others.filter(|(_, other)| other.closed && shape.holds(other)).count();
        shape.told(holds, figure, wording)
    };
    shapes.iter().enumerate().take(most).map(text).collect()
}

#[cfg(test)]
mod tests;
