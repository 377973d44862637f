//! Dashed lines of drawings: an altitude of a triangle, a hidden edge, an axis of symmetry, a border. A dash is too
//! short for a line on a page; dashes in a row become one line that runs along all of them.

mod alike;
mod corners;

use std::collections::HashSet;

use self::alike::{ALIKE, ROUNDING, are_alike};
use self::corners::RowEnd;
use super::contour::{Contour, ContourPoint, crossing};
use super::stroke::Stroke;
use super::tips::FoundContour;
use crate::geom::link::{End, LinkedChain, Part, link};
use crate::geom::nearby::Index;
use crate::geom::{first_eigenvector, right_of};
use crate::units::{Px, PxPoint, PxVector};
use lyon::geom::euclid::Box2D;

/// A dash is at most so many times as long as the shortest contour (2 mm on the page). Longer pieces are lines of their
/// own.
const LONGEST: f32 = 6.0;
/// The ring around a dash whose two sides were found is at most so many times as broad: beyond that it is an area.
const BROADEST: f32 = 1.2;
/// The ring around a dash is at least so many times as long as broad: a dot has no direction.
const ELONGATED: f32 = 1.5;
/// The ends of a dash are at least this share of its length apart: it may bend a little with the line.
const STRAIGHTNESS: f32 = 0.95;
/// The gap between two dashes is at most so many times as long as the shorter of them: the dash patterns of drawing
/// programs have gaps from a third to the whole of a dash, and a stroke's end looks shorter by its blur.
const WIDEST_GAP: f32 = 1.5;
/// Cosine between the direction of a dash and the direction of the next one (18 degrees).
const AHEAD_COSINE: f32 = 0.95;
/// The same of what goes on beyond a dash that is missing (8 degrees).
const STRAIGHT_ON: f32 = 0.99;
/// Fewer than this are no row; with dashes that are too short to be strokes by themselves.
const FEWEST: usize = 3;
const FEWEST_SHORT: usize = 4;

/// A short straight piece.
struct Dash {
    /// The number of its contour.
    number: usize,
    ends: [PxPoint; 2],
    length: f32,
    width: f32,
}

/// Dashes that follow one another.
struct DashRow<'a> {
    dashes: Vec<&'a Dash>,
    /// Both ends of each dash, in the order of the row.
    ends: Vec<[PxPoint; 2]>,
    /// Both ends of each gap.
    gaps: Vec<[PxPoint; 2]>,
    closed: bool,
}

/// Strings dashes in a row together to one stroke each; also returns how many such rows there are. `sigma` is the scale
/// of the edge detector and `least` the length of the shortest contour, px.
pub(super) fn merged_dashes(found: Vec<FoundContour>, sigma: f32, least: f32) -> (Vec<FoundContour>, usize) {
    let dashes: Vec<Dash> = (0..).zip(&found).filter_map(|(number, found)| dash(number, found, sigma, least)).collect();
    if dashes.len() < FEWEST {
        return (found, 0);
    }
    let segments = Segments::of(&found, longest_gap(least));
    let mut rows: Vec<DashRow> = rows(&dashes, least).into_iter().filter(|row| !row.is_hidden(&segments)).collect();
    let mut taken: HashSet<usize> = rows.iter().flat_map(DashRow::numbers).collect();
    rows.iter_mut().filter(|row| !row.closed).for_each(|row| row.go_on(&dashes, &segments, &mut taken));
    let mut lines: Vec<FoundContour> = rows.iter().map(|row| row.line(&found)).collect();
    let dash = rows.iter().flat_map(|row| &row.dashes).map(|dash| dash.length).fold(0.0, f32::max);
    let bent: Vec<bool> = found.iter().map(|found| is_bent_dash(found, dash)).collect();
    let is_met =
        |way: [PxPoint; 2]| segments.first_met(way, |number| !taken.contains(&number) && !bent[number]).is_some();
    let ends: Vec<RowEnd> = (0..).zip(&rows).flat_map(|(number, row)| row.open_ends(number)).collect();
    let tips = corners::join(&ends, &mut lines, &is_met);
    let is_around = |found: &FoundContour, tip: &PxPoint| {
        found.contour.vertices.iter().all(|vertex| (vertex.at - *tip).length() <= dash)
    };
    taken.extend((0..found.len()).filter(|&of| bent[of] && tips.iter().any(|tip| is_around(&found[of], tip))));
    for (row, line) in rows.iter().zip(&mut lines).filter(|(row, _)| !row.closed) {
        extend_ends(&mut line.contour, row.period(), &segments, &taken, &tips);
    }
    let count = lines.len();
    let others = (0..).zip(found).filter(|(number, _)| !taken.contains(number)).map(|(_, found)| found);
    (others.chain(lines).collect(), count)
}

