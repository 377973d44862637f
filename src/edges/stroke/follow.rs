//! Free ends of strokes that go on where pixels do not show them as strokes: between a light area and one that is
//! nearly as dark as the stroke, or where it is thinner than a pixel and lies on the border of two.
//!
//! An end is followed pixel by pixel along what is seen there, a stroke or the border of two areas, and is kept if that
//! leads to another stroke, or to the other end of the same one. What leads nowhere else is left to the detector of
//! edges. At the end of a stroke of another tint it ends, and does not go on in that.

use std::collections::HashSet;

use super::Stroke;
use super::breadth::are_two;
use super::centre::contrast_across;
use super::tint::Tint;
use crate::edges::contour::{Contour, ContourPoint};
use crate::edges::params::{HEADING, Params};
use crate::geom::link::{End, LinkedChain, link};
use crate::geom::nearby::Index;
use crate::geom::right_of;
use crate::raster::plane::Plane;
use crate::units::{Px, PxPoint, PxVector};
use lyon::geom::euclid::Box2D;

/// An end is followed for at most so many least lengths of a contour: shorter pieces of strokes between are not seen.
const FARTHEST: f32 = 6.0;
/// It is followed in steps of this, px.
const STEP: f32 = 1.0;
/// The middle of what is seen is looked for so far to both sides, px, beyond half the width of the stroke.
const ASIDE: f32 = 1.5;
/// The middle of what is seen is at most this far from where the stroke would go straight on, px.
const TURN: f32 = 0.35;
/// Half the distance over which the slope across it is taken, px.
const SLOPE: f32 = 0.5;
/// What is seen has at least this share of the contrast of the stroke.
const SEEN: f32 = 0.4;
/// For so many steps one after the other less contrast is seen, and the stroke still goes on.
const UNSEEN: usize = 2;
/// Another stroke is met where its middle is at most half of both widths and this far away, px.
const MEETS: f32 = 1.0;
/// An end that meets another stroke nearer to its end than so many widths, and this much more, px, meets its end.
const END_WIDTHS: f32 = 1.0;
const END: f32 = 6.0;
/// An end that is at another one from the beginning goes on in it if the cosine between their directions is at least
/// this (26 degrees).
const AHEAD_COSINE: f32 = 0.9;
/// A continuation that leads to another end goes on in it if that cosine is at most this: the two make a corner of at
/// least 60 degrees, as those of a triangle do. Otherwise it only ends there.
const SHARPEST: f32 = 0.5;
/// Side of the cells of the index of points, px.
const CELL: f32 = 8.0;

/// A point of a stroke or of a continuation from one of its ends, in an index.
#[derive(Debug, Clone, Copy)]
struct IndexedPoint {
    stroke: usize,
    /// The vertex of the stroke; none on a continuation.
    vertex: Option<usize>,
    at: PxPoint,
}

type StrokeIndex = Index<IndexedPoint, Px>;

/// The continuation from an end of a stroke, and what it leads to.
struct Continuation {
    points: Vec<ContourPoint>,
    met: IndexedPoint,
    /// Where it leads at its end.
    direction: PxVector,
}

/// An end of a stroke: its number, and whether it is the start.
type StrokeEnd = (usize, bool);

/// Strokes whose free ends are followed to one another.
pub(super) fn follow(mut strokes: Vec<Stroke>, planes: &[Plane], params: &Params) -> Vec<Stroke> {
    let Some(size) = planes.first().map(|plane| plane.size) else { return strokes };
    let picture = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    let mut marks = StrokeIndex::new(picture, CELL);
    for (number, stroke) in strokes.iter().enumerate() {
        for (vertex, point) in stroke.contour.vertices.iter().enumerate() {
            marks.put_at(point.at, IndexedPoint { stroke: number, vertex: Some(vertex), at: point.at });
        }
    }
    let open = (0..strokes.len()).filter(|&number| !strokes[number].contour.closed);
    let ends: Vec<StrokeEnd> = open.flat_map(|number| [(number, true), (number, false)]).collect();
    let (mut continuations, mut met) = (Vec::new(), Vec::new());
    for end in ends {
        let Some(Continuation { mut points, met: to, direction }) = continuation(end, &strokes, &marks, planes, params)
        else {
            continue;
        };
        let goes_on = |other: &StrokeEnd| {
            *other != end && turn(direction, *other, &strokes) <= SHARPEST && may_be_one(end.0, other.0, &strokes)
        };
        match end_at(&strokes, to).filter(goes_on) {
            Some(other) => met.push([end, other]),
            // it ends on the other one
            None => points.extend(points.last().copied().map(|last| ContourPoint { at: to.at, ..last })),
        }
        for point in &points {
            marks.put_at(point.at, IndexedPoint { stroke: end.0, vertex: None, at: point.at });
        }
        continuations.push((end, points));
    }
    for ((number, at_start), points) in continuations {
        let contour = &mut strokes[number].contour;
        if at_start {
            contour.reverse();
        }
        contour.vertices.extend(points);
        if at_start {
            contour.reverse();
        }
    }
    joined(strokes, &met)
}

