//! Contours of which parts are taken out, such as those along lines that go before them.

use lyon::geom::euclid::Box2D;

use crate::edges::{ChainRange, Edgel, Edges};
use crate::geom::ALONG;
use crate::geom::nearby::Nearby;
use crate::geom::polyline::{Located, Polyline, PolylineRef};
use crate::geom::walk::runs;
use crate::lines::Line;
use crate::units::{PageTransform, Px, PxPoint, Size};

/// Contours are looked at this often, as a share of how far lines reach.
const STEP: f32 = 0.1;
/// A line meets another if it comes this near, as a share of that: two lines that were drawn to touch seldom do
/// exactly.
const MEETS: f32 = 0.25;
/// A line only crosses another if it is beside it for no longer than this, in the same unit: at 42 degrees or more.
const CROSSING: f32 = 3.0;

/// Side of the cells in which lines are found again, px.
const CELL: f32 = 16.0;

/// The segments of contours, to be found by their places.
pub(super) fn index_of_edges(edges: &Edges) -> Nearby<Px> {
    let mut near = empty_index(edges.size);
    (0..).zip(edges.chains()).for_each(|(line, chain)| near.insert_line(line, chain, 0.0));
    near
}

/// The segments of drawn lines, to be found by their places in a picture of this size.
pub(super) fn index_of_drawn(lines: &[Line], size: Size, transform: &PageTransform) -> Nearby<Px> {
    let mut near = empty_index(size);
    for (line, run) in (0..).zip(lines).flat_map(|(number, line)| line.runs.iter().map(move |run| (number, run))) {
        let points: Vec<PxPoint> = run.points.iter().map(|&at| transform.to_px(at)).collect();
        near.insert_line(line, PolylineRef { vertices: &points, closed: run.closed }, 0.0);
    }
    near
}

/// An index for a picture of this size.
fn empty_index(size: Size) -> Nearby<Px> {
    let area = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    Nearby::new(area, CELL)
}

/// The parts of a chain that are left where what `is_gone` goes, and whether each is closed.
pub(super) fn parts_left<V: Copy>(vertices: &[V], closed: bool, is_gone: impl Fn(&V) -> bool) -> Vec<(Vec<V>, bool)> {
    let Some(first) = vertices.iter().position(&is_gone) else { return vec![(vertices.to_vec(), closed)] };
    let mut vertices = vertices.to_vec();
    if closed {
        // begun at what goes, no part that stays is cut in two
        vertices.rotate_left(first);
    }
    let parts = vertices.chunk_by(|a, b| is_gone(a) == is_gone(b)).filter(|part| !is_gone(&part[0]) && part.len() > 1);
    parts.map(|part| (part.to_vec(), false)).collect()
}

/// Takes the parts of contours out of which `is_gone` is true; each chain has its number.
pub(super) fn take_out(edges: &mut Edges, is_gone: impl Fn(usize, &ChainRange, &Edgel) -> bool) {
    let (edgels, chains) = (std::mem::take(&mut edges.edgels), std::mem::take(&mut edges.chains));
    for (number, range) in chains.iter().enumerate() {
        let vertices = &edgels[range.edgels.clone()];
        for (vertices, closed) in parts_left(vertices, range.closed, |edgel| is_gone(number, range, edgel)) {
            edges.push_as(range.kind, vertices.into_iter(), closed);
        }
    }
}

/// Takes the parts of contours out that run along lines nearer than `reach`, px.
pub(super) fn take_out_along(edges: &mut Edges, near: &Nearby<Px>, reach: f32) {
    let (edgels, chains) = (std::mem::take(&mut edges.edgels), std::mem::take(&mut edges.chains));
    for range in &chains {
        for (vertices, closed) in parts_apart(&edgels[range.edgels.clone()], range.closed, near, reach) {
            edges.push_as(range.kind, vertices.into_iter(), closed);
        }
    }
}

/// The points that [`take_out_along`] takes out.
pub(super) fn points_taken_out(edges: &Edges, near: &Nearby<Px>, reach: f32) -> Vec<PxPoint> {
    let of_chain = |range: &ChainRange| -> Vec<PxPoint> {
        let vertices = &edges.edgels[range.edgels.clone()];
        let along = run_along(vertices, range.closed, near, reach);
        vertices.iter().zip(along).filter(|(_, is_along)| *is_along).map(|(edgel, _)| edgel.at).collect()
    };
    edges.chains.iter().flat_map(of_chain).collect()
}

