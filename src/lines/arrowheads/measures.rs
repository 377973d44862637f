//! What finding and drawing heads share.

use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmPoint;

/// Angle between each stroke of a head and its shaft, degrees: an open head.
pub(super) const SPREAD: f32 = 35.0;
/// Lengths of its strokes, mm, the first that has room: together as wide as a fingertip (8 mm), or a little less.
pub(super) const LENGTHS: [f32; 3] = [7.0, 6.0, 5.0];
/// The direction of a shaft is taken over this length, mm.
pub(super) const HEADING: f32 = 2.0;
/// One end of a line.
pub(super) fn end(line: &Polyline<Vertex>, at_start: bool) -> Option<MmPoint> {
    let vertex = if at_start { line.vertices.first() } else { line.vertices.last() };
    vertex.map(|vertex| vertex.at)
}
