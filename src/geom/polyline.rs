//! Polylines: one type with one rule of closedness, and what stages ask of polylines again and again.
//!
//! A closed polyline (a ring) goes on from its last vertex to its first. The flag alone says that it is closed: the
//! first vertex is never repeated at the end. A vertex is a bare point, or a position with attributes such as strength
//! or width.

use std::sync::LazyLock;

use lyon::geom::euclid::{Point2D, Vector2D};

use super::nearest_on_segment;

/// What has a position in the plane.
pub trait Located: Copy {
    /// The unit of its coordinates.
    type Unit;

    /// Its position.
    fn at(&self) -> Point2D<f32, Self::Unit>;
}

/// A vertex whose attributes can be interpolated and turned round.
pub trait Blend: Located {
    /// The vertex a share, 0..=1, of the segment from this one to `other`.
    #[must_use]
    fn between(&self, other: &Self, share: f32) -> Self;

    /// The same vertex of the polyline gone along backwards: what is told of its left and right changes sides.
    #[must_use]
    fn reversed(self) -> Self {
        self
    }
}

impl<U> Located for Point2D<f32, U> {
    type Unit = U;

    fn at(&self) -> Point2D<f32, U> {
        *self
    }
}

impl<U> Blend for Point2D<f32, U> {
    fn between(&self, other: &Self, share: f32) -> Self {
        self.lerp(*other, share)
    }
}

/// A polyline that owns its vertices.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Polyline<V> {
    /// Its vertices in order; of a ring the first is not repeated.
    pub vertices: Vec<V>,
    /// Whether it goes on from the last vertex to the first.
    pub closed: bool,
}

/// A polyline whose vertices lie elsewhere, such as in one flat list of many.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolylineRef<'a, V> {
    /// Its vertices in order; of a ring the first is not repeated.
    pub vertices: &'a [V],
    /// Whether it goes on from the last vertex to the first.
    pub closed: bool,
}

impl<V> Polyline<V> {
    /// An open polyline.
    pub fn open(vertices: Vec<V>) -> Self {
        Self { vertices, closed: false }
    }

    /// The polyline as a borrowed view.
    pub fn view(&self) -> PolylineRef<'_, V> {
        PolylineRef { vertices: &self.vertices, closed: self.closed }
    }
}

impl<V: Located> Polyline<V> {
    /// The polyline along a path that is a ring if it comes back to where it began.
    pub fn from_path(mut path: Vec<V>) -> Self {
        let closed = path.len() > 2 && matches!(&path[..], [first, .., last] if first.at() == last.at());
        path.truncate(path.len() - usize::from(closed));
        Self { vertices: path, closed }
    }

    /// See [`PolylineRef::path`].
    pub fn path(&self) -> impl Iterator<Item = &V> + Clone {
        self.view().path()
    }

    /// See [`PolylineRef::segments`].
    pub fn segments(&self) -> impl Iterator<Item = (&V, &V)> + Clone {
        self.view().segments()
    }

    /// See [`PolylineRef::segment_count`].
    pub fn segment_count(&self) -> usize {
        self.view().segment_count()
    }

    /// See [`PolylineRef::length`].
    pub fn length(&self) -> f32 {
        self.view().length()
    }

    /// See [`PolylineRef::chord`].
    pub fn chord(&self) -> f32 {
        self.view().chord()
    }

    /// See [`PolylineRef::arc_lengths`].
    pub fn arc_lengths(&self) -> Vec<f32> {
        self.view().arc_lengths()
    }

    /// See [`PolylineRef::distance`].
    pub fn distance(&self, at: Point2D<f32, V::Unit>) -> f32 {
        self.view().distance(at)
    }

    /// See [`PolylineRef::tangent`].
    pub fn tangent(&self, i: usize) -> Vector2D<f32, V::Unit> {
        self.view().tangent(i)
    }

    /// A ring cut open at vertex `start`, at which the open polyline begins and ends.
    #[must_use]
    pub fn opened_at(&self, start: usize) -> Self {
        let (before, after) = self.vertices.split_at(start);
        Self::open(after.iter().chain(before).chain(after.first()).copied().collect())
    }
}

