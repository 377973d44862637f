//! Room for the heads of arrows among the lines that are drawn.

use super::shapes::{LENGTHS, SPREAD, end};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::geom::segment_distance;
use crate::lines::clearance::TOUCH;
use crate::lines::lead_on::{extend_to, heading};
use crate::lines::marks::HeadMark;
use crate::lines::params::{HEADING, Params, RING_FARTHEST};
use crate::lines::vertex::{FoundIn, SHORTENED_BY, Tip, Vertex, nearby};
use crate::units::{MmPoint, MmRect, MmVector};

/// The end of a shaft as drawn leads as it did, but for 45 degrees: the cosine.
const ALONG: f32 = 0.7;
/// A shaft that is drawn is as strong at its end as in the drawing, but for this share, as where it became one line
/// with a stroke beside it; or it ends where it did, but for so many mm. Chosen by us: a red curve beside a black axis
/// differs by more.
const ALIKE: f32 = 0.25;
const SAME: f32 = 0.3;
/// So far are the strokes of a head from its own shaft before a bend of that, as a share of the clearance. Chosen by
/// us: less would be a clot.
const BEFORE_BEND: f32 = 0.6;
/// A shaft is shortened by at most this for its head to have room, mm, in steps.
const MOST: f32 = 8.0;
const STEP: f32 = 0.5;

/// Where a head has room nowhere on its shaft, as at an axis that ends shortly after its grid, the shaft is longer by
/// at most this, mm, if there is nothing before it.
const FARTHER: f32 = 10.0;

/// The tip of a head, or of a shaft without one, that touches what it points at lies so far beyond the middle of that,
/// mm: the two cross, however both are rounded.
const BEYOND: f32 = 0.1;
/// Its strokes meet that at 36 degrees at least, as lines do that meet at one place: the cosine.
const FLATTEST: f32 = 0.81;
/// What it points at lies before its tip but for this share of its length: a side that is not square to the shaft.
const BEHIND: f32 = 0.5;

/// Heads that are drawn.
#[derive(Debug, Default)]
pub(in crate::lines) struct DrawnHeads {
    /// Their strokes.
    pub(in crate::lines) heads: Vec<Polyline<Vertex>>,
    /// The shafts that are shorter for them, or longer, or led back for want of room: the number of the line, which
    /// end, and by how much it is shorter, mm.
    shorter: Vec<(usize, Tip, f32)>,
}

impl DrawnHeads {
    /// A line, of this number among those that are drawn, as long as its heads let it be; with what of it is anchored.
    pub(in crate::lines) fn shaft(
        &self,
        number: usize,
        line: &Polyline<Vertex>,
        anchored: &[bool],
    ) -> (Polyline<Vertex>, Vec<bool>) {
        let (mut line, mut anchored) = (line.clone(), anchored.to_vec());
        for &(_, which, cut) in self.shorter.iter().filter(|(of, _, cut)| *of == number && *cut != 0.0) {
            if cut < 0.0 {
                let count = line.vertices.len();
                line = longer(&line, which, -cut);
                let added = vec![false; line.vertices.len() - count];
                anchored.splice(if which == Tip::First { 0..0 } else { count..count }, added);
                continue;
            }
            let shorter = line.shortened(which, cut);
            let gone = line.vertices.len() - shorter.vertices.len();
            if which == Tip::First {
                anchored.drain(..gone);
            } else {
                anchored.truncate(anchored.len() - gone);
            }
            line = shorter;
        }
        (line, anchored)
    }
}

/// Draws heads at the ends of `lines`, where there is room beside these and the `points` on them, with their radii, mm;
/// says so in their marks.
pub(in crate::lines) fn draw(
    marks: &mut [HeadMark],
    lines: &[&Polyline<Vertex>],
    points: &[(MmPoint, f32)],
    area: MmRect,
    params: &Params,
) -> DrawnHeads {
    let mut drawn = DrawnHeads::default();
    if marks.is_empty() {
        return drawn;
    }
    let segments = nearby(lines.iter().copied(), area, params);
    let mut taken: Vec<(usize, Tip)> = Vec::new();
    let mut strokes: Vec<(MmPoint, MmPoint)> = Vec::new();
    // shafts that are led back give way to all heads that have room before what they point at
    for leads_back in [false, true] {
        for mark in marks.iter_mut().filter(|mark| !leads_back || !mark.is_drawn && mark.shortened > 0.0) {
            let Some((line, which)) = shaft_of(mark, lines).filter(|shaft| !taken.contains(shaft)) else { continue };
            let last_piece = last_piece(lines[line], which, mark.toward, own_end(params));
            let (toward, back, segments, others) = (mark.toward, 0.0, &segments, &strokes[..]);
            let places = HeadPlaces { line, lines, toward, last_piece, back, segments, points, others, area, params };
            let found = if leads_back {
                places.led_back(which, mark.shortened)
            } else {
                places.head(which).map(|(head, cut)| (Some(head), cut))
            };
            let Some((head, cut)) = found else { continue };
            taken.push((line, which));
            drawn.shorter.push((line, which, cut));
            if leads_back {
                strokes.extend(end(lines[line], which).zip(end(&longer(lines[line], which, -cut), which)));
            }
            if let Some(head) = head {
                strokes.extend(head.segments().map(|(a, b)| (a.at, b.at)));
                drawn.heads.push(head);
                mark.is_drawn = true;
            }
        }
    }
    drawn
}

