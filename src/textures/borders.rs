//! Where regions end, and whether a glyph keeps inside its own.

use super::glyph::{Glyph, Shape};
use crate::classes::{Class, Classes};
use crate::geom::segment_distance;
use crate::units::{MmPoint, MmRect, MmVector};

/// The regions as they lie on the sheet.
pub(crate) struct Borders<'a> {
    classes: &'a Classes,
    area: MmRect,
    /// Width and height of a cell, mm.
    cell: MmVector,
}

impl<'a> Borders<'a> {
    pub(crate) fn new(classes: &'a Classes, area: MmRect) -> Self {
        let cell = MmVector::new(area.width() / classes.size.width as f32, area.height() / classes.size.height as f32);
        Self { classes, area, cell }
    }

    /// The place in cells.
    fn in_cells(&self, at: MmPoint) -> (f32, f32) {
        ((at.x - self.area.min.x) / self.cell.x, (at.y - self.area.min.y) / self.cell.y)
    }

    fn region_of(&self, x: i64, y: i64) -> Option<u32> {
        let size = self.classes.size;
        let inside = x >= 0 && y >= 0 && x < i64::from(size.width) && y < i64::from(size.height);
        if inside { self.classes.region[y as usize * size.width as usize + x as usize] } else { None }
    }

    /// The region at a place; `None` where the picture is white or has ended.
    pub(crate) fn region_at(&self, at: MmPoint) -> Option<u32> {
        let (x, y) = self.in_cells(at);
        self.region_of(x.floor() as i64, y.floor() as i64)
    }

    /// The neighbouring class that the colour at a place leans to.
    pub(super) fn fringe_at(&self, at: MmPoint) -> Option<Class> {
        let (x, y) = self.in_cells(at);
        let size = self.classes.size;
        let inside = x >= 0.0 && y >= 0.0 && x < size.width as f32 && y < size.height as f32;
        let cell = || y as usize * size.width as usize + x as usize;
        if inside { self.classes.fringe.get(cell()).copied().flatten() } else { None }
    }

    /// The colour's lightness at a place.
    pub(crate) fn lightness_at(&self, at: MmPoint) -> f32 {
        let (x, y) = self.in_cells(at);
        self.classes.lightness.at(x, y)
    }

    /// Whether all of a glyph lies in `region`, and `gap` mm or more from what is not.
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
        Shape::Dot { diameter } => {
            let nearest = glyph.at.clamp(cell.min, cell.max);
            ((glyph.at - nearest).length() - 0.5 * diameter).max(0.0)
        }
        Shape::Rhombus { .. } => {
            let ends = [cell.min, MmPoint::new(cell.max.x, cell.min.y), cell.max, MmPoint::new(cell.min.x, cell.max.y)];
            let inside = |at: &MmPoint| {
                (0..4).all(|i| (corners[(i + 1) % 4] - corners[i]).cross(*at - corners[i]) <= 0.0)
                    || (0..4).all(|i| (corners[(i + 1) % 4] - corners[i]).cross(*at - corners[i]) >= 0.0)
            };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::classes::{Class, Region};
    use crate::raster::plane::Plane;
    use crate::units::Size;

    /// Ten by ten cells of 1 mm from (20, 30), the right half another region than the left.
    fn halves() -> Classes {
        let size = Size::new(10, 10);
        let region = (0..100).map(|i| Some(u32::from(i % 10 >= 5))).collect();
        let regions = [Class::Blue, Class::Red].map(|class| Region { class, colour: [0; 3], cells: 50 }).into();
        Classes { size, region, regions, lightness: Plane::filled(size, 0.5), fringe: Vec::new() }
    }

    #[test]
    fn a_glyph_keeps_its_gap_from_the_border_and_no_more() {
        let classes = halves();
        let borders = Borders::new(&classes, MmRect::new(MmPoint::new(20.0, 30.0), MmPoint::new(30.0, 40.0)));
        let rhombus = |degrees| Shape::Rhombus { length: 2.0, thickness: 1.0, degrees };
        for (shape, half) in [(rhombus(0.0), 1.0), (rhombus(90.0), 0.5), (Shape::Dot { diameter: 1.5 }, 0.75)] {
            let keeps = |x: f32, y: f32| {
                let glyph = Glyph { at: MmPoint::new(x, y), shape };
                borders.keeps_inside(&glyph, &glyph.corners(), 0, 0.3)
            };
            assert!(keeps(25.0 - half - 0.31, 35.0), "{shape:?} is far enough");
            assert!(!keeps(25.0 - half - 0.29, 35.0), "{shape:?} is too near to the other region");
            assert!(!keeps(25.0 - 0.1, 35.0), "{shape:?} lies across the border");
            assert!(
                keeps(20.0 + half + 0.31, 35.0) && !keeps(20.0 + half + 0.29, 35.0),
                "{shape:?} at the picture's edge"
            );
        }
    }
}
