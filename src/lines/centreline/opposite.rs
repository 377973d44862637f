//! What lies straight across from a vertex: the other side of a stroke.

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::geom::walk::arc_between;
use crate::geom::{crossing, right_of};
use crate::lines::corner::is_corner;
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::raster::contrast::{dot, length};
use crate::units::{MmPoint, MmRect, MmVector};

/// Least cosine between the directions of two sides (about 37 degrees).
const PARALLEL: f32 = 0.8;
/// Least cosine between the step back and the step up, as directions in colour space: a black axis below a yellow area
/// steps from white to black and from black to yellow, which have 0.45 in common.
const STEP_BACK: f32 = 0.3;
/// The smaller of the two steps is at least this share of the larger.
const ALIKE: f32 = 0.3;
/// On one line, opposite sides are parted by a bend: the length along it is longer than the distance across by this
/// factor (a half circle's is 1.57), and by this length, mm.
const BEND: f32 = 1.4;
const BEND_LEAST: f32 = 0.8;
/// What rounding may change, as a share: where two sides have vertices straight across from one another, as on
/// drawings, it must not decide which of two segments or ends is the opposite.
const ROUNDING: f32 = 1e-3;
/// Cells in which the other side is looked for, mm: about two vertices.
const CELL: f32 = 1.0;
/// Where there are more vertices than this to a square mm, as of lines a quarter of a mm apart, cells have this side,
/// mm: each vertex looks at all segments of a cell.
const DENSE: f32 = 10.0;
const CELL_OF_DENSE: f32 = 0.5;

/// Where a vertex has its opposite.
#[derive(Clone, Copy)]
pub(super) struct Opposite {
    /// The number of the polyline that it lies on.
    pub(super) polyline: usize,
    /// The number of the vertex nearest to it.
    pub(super) index: usize,
    pub(super) at: MmPoint,
}

/// For each vertex of a polyline its opposite, if it has one.
pub(super) type Opposites = Vec<Option<Opposite>>;

/// Finds for every vertex the nearest place on the opposite side of a stroke, if it lies on one: straight across within
/// [`Params::widest_stroke`], on either side of the line.
pub(super) fn opposites(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Opposites> {
    let sides = OppositeSides::new(polylines, area, params);
    let of = |(number, polyline): (usize, &Polyline<Vertex>)| match sides.is_dot(number) {
        true => vec![None; polyline.vertices.len()],
        false => (0..polyline.vertices.len()).map(|i| sides.opposite_of_edge(number, i)).collect(),
    };
    polylines.par_iter().enumerate().map(of).collect()
}

/// What may be a side of a stroke.
struct OppositeSides<'a> {
    polylines: &'a [Polyline<Vertex>],
    /// The length along each polyline to its vertices, mm.
    arcs: Vec<Vec<f32>>,
    segments: Nearby,
    params: &'a Params,
}

impl<'a> OppositeSides<'a> {
    fn new(polylines: &'a [Polyline<Vertex>], area: MmRect, params: &'a Params) -> Self {
        let arcs = polylines.iter().map(Polyline::arc_lengths).collect();
        let segments = Nearby::new(area, cell_of(polylines, area));
        let mut sides = Self { polylines, arcs, segments, params };
        for (number, polyline) in polylines.iter().enumerate() {
            if sides.is_dot(number) {
                continue;
            }
            for (i, (a, b)) in polyline.segments().enumerate() {
                // the middle of a stroke is no side of one, and most lines of drawings are that
                if a.is_in_stroke() && b.is_in_stroke() {
                    continue;
                }
                let (line, index, arc) = (number as u32, i as u32, sides.arcs[number][i]);
                sides.segments.insert(Segment { a: a.at, b: b.at, half_width: 0.0, line, index, arc });
            }
        }
        sides
    }

    fn total(&self, number: usize) -> f32 {
        self.arcs[number].last().copied().unwrap_or(0.0)
    }

    /// A small ring (an eye, a button) is felt as a dot and stays whole.
    fn is_dot(&self, number: usize) -> bool {
        self.polylines[number].closed && self.params.is_dot(self.total(number))
    }

    /// The opposite of vertex `i` of a polyline if that is on an edge: without a step of colour it has none.
    fn opposite_of_edge(&self, number: usize, i: usize) -> Option<Opposite> {
        let is_in_stroke = self.polylines[number].vertices[i].is_in_stroke();
        if is_in_stroke { None } else { self.opposite(number, i) }
    }

