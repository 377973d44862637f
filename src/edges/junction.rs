//! Junctions: a contour that ends just before another one is extended to it.
//!
//! Where three edges meet, the gradient has no single direction, and the weakest edge is found only up to a blur or two
//! before the others.

use lyon::geom::euclid::Box2D;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::contour::{Contour, ContourPoint, LineFit};
use crate::geom::nearby::Index;
use crate::geom::{line_crossing, nearest_on_segment};
use crate::units::{Px, PxPoint, PxVector, Size};

/// Greatest distance over which an end is extended, in blurs.
const MAX_EXTENSION: f32 = 3.5;
/// The last part of a contour before a junction is bent by the other contours: this much of it, in blurs, is replaced.
const BENT: f32 = 1.3;
/// A line is fitted to this much of the contour before that, in blurs.
const FIT_LENGTH: f32 = 4.0;
/// Least sine between a contour and the one that it is extended to: one nearly parallel is a neighbour, not a junction.
const MIN_SINE: f32 = 0.25;
/// How far beyond its ends a segment is still met, as a share of its length.
const TOLERANCE: f32 = 0.05;
/// Points this little beyond the junction, px, are removed too.
const TOO_CLOSE: f32 = 0.2;
/// Side of the cells of the index of points, px.
const CELL: f32 = 8.0;

/// Half length of the part of a contour in which a kink is looked for, px, and the greatest distance of the end of
/// another contour that causes it. The kink is straightened where the parts before and after it lie on one straight
/// line.
const KINK: f32 = 9.0;
/// Length over which a contour is straight before a kink and after it, px.
const STRAIGHT_LENGTH: f32 = 12.0;
/// Greatest distance of a straight part from its line, root mean square, px.
const EVEN: f32 = 0.3;
/// The straight parts before and after a kink lie on one line if the cosine between them is at least the first (6
/// degrees) and one lies beside the other by at most the second, px.
const COLLINEAR: f32 = 0.9945;
const IN_LINE: f32 = 0.75;

/// Distances of a point from another contour, px: up to the first it runs beside that, up to the second it lies on it.
const RUNS_BESIDE: f32 = 1.5;
const ON: f32 = 0.75;
/// Length over which an end runs along another contour before it is cut off, px: one that meets the contour at the
/// flattest angle (see `lines`) leaves it sooner.
const ALONG: f32 = 5.0;

/// An end of a contour with the line that it follows and the junction to which the line leads.
struct EndExtension {
    contour: usize,
    at_start: bool,
    line: LineFit,
    junction: PxPoint,
}

/// Whether an end of a contour may be led to another contour: the numbers of both, and the way from the end.
pub(super) type MayLead<'a> = dyn Fn(usize, usize, [PxPoint; 2]) -> bool + Sync + 'a;

/// Extends open ends to the contours at which they point, in a picture of `size`, where they may be.
pub(super) fn extend(contours: &mut [Contour], size: Size, may_lead: &MayLead<'_>) {
    let index = index_of(contours.iter(), size);
    let is_open = |&number: &usize| !contours[number].closed && contours[number].vertices.len() > 3;
    let both_ends = |number| [true, false].into_iter().map(move |at_start| (number, at_start));
    let ends = (0..contours.len()).into_par_iter().filter(is_open).flat_map_iter(both_ends);
    let extension = |(number, at_start)| extension(contours, &index, (number, at_start), may_lead);
    let found: Vec<_> = ends.filter_map(extension).collect();
    for extension in found {
        apply(&mut contours[extension.contour], &extension);
    }
}

/// Straightens contours beside the ends of others. Where a stroke meets a straight one at a small angle, the two are
/// one thick spot, and the middle of that, through which both were found, lies between them.
pub(super) fn straighten(contours: &mut [Contour], size: Size) {
    let index = index_of(contours.iter(), size);
    let ends = contours.iter().enumerate().filter(|(_, contour)| !contour.closed).flat_map(|(number, contour)| {
        contour.vertices.first().into_iter().chain(contour.vertices.last()).map(move |end| (number, end.at))
    });
    let kinks: Vec<Kink> = ends.filter_map(|(number, end)| kink(contours, &index, number, end)).collect();
    for Kink { contour, vertices, from, to } in kinks {
        for (k, vertex) in vertices.iter().enumerate() {
            contours[contour].vertices[*vertex].at = from.lerp(to, (k + 1) as f32 / (vertices.len() + 1) as f32);
        }
    }
}