/// The parts of a contour that are left without those that run along lines nearer than `reach`, px, and
/// whether each is closed.
pub(super) fn parts_apart<V: Located<Unit = Px>>(
    vertices: &[V],
    closed: bool,
    near: &Nearby<Px>,
    reach: f32,
) -> Vec<(Vec<V>, bool)> {
    parts_marked(vertices.iter().copied().zip(run_along(vertices, closed, near, reach)).collect(), closed)
}

/// Which vertices of a contour lie in stretches along lines nearer than `reach`, px: at most of the vertices of such a
/// stretch its direction is that of the line beside it. Where a line only crosses the contour, or ends before it, there
/// is none: it would open a closed outline at its end, and two lines may meet.
fn run_along<V: Located<Unit = Px>>(vertices: &[V], closed: bool, near: &Nearby<Px>, reach: f32) -> Vec<bool> {
    let contour = PolylineRef { vertices, closed };
    let is_beside = |(number, vertex): (usize, &V)| {
        let (_, _, segment) = near.nearest(vertex.at(), reach, |_| true)?;
        let way = (segment.b - segment.a).try_normalize().unwrap_or_default();
        Some(contour.tangent(number).dot(way).abs() >= ALONG)
    };
    let beside: Vec<Option<bool>> = vertices.iter().enumerate().map(is_beside).collect();
    let mut along = vec![false; vertices.len()];
    for stretch in runs(vertices.len(), closed, |a, b| beside[a].is_some() == beside[b].is_some()) {
        let count = stretch.iter().filter(|&&number| beside[number] == Some(true)).count();
        if count > 0 && 2 * count >= stretch.len() {
            stretch.iter().for_each(|number| along[*number] = true);
        }
    }
    along
}

/// The parts of a contour that are left, and whether each is closed; with each vertex stands whether it is gone.
fn parts_marked<V: Copy>(marked: Vec<(V, bool)>, closed: bool) -> Vec<(Vec<V>, bool)> {
    let parts = parts_left(&marked, closed, |(_, is_gone)| *is_gone);
    parts.into_iter().map(|(part, closed)| (part.into_iter().map(|(vertex, _)| vertex).collect(), closed)).collect()
}

/// The parts of a contour that do not run along lines nearer than `reach`, px; where it meets one, those up to `gap`
/// from it.
pub(super) fn parts_beside(
    whole: Polyline<Edgel>,
    near: &Nearby<Px>,
    [reach, gap]: [f32; 2],
) -> Vec<(Vec<Edgel>, bool)> {
    let distance = |edgel: &Edgel| near.nearest(edgel.at, reach, |_| true).map(|(distance, ..)| distance);
    let closed = whole.closed;
    let mut vertices: Vec<Edgel> = whole.segments().flat_map(|(a, b)| steps(a, b, STEP * reach)).collect();
    vertices.extend(whole.vertices.last().filter(|_| !closed));
    if closed {
        // begun away from them, no part along them is cut in two
        let first = vertices.iter().position(|edgel| distance(edgel).is_none());
        vertices.rotate_left(first.unwrap_or(0));
    }
    let distances: Vec<Option<f32>> = vertices.iter().map(distance).collect();
    let mut are_gone = vec![false; vertices.len()];
    let mut at = 0;
    for part in distances.chunk_by(|a, b| a.is_some() == b.is_some()) {
        let range = at..at + part.len();
        at = range.end;
        let nearest = part.iter().flatten().copied().fold(f32::MAX, f32::min);
        let arc: f32 = vertices[range.clone()].windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum();
        let meets = nearest <= MEETS * reach && arc <= CROSSING * reach;
        for (is_gone, distance) in are_gone[range].iter_mut().zip(part) {
            *is_gone = distance.is_some_and(|distance| !meets || distance < gap);
        }
    }
    if are_gone.iter().all(|is_gone| !is_gone) {
        return vec![(whole.vertices, closed)];
    }
    parts_marked(vertices.into_iter().zip(are_gone).collect(), closed)
}

/// A segment from its first end on, in steps of at most this length, px.
fn steps(a: &Edgel, b: &Edgel, longest: f32) -> impl Iterator<Item = Edgel> + use<> {
    let (a, b) = (*a, *b);
    let count = ((b.at - a.at).length() / longest).ceil().max(1.0);
    (0..count as u32).map(move |k| {
        let share = k as f32 / count;
        Edgel { at: a.at.lerp(b.at, share), strength: a.strength + share * (b.strength - a.strength), ..a }
    })
}

#[cfg(test)]
mod tests;
