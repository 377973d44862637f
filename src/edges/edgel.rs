//! The result of the detector: contours as chains of edgels.

use std::ops::Range;

use crate::geom::polyline::{Located, Polyline, PolylineRef};
use crate::geom::right_of;
use crate::regions::Tree;
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

/// What is known of a chain as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ChainKind {
    /// Whether it is a path of a vector drawing, or as exact as that: a line that a person gave, or the head of an
    /// arrow, whose corners were fitted to the pixels as a triangle. Otherwise it was found in the pixels, and has the
    /// wobble of noise.
    pub exact: bool,
    /// Whether the picture is a drawing, in which every line is meant.
    pub of_drawing: bool,
    /// Width of the stroke of which it is the centre line, px; none of an edge.
    pub stroke: Option<f32>,
    /// Whether it is a stroke of a vector drawing that is much thinner and paler than its others.
    pub faint: bool,
    /// Whether a person added it to those that were found.
    pub added: bool,
    /// Whether it is the filled head of an arrow in a bitmap: its tip and two other corners.
    pub head: bool,
    /// Of the ring of a sign that marks a place, as the points of a scatter plot do, the number of its kind.
    pub sign: Option<u8>,
}

/// The edgels of one chain.
#[derive(Debug, Clone, PartialEq)]
pub struct ChainRange {
    /// Their numbers in [`Edges::edgels`].
    pub edgels: Range<usize>,
    /// Whether the chain continues from its last edgel to its first, which is not repeated.
    pub closed: bool,
    /// What it is.
    pub kind: ChainKind,
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
    /// The regions between contours, where they were asked for.
    pub regions: Option<Tree>,
    /// How many of the lines are dashed in the picture; here they have no gaps.
    pub dashed: usize,
    /// The middles of strokes of a vector drawing that lie as a whole on others, and are no chains of their own.
    pub overlaid: Vec<PxPoint>,
    /// The tip of one of the marks on lines that are too short to be found for certain, as those of minutes on a clock.
    pub short_marks: Option<PxPoint>,
}

impl Edges {
    /// No contours, for a picture of `size`.
    pub fn none(size: Size) -> Self {
        Self {
            size,
            edgels: Vec::new(),
            chains: Vec::new(),
            regions: None,
            dashed: 0,
            overlaid: Vec::new(),
            short_marks: None,
        }
    }

    /// Appends an edge that was found in the pixels.
    pub fn push(&mut self, chain: impl Iterator<Item = Edgel>, closed: bool) {
        self.push_as(ChainKind::default(), chain, closed);
    }

    /// Appends a chain of any kind.
    pub fn push_as(&mut self, kind: ChainKind, chain: impl Iterator<Item = Edgel>, closed: bool) {
        let start = self.edgels.len();
        self.edgels.extend(chain);
        self.chains.push(ChainRange { edgels: start..self.edgels.len(), closed, kind });
    }

    /// A chain as a polyline.
    pub fn chain(&self, range: &ChainRange) -> PolylineRef<'_, Edgel> {
        PolylineRef { vertices: &self.edgels[range.edgels.clone()], closed: range.closed }
    }

    /// The chains one by one.
    pub fn chains(&self) -> impl Iterator<Item = PolylineRef<'_, Edgel>> {
        self.chains.iter().map(|range| self.chain(range))
    }

    /// Where colours end: the positions of all chains, of a stroke those of its two sides.
    pub fn borders(&self) -> Vec<Polyline<PxPoint>> {
        let mut borders = Vec::with_capacity(self.chains.len());
        for range in &self.chains {
            let chain = self.chain(range);
            match range.kind {
                ChainKind { stroke: Some(width), .. } if width > THIN => {
                    borders.extend([0.5, -0.5].map(|side| offset(chain, side * width)));
                }
                _ => borders.push(offset(chain, 0.0)),
            }
        }
        borders
    }

    /// Whether they are those of a drawing, in which every line is meant.
    pub fn of_drawing(&self) -> bool {
        self.chains.iter().any(|chain| chain.kind.of_drawing)
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.chains.is_empty()
    }
}

/// A stroke of up to this width, px, has no colour of its own that fills a pixel.
const THIN: f32 = 1.5;

/// The positions of a chain, moved to its right by a distance, px.
fn offset(chain: PolylineRef<'_, Edgel>, distance: f32) -> Polyline<PxPoint> {
    let moved = |i: usize| {
        let along = chain.tangent(i);
        chain.vertices[i].at + right_of(along) * distance
    };
    Polyline { vertices: (0..chain.vertices.len()).map(moved).collect(), closed: chain.closed }
}