/// Strokes without those that are too short to be ones and in no row of dashes. `least` is the length of the shortest
/// contour, px.
pub(super) fn without_loose(strokes: Vec<Stroke>, least: f32) -> Vec<Stroke> {
    if !strokes.iter().any(|stroke| stroke.is_dash) {
        return strokes;
    }
    // of one row some may be just long enough
    let open = (0..).zip(&strokes).filter(|(_, stroke)| !stroke.contour.closed);
    let dashes = open.filter_map(|(number, stroke)| open_dash(number, &stroke.contour, stroke.width, least));
    let dashes: Vec<Dash> = dashes.collect();
    let rows = rows(&dashes, least);
    let long_rows = rows.iter().filter(|row| row.dashes.len() >= FEWEST_SHORT);
    let in_rows: HashSet<usize> = long_rows.flat_map(DashRow::numbers).collect();
    let numbered = (0..).zip(strokes);
    numbered.filter(|(number, stroke)| !stroke.is_dash || in_rows.contains(number)).map(|(_, stroke)| stroke).collect()
}

fn longest_gap(least: f32) -> f32 {
    WIDEST_GAP * LONGEST * least
}

/// The rows of dashes that are even.
fn rows(dashes: &[Dash], least: f32) -> Vec<DashRow<'_>> {
    let ends: Vec<End<Px>> = (0..).zip(dashes).flat_map(|(polyline, dash)| dash.both_ends(polyline)).collect();
    let threads = link(dashes.len(), &ends, longest_gap(least), |a, b| cost(a, b, dashes));
    threads.iter().map(|thread| DashRow::of(thread, dashes)).filter(DashRow::is_even).collect()
}

/// The segments of all contours by place, each with the number of its contour.
struct Segments(Index<(usize, [PxPoint; 2]), Px>);

impl Segments {
    fn of(found: &[FoundContour], cell: f32) -> Self {
        let points = found.iter().flat_map(|found| &found.contour.vertices).map(|vertex| vertex.at);
        let mut index = Index::new(Box2D::from_points(points), cell);
        for (number, found) in found.iter().enumerate() {
            for (a, b) in found.contour.segments() {
                index.put_over(a.at.min(b.at), a.at.max(b.at), (number, [a.at, b.at]));
            }
        }
        Self(index)
    }

    /// How far along a segment it meets the first segment of a contour that counts, px.
    fn first_met(&self, displacement @ [from, to]: [PxPoint; 2], counts: impl Fn(usize) -> bool) -> Option<f32> {
        let mut nearest: Option<f32> = None;
        self.0.around(from.min(to), from.max(to), ON, |&(number, segment)| {
            if counts(number)
                && let Some(ahead) = ahead(displacement, segment)
                && nearest.is_none_or(|least| ahead < least)
            {
                nearest = Some(ahead);
            }
        });
        nearest
    }
}

/// A contour as a dash, if it is one.
fn dash(number: usize, FoundContour { contour, stroke, .. }: &FoundContour, sigma: f32, least: f32) -> Option<Dash> {
    let (ends, width) = match (contour.closed, stroke) {
        (true, None) => around(contour, sigma, least)?,
        (false, Some(width)) => return open_dash(number, contour, *width, least),
        _ => return None,
    };
    let length = (ends[1] - ends[0]).length();
    (length > 0.0 && length <= LONGEST * least).then_some(Dash { number, ends, length, width })
}