/// The end of an open stroke that a mark is near.
fn end_at(strokes: &[Stroke], mark: IndexedPoint) -> Option<StrokeEnd> {
    let Stroke { contour, width, .. } = &strokes[mark.stroke];
    let vertex = mark.vertex.filter(|_| !contour.closed)?;
    let [to_start, to_end] =
        [false, true].map(|forwards| contour.walk(vertex, forwards).last().map_or(0.0, |(_, arc)| arc));
    (to_start.min(to_end) <= END_WIDTHS * width + END).then_some((mark.stroke, to_start <= to_end))
}

/// The last vertex of an end, and the direction in which it leaves the stroke.
fn leaving(contour: &Contour, at_start: bool) -> Option<(usize, PxVector)> {
    let tip = if at_start { 0 } else { contour.vertices.len().checked_sub(1)? };
    contour.heading(tip, at_start, [0.0, HEADING]).map(|inwards| (tip, -inwards))
}

/// Cosine between a direction and that in which a stroke leaves through one of its ends: -1 where the one goes straight
/// on in the other. 1 where the stroke is too short to tell.
fn turn(direction: PxVector, (other, at_start): StrokeEnd, strokes: &[Stroke]) -> f32 {
    leaving(&strokes[other].contour, at_start).map_or(1.0, |(_, leaving)| direction.dot(leaving))
}

/// Whether two strokes may be one: their breadths do not differ, nor their tints, as far as they are known.
fn may_be_one(one: usize, other: usize, strokes: &[Stroke]) -> bool {
    let [one, other] = [one, other].map(|number| &strokes[number]);
    !Tint::are_two(one.tint, other.tint) && !are_two(one.width, other.width)
}

/// The continuation from an end of a stroke, if it leads to another one or to another part of the same.
fn continuation(
    end: StrokeEnd,
    strokes: &[Stroke],
    marks: &StrokeIndex,
    planes: &[Plane],
    params: &Params,
) -> Option<Continuation> {
    let (number, at_start) = end;
    let Stroke { contour, width, .. } = &strokes[number];
    let (tip, mut direction) = leaving(contour, at_start)?;
    let last = contour.vertices[tip];
    let strength = contour.vertices.iter().map(|vertex| vertex.strength).sum::<f32>() / contour.vertices.len() as f32;
    let least = params.low.max(SEEN * strength);
    if let Some(met) = meets(last.at, end, 0.0, strokes, marks, params.widest_stroke.max(params.widest_of_bitmap())) {
        let goes_on = end_at(strokes, met).is_some_and(|other| {
            turn(direction, other, strokes) <= -AHEAD_COSINE && may_be_one(number, other.0, strokes)
        });
        return goes_on.then_some(Continuation { points: Vec::new(), met, direction });
    }
    let size = planes[0].size;
    let is_inside =
        |at: PxPoint| (0.0..=size.width as f32).contains(&at.x) && (0.0..=size.height as f32).contains(&at.y);
    let mut points: Vec<ContourPoint> = Vec::new();
    let (mut at, mut unseen) = (last.at, 0);
    for step in 1..=(FARTHEST * params.min_length / STEP) as usize {
        let straight = at + direction * STEP;
        let across = right_of(direction);
        let aside = middle(straight, across, 0.5 * width + ASIDE, planes);
        at = straight + across * aside.clamp(-TURN, TURN);
        let height = contrast_across(at, across, *width, planes);
        unseen = if height >= least { 0 } else { unseen + 1 };
        if unseen > UNSEEN || !is_inside(at) {
            return None;
        }
        points.push(ContourPoint { at, strength: height, ..last });
        if let Some(met) =
            meets(at, end, step as f32 * STEP, strokes, marks, params.widest_stroke.max(params.widest_of_bitmap()))
        {
            return Some(Continuation { points, met, direction });
        }
        let before = contour.walk(tip, at_start).map(|(vertex, _)| contour.vertices[vertex].at);
        let mut back = points.iter().rev().map(|point| point.at).chain(before);
        let back = back.find(|back| (at - *back).length() >= HEADING);
        direction = back.and_then(|back| (at - back).try_normalize()).unwrap_or(direction);
    }
    None
}

