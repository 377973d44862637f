//! Where lines of a page run nearer to one another, or to themselves, than a finger can tell apart: measured on the
//! finished lines alone, by a rule of its own, not by the one that made them. Each segment is held against every other one, with
//! geometry in f64 that is written here, so no fault of the library's index or of its distances can hide itself.

use tactograph::internals::page::Line;
use tactograph::internals::units::MmPoint;

/// Lines are looked at every so often, mm.
const STEP: f32 = 0.25;
/// A line that ends this near to another meets it, mm.
const TOUCH: f32 = 0.02;
/// ... or the corner of a ring, as of a leaf at its stem: corners are not moved onto the other line.
const CORNER_TOUCH: f32 = 0.2;
/// Where a line meets another it must have come from beyond the clearance within this way, in clearances: at 36 degrees or
/// steeper.
pub(crate) const APPROACH: f32 = 1.7;
/// ... of a drawing, at 19.5 degrees or steeper.
pub(crate) const APPROACH_OF_DRAWINGS: f32 = 3.0;

/// The longest approach on the page of a sample, named by its file.
pub(crate) fn approach_of(sample: &str) -> f32 {
    if is_drawing(sample) { APPROACH_OF_DRAWINGS } else { APPROACH }
}

/// Whether a sample is a vector drawing.
pub(crate) fn is_drawing(sample: &str) -> bool {
    [".svg", ".pdf"].iter().any(|kind| sample.contains(kind))
}

/// Two places of one line with this much way between them, in distances and mm, lie on the two sides of a bend: a corner of
/// 30 degrees has the factor 1 / sin 15 = 3.9.
const BEND: f32 = 4.0;
const BEND_LEAST: f32 = 2.0;
/// ... or, of a corner with straight sides, down to 19 degrees: 1 / sin 9.5 = 6.1. Straight are sides if the way over the tip is
/// nearly as long as the line.
const CORNER: f32 = 6.1;
const STRAIGHT: f32 = 0.92;
/// Numbers of the page have two digits after the point, and some are added up.
const ROUNDING: f32 = 0.01;

/// The least blank beside a disc that stands for a point, in least blanks of lines.
const DISC_GAP: f32 = 0.5;

/// A place where two lines are too near.
#[derive(Debug, Clone, Copy)]
#[allow(dead_code, reason = "what a test does not ask for still stands in its message")]
pub(crate) struct TooNear {
    /// Where.
    pub at: MmPoint,
    /// Blank between the edges of the lines, mm; negative where they overlap.
    pub gap: f32,
    /// Numbers of the lines; the same for a line too near to itself.
    pub lines: (u32, u32),
    /// How much of the line this stands for, mm.
    pub length: f32,
}

/// A straight piece of a line.
#[derive(Debug, Clone, Copy)]
struct Segment {
    a: MmPoint,
    b: MmPoint,
    half_width: f32,
    /// Number of its line.
    line: u32,
    /// Length along its line to `a`, mm.
    arc: f32,
}

impl Segment {
    /// Whether any of it may lie within `reach` of the box `low`-`high`.
    fn near(&self, low: MmPoint, high: MmPoint, reach: f32) -> bool {
        let (least, most) = (self.a.min(self.b), self.a.max(self.b));
        least.x <= high.x + reach && least.y <= high.y + reach && most.x >= low.x - reach && most.y >= low.y - reach
    }

