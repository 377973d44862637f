//! Angles between straight lines: a label that stands in one, such as the name of an angle of a triangle, says nothing
//! of that angle on the other side of its legs.
//!
//! ```text
//!        /            a leg
//!      (/  35         the label, beyond the arc if there is one
//!      /)________     the other leg
//! ```

use crate::geom::polyline::PolylineRef;
use crate::geom::simplify::simplify;
use crate::page::{Line, Pen};
use crate::units::{MmPoint, MmRect, MmVector};

/// Legs are at least so long, mm: ticks and arrowheads are shorter.
const LEG: f32 = 10.0;
/// Legs that would meet so far beyond their ends meet there, mm: lines stop short of others, by two dots on a grid, and
/// corners are rounded.
const MEETS: f32 = 5.0;
/// How far the points of a leg lie off the straight, mm: rows of dots on a grid lie up to a step off it, and
/// more where lines keep apart.
const STRAIGHT: f32 = 0.5;
const STRAIGHT_OF_DOTS: f32 = 3.0;
/// Legs differ in their direction by at least 10 degrees, and not by more than 170: the sine.
const OPEN: f32 = 0.17;
/// A text so near to the place where legs meet stands in their angle, mm.
const NEAR_VERTEX: f32 = 25.0;
/// Most straight lines of a page that are looked at: worksheets have some tens.
const MOST: usize = 400;

/// An angle: where its legs meet, and their directions, the second to the right of the first as a reader sees them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Angle {
    pub(super) vertex: MmPoint,
    legs: [MmVector; 2],
}

impl Angle {
    /// Whether a point lies between the legs.
    fn holds(&self, at: MmPoint) -> bool {
        let (to, [first, second]) = (at - self.vertex, self.legs);
        first.cross(to) > 0.0 && to.cross(second) > 0.0
    }

    /// Whether a box lies between them as a whole.
    pub(super) fn holds_box(&self, place: MmRect) -> bool {
        crate::geom::polygon::corners(place).into_iter().all(|corner| self.holds(corner))
    }

    /// The angle in which a point stands near the vertex.
    pub(super) fn around(at: MmPoint, all: &[Self]) -> Option<Self> {
        let far = |angle: &Self| (at - angle.vertex).length();
        let near = all.iter().filter(|angle| far(angle) <= NEAR_VERTEX && angle.holds(at));
        near.min_by(|a, b| far(a).total_cmp(&far(b))).copied()
    }
}

/// Whether a text is such as names an angle: one letter, which may have a prime or an index, a size in degrees, or
/// the question for it.
pub(super) fn is_name(text: &str) -> bool {
    let mut characters = text.trim().chars();
    let Some(first) = characters.next() else { return false };
    let rest: String = characters.collect();
    match first {
        '?' => rest.is_empty() || rest == "°",
        '0'..='9' => rest.ends_with('°') && rest.chars().all(|c| c.is_ascii_digit() || ".,°".contains(c)),
        _ => first.is_alphabetic() && rest.chars().count() <= 1 && !rest.chars().any(char::is_alphabetic),
    }
}

/// The angles between the straight parts of lines.
pub(super) fn of<'a>(lines: impl IntoIterator<Item = &'a Line>) -> Vec<Angle> {
    let straight = straight_parts(lines);
    if straight.len() > MOST {
        return Vec::new();
    }
    // where legs meet, and in which directions they lead away from there
    let mut vertices: Vec<(MmPoint, Vec<MmVector>)> = Vec::new();
    for (number, &one) in straight.iter().enumerate() {
        for &other in &straight[..number] {
            let Some(at) = meeting(one, other) else { continue };
            let known = vertices.iter().position(|(vertex, _)| (*vertex - at).length() <= MEETS);
            let number = known.unwrap_or_else(|| {
                vertices.push((at, Vec::new()));
                vertices.len() - 1
            });
            vertices[number].1.extend([one, other].into_iter().flat_map(|part| legs(part, at)));
        }
    }
    vertices.into_iter().flat_map(|(vertex, legs)| angles_at(vertex, legs)).collect()
}

/// The straight parts of lines that are long enough for a leg.
fn straight_parts<'a>(lines: impl IntoIterator<Item = &'a Line>) -> Vec<(MmPoint, MmPoint)> {
    let runs = lines.into_iter().flat_map(|line| &line.runs);
    let parts = runs.flat_map(|run| {
        let tolerance = if run.pen == Pen::Stroke { STRAIGHT } else { STRAIGHT_OF_DOTS };
        let path: Vec<MmPoint> = run.polyline().path().copied().collect();
        let kept = simplify(PolylineRef { vertices: &path, closed: false }, tolerance);
        kept.windows(2).map(|pair| (path[pair[0]], path[pair[1]])).collect::<Vec<_>>()
    });
    parts.filter(|(a, b)| (*b - *a).length() >= LEG).collect()
}

/// Where two straight parts meet at an angle, on both of them or a little beyond their ends.
fn meeting((a, b): (MmPoint, MmPoint), (c, d): (MmPoint, MmPoint)) -> Option<MmPoint> {
    let (one, other) = (b - a, d - c);
    let (length, of_other) = (one.length(), other.length());
    let across = one.cross(other);
    if across.abs() < OPEN * length * of_other {
        return None;
    }
    let along = (c - a).cross(other) / across;
    let on_other = (c - a).cross(one) / across;
    let is_on = |share: f32, length: f32| (-MEETS..=length + MEETS).contains(&(share * length));
    (is_on(along, length) && is_on(on_other, of_other)).then(|| a + one * along)
}

/// The directions in which a straight part leads away from a point on it.
fn legs((a, b): (MmPoint, MmPoint), from: MmPoint) -> impl Iterator<Item = MmVector> {
    [a, b].into_iter().map(move |end| end - from).filter(|leg| leg.length() >= LEG).map(MmVector::normalize)
}

/// The angles between legs that follow one another around a vertex.
fn angles_at(vertex: MmPoint, mut legs: Vec<MmVector>) -> Vec<Angle> {
    legs.sort_by(|a, b| a.y.atan2(a.x).total_cmp(&b.y.atan2(b.x)));
    legs.dedup_by(|a, b| a.dot(*b) > 0.0 && a.cross(*b).abs() < OPEN);
    if legs.len() > 1 && legs[0].dot(legs[legs.len() - 1]) > 0.0 && legs[0].cross(legs[legs.len() - 1]).abs() < OPEN {
        legs.pop();
    }
    let pairs = (0..legs.len()).map(|number| [legs[number], legs[(number + 1) % legs.len()]]);
    // those of more than half a turn have the second leg on the other side
    pairs.filter(|[first, second]| first.cross(*second) >= OPEN).map(|legs| Angle { vertex, legs }).collect()
}

#[cfg(test)]
mod tests;
