//! Lines in the making: polylines on the sheet, before it is known what of them is drawn.

use crate::edges::{ChainKind, Edgel};
use crate::geom::polyline::{Blend, Located, Polyline, PolylineRef, smooth};
use crate::units::{Mm, MmPoint, PageTransform};

/// Distance of the vertices of a line in the making, mm: a few to the width of the thinnest line.
pub(super) const SPACING: f32 = 0.4;
/// Vertices farther apart than this, mm, get others between them: what looks at a line looks at its vertices.
const LONGEST: f32 = 1.25 * SPACING;

/// A vertex of a line in the making.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vertex {
    pub(super) at: MmPoint,
    pub(super) strength: f32,
    /// Colour on the right less colour on the left.
    pub(super) contrast: [f32; 3],
    /// Width of the line here, mm; 0 until `weight` has been there.
    pub(super) width: f32,
    /// Whether it is where a vector drawing has it, and not where it was found in pixels.
    pub(super) exact: bool,
}

impl Located for Vertex {
    type Unit = Mm;

    fn at(&self) -> MmPoint {
        self.at
    }
}

impl Blend for Vertex {
    fn between(&self, other: &Self, share: f32) -> Self {
        let mix = |a: f32, b: f32| a + (b - a) * share;
        Self {
            at: self.at.lerp(other.at, share),
            strength: mix(self.strength, other.strength),
            contrast: std::array::from_fn(|i| mix(self.contrast[i], other.contrast[i])),
            width: mix(self.width, other.width),
            exact: self.exact && other.exact,
        }
    }

    fn reversed(self) -> Self {
        Self { contrast: self.contrast.map(|v| -v), ..self }
    }
}

impl Polyline<Vertex> {
    /// A contour on the sheet.
    pub(super) fn of_chain(chain: PolylineRef<'_, Edgel>, kind: ChainKind, transform: &PageTransform) -> Self {
        let vertex = |p: &Edgel| Vertex {
            at: transform.to_mm(p.at),
            strength: p.strength,
            contrast: p.contrast,
            width: 0.0,
            exact: kind.exact,
        };
        Self { vertices: chain.vertices.iter().map(vertex).collect(), closed: chain.closed }
    }

    /// Length, mm, of a line of full strength that is worth as much: a weak line counts in proportion.
    pub(super) fn weighted_length(&self, full_strength: f32) -> f32 {
        self.length() * (self.mean_strength() / full_strength).min(1.0)
    }

    /// Mean strength along the path; of a ring the first vertex counts at both its ends.
    pub(super) fn mean_strength(&self) -> f32 {
        let count = self.vertices.len() + usize::from(self.closed);
        self.path().map(|v| v.strength).sum::<f32>() / count.max(1) as f32
    }

    /// The line in the one of its two directions that begins with its stronger half, so that nothing hangs on the
    /// direction it was found in.
    pub(super) fn stronger_half_first(self) -> Self {
        let count = self.vertices.len() + usize::from(self.closed);
        let half = count / 2;
        let strengths = || self.path().map(|v| v.strength);
        let (first, second): (f32, f32) = (strengths().take(half).sum(), strengths().skip(count - half).sum());
        if second > first { self.reversed() } else { self }
    }

    /// Puts vertices at even distances of about [`SPACING`], the ends where they are. A ring begins at its strongest
    /// vertex, so that the result does not hang on where the search for it began.
    pub(super) fn evened(mut self) -> Self {
        if self.closed {
            let strength = |i: &usize| self.vertices[*i].strength;
            let strongest = (0..self.vertices.len()).max_by(|a, b| strength(a).total_cmp(&strength(b)));
            self.vertices.rotate_left(strongest.unwrap_or(0));
        }
        self.resampled(SPACING)
    }

    /// Puts vertices where two that follow one another are much farther apart than [`SPACING`].
    pub(super) fn fill(&mut self) {
        self.subdivide(LONGEST);
    }

    /// Positions, strengths and steps smoothed along the line; widths are not yet known.
    pub(super) fn smoothed(self, sigma: f32) -> Self {
        let smooth = smooth(&self.arc_lengths(), self.closed, sigma, |i| {
            let v = &self.vertices[i];
            [v.at.x, v.at.y, v.strength, v.contrast[0], v.contrast[1], v.contrast[2]]
        });
        let vertex = |[x, y, strength, l, a, b]: [f32; 6]| Vertex {
            at: MmPoint::new(x, y),
            strength,
            contrast: [l, a, b],
            width: 0.0,
            exact: false,
        };
        Self { vertices: smooth.into_iter().map(vertex).collect(), closed: self.closed }
    }
}

/// Scalar product of two colour steps.
pub(super) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
