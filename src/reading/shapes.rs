//! Subpaths that are dots and rhombuses.

use super::subpath::{Subpath, clean};
use crate::geom::right_of;
use crate::page::{Glyph, Shape};
use crate::units::{MmPoint, MmVector};

/// How far the points of a disc may be from its mean radius, as a share of it: an oval of less is felt as a dot.
const ROUND: f32 = 0.08;
/// Fewest corners of a polygon that is taken for a disc.
const MANY: usize = 8;
/// Two diagonals cross in a rhombus: how far their middles may be apart, and how far from a right angle they may
/// be (its cosine), as a share.
const SQUARE: f32 = 0.1;
/// Corners in steps of 0.01 mm give a direction to this many degrees.
const UNSURE: f32 = 1.0;

/// The disc that a subpath is: its centre and diameter.
pub(super) fn disc(subpath: &Subpath) -> Option<(MmPoint, f32)> {
    let is_round = subpath.curved || subpath.points.len() >= MANY;
    if !subpath.closed || !is_round {
        return None;
    }
    let centre = mean(&subpath.named)?;
    let count = subpath.named.len() as f32;
    let radius = subpath.named.iter().map(|at| (*at - centre).length()).sum::<f32>() / count;
    let fits = |at: &MmPoint| ((*at - centre).length() - radius).abs() <= ROUND * radius + 0.002;
    (radius > 0.0 && subpath.points.iter().all(fits))
        .then(|| (MmPoint::new(clean(centre.x), clean(centre.y)), clean(2.0 * radius)))
}

/// The glyph that a subpath is.
pub(super) fn glyph(subpath: &Subpath) -> Option<Glyph> {
    if let Some((at, diameter)) = disc(subpath) {
        return Some(Glyph { at, shape: Shape::Dot { diameter } });
    }
    let &[a, b, c, d] = subpath.named.as_slice() else { return None };
    if subpath.curved || !subpath.closed {
        return None;
    }
    let (first, second) = ((a - c) * 0.5, (b - d) * 0.5);
    let (middle, other) = (a.lerp(c, 0.5), b.lerp(d, 0.5));
    let size = first.length().max(second.length());
    let apart = (middle - other).length();
    let cosine = first.dot(second).abs() / (first.length() * second.length()).max(f32::MIN_POSITIVE);
    if size <= 0.0 || apart > SQUARE * size || cosine > SQUARE {
        return None;
    }
    // the first corner is a tip in what we write; only what somebody drew has it elsewhere
    let (along, across) = if first.length() * 1.02 >= second.length() { (first, second) } else { (second, first) };
    let measured = (-along.y).atan2(along.x).to_degrees().rem_euclid(180.0);
    let five = 5.0 * (0.2 * measured).round();
    let whole = measured.round();
    let directions = [five, whole, whole - 1.0, whole + 1.0, measured];
    let directions = directions.into_iter().filter(|degrees| (degrees - measured).abs() <= UNSURE);
    let at = MmPoint::new(clean(middle.x), clean(middle.y));
    // the shape whose corners are these when they are written, if there is one
    let tries = directions.flat_map(|degrees| {
        let lengths = OFF.into_iter().flat_map(|long| OFF.into_iter().map(move |short| (long, short)));
        lengths.map(move |(long, short)| rhombus(along, across, degrees.rem_euclid(180.0), long, short))
    });
    let is_same = |shape: &Shape| {
        let corners = Glyph { at, shape: *shape }.corners();
        let near = |a: f32, b: f32| (a.abs() - b.abs()).abs() < 0.5 * WRITTEN - 1e-4;
        let alike = |corner: MmPoint, half: MmVector| near(corner.x - at.x, half.x) && near(corner.y - at.y, half.y);
        alike(corners[0], along) && alike(corners[1], across)
    };
    let shape = tries.into_iter().find(is_same).unwrap_or_else(|| rhombus(along, across, measured, 0.0, 0.0));
    Some(Glyph { at, shape })
}

/// Corners are written in steps of this, mm.
const WRITTEN: f32 = 0.01;
/// By how much a diagonal may be longer than it looks, mm.
const OFF: [f32; 5] = [0.0, 0.002, -0.002, 0.005, -0.005];

/// A rhombus of these half diagonals, its direction given.
fn rhombus(along: MmVector, across: MmVector, degrees: f32, longer: f32, broader: f32) -> Shape {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let tip = MmVector::new(cos, -sin);
    let side = right_of(tip);
    let (length, thickness) = (2.0 * along.dot(tip).abs(), 2.0 * across.dot(side).abs());
    Shape::Rhombus { length: (length + longer).max(0.0), thickness: (thickness + broader).max(0.0), degrees }
}

fn mean(points: &[MmPoint]) -> Option<MmPoint> {
    let count = points.len() as f32;
    let sum = points.iter().fold(MmVector::zero(), |sum, at| sum + at.to_vector());
    (!points.is_empty()).then(|| (sum / count).to_point())
}

#[cfg(test)]
mod tests;