/// Whether a contour is no longer than a dash of this length, which may be bent around a corner: the stroke, or its two
/// sides. A stroke that is a ring is a mark.
fn is_bent_dash(FoundContour { contour, stroke, .. }: &FoundContour, dash: f32) -> bool {
    let sides = if contour.closed { 2.0 } else { 1.0 };
    !(contour.closed && stroke.is_some()) && contour.length() <= sides * (ALIKE * dash + ROUNDING)
}

/// A stroke as a dash, if it is one.
fn open_dash(number: usize, contour: &Contour, width: f32, least: f32) -> Option<Dash> {
    let ends = [contour.vertices.first()?.at, contour.vertices.last()?.at];
    let length = (ends[1] - ends[0]).length();
    let is_straight = length >= STRAIGHTNESS * contour.length();
    (is_straight && length > 0.0 && length <= LONGEST * least).then_some(Dash { number, ends, length, width })
}

/// The ends and the width of a dash inside the ring of its sides.
fn around(ring: &Contour, sigma: f32, least: f32) -> Option<([PxPoint; 2], f32)> {
    let points = || ring.vertices.iter().map(|vertex| vertex.at);
    if ring.length() > 2.0 * (LONGEST + BROADEST) * least {
        return None;
    }
    let centre = (points().map(|at| at.to_vector()).sum::<PxVector>() / ring.vertices.len().max(1) as f32).to_point();
    let moment = |f: &dyn Fn(PxVector) -> f32| points().map(|at| f(at - centre)).sum::<f32>();
    let along: PxVector = first_eigenvector(moment(&|v| v.x * v.x), moment(&|v| v.x * v.y), moment(&|v| v.y * v.y))?;
    let extent = |direction: PxVector| {
        let places = || points().map(|at| (at - centre).dot(direction));
        (places().fold(f32::MAX, f32::min), places().fold(f32::MIN, f32::max))
    };
    let ((from, to), (left, right)) = (extent(along), extent(right_of(along)));
    let breadth = right - left;
    // blur puts the sides of a thin stroke a scale of the detector from its middle
    let width = (breadth * breadth - 4.0 * sigma * sigma).max(1.0).sqrt();
    let is_dash = breadth <= BROADEST * least && to - from >= ELONGATED * breadth;
    is_dash.then_some(([centre + along * from, centre + along * to], width))
}

impl Dash {
    fn both_ends(&self, polyline: usize) -> [End<Px>; 2] {
        let [start, last] = self.ends;
        let direction = (last - start) / self.length;
        [(true, start, -direction), (false, last, direction)].map(|(at_start, at, direction)| End {
            polyline,
            at_start,
            at,
            direction,
            contrast: [0.0; 3],
        })
    }
}

/// The length of the gap between two dashes, if one goes on in the other.
fn cost(a: &End<Px>, b: &End<Px>, dashes: &[Dash]) -> Option<f32> {
    let [first, second] = [a, b].map(|end| dashes[end.polyline].length);
    let gap = b.at - a.at;
    let distance = gap.length();
    if a.polyline == b.polyline || distance <= 0.0 || distance > WIDEST_GAP * first.min(second) {
        return None;
    }
    let displacement = gap / distance;
    (a.direction.dot(displacement) >= AHEAD_COSINE && -b.direction.dot(displacement) >= AHEAD_COSINE)
        .then_some(distance)
}

impl<'a> DashRow<'a> {
    fn of(thread: &LinkedChain, dashes: &'a [Dash]) -> Self {
        let ends = |part: &Part| {
            let [start, last] = dashes[part.polyline].ends;
            if part.reversed { [last, start] } else { [start, last] }
        };
        let ends: Vec<[PxPoint; 2]> = thread.parts.iter().map(ends).collect();
        let mut gaps: Vec<[PxPoint; 2]> = ends.windows(2).map(|pair| [pair[0][1], pair[1][0]]).collect();
        if thread.closed {
            gaps.extend(ends.last().zip(ends.first()).map(|(last, first)| [last[1], first[0]]));
        }
        let dashes = thread.parts.iter().map(|part| &dashes[part.polyline]).collect();
        Self { dashes, ends, gaps, closed: thread.closed }
    }

