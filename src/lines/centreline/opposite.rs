//! What lies straight across from a vertex: the other side of a stroke.

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::geom::crossing;
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::{Vertex, dot};
use crate::units::{MmPoint, MmRect, MmVector};

/// Least cosine between the directions of two sides (about 37 degrees).
const PARALLEL: f32 = 0.8;
/// Least cosine between the step back and the step up, as directions in colour space: a black axis below a yellow area
/// steps from white to black and from black to yellow, which have 0.45 in common.
const STEP_BACK: f32 = 0.3;
/// The smaller of the two steps is at least this share of the larger.
const ALIKE: f32 = 0.3;
/// On one line, opposite sides are parted by a bend: the way along it is longer than the way across by this factor (a
/// half circle's is 1.57), and by this length, mm.
const BEND: f32 = 1.4;
const BEND_LEAST: f32 = 0.8;
/// What rounding may change, as a share: where two sides have vertices straight across from one another, as on
/// drawings, it must not decide which of two segments or ends is the opposite.
const ROUNDING: f32 = 1e-3;
/// Cells in which the other side is looked for, mm: about two vertices.
const CELL: f32 = 1.0;

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
/// `reach`, on either side of the line.
pub(super) fn opposites(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Opposites> {
    let reach = params.max_spacing();
    let mut nearby = Nearby::new(area, CELL);
    let mut all_arcs = Vec::with_capacity(polylines.len());
    for (number, polyline) in polylines.iter().enumerate() {
        let arcs = polyline.arc_lengths();
        if !is_dot(polyline, &arcs, params) {
            for (i, (a, b)) in polyline.segments().enumerate() {
                let (a, b) = (a.at, b.at);
                nearby.insert(Segment { a, b, half_width: 0.0, line: number as u32, index: i as u32, arc: arcs[i] });
            }
        }
        all_arcs.push(arcs);
    }
    polylines
        .par_iter()
        .enumerate()
        .map(|(number, polyline)| match is_dot(polyline, &all_arcs[number], params) {
            true => vec![None; polyline.vertices.len()],
            false => {
                let own = (number, &all_arcs[number][..]);
                (0..polyline.vertices.len()).map(|i| opposite(polylines, own, i, &nearby, reach)).collect()
            }
        })
        .collect()
}

/// The opposite of vertex `i` of a polyline, which is given by its number and the way to its vertices.
fn opposite(
    polylines: &[Polyline<Vertex>],
    (number, arcs): (usize, &[f32]),
    i: usize,
    nearby: &Nearby,
    reach: f32,
) -> Option<Opposite> {
    let polyline = &polylines[number];
    let here: &Vertex = &polyline.vertices[i];
    let (arc, total) = (arcs[i], arcs.last().copied().unwrap_or(0.0));
    let tangent = polyline.tangent(i);
    let up = dot(here.step, here.step).sqrt();
    let mut best: Option<(f32, Opposite)> = None;
    for side in [1.0, -1.0] {
        let across = MmVector::new(-tangent.y, tangent.x) * (side * best.map_or(reach, |(distance, _)| distance));
        let way = (here.at, here.at + across);
        nearby.along(way.0, way.1, |segment| {
            // longer by a rounding: a line that leads through a vertex exactly crosses both segments, not neither
            let over = (segment.b - segment.a) * ROUNDING;
            let Some(at) = crossing(way, (segment.a - over, segment.b + over)) else { return };
            let distance = (at - here.at).length();
            if best.is_some_and(|(least, _)| distance >= least * (1.0 - ROUNDING)) {
                return;
            }
            if segment.line as usize == number {
                // Along the same line: not this place itself, only what lies beyond a bend.
                let apart = (segment.arc - arc).abs();
                let apart = if polyline.closed { apart.min(total - apart) } else { apart };
                if apart < BEND * distance + BEND_LEAST {
                    return;
                }
            }
            let Some(direction) = (segment.b - segment.a).try_normalize() else { return };
            let along = direction.dot(tangent);
            if along.abs() < PARALLEL {
                return;
            }
            let other = &polylines[segment.line as usize];
            let sides = [0, 1].map(|end| other.vertices[(segment.index as usize + end) % other.vertices.len()].step);
            let there = std::array::from_fn(|i| 0.5 * (sides[0][i] + sides[1][i]) * along.signum());
            let down = dot(there, there).sqrt();
            // a faint ghost beside a strong contour is no side of a stroke
            let alike = up.min(down) >= ALIKE * up.max(down);
            if alike && dot(here.step, there) < -STEP_BACK * up * down {
                let (first, second) = ((segment.a - at).length(), (segment.b - at).length());
                let nearer_end = usize::from(second < first * (1.0 - ROUNDING));
                let index = (segment.index as usize + nearer_end) % other.vertices.len();
                best = Some((distance, Opposite { polyline: segment.line as usize, index, at }));
            }
        });
    }
    best.map(|(_, opposite)| opposite)
}

/// A small ring (an eye, a button) is felt as a dot and stays whole.
fn is_dot(polyline: &Polyline<Vertex>, arcs: &[f32], params: &Params) -> bool {
    polyline.closed && arcs.last().is_none_or(|&total| params.is_dot(total))
}