    /// The opposite of vertex `i` of a polyline.
    fn opposite(&self, number: usize, i: usize) -> Option<Opposite> {
        let polyline = &self.polylines[number];
        let here: &Vertex = &polyline.vertices[i];
        let tangent = polyline.tangent(i);
        let reach = self.params.widest_stroke();
        let mut best: Option<(f32, Opposite)> = None;
        for side in [1.0, -1.0] {
            let length = best.map_or(reach, |(distance, _)| distance);
            let ray = (here.at, here.at + right_of(tangent) * (side * length));
            self.segments.along(ray.0, ray.1, |segments, begins| {
                // what is in this cell and in no other before it is farther off
                if best.is_some_and(|(least, _)| begins * length > least) {
                    return false;
                }
                for segment in segments {
                    // longer by a rounding: a way through a vertex exactly crosses both segments, and not neither
                    let over = (segment.b - segment.a) * ROUNDING;
                    let Some(at) = crossing(ray, (segment.a - over, segment.b + over)) else { continue };
                    let distance = (at - here.at).length();
                    if best.is_none_or(|(least, _)| distance < least * (1.0 - ROUNDING))
                        && !self.is_same_side((number, i), segment, distance)
                        && self.steps_back(here, tangent, segment)
                        && !self.is_corner((number, i), segment, at)
                    {
                        best = Some((distance, self.opposite_on(segment, at)));
                    }
                }
                true
            });
        }
        best.map(|(_, opposite)| opposite)
    }

    /// Whether a segment, this far away, is part of the vertex's own side: of the same line, and not beyond a bend.
    fn is_same_side(&self, (number, i): (usize, usize), segment: &Segment, distance: f32) -> bool {
        let ring_length = self.polylines[number].closed.then(|| self.total(number));
        let apart = arc_between(segment.arc, self.arcs[number][i], ring_length);
        segment.line as usize == number && apart < BEND * distance + BEND_LEAST
    }

    /// Whether a place on a segment is on the other side of a sharp corner.
    fn is_corner(&self, (number, i): (usize, usize), segment: &Segment, at: MmPoint) -> bool {
        let (polyline, arcs) = (&self.polylines[number], &self.arcs[number]);
        let there = segment.arc + (at - segment.a).length();
        let places = [(arcs[i], polyline.vertices[i].at), (there, at)];
        segment.line as usize == number && is_corner(polyline, arcs, polyline.closed, places)
    }

    /// Whether a segment runs beside a vertex and the colour steps back there what it steps at the vertex.
    fn steps_back(&self, here: &Vertex, tangent: MmVector, segment: &Segment) -> bool {
        let Some(direction) = (segment.b - segment.a).try_normalize() else { return false };
        let along = direction.dot(tangent);
        if along.abs() < PARALLEL {
            return false;
        }
        let other = &self.polylines[segment.line as usize].vertices;
        let ends = [0, 1].map(|end| other[(segment.index as usize + end) % other.len()].contrast);
        let there = std::array::from_fn(|i| 0.5 * (ends[0][i] + ends[1][i]) * along.signum());
        let (up, down) = (length(here.contrast), length(there));
        // a faint ghost beside a strong contour is no side of a stroke
        let alike = up.min(down) >= ALIKE * up.max(down);
        alike && dot(here.contrast, there) < -STEP_BACK * up * down
    }

    /// The place `at` of a segment, and its end that is nearer.
    fn opposite_on(&self, segment: &Segment, at: MmPoint) -> Opposite {
        let (first, second) = ((segment.a - at).length(), (segment.b - at).length());
        let nearer_end = usize::from(second < first * (1.0 - ROUNDING));
        let polyline = segment.line as usize;
        let index = (segment.index as usize + nearer_end) % self.polylines[polyline].vertices.len();
        Opposite { polyline, index, at }
    }
}

/// In cells of which side the other side is looked for, mm.
fn cell_of(polylines: &[Polyline<Vertex>], area: MmRect) -> f32 {
    let vertices: usize = polylines.iter().map(|polyline| polyline.vertices.len()).sum();
    if vertices as f32 > DENSE * area.area() { CELL_OF_DENSE } else { CELL }
}

#[cfg(test)]
mod tests;