/// Finds the ends of `lines` at which heads are drawn later, as dots; says of which heads there is none.
pub(in crate::lines) fn find_shafts(marks: &mut [HeadMark], lines: &[&Polyline<Vertex>]) {
    for mark in marks {
        match shaft_of(mark, lines).and_then(|(line, which)| end(lines[line], which)) {
            Some(at) => mark.at = at,
            None => mark.has_shaft = false,
        }
    }
}

/// The end of a line that is the shaft of a head, as it is drawn: the line's number, and which tip it is.
fn shaft_of(mark: &HeadMark, lines: &[&Polyline<Vertex>]) -> Option<(usize, Tip)> {
    let ends = lines.iter().enumerate().filter(|(_, line)| !line.closed);
    let ends = ends.flat_map(|(number, line)| Tip::BOTH.map(|which| (number, which, *line)));
    let near = ends.filter_map(|(number, which, line)| {
        let far = (end(line, which)? - mark.at).length();
        let is_there = far <= 2.0 * RING_FARTHEST && leads(line, which, mark.toward);
        // not a curve that ends beside an axis which is not drawn up to there
        let strength = which.of(line)?.strength;
        let is_it = far <= SAME || (strength - mark.strength).abs() <= ALIKE * mark.strength;
        (is_there && is_it).then_some((far, number, which))
    });
    near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|(_, number, which)| (number, which))
}

/// Whether a line leads to one of its ends as the head there points, but for 45 degrees.
pub(super) fn leads(line: &Polyline<Vertex>, which: Tip, toward: MmVector) -> bool {
    heading(line, which, HEADING).is_some_and(|way| way.dot(toward) >= ALONG)
}

/// How much of a line, from one of its ends on, leads as the head there points, up to its last bend, mm; or `most`.
pub(super) fn last_piece(line: &Polyline<Vertex>, which: Tip, toward: MmVector, most: f32) -> f32 {
    line.shorter_ones(which, most).take_while(|line| leads(line, which, toward)).count() as f32 * SHORTENED_BY
}

/// As far from its tip, along its shaft, a head may be near to that, mm.
fn own_end(params: &Params) -> f32 {
    params.approach(0.5 * params.width_max, 0.5 * params.width_max)
}

/// Where a head may be on a line.
struct HeadPlaces<'a> {
    line: usize,
    lines: &'a [&'a Polyline<Vertex>],
    /// Which way the head points in the drawing.
    toward: MmVector,
    /// How much of the line leads that way, mm.
    last_piece: f32,
    /// By how much the line is led back to what it points at, mm.
    back: f32,
    segments: &'a Nearby,
    points: &'a [(MmPoint, f32)],
    /// The strokes of other heads, and what other shafts are longer by.
    others: &'a [(MmPoint, MmPoint)],
    area: MmRect,
    params: &'a Params,
}

