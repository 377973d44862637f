//! What is where on the sheet: the regions, and how densely lines lie.

use super::glyph::{Glyph, Shape};
use crate::classes::{Class, Classes};
use crate::geom::{polygon, segment_distance};
use crate::lines::Line;
use crate::raster::plane::Plane;
use crate::units::{MmPoint, MmRect, MmVector, Size};

/// The regions as they lie on the sheet.
pub(crate) struct RegionMap<'a> {
    classes: &'a Classes,
    area: MmRect,
    /// Width and height of a cell, mm.
    cell: MmVector,
}

impl<'a> RegionMap<'a> {
    pub(crate) fn new(classes: &'a Classes, area: MmRect) -> Self {
        let cell = MmVector::new(area.width() / classes.size.width as f32, area.height() / classes.size.height as f32);
        Self { classes, area, cell }
    }

    /// A position in cells.
    fn in_cells(&self, at: MmPoint) -> (f32, f32) {
        ((at.x - self.area.min.x) / self.cell.x, (at.y - self.area.min.y) / self.cell.y)
    }

    fn region_of(&self, x: i64, y: i64) -> Option<u32> {
        let size = self.classes.size;
        let inside = x >= 0 && y >= 0 && x < i64::from(size.width) && y < i64::from(size.height);
        if inside { self.classes.region[y as usize * size.width as usize + x as usize] } else { None }
    }

    /// The region at a position; `None` where the picture is white and outside of it.
    pub(crate) fn region_at(&self, at: MmPoint) -> Option<u32> {
        let (x, y) = self.in_cells(at);
        self.region_of(x.floor() as i64, y.floor() as i64)
    }

    /// The neighbouring class that the colour at a position tends to.
    pub(super) fn fringe_at(&self, at: MmPoint) -> Option<Class> {
        let (x, y) = self.in_cells(at);
        let size = self.classes.size;
        let inside = x >= 0.0 && y >= 0.0 && x < size.width as f32 && y < size.height as f32;
        let cell = || y as usize * size.width as usize + x as usize;
        if inside { self.classes.fringe.get(cell()).copied().flatten() } else { None }
    }

    /// The lightness of the colour at a position.
    pub(crate) fn lightness_at(&self, at: MmPoint) -> f32 {
        let (x, y) = self.in_cells(at);
        self.classes.lightness.at(x, y)
    }

    /// Whether all of a glyph lies in `region`, with a clearance of `gap` mm from everything else.
    pub(crate) fn keeps_inside(&self, glyph: &Glyph, corners: &[MmPoint; 4], region: u32, gap: f32) -> bool {
        let mut low = glyph.at;
        let mut high = glyph.at;
        for corner in corners {
            (low, high) = (low.min(*corner), high.max(*corner));
        }
        let (left, top) = self.in_cells(low - MmVector::new(gap, gap));
        let (right, bottom) = self.in_cells(high + MmVector::new(gap, gap));
        (top.floor() as i64..=bottom.floor() as i64).all(|y| {
            (left.floor() as i64..=right.floor() as i64).all(|x| {
                self.region_of(x, y) == Some(region) || distance_to_box(glyph, corners, self.box_of(x, y)) >= gap
            })
        })
    }

    fn box_of(&self, x: i64, y: i64) -> MmRect {
        let low = self.area.min + MmVector::new(x as f32 * self.cell.x, y as f32 * self.cell.y);
        MmRect::new(low, low + self.cell)
    }
}

/// Distance between a glyph's outline and a box, mm; 0 where they overlap.
fn distance_to_box(glyph: &Glyph, corners: &[MmPoint; 4], cell: MmRect) -> f32 {
    match glyph.shape {
        Shape::Dot { diameter } => (polygon::distance_to_box(glyph.at, cell) - 0.5 * diameter).max(0.0),
        Shape::Rhombus { .. } => {
            let ends = polygon::corners(cell);
            let inside = |at: &MmPoint| polygon::is_in_convex(*at, corners);
            if corners.iter().any(|corner| cell.contains_inclusive(*corner)) || ends.iter().any(inside) {
                return 0.0;
            }
            let sides = |points: [MmPoint; 4]| (0..4).map(move |i| (points[i], points[(i + 1) % 4]));
            sides(*corners)
                .flat_map(|side| sides(ends).map(move |other| segment_distance(side, other)))
                .fold(f32::MAX, f32::min)
        }
    }
}

/// Cells of the map of line density, mm. The blur is several times wider.
const DENSITY_CELL: f32 = 1.0;
/// Lines are marked in steps of this, mm.
const DENSITY_STEP: f32 = 0.25;

/// The density of lines over `area`, where textures stand dense; its pixels are [`DENSITY_CELL`] wide. As in the paper
/// (Rataj 2004), every line is marked and the marks are blurred with `sigma` millimetres. The result is divided by the
/// value that a lone straight line has on itself, `1 / (sqrt(tau) sigma)`, and cut at 1: the local density, whatever
/// the resolution.
pub(crate) fn line_density(lines: &[Line], area: MmRect, sigma: f32) -> Plane {
    let cells = |mm: f32| (mm / DENSITY_CELL).ceil().max(1.0) as u32;
    let mut map = Plane::filled(Size::new(cells(area.width()), cells(area.height())), 0.0);
    if lines.is_empty() {
        return map;
    }
    for (&a, &b) in lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.polyline().segments()) {
        let (step, length) = (b - a, (b - a).length());
        let steps = (length / DENSITY_STEP).ceil().max(1.0);
        for k in 0..steps as u32 {
            let at = a + step * ((k as f32 + 0.5) / steps) - area.min.to_vector();
            let x = ((at.x / DENSITY_CELL) as u32).min(map.size.width - 1);
            let y = ((at.y / DENSITY_CELL) as u32).min(map.size.height - 1);
            map.values[(y * map.size.width + x) as usize] += length / steps;
        }
    }
    let mut map = map.blurred(sigma / DENSITY_CELL);
    let lone_line = DENSITY_CELL / (std::f32::consts::TAU.sqrt() * sigma / DENSITY_CELL);
    map.values.iter_mut().for_each(|value| *value = (*value / lone_line).min(1.0));
    map
}

#[cfg(test)]
mod tests;
