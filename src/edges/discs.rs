//! Small discs and rings on the lines of a bitmap, such as the points of a number line. What is found of one as strokes
//! and edges is torn by the line that goes through it, and the line goes round it. Its edge is a circle all the same:
//!
//! ```text
//! ridge points -> votes for a middle, along their normals (Hough) -> circle fit -> Disc
//! contours that lead to its middle end at its side, and a ring takes the place of the others there
//! ```

use lyon::geom::euclid::Box2D;

use super::contour::{Contour, ContourPoint, LineFit};
use super::params::Params;
use super::ridge::RidgePoint;
use super::tips::{FoundContour, IsSeen};
use crate::geom::circle as circle_through;
use crate::geom::nearby::Index;
use crate::geom::polygon::circle_points;
use crate::geom::polyline::Polyline;
use crate::geom::walk::runs;
use crate::units::{Px, PxPoint, PxVector, Size};

/// Least radius of a disc, in scales of the edge detector: a smaller one has no inside between its edges.
const SMALLEST: f32 = 2.0;
/// Greatest radius of a disc, in widths of the widest stroke that is drawn as one line: larger ones have room as they
/// are.
const LARGEST: f32 = 0.65;
/// A circle is seen if there are ridge points in so many of its [`PARTS`] equal arcs: lines hide the others. A square,
/// whose sides touch a circle at their middles, has points in ten.
const SEEN: usize = 14;
const PARTS: usize = 24;
/// Least number of pairs of opposite arcs that both have points: the round end of a stroke has three.
const OPPOSITE: usize = 5;
/// Greatest distance of these points from the circle, px.
const OFF: f32 = 0.9;
/// Least cosine between the normal of such a point and the radius through it (20 degrees).
const RADIAL: f32 = 0.94;
/// A hollow disc has an outline at least so wide, px, and a hole with a radius of at least this share of the outer one.
const OUTLINE: f32 = 1.5;
const HOLE: f32 = 0.3;
/// Distance from the side of a disc up to which contours are bent, in scales of the edge detector.
const BENT: f32 = 1.2;
/// The direction of an end at a disc is taken over this length, px: 2 px more than elsewhere, as it is bent beside the
/// disc.
const HEADING: f32 = 10.0;
/// An end leads to the middle if it does not pass it farther away than this share of the radius and this much more, px.
const MIDDLE: f32 = 0.35;
const MIDDLE_LEAST: f32 = 0.7;
/// Between two lines that lead to a disc at a small angle both are one thick spot up to this distance from its side, px
/// (two of 2.5 px at 10 degrees). One ends before the disc there, and the other is led aside.
const MERGED: f32 = 18.0;
/// Where they run before that is taken over this length, px, over which they are straight to this root mean square
/// distance, px.
const BEFORE: f32 = 24.0;
const EVEN: f32 = 0.3;
/// Where lines have been led aside, there is a disc if one of those that lead to it has this share of its contrast.
const BOLD: f32 = 0.5;

/// A disc, or a ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Disc {
    at: PxPoint,
    radius: f32,
    /// Width of its outline, px, if it is hollow.
    outline: Option<f32>,
    height: f32,
}

