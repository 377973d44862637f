//! A line in the making: a contour on the sheet, before it is known what of it is drawn.

use crate::edges::Edgel;
use crate::frame::Frame;
use crate::geom::polyline::{self, PolylineRef, arc_lengths};
use crate::units::{MmPoint, MmVector};

/// Distance of the vertices of a line in the making, mm: a few to the width of the thinnest line.
pub(super) const SPACING: f32 = 0.4;

/// A line in the making.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Trail {
    pub(super) vertices: Vec<Vertex>,
    /// A closed trail repeats its first vertex at its end.
    pub(super) closed: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vertex {
    pub(super) at: MmPoint,
    pub(super) strength: f32,
    /// Colour on the right less colour on the left.
    pub(super) step: [f32; 3],
    /// Width of the line here, mm; 0 until `weight` has been there.
    pub(super) width: f32,
}

impl Vertex {
    /// The vertex a share of the way from this one to `other`.
    pub(super) fn between(&self, other: &Self, share: f32) -> Self {
        let mix = |a: f32, b: f32| a + (b - a) * share;
        Self {
            at: self.at.lerp(other.at, share),
            strength: mix(self.strength, other.strength),
            step: std::array::from_fn(|i| mix(self.step[i], other.step[i])),
            width: mix(self.width, other.width),
        }
    }
}

impl Trail {
    pub(super) fn from_chain(chain: PolylineRef<'_, Edgel>, frame: &Frame) -> Self {
        let vertex = |p: &Edgel| Vertex { at: frame.to_mm(p.at), strength: p.strength, step: p.contrast, width: 0.0 };
        Self { vertices: chain.path().map(vertex).collect(), closed: chain.closed }
    }

    pub(super) fn points(&self) -> Vec<MmPoint> {
        self.vertices.iter().map(|v| v.at).collect()
    }

    /// The number of its vertices, of a ring without the one that is repeated.
    pub(super) fn places(&self) -> usize {
        self.vertices.len() - usize::from(self.closed)
    }

    pub(super) fn length(&self) -> f32 {
        self.vertices.windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum()
    }

    /// Length, mm, of a line of full strength that is worth as much: a weak line counts in proportion.
    pub(super) fn weighted_length(&self, full_strength: f32) -> f32 {
        self.length() * (self.mean_strength() / full_strength).min(1.0)
    }

    pub(super) fn mean_strength(&self) -> f32 {
        self.vertices.iter().map(|v| v.strength).sum::<f32>() / self.vertices.len().max(1) as f32
    }

    pub(super) fn reversed(mut self) -> Self {
        self.vertices.reverse();
        for vertex in &mut self.vertices {
            vertex.step = vertex.step.map(|v| -v);
        }
        self
    }

    /// The trail in the one of its two directions that begins with its stronger half, so that nothing hangs on the direction
    /// it was found in.
    pub(super) fn stronger_half_first(self) -> Self {
        let half = self.vertices.len() / 2;
        let sum = |vertices: &[Vertex]| vertices.iter().map(|v| v.strength).sum::<f32>();
        let (first, second) = (sum(&self.vertices[..half]), sum(&self.vertices[self.vertices.len() - half..]));
        if second > first { self.reversed() } else { self }
    }

    /// Unit direction of travel at a vertex, over its neighbours.
    pub(super) fn tangent(&self, i: usize) -> MmVector {
        let n = self.vertices.len();
        let (before, after) = if self.closed {
            ((i + n - 2) % (n - 1), (i + 1) % (n - 1))
        } else {
            (i.saturating_sub(1), (i + 1).min(n - 1))
        };
        (self.vertices[after].at - self.vertices[before].at).try_normalize().unwrap_or(MmVector::zero())
    }

    /// Puts vertices at even distances of about [`SPACING`], the ends where they are. A ring begins at its strongest place,
    /// so that the result does not hang on where the search for it began.
    pub(super) fn evened(mut self) -> Self {
        if self.closed {
            self.vertices.pop();
            let strength = |i: &usize| self.vertices[*i].strength;
            let strongest = (0..self.vertices.len()).max_by(|a, b| strength(a).total_cmp(&strength(b)));
            self.vertices.rotate_left(strongest.unwrap_or(0));
            self.vertices.extend(self.vertices.first().copied());
        }
        let arcs = arc_lengths(&self.points());
        let total = arcs.last().copied().unwrap_or(0.0);
        let steps = (total / SPACING).round().max(1.0) as usize;
        let mut even = Vec::with_capacity(steps + 1);
        let mut k = 0;
        for step in 0..=steps {
            let arc = total * step as f32 / steps as f32;
            while k + 2 < arcs.len() && arcs[k + 1] < arc {
                k += 1;
            }
            let (a, b) = (&self.vertices[k], &self.vertices[(k + 1).min(self.vertices.len() - 1)]);
            let length = arcs.get(k + 1).map_or(0.0, |next| next - arcs[k]);
            even.push(a.between(b, if length > 0.0 { (arc - arcs[k]) / length } else { 0.0 }));
        }
        if self.closed {
            even[steps] = even[0];
        }
        self.closed &= steps >= 3;
        self.vertices = even;
        self
    }

    /// Puts vertices where two that follow one another are much farther apart than [`SPACING`]: what looks at a line looks at
    /// its vertices.
    pub(super) fn filled(&mut self) {
        let far = |pair: &[Vertex]| (pair[1].at - pair[0].at).length() > 1.25 * SPACING;
        if !self.vertices.windows(2).any(far) {
            return;
        }
        let mut filled = Vec::with_capacity(self.vertices.len() + 8);
        for pair in self.vertices.windows(2) {
            let steps = ((pair[1].at - pair[0].at).length() / (1.25 * SPACING)).ceil().max(1.0) as usize;
            filled.extend((0..steps).map(|k| pair[0].between(&pair[1], k as f32 / steps as f32)));
        }
        filled.extend(self.vertices.last().copied());
        self.vertices = filled;
    }

    pub(super) fn smoothed(mut self, sigma: f32) -> Self {
        let arcs = arc_lengths(&self.points());
        let old = std::mem::take(&mut self.vertices);
        let smooth = polyline::smooth(&arcs, self.closed, sigma, |i| {
            let v = &old[i];
            [v.at.x, v.at.y, v.strength, v.step[0], v.step[1], v.step[2]]
        });
        self.vertices = smooth
            .into_iter()
            .map(|[x, y, strength, l, a, b]| Vertex { at: MmPoint::new(x, y), strength, step: [l, a, b], width: 0.0 })
            .collect();
        self
    }
}

/// Products of two colour steps, as vectors.
pub(super) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
