//! The outline of the whole: which lines of a drawing have the ground outside of all its shapes on one side, as the
//! coasts of a map, and how much of what lines enclose is open to that ground where some of them have no room. A shape
//! without a part of what is in it tells more than one that is open.

use super::outlines::Rank;
use super::params::Params;
use super::vertex::Vertex;
use super::weight;
use crate::geom::cells::{COVERS, edge_cells, filled, set_along};
use crate::geom::components::{Connectivity, of_set};
use crate::geom::distance::squared_distances;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, MmVector, Size};

/// Side of a cell, mm: half a line's width.
const CELL: f32 = 0.5;
/// So many cells lie around the part of the page on every side: more than a line on its edge covers.
const RIM: u32 = 6;
/// The ground begins no farther than this beyond what a line on the outline covers, in cells: a millimetre, which is
/// less than two lines are apart.
const BESIDE: f32 = 2.0;
/// An area is open if the ground has more than this share of it: beside lines that are moved it has a little.
const MOSTLY: f32 = 0.5;

/// What lines leave blank, cell by cell.
pub(super) struct Ground {
    /// The corner of the first cell.
    origin: MmPoint,
    size: Size,
    is_line: Vec<bool>,
    /// Whether a cell can be reached from the edge without crossing a line.
    is_outside: Vec<bool>,
}

impl Ground {
    /// That of lines with widths in this part of the page.
    pub(super) fn of<'a>(lines: impl Iterator<Item = &'a Polyline<Vertex>>, area: MmRect) -> Self {
        let count = |length: f32| (length / CELL).ceil().max(0.0) as u32 + 2 * RIM;
        let size = Size::new(count(area.width()), count(area.height()));
        // from the middle, so that a flipped drawing has flipped cells
        let origin = area.center() - MmVector::new(size.width as f32, size.height as f32) * (0.5 * CELL);
        let mut is_line = vec![false; size.len()];
        for (a, b) in lines.flat_map(Polyline::segments) {
            let ends = [a, b].map(|vertex| to_cells(vertex.at, origin));
            set_along(&mut is_line, size, ends, 0.5 * weight::between(a, b) / CELL + COVERS);
        }
        let is_outside = filled(size, edge_cells(size), |cell| !is_line[cell]);
        Self { origin, size, is_line, is_outside }
    }

    /// The share of what these lines enclose, area by area, that is open where `drawn` are the lines, 0..=1.
    pub(super) fn opened(&self, drawn: &Self) -> f32 {
        let is_enclosed = |(is_line, is_outside): (&bool, &bool)| !is_line && !is_outside;
        let enclosed: Vec<bool> = self.is_line.iter().zip(&self.is_outside).map(is_enclosed).collect();
        let (mut all, mut open) = (0, 0);
        for area in of_set(&enclosed, self.size, Connectivity::Four) {
            let outside = area.iter().filter(|cell| drawn.is_outside[**cell]).count();
            all += area.len();
            open += if outside as f32 > MOSTLY * area.len() as f32 { area.len() } else { 0 };
        }
        open as f32 / all.max(1) as f32
    }

    /// These lines, of which those on the outline of the whole go before others; none if that changes nothing, as all
    /// are on it or none.
    pub(super) fn outline_first(
        &self,
        lines: &[(Polyline<Vertex>, Rank)],
        params: &Params,
    ) -> Option<Vec<(Polyline<Vertex>, Rank)>> {
        let to_ground = squared_distances(&self.is_outside, self.size);
        let ranked = |(line, rank): &(Polyline<Vertex>, Rank)| {
            let goes_first = *rank == Rank::Ordinary && self.is_on_outline(line, &to_ground, params);
            (line.clone(), if goes_first { Rank::Whole } else { *rank })
        };
        let ranked: Vec<_> = lines.iter().map(ranked).collect();
        let has = |of: Rank| ranked.iter().any(|(_, rank)| *rank == of);
        (has(Rank::Whole) && has(Rank::Ordinary)).then_some(ranked)
    }

    /// Whether so much of a line as is felt as one lies beside the ground, which is so many squared cells away from
    /// each. A river comes to it at its mouth only.
    fn is_on_outline(&self, line: &Polyline<Vertex>, to_ground: &[u32], params: &Params) -> bool {
        let is_beside = |(a, b): &(&Vertex, &Vertex)| {
            let reach = 0.5 * weight::between(a, b) / CELL + COVERS + BESIDE;
            self.cell(a.at.lerp(b.at, 0.5)).is_some_and(|cell| to_ground[cell] as f32 <= reach * reach)
        };
        let beside: f32 = line.segments().filter(is_beside).map(|(a, b)| (b.at - a.at).length()).sum();
        beside >= params.min_length.min(0.5 * line.length())
    }

    /// The number of the cell at a place; none beside the grid.
    fn cell(&self, at: MmPoint) -> Option<usize> {
        let at = to_cells(at, self.origin);
        let (width, height) = (self.size.width, self.size.height);
        let is_there = at.x >= 0.0 && at.y >= 0.0 && at.x < width as f32 && at.y < height as f32;
        is_there.then(|| at.y as usize * width as usize + at.x as usize)
    }
}

/// A place, in cells from this corner.
fn to_cells(at: MmPoint, origin: MmPoint) -> MmPoint {
    ((at - origin) / CELL).to_point()
}

#[cfg(test)]
mod tests;