/// The contours of a drawing with each disc that lines lead to as a ring, at which they end. `is_seen` is that of
/// [`super::tips::join_corners`].
pub(super) fn split_at_discs(
    mut found: Vec<FoundContour>,
    discs: &[Disc],
    params: &Params,
    is_seen: &IsSeen<'_>,
) -> Vec<FoundContour> {
    for disc in discs {
        let reach = disc.radius + BENT * params.sigma;
        let is_at = |vertex: &ContourPoint| (vertex.at - disc.at).length() < reach;
        let are_there: Vec<bool> = found.iter().map(|found| found.contour.vertices.iter().any(is_at)).collect();
        let mut arms: Vec<FoundContour> = Vec::new();
        let (mut leads, mut led) = (true, true);
        for (contour, _) in found.iter().zip(&are_there).filter(|(_, is_there)| **is_there) {
            let outside = outside(contour, disc.at, reach);
            leads &= outside.iter().all(|part| leads_to(&part.contour, disc, reach, false));
            led &= outside.iter().all(|part| leads_to(&part.contour, disc, reach, true));
            arms.extend(outside.into_iter().filter(|part| part.contour.length() >= params.min_length));
        }
        // a gridline that is led round a digit makes no disc of that
        let has_bold = || arms.iter().any(|arm| arm.height() >= BOLD * disc.height);
        if !arms.is_empty() && (leads || led && has_bold()) {
            let mut are_there = are_there.into_iter();
            found.retain(|_| are_there.next() == Some(false));
            found.extend(arms);
            found.iter_mut().for_each(|found| disc.lead_to_side(found, reach, is_seen));
            found.push(disc.ring());
        }
    }
    found
}

/// The parts of a contour that lie outside of a circle.
fn outside(found: &FoundContour, middle: PxPoint, radius: f32) -> Vec<FoundContour> {
    let vertices = &found.contour.vertices;
    let is_outside: Vec<bool> = vertices.iter().map(|vertex| (vertex.at - middle).length() >= radius).collect();
    let runs = runs(vertices.len(), found.contour.closed, |a, b| is_outside[a] == is_outside[b]).into_iter();
    let part = |run: Vec<usize>| {
        let contour = Polyline::open(run.iter().map(|&i| vertices[i]).collect());
        FoundContour { contour, ..found.clone() }
    };
    runs.filter(|run| is_outside[run[0]] && run.len() > 1).map(part).collect()
}

/// Whether those ends of a contour that lie at the side of a disc lead to its middle; with `or_before` also if they
/// were led aside, and led there before.
fn leads_to(contour: &Contour, disc: &Disc, reach: f32, or_before: bool) -> bool {
    let ends = [(0, true), (contour.vertices.len() - 1, false)];
    ends.into_iter().all(|(end, forwards)| {
        let is_beside = (disc.at - contour.vertices[end].at).length() <= reach + 2.0;
        let leads_before = || or_before && disc.line_before(contour, end, forwards).is_some();
        !is_beside || disc.is_ahead(contour, end, forwards) || leads_before()
    })
}

impl Disc {
    /// Its middle.
    pub(super) fn at(&self) -> PxPoint {
        self.at
    }

    /// Whether an end of a contour leads to the middle.
    fn is_ahead(&self, contour: &Contour, end: usize, forwards: bool) -> bool {
        let inwards = contour.heading(end, forwards, [0.0, HEADING]);
        inwards.is_some_and(|inwards| self.is_on(contour.vertices[end].at, inwards))
    }

    /// Whether a line that leads away from the disc passes its middle.
    fn is_on(&self, from: PxPoint, away: PxVector) -> bool {
        let to_middle = self.at - from;
        to_middle.dot(away) < 0.0 && to_middle.cross(away).abs() <= MIDDLE * self.radius + MIDDLE_LEAST
    }

    /// The straight line away from the middle on which a contour runs before it comes near the disc with one of its
    /// ends.
    fn line_before(&self, contour: &Contour, end: usize, forwards: bool) -> Option<LineFit> {
        let from = self.radius + MERGED - (contour.vertices[end].at - self.at).length();
        let line = contour.line_fit(end, forwards, from.max(0.0), from.max(0.0) + BEFORE)?;
        (line.rms <= EVEN && self.is_on(line.centre, line.direction)).then_some(line)
    }