impl<V: Blend> Polyline<V> {
    /// The same polyline gone along backwards. A ring still begins at its first vertex.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.reverse();
        self
    }

    /// Turns the polyline round. A ring still begins at its first vertex.
    pub fn reverse(&mut self) {
        let from = usize::from(self.closed).min(self.vertices.len());
        self.vertices[from..].reverse();
        for vertex in &mut self.vertices {
            *vertex = vertex.reversed();
        }
    }

    /// The same polyline with vertices at even distances of about `spacing`; the first, and of an open one the last,
    /// stay. A ring that is too short for three vertices comes out open, with its first vertex at both ends.
    #[must_use]
    pub fn resampled(&self, spacing: f32) -> Self {
        let arcs = self.arc_lengths();
        let total = arcs.last().copied().unwrap_or(0.0);
        let steps = (total / spacing).round().max(1.0) as usize;
        let n = self.vertices.len();
        if n == 0 {
            return Self { vertices: Vec::new(), closed: false };
        }
        let mut even = Vec::with_capacity(steps + 1);
        let mut k = 0;
        for step in 0..=steps {
            let arc = total * step as f32 / steps as f32;
            while k + 2 < arcs.len() && arcs[k + 1] < arc {
                k += 1;
            }
            let next = if self.closed { (k + 1) % n } else { (k + 1).min(n - 1) };
            let length = arcs.get(k + 1).map_or(0.0, |next| next - arcs[k]);
            let share = if length > 0.0 { (arc - arcs[k]) / length } else { 0.0 };
            even.push(self.vertices[k].between(&self.vertices[next], share));
        }
        let closed = self.closed && steps >= 3;
        if self.closed {
            even.truncate(steps);
        }
        if self.closed && !closed {
            even.push(even[0]);
        }
        Self { vertices: even, closed }
    }

    /// Puts vertices between those that are farther than `longest` apart.
    pub fn subdivide(&mut self, longest: f32) {
        let distance = |a: &V, b: &V| (b.at() - a.at()).length();
        if !self.segments().any(|(a, b)| distance(a, b) > longest) {
            return;
        }
        let mut vertices = Vec::with_capacity(self.vertices.len() + 8);
        for (a, b) in self.segments() {
            let steps = (distance(a, b) / longest).ceil().max(1.0) as usize;
            vertices.extend((0..steps).map(|k| a.between(b, k as f32 / steps as f32)));
        }
        if !self.closed {
            vertices.extend(self.vertices.last());
        }
        self.vertices = vertices;
    }
}

impl<'a, V: Located> PolylineRef<'a, V> {
    /// The vertices in order; in a ring the first comes again at the end.
    pub fn path(self) -> impl Iterator<Item = &'a V> + Clone {
        let back = if self.closed { self.vertices.first() } else { None };
        self.vertices.iter().chain(back)
    }

    /// The segments in order, as their two vertices; of a ring the one from the last vertex to the first comes last.
    pub fn segments(self) -> impl Iterator<Item = (&'a V, &'a V)> + Clone {
        let closing = if self.closed { self.vertices.last().zip(self.vertices.first()) } else { None };
        self.vertices.windows(2).map(|pair| (&pair[0], &pair[1])).chain(closing)
    }

    /// How many segments there are.
    pub fn segment_count(self) -> usize {
        if self.closed { self.vertices.len() } else { self.vertices.len().saturating_sub(1) }
    }

    /// Length, of a ring all round.
    pub fn length(self) -> f32 {
        self.segments().map(|(a, b)| (b.at() - a.at()).length()).sum()
    }

    /// How far its ends lie apart; 0 of a ring.
    pub fn chord(self) -> f32 {
        match (self.vertices.first(), self.vertices.last(), self.closed) {
            (Some(first), Some(last), false) => (last.at() - first.at()).length(),
            _ => 0.0,
        }
    }

    /// How far a place is from the nearest point of the polyline; infinitely far if it has no segments.
    pub fn distance(self, at: Point2D<f32, V::Unit>) -> f32 {
        let distances = self.segments().map(|(a, b)| nearest_on_segment(at, a.at(), b.at()).0);
        distances.fold(f32::INFINITY, f32::min)
    }

    /// Length along the polyline from the first vertex to each; the first entry is 0. Of a ring there is one entry more
    /// than vertices: its whole length. So the last entry is the length of the polyline.
    pub fn arc_lengths(self) -> Vec<f32> {
        let mut arcs = Vec::with_capacity(self.vertices.len() + 1);
        arcs.extend(self.vertices.first().map(|_| 0.0));
        let mut arc = 0.0;
        arcs.extend(self.segments().map(|(a, b)| {
            arc += (b.at() - a.at()).length();
            arc
        }));
        arcs
    }

    /// The number of the vertex `steps` after vertex `i`, or before it if negative; none beyond the ends of an open
    /// polyline.
    pub fn next(self, i: usize, steps: isize) -> Option<usize> {
        let n = self.vertices.len() as isize;
        let to = i as isize + steps;
        if self.closed { Some(to.rem_euclid(n) as usize) } else { (0..n).contains(&to).then_some(to as usize) }
    }

    /// Unit direction of travel at vertex `i`, over its neighbours; zero if they are at one place.
    pub fn tangent(self, i: usize) -> Vector2D<f32, V::Unit> {
        let [before, after] = [-1, 1].map(|step| self.vertices[self.next(i, step).unwrap_or(i)].at());
        (after - before).try_normalize().unwrap_or(Vector2D::zero())
    }
}