    /// The numbers of its contours.
    fn numbers(&self) -> impl Iterator<Item = usize> {
        self.dashes.iter().map(|dash| dash.number)
    }

    fn gap_lengths(&self) -> impl Iterator<Item = f32> {
        self.gaps.iter().map(|[a, b]| (*b - *a).length())
    }

    /// Whether they are enough, and dashes and gaps are alike.
    fn is_even(&self) -> bool {
        let alike = |lengths: &mut dyn Iterator<Item = f32>| {
            let (least, most) = lengths.fold((f32::MAX, 0.0_f32), |(low, high), v| (low.min(v), high.max(v)));
            are_alike(least, most)
        };
        let lengths = || self.dashes.iter().map(|dash| dash.length);
        let cut = usize::from(!self.closed);
        let inner = || lengths().take(self.dashes.len() - cut).skip(cut);
        let longest = inner().fold(0.0_f32, f32::max);
        self.dashes.len() >= FEWEST
            && alike(&mut inner())
            && alike(&mut self.gap_lengths())
            && lengths().all(|length| length <= ALIKE * longest + ROUNDING)
    }

    /// Whether more than half of the gaps have something between: the pieces of a grid line that bars hide are no
    /// dashes.
    fn is_hidden(&self, segments: &Segments) -> bool {
        let own: HashSet<usize> = self.numbers().collect();
        let is_filled = |gap: &&[PxPoint; 2]| segments.first_met(**gap, |number| !own.contains(&number)).is_some();
        2 * self.gaps.iter().filter(is_filled).count() > self.gaps.len()
    }

    /// Goes on beyond a dash that has become a part of another line, as one that crosses a gridline, with dashes that
    /// are in no row. Those that it takes are `taken`.
    fn go_on(&mut self, dashes: &'a [Dash], segments: &Segments, taken: &mut HashSet<usize>) {
        for _ in 0..2 {
            self.reverse();
            while let Some((dash, ends)) = self.next(dashes, segments, taken) {
                taken.insert(dash.number);
                self.gaps.extend(self.ends.last().map(|last| [last[1], ends[0]]));
                self.dashes.push(dash);
                self.ends.push(ends);
            }
        }
    }

    fn reverse(&mut self) {
        self.dashes.reverse();
        for pairs in [&mut self.ends, &mut self.gaps] {
            pairs.reverse();
            pairs.iter_mut().for_each(|pair| pair.reverse());
        }
    }

    /// The dash that is straight ahead behind a gap, or behind one more dash that there is something else in place of.
    fn next(
        &self,
        dashes: &'a [Dash],
        segments: &Segments,
        taken: &HashSet<usize>,
    ) -> Option<(&'a Dash, [PxPoint; 2])> {
        let [before, last] = *self.ends.last()?;
        let direction = (last - before).try_normalize()?;
        let gap = self.gap_lengths().fold(0.0, f32::max);
        let longest = self.dashes.iter().map(|dash| dash.length).fold(0.0, f32::max);
        let is_ahead = |way: PxVector| way.length() > 0.0 && direction.dot(way) >= STRAIGHT_ON * way.length();
        let is_one_of_them = |dash: &Dash| {
            let (width, other) = (dash.width, self.dashes[0].width);
            dash.length <= ALIKE * longest + ROUNDING && are_alike(width, other)
        };
        let free = dashes.iter().filter(|dash| !taken.contains(&dash.number) && is_one_of_them(dash));
        let both = free.flat_map(|dash| [dash.ends, [dash.ends[1], dash.ends[0]]].map(|ends| (dash, ends)));
        let is_next = |(dash, [near, far]): &(&Dash, [PxPoint; 2])| {
            let far_off = (*near - last).length();
            let is_other = |number: usize| number != dash.number && !taken.contains(&number);
            let is_passed = || segments.first_met([last, *near], is_other).is_some();
            let is_near = far_off <= gap + ROUNDING || far_off <= 2.0 * gap + longest + ROUNDING && is_passed();
            is_near && is_ahead(*near - last) && is_ahead(*far - *near)
        };
        both.filter(is_next).min_by(|a, b| (a.1[0] - last).length().total_cmp(&(b.1[0] - last).length()))
    }