    /// Leads those ends of a stroke straight on to its side that lie near it, but not before it.
    fn lead_to_side(&self, found: &mut FoundContour, reach: f32, is_seen: &IsSeen<'_>) {
        let Some(width) = found.stroke.filter(|_| !found.contour.closed) else { return };
        for at_start in [true, false] {
            let contour = &found.contour;
            let end = if at_start { 0 } else { contour.vertices.len() - 1 };
            let distance = (contour.vertices[end].at - self.at).length();
            let is_there = distance <= reach + 2.0 && self.is_ahead(contour, end, at_start);
            if is_there || distance > self.radius + MERGED {
                continue;
            }
            let Some(line) = self.line_before(contour, end, at_start) else { continue };
            let [from, to] = [self.radius + MERGED, reach].map(|distance| self.at + line.direction * distance);
            if is_seen(from, to, width, found.least_seen(at_start)) {
                found.lead_to(self.at + line.direction * self.radius, at_start, MERGED);
            }
        }
    }

    /// Its contour: of a ring the middle of its outline, of a disc its side.
    fn ring(&self) -> FoundContour {
        let radius = self.radius - 0.5 * self.outline.unwrap_or(0.0);
        let count = (std::f32::consts::TAU * radius).ceil() as usize;
        // a stroke has none
        let contrast = [if self.outline.is_some() { 0.0 } else { self.height }, 0.0, 0.0];
        let vertex = |at: PxPoint| ContourPoint { at, strength: self.height, contrast, blur: 0.0, position_sigma: 0.0 };
        let vertices = circle_points(self.at, radius, count).map(vertex).collect();
        let contour = Polyline { vertices, closed: true };
        FoundContour { stroke: self.outline, ..FoundContour::edge(contour) }
    }
}

/// The discs in a picture, given by all its ridge points.
pub(super) fn find(points: &[RidgePoint], size: Size, params: &Params) -> Vec<Disc> {
    let [least, most] = [SMALLEST * params.sigma, LARGEST * params.widest_stroke];
    let strong: Vec<&RidgePoint> = points.iter().filter(|point| point.height >= params.high).collect();
    let (width, height) = (size.width as usize, size.height as usize);
    let cell = |at: PxPoint| {
        let is_inside = at.x >= 0.0 && at.y >= 0.0 && (at.x as usize) < width && (at.y as usize) < height;
        is_inside.then(|| at.y as usize * width + at.x as usize)
    };
    let mut votes = vec![0_u16; width * height];
    for point in &strong {
        for side in [1.0, -1.0] {
            let places = (0..).map(|k| least + k as f32).take_while(|radius| *radius <= most);
            for place in places.filter_map(|radius| cell(point.at + point.normal * (side * radius))) {
                votes[place] = votes[place].saturating_add(1);
            }
        }
    }
    let area = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    let mut index: Index<usize, Px> = Index::new(area, most);
    strong.iter().enumerate().for_each(|(number, point)| index.put_at(point.at, number));
    // the votes of a middle are spread over a cell and its neighbours
    let around = |x: usize, y: usize| -> u32 {
        let rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.map(|y| {
            votes[y * width + x.saturating_sub(1)..y * width + (x + 2).min(width)]
                .iter()
                .map(|v| u32::from(*v))
                .sum::<u32>()
        })
        .sum()
    };
    let enough = (SEEN as f32 / PARTS as f32 * std::f32::consts::TAU * least) as u32;
    let mut middles: Vec<(u32, PxPoint)> = Vec::new();
    for y in 0..height {
        for x in 0..width {
            // most cells have no votes at all
            if votes[y * width + x] > 1 {
                let sum = around(x, y);
                if sum >= enough {
                    middles.push((sum, PxPoint::new(x as f32 + 0.5, y as f32 + 0.5)));
                }
            }
        }
    }
    middles.sort_by_key(|(sum, _)| std::cmp::Reverse(*sum));
    let mut found: Vec<Disc> = Vec::new();
    for (_, middle) in middles {
        if found.iter().any(|disc| (disc.at - middle).length() < disc.radius + least) {
            continue;
        }
        let mut near: Vec<&RidgePoint> = Vec::new();
        index.around(middle, middle, most + OFF, |&number| near.push(strong[number]));
        if let Some(disc) = disc_at(middle, &near, [least, most])
            && !found.iter().any(|other| (other.at - disc.at).length() < other.radius + disc.radius)
        {
            found.push(disc);
        }
    }
    found
}