/// The vertices of a contour that are to lie on the segment between two points.
struct Kink {
    contour: usize,
    vertices: Vec<usize>,
    from: PxPoint,
    to: PxPoint,
}

/// The kink of the contour on which another one ends, if that is straight before and after it.
fn kink(contours: &[Contour], index: &PointIndex, number: usize, end: PxPoint) -> Option<Kink> {
    let mut nearest: Option<(f32, usize, usize)> = None;
    index.around(end, end, KINK, |&(other, k)| {
        let (other, k) = (other as usize, k as usize);
        let distance = (contours[other].vertices[k].at - end).length();
        let is_nearer = nearest.is_none_or(|(least, a, b)| (distance, other, k) < (least, a, b));
        if other != number && distance <= KINK && is_nearer {
            nearest = Some((distance, other, k));
        }
    });
    let (_, other, at) = nearest?;
    let contour = &contours[other];
    let side = |forwards: bool| contour.line_fit(at, forwards, KINK, KINK + STRAIGHT_LENGTH);
    let [before, after] = [side(false)?, side(true)?];
    let is_straight = before.rms.max(after.rms) <= EVEN
        && before.direction.dot(after.direction) <= -COLLINEAR
        && (before.nearest(after.centre) - after.centre).length() <= IN_LINE
        && (after.nearest(before.centre) - before.centre).length() <= IN_LINE;
    if !is_straight {
        return None;
    }
    let within =
        |forwards: bool| contour.walk(at, forwards).take_while(|(_, arc)| *arc < KINK).map(|(vertex, _)| vertex);
    let beyond = |forwards: bool| contour.walk(at, forwards).find(|(_, arc)| *arc >= KINK).map(|(vertex, _)| vertex);
    let [from, to] = [beyond(false)?, beyond(true)?].map(|vertex| contour.vertices[vertex].at);
    let mut vertices: Vec<usize> = within(false).collect();
    vertices.reverse();
    vertices.extend(within(true).skip(1));
    Some(Kink { contour: other, vertices, from: before.nearest(from), to: after.nearest(to) })
}

/// Cuts off ends that run along another contour, up to the place where they come onto it: a stroke that was found
/// together with a piece of what it meets has a hook there, and what turns back is no junction.
pub(super) fn trim(contours: &mut [Contour], size: Size) {
    let index = index_of(contours.iter(), size);
    let mut kept: Vec<[usize; 2]> = contours.iter().map(|contour| [0, contour.vertices.len()]).collect();
    for number in 0..contours.len() {
        for at_start in [true, false] {
            if let Some(vertex) = hook(contours, &index, &kept, number, at_start) {
                if at_start {
                    kept[number][0] = vertex;
                } else {
                    kept[number][1] = vertex + 1;
                }
            }
        }
    }
    for (contour, [from, to]) in contours.iter_mut().zip(kept) {
        contour.vertices.truncate(to);
        contour.vertices.drain(..from);
    }
}

/// Where an end that runs along another contour comes onto it; `kept` is from where to where each contour is there yet.
fn hook(contours: &[Contour], index: &PointIndex, kept: &[[usize; 2]], number: usize, at_start: bool) -> Option<usize> {
    let (contour, [from, to]) = (&contours[number], kept[number]);
    if contour.closed || to < from + 2 {
        return None;
    }
    let is_there = |other: usize, k: usize| (kept[other][0]..kept[other][1]).contains(&k);
    let to_others = |at: PxPoint| {
        let mut least = f32::INFINITY;
        index.around(at, at, CELL, |&(other, k)| {
            let (other, k) = (other as usize, k as usize);
            let Some(next) = contours[other].next(k, 1).filter(|_| other != number) else { return };
            if is_there(other, k) && is_there(other, next) {
                let (a, b) = (contours[other].vertices[k].at, contours[other].vertices[next].at);
                least = least.min(nearest_on_segment(at, a, b).0);
            }
        });
        least
    };
    let tip = if at_start { from } else { to - 1 };
    let mut onto = None;
    for (vertex, arc) in contour.walk(tip, at_start).take_while(|(vertex, _)| is_there(number, *vertex)) {
        match to_others(contour.vertices[vertex].at) {
            distance if distance <= ON => onto = Some((vertex, arc)),
            // beside the other one, but not on it: it may touch it further on
            distance if distance <= RUNS_BESIDE => {}
            // it leaves the other one
            _ => return onto.filter(|(_, arc)| *arc > ALONG).map(|(vertex, _)| vertex),
        }
    }
    None
}

