//! A part of a picture, cell by cell.

use super::grid::RegionGrid;
use crate::geom::cells::{edge_cells, filled};
use crate::geom::distance::squared_distances;
use crate::geom::polygon::row_inside;
use crate::units::PxPoint;

/// Some cells of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Mask {
    grid: RegionGrid,
    is_in: Vec<bool>,
}

impl Mask {
    pub(super) fn new(grid: RegionGrid, is_in: Vec<bool>) -> Self {
        Self { grid, is_in }
    }

    /// The cells whose middles lie inside a ring, whose points are in pixels of the picture.
    pub fn of_ring(grid: RegionGrid, ring: &[PxPoint]) -> Self {
        let (width, height) = (grid.cells.width as usize, grid.cells.height as usize);
        let corners: Vec<PxPoint> = ring.iter().map(|&at| grid.to_cells(at)).collect();
        let mut is_in = vec![false; width * height];
        for (y, row) in is_in.chunks_exact_mut(width).enumerate() {
            let sides = corners.iter().zip(corners.iter().cycle().skip(1));
            for [from, to] in row_inside(sides, y as f32 + 0.5) {
                let column = |x: f32| ((x + 0.5).floor().max(0.0) as usize).min(width);
                row[column(from)..column(to)].fill(true);
            }
        }
        Self { grid, is_in }
    }

    /// What lines enclose together around a place, with whatever lies inside it; none if they do not, so that the edge
    /// of the picture can be reached from there without crossing a line, or if one runs through the place. Points are
    /// in pixels of the picture.
    pub fn enclosed(grid: RegionGrid, lines: &[Vec<PxPoint>], at: PxPoint) -> Option<Self> {
        let start = grid.cell_at(grid.to_cells(at))?;
        let mut is_line = vec![false; grid.cells.len()];
        for (a, b) in lines.iter().flat_map(|line| line.iter().zip(line.iter().skip(1))) {
            let (a, b) = (grid.to_cells(*a), grid.to_cells(*b));
            // in steps of half a cell cells follow one another at corners at least, between which no fill passes
            let steps = (2.0 * (b - a).length()).ceil().max(1.0) as u32;
            let cells = (0..=steps).filter_map(|step| grid.cell_at(a.lerp(b, step as f32 / steps as f32)));
            cells.for_each(|cell| is_line[cell] = true);
        }
        if is_line[start] {
            return None;
        }
        let inside = filled(grid.cells, [start], |cell| !is_line[cell]);
        if edge_cells(grid.cells).any(|cell| inside[cell]) {
            return None;
        }
        // with what lies in it, as eyes in a face, and half of the line around it
        let outside = filled(grid.cells, edge_cells(grid.cells), |cell| !inside[cell]);
        let all = Self { grid, is_in: outside.into_iter().map(|is_outside| !is_outside).collect() };
        Some(all.grown(1.0))
    }

    /// Whether it has this share of the picture or more, or reaches three of its sides.
    pub fn fills(&self, share: f32) -> bool {
        let (width, height) = (self.grid.cells.width as usize, self.grid.cells.height as usize);
        let is_in = |x: usize, y: usize| self.is_in[y * width + x];
        let sides = [
            (0..width).any(|x| is_in(x, 0)),
            (0..width).any(|x| is_in(x, height - 1)),
            (0..height).any(|y| is_in(0, y)),
            (0..height).any(|y| is_in(width - 1, y)),
        ];
        self.cells() as f32 >= share * self.is_in.len() as f32 || sides.into_iter().filter(|side| *side).count() > 2
    }

    /// The same part of a picture in other cells, of the picture in another size.
    #[must_use]
    pub fn on(&self, grid: RegionGrid) -> Self {
        let (width, height) = (grid.cells.width as usize, grid.cells.height as usize);
        let across = self.grid.picture.width as f32 / width as f32;
        let down = self.grid.picture.height as f32 / height as f32;
        let middle = |x: usize, y: usize| PxPoint::new((x as f32 + 0.5) * across, (y as f32 + 0.5) * down);
        let cells = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Self { grid, is_in: cells.map(|(x, y)| self.contains(middle(x, y))).collect() }
    }