/// The disc around a place, given the points there.
fn disc_at(middle: PxPoint, points: &[&RidgePoint], [least, most]: [f32; 2]) -> Option<Disc> {
    let (mut at, mut radius) = (middle, None);
    // the second time from the middle of the circle
    for _ in 0..2 {
        let steps = (2.0 * (most - least)).max(0.0) as usize;
        let radii = (0..=steps).map(|k| most - 0.5 * k as f32);
        let facing = facing(at, points);
        let seen = radii.map(|radius| (radius, on_circle(radius, &facing)));
        let fullest = seen.filter(|(_, on)| is_seen(at, on)).max_by_key(|(_, on)| on.len())?;
        let fit = circle_through(fullest.1.iter().map(|point| point.at))?;
        (at, radius) = (fit.0, Some(fit.1));
    }
    let radius = radius.filter(|radius| (least..=most).contains(radius))?;
    let facing = facing(at, points);
    let on = on_circle(radius, &facing);
    if !is_seen(at, &on) {
        return None;
    }
    let height = on.iter().map(|point| point.height).sum::<f32>() / on.len() as f32;
    // the other edge of an outline
    let seen = |radius: &f32| is_seen(at, &on_circle(*radius, &facing));
    let steps = |from: f32, to: f32| (0..).map(move |k| from + 0.5 * k as f32).take_while(move |at| *at <= to);
    let inner = steps(HOLE * radius, radius - OUTLINE - OFF).filter(seen).last();
    let outer = steps(radius + OUTLINE + OFF, most).find(seen);
    let (radius, outline) = match (inner, outer) {
        (Some(inner), _) => (radius, Some(radius - inner)),
        (None, Some(outer)) => (outer, Some(outer - radius)),
        (None, None) => (radius, None),
    };
    Some(Disc { at, radius, outline, height })
}

/// The points whose normals lead to a middle, each with how far it is from there, px.
fn facing<'a>(middle: PxPoint, points: &[&'a RidgePoint]) -> Vec<(f32, &'a RidgePoint)> {
    let place = |point: &'a RidgePoint| {
        let to_middle = point.at - middle;
        let distance = to_middle.length();
        (to_middle.dot(point.normal).abs() >= RADIAL * distance).then_some((distance, point))
    };
    points.iter().copied().filter_map(place).collect()
}

/// Those of the points that face a middle which are on a circle around it.
fn on_circle<'a>(radius: f32, facing: &[(f32, &'a RidgePoint)]) -> Vec<&'a RidgePoint> {
    let is_on = |(distance, _): &&(f32, &RidgePoint)| (distance - radius).abs() <= OFF;
    facing.iter().filter(is_on).map(|(_, point)| *point).collect()
}

/// In which parts of a circle points lie.
fn parts(middle: PxPoint, points: &[&RidgePoint]) -> [bool; PARTS] {
    let mut seen = [false; PARTS];
    for point in points {
        let turn = (point.at - middle).angle_from_x_axis().radians / std::f32::consts::TAU + 0.5;
        seen[((turn * PARTS as f32) as usize).min(PARTS - 1)] = true;
    }
    seen
}

/// Whether points lie all round a circle.
fn is_seen(middle: PxPoint, points: &[&RidgePoint]) -> bool {
    let seen = parts(middle, points);
    let (one, other) = seen.split_at(PARTS / 2);
    let opposite = one.iter().zip(other).filter(|(one, other)| **one && **other).count();
    seen.iter().filter(|seen| **seen).count() >= SEEN && opposite >= OPPOSITE
}

#[cfg(test)]
mod tests;
