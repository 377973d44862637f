//! Sharp corners: the tips of triangles, leaves and arrows. Beside a tip the two sides of it are near one another, and
//! yet they are neither the two sides of a stroke nor a line that comes back to itself.

use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::MmPoint;

/// The length along a corner of 20 degrees is at most this many times the distance between its sides: 1 / sin 10.
/// Sharper ones are felt as one line, and in photographs they are the wobble of a contour.
pub(crate) const SHARPEST: f32 = 5.8;
/// Where the tip is rounded, the length along a corner may be this much longer, mm.
const ROUNDED: f32 = 1.5;
/// The sides are straight if the length over the tip is at least this share of the length along the line. Strokes with
/// a square end have 0.86 at most, with a round end 0.92.
pub(crate) const STRAIGHTNESS: f32 = 0.94;

/// Whether between two places of a line there is nothing but a sharp corner with straight sides. `arcs` are the arc
/// lengths of the line's path; it is a ring if `ring`; each place is given as its arc length and its point.
pub(super) fn is_corner(polyline: &Polyline<Vertex>, arcs: &[f32], ring: bool, places: [(f32, MmPoint); 2]) -> bool {
    let [(s, a), (t, b)] = places;
    let (from, to) = (s.min(t), s.max(t));
    let total = arcs.last().copied().unwrap_or(0.0);
    let over_start = ring && total - (to - from) < to - from;
    let length = if over_start { total - (to - from) } else { to - from };
    if length > SHARPEST * (b - a).length() + ROUNDED {
        return false;
    }
    // nothing but what is between is looked at: it is asked of each vertex of long lines
    let [start, end] = [from, to].map(|place| arcs.partition_point(|arc| *arc < place));
    let (first, last) = if over_start { (0..start, end..arcs.len()) } else { (start..end, 0..0) };
    let at = |i: usize| polyline.vertices[i % polyline.vertices.len()].at;
    let height = |at: MmPoint| (at - a).cross(b - a).abs();
    let tip = first.chain(last).map(at).max_by(|p, q| height(*p).total_cmp(&height(*q)));
    tip.is_some_and(|tip| (tip - a).length() + (tip - b).length() >= STRAIGHTNESS * length)
}

#[cfg(test)]
mod tests;