    /// How far a point is from it, and the point of it that is nearest.
    fn nearest(&self, at: MmPoint) -> (f32, MmPoint) {
        let [ax, ay, bx, by, px, py] = [self.a.x, self.a.y, self.b.x, self.b.y, at.x, at.y].map(f64::from);
        let (dx, dy) = (bx - ax, by - ay);
        let square = dx * dx + dy * dy;
        let share = if square > 0.0 { (((px - ax) * dx + (py - ay) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
        let (x, y) = (ax + share * dx, ay + share * dy);
        ((x - px).hypot(y - py) as f32, MmPoint::new(x as f32, y as f32))
    }

    /// Where it crosses another one, in a point inside both.
    fn crossing(&self, other: &Self) -> Option<MmPoint> {
        let [ax, ay, bx, by] = [self.a.x, self.a.y, self.b.x, self.b.y].map(f64::from);
        let [cx, cy, dx, dy] = [other.a.x, other.a.y, other.b.x, other.b.y].map(f64::from);
        let determinant = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx);
        let s = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / determinant;
        let t = ((cx - ax) * (by - ay) - (cy - ay) * (bx - ax)) / determinant;
        let inside = |share: f64| share > 0.0 && share < 1.0; // of parallel ones neither is a number in there
        let at = MmPoint::new((ax + s * (bx - ax)) as f32, (ay + s * (by - ay)) as f32);
        (inside(s) && inside(t)).then_some(at)
    }
}

struct Way {
    segments: Vec<Segment>,
    length: f32,
    closed: bool,
}

impl Way {
    fn of(number: usize, line: &Line) -> Self {
        let mut segments = Vec::new();
        let mut arc = 0.0;
        for run in &line.runs {
            for (&a, &b) in run.polyline().segments() {
                segments.push(Segment { a, b, half_width: 0.5 * run.width, line: number as u32, arc });
                arc += (b - a).length();
            }
        }
        let closed = segments.len() > 2 && segments.first().map(|s| s.a) == segments.last().map(|s| s.b);
        Self { segments, length: arc, closed }
    }

    /// Whether a place is an end of the line, give or take what simplification moves.
    fn ends_at(&self, at: MmPoint) -> bool {
        let tips = [self.segments.first().map(|s| s.a), self.segments.last().map(|s| s.b)];
        !self.closed && tips.into_iter().flatten().any(|tip| (tip - at).length() <= 0.1)
    }

    /// Places on the line between two others, every half millimetre.
    fn places(&self, from: f32, to: f32) -> impl Iterator<Item = MmPoint> {
        let steps = (2.0 * (to - from)).ceil().max(1.0) as u32;
        (1..steps).map(move |k| {
            let arc = from + (to - from) * k as f32 / steps as f32;
            let segment = &self.segments[self.segments.partition_point(|s| s.arc <= arc).saturating_sub(1)];
            let length = (segment.b - segment.a).length().max(f32::MIN_POSITIVE);
            segment.a.lerp(segment.b, ((arc - segment.arc) / length).min(1.0))
        })
    }

    /// Whether between two of its places there are but two straight sides of a corner.
    fn has_corner(&self, (s, a): (f32, MmPoint), (t, b): (f32, MmPoint)) -> bool {
        let (from, to) = (s.min(t), s.max(t));
        let over_start = self.closed && self.length - (to - from) < to - from;
        let places = self.segments.iter().filter(|s| (from..to).contains(&s.arc) != over_start).map(|s| s.a);
        let over = |tip: MmPoint| f64::from((tip - a).length()) + f64::from((tip - b).length());
        let farthest = places.map(over).fold(0.0, f64::max);
        farthest >= f64::from(STRAIGHT * self.between(s, t))
    }

    /// The way along the line between two of its places.
    fn between(&self, s: f32, t: f32) -> f32 {
        let apart = (s - t).abs();
        if self.closed { apart.min(self.length - apart) } else { apart }
    }
}

/// Whether both ends of a line lie on others.
pub(crate) fn leads_from_line_to_line(lines: &[Line], number: usize) -> bool {
    let others: Vec<Way> =
        lines.iter().enumerate().filter(|(i, _)| *i != number).map(|(i, line)| Way::of(i, line)).collect();
    let on_other = |at: MmPoint| others.iter().flat_map(|way| &way.segments).any(|s| s.nearest(at).0 <= TOUCH);
    let own = Way::of(number, &lines[number]);
    !own.closed && own.segments.first().zip(own.segments.last()).is_some_and(|(a, b)| on_other(a.a) && on_other(b.b))
}

/// Whether a line is a disc that stands for a point: a ring whose stroke fills it.
pub(crate) fn is_disc(line: &Line) -> bool {
    let [run] = &line.runs[..] else { return false };
    let far = |axis: fn(&MmPoint) -> f32| {
        let (least, most) = run.points.iter().map(axis).fold((f32::MAX, f32::MIN), |(a, b), at| (a.min(at), b.max(at)));
        most - least
    };
    run.closed && far(|at| at.x) <= run.width && far(|at| at.y) <= run.width
}

/// All places where lines are nearer than `min_gap` though they do not join there, on an approach of at
/// most so many clearances.
pub(crate) fn too_near(lines: &[Line], min_gap: f32, approach: f32) -> Vec<TooNear> {
    let ways: Vec<Way> = lines.iter().enumerate().map(|(number, line)| Way::of(number, line)).collect();
    let all: Vec<Segment> = ways.iter().flat_map(|way| &way.segments).copied().collect();
    let widest = all.iter().map(|s| s.half_width).fold(0.0, f32::max);
    let are_discs: Vec<bool> = lines.iter().map(is_disc).collect();
    let mut junctions = junctions(&ways, &all, min_gap);
    if approach > APPROACH {
        let by_third = by_third(&ways, &junctions, min_gap + 2.0 * widest);
        junctions.iter_mut().zip(by_third).for_each(|(own, more)| own.extend(more));
    }
    // whether line `a`, `arc` from its start, is on its way to a junction with line `b`
    let arrives = |a: u32, arc: f32, b: u32, clearance: f32| {
        let way = &ways[a as usize];
        let longest = |j: &Junction| j.by_third.map_or(approach * clearance, |apart| APPROACH * clearance - apart);
        let on_the_way = |j: &Junction| j.other == b && way.between(j.arc, arc) <= longest(j);
        junctions[a as usize].iter().any(on_the_way)
    };

    let mut found = Vec::new();
    for segment in &all {
        let (low, high) = (segment.a.min(segment.b), segment.a.max(segment.b));
        let reach = min_gap + segment.half_width + widest;
        let others: Vec<&Segment> = all.iter().filter(|other| other.near(low, high, reach)).collect();
        let length = (segment.b - segment.a).length();
        let steps = (length / STEP).ceil().max(1.0);
        for k in 0..steps as u32 {
            let share = (k as f32 + 0.5) / steps;
            let (here, at) = (segment.arc + share * length, segment.a.lerp(segment.b, share));
            let mut worst: Option<TooNear> = None;
            for other in &others {
                let (distance, point) = other.nearest(at);
                let discs = [segment.line, other.line].iter().filter(|line| are_discs[**line as usize]).count();
                let gap = distance - segment.half_width - other.half_width;
                // a disc keeps half of the blank, and may lie on a line; it is not near itself
                let lies_on = discs == 1 && gap < -ROUNDING;
                if discs > 0 && (other.line == segment.line || lies_on || gap >= DISC_GAP * min_gap - ROUNDING) {
                    continue;
                }
                let clearance = min_gap + segment.half_width + other.half_width;
                if distance >= clearance - ROUNDING {
                    continue;
                }
                let there = other.arc + (point - other.a).length();
                let way = &ways[other.line as usize];
                let along = way.between(here, there);
                let bend = other.line == segment.line
                    && (along <= BEND * distance + BEND_LEAST
                        || (along <= CORNER * distance + BEND_LEAST && way.has_corner((here, at), (there, point))));
                let joins = arrives(segment.line, here, other.line, clearance)
                    || arrives(other.line, there, segment.line, clearance);
                if !bend && !joins && worst.is_none_or(|worst| gap < worst.gap) {
                    worst = Some(TooNear { at, gap, lines: (segment.line, other.line), length: length / steps });
                }
            }
            found.extend(worst);
        }
    }
    found
}

/// The vertices of a line, each with the piece that comes to it and the one that goes on.
fn corners(way: &Way) -> impl Iterator<Item = [&Segment; 2]> {
    let over_start = way.segments.last().zip(way.segments.first()).filter(|_| way.closed);
    way.segments.windows(2).map(|pair| [&pair[0], &pair[1]]).chain(over_start.map(|(last, first)| [last, first]))
}

/// Whether a line turns at once in a vertex, by 30 degrees or more.
fn turns(here: [&Segment; 2]) -> bool {
    let direction = |s: &Segment| f64::from(s.b.y - s.a.y).atan2(f64::from(s.b.x - s.a.x));
    let turn = (direction(here[1]) - direction(here[0])).rem_euclid(std::f64::consts::TAU);
    turn.min(std::f64::consts::TAU - turn) >= 30_f64.to_radians()
}

/// Whether two lines cross in a vertex that both have: one of them comes and goes on different sides of the other.
fn cross_in_a_vertex(one: [&Segment; 2], other: [&Segment; 2]) -> bool {
    let at = one[1].a;
    let direction = |to: MmPoint| f64::from(to.y - at.y).atan2(f64::from(to.x - at.x));
    let from = direction(one[0].a);
    let round = |to: MmPoint| (direction(to) - from).rem_euclid(std::f64::consts::TAU);
    let beyond = |to: MmPoint| round(to) > round(one[1].b);
    other[1].a == at && beyond(other[0].a) != beyond(other[1].b)
}

/// Where a line ends on another, or crosses it.
#[derive(Debug, Clone, Copy)]
struct Junction {
    arc: f32,
    other: u32,
    /// How far along that.
    there: f32,
    /// Of two lines that meet a third one at nearly one place: how far the two places are apart along that.
    by_third: Option<f32>,
}

/// The junctions of every line. Two lines that cross again before they have been apart only wind round one another: these
/// are none.
fn junctions(ways: &[Way], all: &[Segment], min_gap: f32) -> Vec<Vec<Junction>> {
    let of = |(number, way): (usize, &Way)| {
        let mut found: Vec<Junction> = Vec::new();
        let mut add = |arc: f32, there: f32, other: &Segment| {
            let itself = other.line as usize == number;
            if !(itself && way.between(arc, there) <= BEND_LEAST) {
                found.push(Junction { arc, other: other.line, there, by_third: None });
            }
        };
        for segment in &way.segments {
            let (a, b) = (segment.a, segment.b);
            for other in all.iter().filter(|other| other.near(a.min(b), a.max(b), 0.0)) {
                if let Some(at) = segment.crossing(other)
                    && !ways[other.line as usize].ends_at(at)
                {
                    add(segment.arc + (at - a).length(), other.arc + (at - other.a).length(), other);
                }
            }
        }
        for here in corners(way) {
            for there in ways.iter().flat_map(corners).filter(|there| cross_in_a_vertex(here, *there)) {
                add(here[1].arc, there[1].arc, there[1]);
            }
        }
        for here in corners(way).filter(|_| way.closed).filter(|here| turns(*here)) {
            for other in all.iter().filter(|other| other.near(here[1].a, here[1].a, CORNER_TOUCH)) {
                let (distance, at) = other.nearest(here[1].a);
                if distance <= CORNER_TOUCH {
                    add(here[1].arc, other.arc + (at - other.a).length(), other);
                }
            }
        }
        if let (Some(first), Some(last), false) = (way.segments.first(), way.segments.last(), way.closed) {
            for (tip, arc) in [(first.a, 0.0), (last.b, way.length)] {
                for other in all.iter().filter(|other| other.near(tip, tip, TOUCH)) {
                    let (distance, at) = other.nearest(tip);
                    if distance <= TOUCH {
                        add(arc, other.arc + (at - other.a).length(), other);
                    }
                }
            }
        }
        found
    };
    let found: Vec<Vec<Junction>> = ways.iter().enumerate().map(of).collect();
    let follows = |at: MmPoint, line: u32| {
        let segments = &ways[line as usize].segments;
        segments.iter().any(|s| s.near(at, at, min_gap) && s.nearest(at).0 <= min_gap)
    };
    let winds = |way: &Way, junction: &Junction, list: &[Junction]| {
        list.iter().any(|other| {
            let (from, to) = (junction.arc.min(other.arc), junction.arc.max(other.arc));
            let itself = way.segments.first().map(|s| s.line) == Some(junction.other);
            other.other == junction.other
                && !itself
                && to - from > 1.0
                && way.places(from, to).all(|at| follows(at, junction.other))
        })
    };
    found
        .iter()
        .zip(ways)
        .map(|(list, way)| list.iter().filter(|junction| !winds(way, junction, list)).copied().collect())
        .collect()
}

/// The junctions of every line, where it ends on another, with those that meet that no farther than `spacing` from there
/// and do not lie within 30 degrees of it.
fn by_third(ways: &[Way], junctions: &[Vec<Junction>], spacing: f32) -> Vec<Vec<Junction>> {
    let all = || junctions.iter().enumerate().flat_map(|(line, own)| own.iter().map(move |j| (line as u32, *j)));
    // a meeting of two lines, seen from either
    let both = all().flat_map(|(line, j)| [(line, j.arc, j.other, j.there), (j.other, j.there, line, j.arc)]);
    let both: Vec<(u32, f32, u32, f32)> = both.collect();
    let leaves = |line: u32, arc: f32| -> Vec<f64> {
        let way = &ways[line as usize];
        let at = |arc: f32| {
            let arc = if way.closed { arc.rem_euclid(way.length) } else { arc.clamp(0.0, way.length) };
            let segment = way.segments.iter().rev().find(|segment| segment.arc <= arc && arc <= way.length)?;
            let (along, from, to) = (f64::from(arc - segment.arc), segment.a.to_f64(), segment.b.to_f64());
            Some(from + (to - from).normalize() * along)
        };
        let from = at(arc);
        let both = [arc + spacing, arc - spacing].map(|to| Some(at(to)? - from?));
        let ways = both.into_iter().flatten().filter(|way| way.length() > 0.01);
        ways.map(|way| way.angle_from_x_axis().to_degrees()).collect()
    };
    let is_apart = |one: f64, other: f64| (one - other + 540.0).rem_euclid(360.0) - 180.0;
    let of = |number: u32| {
        let mut found = Vec::new();
        let way = &ways[number as usize];
        let ends = |arc: f32| !way.closed && (arc <= TOUCH || arc >= way.length - TOUCH);
        for &(_, arc, third, at) in both.iter().filter(|meeting| meeting.0 == number && ends(meeting.1)) {
            let own = leaves(number, arc);
            for &(_, near, other, there) in both.iter().filter(|meeting| meeting.0 == third && meeting.2 != number) {
                let apart = ways[third as usize].between(at, near);
                let others = leaves(other, there);
                let diverge = own.iter().all(|a| others.iter().all(|b| is_apart(*a, *b).abs() >= 30.0));
                if apart <= spacing && diverge {
                    found.push(Junction { arc, other, there, by_third: Some(apart) });
                }
            }
        }
        found
    };
    (0..ways.len() as u32).map(of).collect()
}
