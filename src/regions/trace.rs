//! Traced contours, as they come in and as outlines go out, and the areas that those surround.

use super::grid::RegionGrid;
use crate::geom::polyline::{Located, Polyline};
use crate::units::{Px, PxPoint};

/// A point of a traced contour, in pixels of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TracePoint {
    /// Where it is.
    pub at: PxPoint,
    /// Strength of the contour here.
    pub strength: f32,
}

impl Located for TracePoint {
    type Unit = Px;

    fn at(&self) -> PxPoint {
        self.at
    }
}

/// A traced contour.
pub type TracedContour = Polyline<TracePoint>;

/// A piece of the outline of a chosen region.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionOutline {
    /// Where it runs, in pixels of the picture.
    pub contour: TracedContour,
    /// Whose it is: the place of the region among those that are chosen, from 0 on.
    pub region: usize,
}

/// The areas inside the outlines of chosen regions, cell by cell.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineAreas {
    pub(super) grid: RegionGrid,
    /// The area of each cell, from 1 on; 0 is the ground.
    pub(super) labels: Vec<u8>,
    /// How many there are beside the ground.
    pub(super) count: usize,
    /// How many regions tell enough for an outline beside these, and are beyond the most that are drawn.
    pub(super) beyond: usize,
}

impl OutlineAreas {
    /// How many there are, without the ground between and around them.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How many regions tell enough for an outline and are left out, as they are beyond the most that are drawn.
    pub fn beyond(&self) -> usize {
        self.beyond
    }

    /// The number of the area at a place of the picture, from 1 on; 0 is the ground, which also is outside the picture.
    pub fn at(&self, at: PxPoint) -> usize {
        self.grid.cell_at(self.grid.to_cells(at)).map_or(0, |cell| usize::from(self.labels[cell]))
    }
}