    /// The length of a dash and of a gap, together, px: the mean.
    fn period(&self) -> f32 {
        let dash: f32 = self.dashes.iter().map(|dash| dash.length).sum();
        dash / self.dashes.len() as f32 + self.gap_lengths().sum::<f32>() / self.gaps.len().max(1) as f32
    }

    /// Its ends; a ring has none.
    fn open_ends(&self, row: usize) -> Vec<RowEnd> {
        let (first, last) = (self.ends[0], self.ends[self.ends.len() - 1]);
        let width = self.dashes.iter().map(|dash| dash.width).sum::<f32>() / self.dashes.len() as f32;
        let end = |at_start: bool, [inner, at]: [PxPoint; 2]| {
            let direction = (at - inner).try_normalize().unwrap_or_default();
            RowEnd { row, at_start, at, direction, reach: self.period() + ROUNDING, width }
        };
        if self.closed { Vec::new() } else { vec![end(true, [first[1], first[0]]), end(false, last)] }
    }

    /// The line along the row; a point every pixel.
    fn line(&self, found: &[FoundContour]) -> FoundContour {
        let count = self.dashes.len() as f32;
        let width = self.dashes.iter().map(|dash| dash.width / count).sum();
        let contours = || self.numbers().map(|number| &found[number].contour);
        let mean = |contour: &Contour| {
            let sum: f32 = contour.vertices.iter().map(|vertex| vertex.strength).sum();
            sum / contour.vertices.len().max(1) as f32
        };
        let strength = contours().map(|contour| mean(contour) / count).sum();
        let sample = contours().find_map(|contour| contour.vertices.first().copied());
        let point =
            |at: &PxPoint| sample.map(|sample| ContourPoint { at: *at, strength, contrast: [0.0; 3], ..sample });
        let mut contour =
            Contour { vertices: self.ends.iter().flatten().filter_map(point).collect(), closed: self.closed };
        contour.subdivide(1.0);
        FoundContour { whole: contour.length(), contour, stroke: Some(width), tint: None }
    }
}

/// Extends the ends of a dashed line straight to what they point at within one more gap and dash: a dash that touches
/// another line has become a part of that. What is `taken` is in rows. Those that end at a corner, one of the `tips`,
/// stay.
fn extend_ends(line: &mut Contour, period: f32, segments: &Segments, taken: &HashSet<usize>, tips: &[PxPoint]) {
    for _ in 0..2 {
        line.reverse();
        let Some(&end) = line.vertices.last() else { return };
        if tips.iter().any(|tip| (*tip - end.at).length() < ON) {
            continue;
        }
        let before = line.vertices[line.vertices.len().saturating_sub(period.ceil() as usize)];
        let Some(direction) = (end.at - before.at).try_normalize() else { continue };
        let displacement = [end.at, end.at + direction * (period + ROUNDING)];
        if let Some(ahead) = segments.first_met(displacement, |number| !taken.contains(&number)) {
            line.lead_to(end.at + direction * ahead);
        }
    }
}

/// How far beyond its ends a segment still meets another, px.
const ON: f32 = 1e-3;

/// How far along a segment it meets a segment, px, if it does; an end of the segment belongs to it.
fn ahead([from, to]: [PxPoint; 2], [a, b]: [PxPoint; 2]) -> Option<f32> {
    let (displacement, segment) = (to - from, b - a);
    let (ahead, along) = crossing((from, displacement.try_normalize()?), (a, segment.try_normalize()?))?;
    let within = |at: f32, length: f32| (-ON..=length + ON).contains(&at);
    (within(ahead, displacement.length()) && within(along, segment.length())).then_some(ahead.max(0.0))
}

#[cfg(test)]
mod tests;