/// What is met at a place on the way from an end, so many pixels from it: the nearest that is not of what lies before
/// it. No stroke is wider than `widest`, px.
fn meets(
    at: PxPoint,
    (number, at_start): StrokeEnd,
    walked: f32,
    strokes: &[Stroke],
    marks: &StrokeIndex,
    widest: f32,
) -> Option<IndexedPoint> {
    let Stroke { contour, width, .. } = &strokes[number];
    let tip = if at_start { 0 } else { contour.vertices.len() - 1 };
    let mut nearest: Option<(f32, IndexedPoint)> = None;
    marks.around(at, at, 0.5 * (width + widest) + MEETS, |mark| {
        let distance = (mark.at - at).length();
        let reach = 0.5 * (width + strokes[mark.stroke].width) + MEETS;
        let own = 3.0 * reach + walked;
        let is_before = || {
            let before = contour.walk(tip, at_start).take_while(|(_, arc)| *arc <= own);
            mark.vertex.is_some_and(|vertex| before.map(|(vertex, _)| vertex).any(|before| before == vertex))
        };
        let is_nearer = nearest.is_none_or(|(least, known)| {
            distance.total_cmp(&least).then(mark.stroke.cmp(&known.stroke)).then(mark.vertex.cmp(&known.vertex)).is_lt()
        });
        if distance <= reach && is_nearer && !(mark.stroke == number && is_before()) {
            nearest = Some((distance, *mark));
        }
    });
    nearest.map(|(_, mark)| mark)
}

/// How far aside the middle is of what is seen across a continuation: the mean of places, each weighted with the square
/// of its slope. Of a stroke it is its middle, of the border of two areas the border.
fn middle(at: PxPoint, across: PxVector, reach: f32, planes: &[Plane]) -> f32 {
    let steps = (reach / SLOPE).ceil() as i32;
    let (mut sum, mut moment) = (0.0, 0.0);
    for k in -steps..=steps {
        let aside = k as f32 * SLOPE;
        let slope = |plane: &Plane| {
            let [right, left] = [aside + SLOPE, aside - SLOPE].map(|distance| at + across * distance);
            plane.at(right.x, right.y) - plane.at(left.x, left.y)
        };
        let square = planes.iter().map(|plane| slope(plane).powi(2)).sum::<f32>();
        sum += square;
        moment += square * aside;
    }
    if sum > 0.0 { moment / sum } else { 0.0 }
}

/// The strokes of which some ends are one, joined.
fn joined(strokes: Vec<Stroke>, met: &[[StrokeEnd; 2]]) -> Vec<Stroke> {
    let open = (0..strokes.len()).filter(|&number| !strokes[number].contour.closed);
    let end = |(number, at_start): StrokeEnd| {
        let vertices = &strokes[number].contour.vertices;
        let at = vertices[if at_start { 0 } else { vertices.len() - 1 }].at;
        End { polyline: number, at_start, at, direction: PxVector::zero(), contrast: [0.0; 3] }
    };
    let ends: Vec<End<Px>> = open.flat_map(|number| [end((number, true)), end((number, false))]).collect();
    let pairs: HashSet<[StrokeEnd; 2]> = met.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
    let is_pair = |a: &End<Px>, b: &End<Px>| pairs.contains(&[a, b].map(|end| (end.polyline, end.at_start)));
    let reach = met.iter().map(|pair| (end(pair[0]).at - end(pair[1]).at).length()).fold(0.0, f32::max);
    let threads = link(strokes.len(), &ends, reach, |a, b| is_pair(a, b).then(|| (b.at - a.at).length()));
    let mut left: Vec<Option<Stroke>> = strokes.into_iter().map(Some).collect();
    let of_thread = |thread: LinkedChain| {
        let mut parts = thread.parts.iter().filter_map(|part| {
            let mut stroke = left[part.polyline].take()?;
            if part.reversed {
                stroke.contour.reverse();
            }
            Some(stroke)
        });
        let first = parts.next()?;
        let mut whole = parts.fold(first, |mut whole, next| {
            let [before, after] = [&whole, &next].map(|stroke| stroke.contour.length());
            whole.width = (whole.width * before + next.width * after) / (before + after);
            whole.whole += next.whole;
            whole.contour.vertices.extend(next.contour.vertices);
            whole
        });
        whole.contour.closed |= thread.closed;
        whole.whole = whole.whole.max(whole.contour.length());
        Some(whole)
    };
    threads.into_iter().filter_map(of_thread).collect()
}

#[cfg(test)]
mod tests;