/// Where an end meets another contour if it continues straight on. The first that it would meet is in the way of those
/// behind: if it may not be led to that, it stays as it is.
fn extension(
    contours: &[Contour],
    index: &PointIndex,
    (number, at_start): (usize, bool),
    may_lead: &MayLead<'_>,
) -> Option<EndExtension> {
    let contour = &contours[number];
    let tip = if at_start { 0 } else { contour.vertices.len() - 1 };
    let ContourPoint { at: end, blur, .. } = contour.vertices[tip];
    let line = contour
        .line_fit(tip, at_start, BENT * blur, (BENT + FIT_LENGTH) * blur)
        .or_else(|| contour.line_fit(tip, at_start, 0.0, FIT_LENGTH * blur))?;
    let ahead = -line.direction; // the line is directed away from the tip
    let from = line.nearest(end) - ahead * (BENT * blur);
    let reach = (MAX_EXTENSION + BENT) * blur;
    // the last part of the contour itself does not count
    let is_own =
        |k: usize| contour.walk(tip, at_start).take_while(|(_, arc)| *arc < 3.0 * reach).any(|(own, _)| own == k);
    let mut nearest: Option<(f32, usize)> = None;
    index.around(end, end, reach, |&(other, k)| {
        let (other, k) = (other as usize, k as usize);
        let Some(next) = contours[other].next(k, 1) else { return };
        if other == number && (is_own(k) || is_own(next)) {
            return;
        }
        let (a, b) = (contours[other].vertices[k].at, contours[other].vertices[next].at);
        if let Some(distance) = crossing(from, ahead, a, b)
            && distance <= reach
            && nearest.is_none_or(|(least, _)| distance < least)
        {
            nearest = Some((distance, other));
        }
    });
    let (distance, other) = nearest?;
    let junction = from + ahead * distance;
    may_lead(number, other, [end, junction]).then_some(EndExtension { contour: number, at_start, line, junction })
}

/// Distance along the ray at which it crosses the segment `a`-`b`, if it does.
fn crossing(from: PxPoint, ahead: PxVector, a: PxPoint, b: PxPoint) -> Option<f32> {
    let side = b - a;
    let (distance, share) = line_crossing((from, ahead), (a, side), MIN_SINE * side.length())?;
    (distance >= 0.0 && (-TOLERANCE..=1.0 + TOLERANCE).contains(&share)).then_some(distance)
}

/// Moves the last points of a contour onto its line, up to the junction.
fn apply(contour: &mut Contour, extension: &EndExtension) {
    let EndExtension { at_start, line, junction, .. } = extension;
    if !at_start {
        contour.reverse();
    }
    let blur = contour.vertices[0].blur;
    let bent = contour.walk(0, true).take_while(|(_, arc)| *arc < BENT * blur).count();
    let tip = ContourPoint { at: *junction, ..contour.vertices[0] };
    for point in &mut contour.vertices[..bent] {
        point.at = line.nearest(point.at);
    }
    let is_beyond = |point: &ContourPoint| line.direction.dot(point.at - *junction) <= TOO_CLOSE;
    let beyond = contour.vertices.iter().take_while(|point| is_beyond(point)).count().min(bent);
    contour.vertices.splice(..beyond, [tip]);
    if !at_start {
        contour.reverse();
    }
}

/// The points of all contours by place, each as its contour and its number there.
pub(super) type PointIndex = Index<(u32, u32), Px>;

/// The index of the points of contours in a picture of `size`.
pub(super) fn index_of<'a>(contours: impl Iterator<Item = &'a Contour>, size: Size) -> PointIndex {
    let picture = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    let mut index = PointIndex::new(picture, CELL);
    for (number, contour) in contours.enumerate() {
        for (k, point) in contour.vertices.iter().enumerate() {
            index.put_at(point.at, (number as u32, k as u32));
        }
    }
    index
}

#[cfg(test)]
mod tests;
