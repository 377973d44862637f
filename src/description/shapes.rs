//! Lines in words: form, place and size, as far as they are certain.

use std::f32::consts::PI;

use crate::geom::ninths::ninth;
use crate::page::Line;
use crate::units::{MmPoint, MmRect, MmVector};
use crate::wording::{Value, Wording};

/// A closed line is round if its area is so much of that of a circle of its length; a square has 0.785.
const ROUND: f32 = 0.88;
/// ... and as wide as high, within this.
const AS_WIDE: f32 = 0.8;
/// An open line is straight if its ends are so far apart, of its length.
const STRAIGHT: f32 = 0.97;
/// A straight line is level or upright within 10 degrees.
const LEVEL: f32 = 0.985;
/// A line is long from this share of the figure's side on.
const LONG: f32 = 0.6;
/// Ends nearer than this close a line, mm.
const CLOSED: f32 = 0.05;

struct Shape {
    path: Vec<MmPoint>,
    length: f32,
    closed: bool,
    extent: MmRect,
}

impl Shape {
    fn of(line: &Line) -> Option<Self> {
        let path: Vec<MmPoint> = line.runs.iter().flat_map(|run| run.path()).map(written).collect();
        let (first, last) = (*path.first()?, *path.last()?);
        let length = path.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum();
        // a ring of dots ends a step before its beginning
        let step =
            line.runs.iter().filter(|run| run.points.len() > 1).map(|run| run.length() / run.points.len() as f32);
        let gap =
            if line.runs.iter().any(|run| run.pen != Default::default()) { step.fold(0.0, f32::max) } else { 0.0 };
        let closed = path.len() > 3 && (first - last).length() <= CLOSED.max(1.6 * gap);
        let extent = path
            .iter()
            .fold(MmRect::new(first, first), |extent, &at| MmRect::new(extent.min.min(at), extent.max.max(at)));
        Some(Self { path, length, closed, extent })
    }

    fn area(&self) -> f32 {
        let first = self.path[0];
        let crosses = self.path.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first));
        0.5 * crosses.sum::<f32>().abs()
    }

    /// Whether another closed shape lies within this one.
    fn holds(&self, other: &Self) -> bool {
        let at = other.path[0];
        let crosses = self.path.windows(2).filter(|pair| {
            let (a, b) = (pair[0], pair[1]);
            (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)
        });
        self.extent.contains_box(&other.extent) && crosses.count() % 2 == 1
    }

    /// The sentence on it. `holds` is how many other closed shapes lie inside.
    fn told(&self, holds: usize, figure: MmRect, wording: &Wording) -> String {
        let (width, height) = (self.extent.width(), self.extent.height());
        let place = ("place", wording.place(ninth(self.extent.center(), figure)).into());
        let mm = |name: &'static str, length: f32| (name, Value::from(length.round()));
        if self.closed {
            let holds = ("holds", holds.into());
            let roundness = 4.0 * PI * self.area() / (self.length * self.length).max(f32::MIN_POSITIVE);
            let as_wide = width.min(height) >= AS_WIDE * width.max(height);
            return match roundness >= ROUND && as_wide {
                true => wording.say("shape-round", &[place, mm("across", 0.5 * (width + height)), holds]),
                false => wording.say("shape-closed", &[place, mm("width", width), mm("height", height), holds]),
            };
        }
        let way: MmVector = self.path[self.path.len() - 1] - self.path[0];
        let straight = way.length() >= STRAIGHT * self.length;
        let (dx, dy) =
            (way.x.abs() / way.length().max(f32::MIN_POSITIVE), way.y.abs() / way.length().max(f32::MIN_POSITIVE));
        let (form, across) = match (straight, dx, dy) {
            (true, dx, _) if dx >= LEVEL => ("line-level", width / figure.width()),
            (true, _, dy) if dy >= LEVEL => ("line-upright", height / figure.height()),
            (true, ..) => ("line-slanting", 0.0),
            (false, ..) => ("line-bent", 0.0),
        };
        let long = ("long", if across >= LONG { "yes" } else { "no" }.into());
        wording.say(form, &[place, mm("length", self.length), long])
    }
}

/// A point as it is written, in steps of 0.01 mm.
fn written(at: MmPoint) -> MmPoint {
    MmPoint::new((100.0 * at.x).round() / 100.0, (100.0 * at.y).round() / 100.0)
}

/// Sentences on the longest lines, the longest first.
pub(super) fn told(lines: &[Line], figure: MmRect, most: usize, wording: &Wording) -> Vec<String> {
    let mut shapes: Vec<Shape> = lines.iter().filter_map(Shape::of).collect();
    shapes.sort_by(|a, b| b.length.total_cmp(&a.length));
    let text = |(number, shape): (usize, &Shape)| {
        let others = shapes.iter().enumerate().filter(|(other, _)| *other != number && shape.closed);
        let holds = others.filter(|(_, other)| other.closed && shape.holds(other)).count();
        shape.told(holds, figure, wording)
    };
    shapes.iter().enumerate().take(most).map(text).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Run;

    fn line(points: Vec<MmPoint>) -> Line {
        Line { strength: 20.0, runs: vec![Run::stroke(1.0, points)] }
    }

    fn circle(x: f32, y: f32, radius: f32) -> Line {
        let at = |k: usize| {
            let (sin, cos) = (k as f32 * PI / 20.0).sin_cos();
            MmPoint::new(x + radius * cos, y + radius * sin)
        };
        let first = at(0);
        line((0..40).map(at).chain([first]).collect())
    }

    #[test]
    fn lines_have_their_form_place_and_size() {
        let figure = MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 150.0));
        let level = line(vec![MmPoint::new(10.0, 130.0), MmPoint::new(140.0, 131.0)]);
        let bent = line(vec![MmPoint::new(10.0, 10.0), MmPoint::new(20.0, 10.0), MmPoint::new(20.0, 30.0)]);
        let told =
            told(&[bent, circle(75.0, 25.0, 6.0), level, circle(75.0, 30.0, 30.0)], figure, 9, Wording::english());
        assert_eq!(
            told,
            [
                "A closed round outline in the upper middle, 60 mm across; it contains a smaller one.",
                "A straight level line in the lower middle, 130 mm long, across most of the figure.",
                "A closed round outline in the upper middle, 12 mm across.",
                "A bent line in the upper left, 30 mm long.",
            ]
        );
    }
}
