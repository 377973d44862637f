//! The result of the detector: contours as chains of edgels.

use std::ops::Range;

use crate::geom::polyline::{Located, Polyline, PolylineRef};
use crate::units::{Px, PxPoint, Size};

/// An edge element: a point of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edgel {
    /// Position in pixels of the working picture.
    pub at: PxPoint,
    /// Height of the colour step here, less its share of texture (see the module).
    pub strength: f32,
    /// Colour on the right of the chain minus the colour on its left (L, 2a, 2b). The two sides of a bar have opposite
    /// contrast.
    pub contrast: [f32; 3],
}

impl Located for Edgel {
    type Unit = Px;

    fn at(&self) -> PxPoint {
        self.at
    }
}

/// The edgels of one chain.
#[derive(Debug, Clone, PartialEq)]
pub struct ChainRange {
    /// Their numbers in [`Edges::edgels`].
    pub edgels: Range<usize>,
    /// Whether the chain continues from its last edgel to its first, which is not repeated.
    pub closed: bool,
}

/// Contours as chains of edgels.
#[derive(Debug, Clone, PartialEq)]
pub struct Edges {
    /// Size of the picture they were found in.
    pub size: Size,
    /// All edgels, chain after chain.
    pub edgels: Vec<Edgel>,
    /// Which edgels form which chain.
    pub chains: Vec<ChainRange>,
}

impl Edges {
    /// No contours, for a picture of `size`.
    pub fn none(size: Size) -> Self {
        Self { size, edgels: Vec::new(), chains: Vec::new() }
    }

    /// Appends a chain.
    pub fn push(&mut self, chain: impl Iterator<Item = Edgel>, closed: bool) {
        let start = self.edgels.len();
        self.edgels.extend(chain);
        self.chains.push(ChainRange { edgels: start..self.edgels.len(), closed });
    }

    /// A chain as a polyline.
    pub fn chain(&self, range: &ChainRange) -> PolylineRef<'_, Edgel> {
        PolylineRef { vertices: &self.edgels[range.edgels.clone()], closed: range.closed }
    }

    /// The chains one by one.
    pub fn chains(&self) -> impl Iterator<Item = PolylineRef<'_, Edgel>> {
        self.chains.iter().map(|range| self.chain(range))
    }

    /// The positions of all chains.
    pub fn polylines(&self) -> Vec<Polyline<PxPoint>> {
        let positions = |chain: PolylineRef<'_, Edgel>| chain.vertices.iter().map(|edgel| edgel.at).collect();
        self.chains().map(|chain| Polyline { vertices: positions(chain), closed: chain.closed }).collect()
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.chains.is_empty()
    }
}