/// Length of an open polyline through points.
pub fn length<U>(points: &[Point2D<f32, U>]) -> f32 {
    PolylineRef { vertices: points, closed: false }.length()
}

/// A Gaussian mean along a polyline: the values of its vertices, blurred with `sigma` in the unit of `arcs`, which are
/// its [`PolylineRef::arc_lengths`].
///
/// `value(i)` gives the numbers of vertex `i`. On a ring the window wraps round. At the ends of an open polyline it is
/// cut to the same reach on both sides, so that end points stay where they are and nothing shrinks towards the middle.
/// The Gaussian is lowered so that it ends at 0. What lies at the window's end, give or take a rounding, is inside: at
/// even distances many vertices do, and rounding must not decide.
pub fn smooth<const N: usize>(
    arcs: &[f32],
    closed: bool,
    sigma: f32,
    value: impl Fn(usize) -> [f32; N],
) -> Vec<[f32; N]> {
    // of a ring the last arc is its whole length, not that of a vertex of its own
    let n = arcs.len().saturating_sub(usize::from(closed));
    if arcs.len() < 3 || sigma <= 0.0 {
        return (0..n).map(value).collect();
    }
    let total = arcs[arcs.len() - 1];
    let (bell, per_sigma) = (&*BELL, STEPS as f32 / sigma);
    let reach = if closed { (3.0 * sigma).min(total / 2.0) } else { 3.0 * sigma };
    let values: Vec<[f64; N]> = (0..n).map(|i| value(i).map(f64::from)).collect();
    let mut out = Vec::with_capacity(n);
    for i in 0..n {
        let reach = if closed { reach } else { reach.min(arcs[i]).min(total - arcs[i]) } + ROUNDING * sigma;
        let mut sum = values[i];
        let mut weight = 1.0_f64;
        // Adds what lies within reach; says whether there may be more behind it.
        let mut add = |distance: f32, value: &[f64; N]| {
            if distance > reach {
                return false;
            }
            let k = bell[(distance * per_sigma) as u32 as usize];
            sum.iter_mut().zip(value).for_each(|(sum, v)| *sum += k * v);
            weight += k;
            true
        };
        let here = arcs[i];
        let (before, after) = (arcs[..i].iter().zip(&values[..i]), arcs[i + 1..n].iter().zip(&values[i + 1..]));
        // forwards, in a ring over its seam to the vertices before; then the same backwards
        if after.clone().all(|(arc, value)| add(arc - here, value)) && closed {
            before.clone().all(|(arc, value)| add(arc + total - here, value));
        }
        if before.rev().all(|(arc, value)| add(here - arc, value)) && closed {
            after.rev().all(|(arc, value)| add(here + total - arc, value));
        }
        out.push(sum.map(|s| (s / weight) as f32));
    }
    out
}

/// Steps for one sigma in the table of the Gaussian: its values are right within 0.005.
const STEPS: usize = 64;
/// What rounding may add to a distance, in sigmas.
const ROUNDING: f32 = 1e-3;

/// The Gaussian from its middle to three sigma, where it is 0, and a step; each value that of the middle of its step.
static BELL: LazyLock<[f64; 3 * STEPS + 2]> = LazyLock::new(|| {
    let gaussian = |x: f64| (-0.5 * x * x).exp();
    std::array::from_fn(|i| (gaussian((i as f64 + 0.5) / STEPS as f64) - gaussian(3.0)).max(0.0))
});

#[cfg(test)]
mod tests;