    /// The cells of either; both are in the cells of one grid.
    #[must_use]
    pub fn united(mut self, other: &Self) -> Self {
        debug_assert_eq!(self.grid, other.grid, "cells of unlike grids are in unlike places");
        self.is_in.iter_mut().zip(&other.is_in).for_each(|(own, other)| *own |= other);
        self
    }

    /// The cells no further than so many cells from it.
    #[must_use]
    pub fn grown(mut self, cells: f32) -> Self {
        let to = squared_distances(&self.is_in, self.grid.cells);
        self.is_in.iter_mut().zip(to).for_each(|(is_in, to)| *is_in = to as f32 <= cells * cells);
        self
    }

    /// Whether a place of the picture is in it.
    pub fn contains(&self, at: PxPoint) -> bool {
        self.grid.cell_at(self.grid.to_cells(at)).is_some_and(|cell| self.is_in[cell])
    }

    /// The middles of its cells that have others beside them, in pixels of the picture. The edge of the picture is no
    /// border.
    pub fn border(&self) -> Vec<PxPoint> {
        let (width, height) = (self.grid.cells.width as usize, self.grid.cells.height as usize);
        let is_in = |x: usize, y: usize| self.is_in[y * width + x];
        let is_border = |x: usize, y: usize| {
            x > 0 && !is_in(x - 1, y)
                || x + 1 < width && !is_in(x + 1, y)
                || y > 0 && !is_in(x, y - 1)
                || y + 1 < height && !is_in(x, y + 1)
        };
        let mut border = Vec::new();
        for (y, row) in self.is_in.chunks_exact(width).enumerate() {
            let own = row.iter().enumerate().filter(|(_, is_in)| **is_in).map(|(x, _)| x);
            let of_row = own.filter(|&x| is_border(x, y));
            border.extend(of_row.map(|x| self.grid.to_picture(PxPoint::new(x as f32 + 0.5, y as f32 + 0.5))));
        }
        border
    }

    /// The smallest box around it, in pixels of the picture: its least and greatest corner; none if it is empty.
    pub fn extent(&self) -> Option<[PxPoint; 2]> {
        let width = self.grid.cells.width as usize;
        let cells = || self.is_in.iter().enumerate().filter(|(_, is_in)| **is_in).map(|(cell, _)| cell);
        let (left, right) = (cells().map(|cell| cell % width).min()?, cells().map(|cell| cell % width + 1).max()?);
        let (top, bottom) = (cells().next()? / width, cells().next_back()? / width + 1);
        let corner = |x: usize, y: usize| self.grid.to_picture(PxPoint::new(x as f32, y as f32));
        Some([corner(left, top), corner(right, bottom)])
    }

    /// A place well inside: the middle of the cell that is farthest from all that are not in it, of which those beyond
    /// the edge of the picture are some, in pixels of the picture; none if it is empty.
    pub fn inside(&self) -> Option<PxPoint> {
        let [width, height] = [self.grid.cells.width, self.grid.cells.height].map(|side| side as usize);
        let is_outside: Vec<bool> = self.is_in.iter().map(|is_in| !is_in).collect();
        let to_others = squared_distances(&is_outside, self.grid.cells);
        let own = to_others.into_iter().zip(&self.is_in).enumerate().filter(|(_, (_, is_in))| **is_in);
        let far = |cell: usize, to_others: u32| {
            let (x, y) = (cell % width, cell / width);
            let to_edge = (x + 1).min(width - x).min(y + 1).min(height - y);
            to_others.min((to_edge * to_edge) as u32)
        };
        let (cell, _) = own.max_by_key(|(cell, (to_others, _))| far(*cell, *to_others))?;
        Some(self.grid.to_picture(PxPoint::new((cell % width) as f32 + 0.5, (cell / width) as f32 + 0.5)))
    }

    /// The share of its outline that lies on the edge of the picture, 0..=1.
    pub fn on_picture_edge(&self) -> f32 {
        match edge_cells(self.grid.cells).filter(|&cell| self.is_in[cell]).count() {
            // what follows takes time
            0 => 0.0,
            on_edge => on_edge as f32 / (on_edge + self.border().len()) as f32,
        }
    }

    /// Whether each cell is in it.
    pub(super) fn is_in(&self) -> &[bool] {
        &self.is_in
    }

    /// How many cells it has.
    pub fn cells(&self) -> usize {
        self.is_in.iter().filter(|is_in| **is_in).count()
    }
}

#[cfg(test)]
mod tests;