impl HeadPlaces<'_> {
    /// The largest head for which there is room, and by how much the shaft is shorter then, mm.
    fn head(&self, which: Tip) -> Option<(Polyline<Vertex>, f32)> {
        let line = self.lines[self.line];
        let most = (line.length() - self.params.min_length).clamp(0.0, MOST);
        let cuts = (0..=(most / STEP) as u32).map(|step| step as f32 * STEP);
        // before a bend it would point another way
        let shafts: Vec<(f32, Polyline<Vertex>)> = cuts
            .map(|cut| (cut, line.shortened(which, cut)))
            .take_while(|(_, shaft)| leads(shaft, which, self.toward))
            .collect();
        let head = |(cut, shaft): &(f32, Polyline<Vertex>), length: f32| {
            let at = end(shaft, which)?;
            let strokes = strokes(at, heading(shaft, which, HEADING)?, length);
            self.has_room(strokes, which, None).then(|| (self.polyline(strokes, which), *cut))
        };
        let on_shaft = LENGTHS.iter().find_map(|length| shafts.iter().find_map(|shaft| head(shaft, *length)));
        on_shaft.or_else(|| {
            // an overview has no room for more
            if self.params.in_overview_of_drawing() {
                return None;
            }
            let at_end = end(line, which)?;
            if let Some((at, pointed_at)) = self.on_other(at_end) {
                return self.touching(which, at, pointed_at);
            }
            let steps = (1..=(FARTHER / STEP) as u32).map(|step| step as f32 * STEP);
            let longer = steps.map(|by| (-by, longer(line, which, by)));
            let free: Vec<(f32, Polyline<Vertex>)> =
                longer.take_while(|(_, shaft)| self.is_clear(shaft, which)).collect();
            LENGTHS.iter().rev().find_map(|length| free.iter().find_map(|shaft| head(shaft, *length)))
        })
    }

    /// A shaft that was shortened by so much, mm, and on which no head has room: it leads to what it points at again,
    /// as in the drawing, if nothing is in between. With the head that touches that, if there is room for one, and by
    /// how much the shaft is shorter, mm.
    fn led_back(mut self, which: Tip, shortened: f32) -> Option<(Option<Polyline<Vertex>>, f32)> {
        let line = self.lines[self.line];
        let (from, toward) = (end(line, which)?, heading(line, which, HEADING)?);
        let farthest = shortened + self.params.bridged_gap();
        let mut steps = (1..=(farthest / TOUCH) as u32).map(|step| step as f32 * TOUCH);
        let (at, pointed_at) = steps.find_map(|far| self.on_other(from + toward * far))?;
        self.back = (at - from).dot(toward);
        self.last_piece += self.back;
        // both lines may have moved; what is nearer lies between them
        let is_it = self.back >= (shortened - 2.0 * RING_FARTHEST).max(SHORTENED_BY);
        let is_steep = self.sides(at, pointed_at).iter().all(|side| -toward.dot(*side) <= FLATTEST);
        let is_before = |of: MmPoint| (of - from).dot(toward) >= 0.0;
        let is_touched = |segment: &Segment| segment.line == pointed_at && is_before(segment.a) && is_before(segment.b);
        if !is_it || !is_steep || !self.is_free((from, at), which, is_touched) {
            return None;
        }
        self.last_piece = self.last_piece.min(own_end(self.params));
        let touching = if self.params.in_overview_of_drawing() { None } else { self.touching(which, at, pointed_at) };
        Some((touching.map(|(head, _)| head), -(self.back + BEYOND)))
    }

    /// The largest head at the end of a short shaft that leads up to another line there, between two boxes: before that
    /// line there is no room for it, so its tip touches it. Without a head such a shaft says nothing.
    fn touching(&self, which: Tip, at: MmPoint, pointed_at: u32) -> Option<(Polyline<Vertex>, f32)> {
        let toward = heading(self.lines[self.line], which, HEADING)?;
        let sides = self.sides(at, pointed_at);
        LENGTHS.iter().find_map(|length| {
            let strokes = strokes(at + toward * BEYOND, toward, *length);
            let [left, apex, right] = strokes;
            let is_steep = |wing: MmPoint| sides.iter().all(|side| (wing - apex).dot(*side) <= FLATTEST * length);
            let has_room = is_steep(left) && is_steep(right) && self.has_room(strokes, which, Some(pointed_at));
            has_room.then(|| (self.polyline(strokes, which), 0.0))
        })
    }

    /// Which ways a line leads from a place on it: two, which are opposite but for a corner.
    fn sides(&self, at: MmPoint, line: u32) -> Vec<MmVector> {
        let mut sides = Vec::new();
        self.segments.around_point(at, TOUCH, |segment| {
            let is_there = segment.line == line && nearest_on_segment(at, segment.a, segment.b).0 <= TOUCH;
            let ends = [segment.a, segment.b].into_iter().filter(|end| is_there && (*end - at).length() > TOUCH);
            sides.extend(ends.filter_map(|end| (end - at).try_normalize()));
        });
        sides
    }

    /// The place on another line that runs through this one, and its number.
    fn on_other(&self, at: MmPoint) -> Option<(MmPoint, u32)> {
        let nearest = self.segments.nearest(at, TOUCH, |segment| segment.line as usize != self.line)?;
        Some((nearest.1, nearest.2.line))
    }

    /// Whether the end of a longer shaft is clear of all other lines.
    fn is_clear(&self, shaft: &Polyline<Vertex>, which: Tip) -> bool {
        let clearance = self.params.max_clearance();
        end(shaft, which).is_some_and(|at| {
            let other = |segment: &Segment| segment.line as usize != self.line;
            let ahead = heading(shaft, which, HEADING);
            let is_before = |of: MmPoint| ahead.is_none_or(|ahead| (of - at).dot(ahead) >= 0.0);
            let mut is_clear = self.area.contains(at);
            self.segments.around_point(at, clearance, |segment| {
                let (distance, nearest) = nearest_on_segment(at, segment.a, segment.b);
                is_clear &= !other(segment) || distance >= clearance || !is_before(nearest);
            });
            is_clear
        })
    }

    /// Whether the strokes of a head are clear of all other lines, and of all but the end of its own, before a bend of
    /// which they may be a little nearer; of a line that it points at and touches only beside its shaft.
    fn has_room(&self, [left, apex, right]: [MmPoint; 3], which: Tip, pointed_at: Option<u32>) -> bool {
        let ahead = apex - left.lerp(right, 0.5);
        let is_before = |at: MmPoint| (at - apex).dot(ahead) >= -BEHIND * ahead.square_length();
        let is_touched =
            |segment: &Segment| pointed_at == Some(segment.line) && is_before(segment.a) && is_before(segment.b);
        [(left, apex), (apex, right)].into_iter().all(|stroke| self.is_free(stroke, which, is_touched))
    }

    /// Whether a stroke is clear of all lines but those parts that it touches, of points and of other heads.
    fn is_free(&self, stroke: (MmPoint, MmPoint), which: Tip, is_touched: impl Fn(&Segment) -> bool) -> bool {
        let (clearance, length) = (self.params.max_clearance(), self.lines[self.line].length());
        let own_end = own_end(self.params);
        let arcs = self.lines[self.line].arc_lengths();
        let arc = |index: u32| arcs.get(index as usize).copied().unwrap_or(length);
        let least = |segment: &Segment| {
            let from_end = if which == Tip::First { arc(segment.index) } else { length - arc(segment.index + 1) };
            let from_tip = self.back + from_end;
            match segment.line as usize == self.line {
                true if from_tip < self.last_piece => 0.0,
                true if from_tip <= own_end => BEFORE_BEND * clearance,
                _ => clearance,
            }
        };
        let mut is_free = self.area.contains(stroke.0) && self.area.contains(stroke.1);
        let reach = clearance + 0.5 * (stroke.1 - stroke.0).length();
        self.segments.around_point(stroke.0.lerp(stroke.1, 0.5), reach, |segment| {
            is_free &= is_touched(segment) || segment_distance(stroke, (segment.a, segment.b)) >= least(segment);
        });
        let is_beside = |(at, radius): &(MmPoint, f32)| {
            nearest_on_segment(*at, stroke.0, stroke.1).0 >= self.params.beside_disc(*radius)
        };
        is_free &= self.points.iter().all(is_beside);
        is_free && self.others.iter().all(|other| segment_distance(stroke, *other) >= clearance)
    }

    /// A head as a line, as broad as its shaft.
    fn polyline(&self, strokes: [MmPoint; 3], which: Tip) -> Polyline<Vertex> {
        let end = which.of(self.lines[self.line]);
        let (strength, width) = end.map_or((0.0, self.params.width_max), |end| (end.strength, end.width));
        let vertex = |at: MmPoint| Vertex {
            at,
            strength,
            contrast: [0.0; 3],
            width,
            stroke: 0.0,
            bar: 0.0,
            source: FoundIn::Vector,
            displaced: MmVector::zero(),
        };
        Polyline::open(strokes.map(vertex).to_vec())
    }
}

/// A line that goes straight on at one of its ends by so much, mm.
fn longer(line: &Polyline<Vertex>, which: Tip, by: f32) -> Polyline<Vertex> {
    let mut line = line.clone();
    if let (Some(at), Some(heading)) = (end(&line, which), heading(&line, which, HEADING)) {
        extend_to(&mut line, which, at + heading * by);
    }
    line
}

/// The strokes of a head with its tip at a place: their ends, and that between them.
pub(super) fn strokes(apex: MmPoint, toward: MmVector, length: f32) -> [MmPoint; 3] {
    let turned = |degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        apex - MmVector::new(toward.x * cos - toward.y * sin, toward.x * sin + toward.y * cos) * length
    };
    [turned(SPREAD), apex, turned(-SPREAD)]
}
