//! The dots of a page: on its device's grid, or where they lie.

use super::Matrix;
use crate::devices::DotArea;
use crate::page::{DotMedium, Dots, Height, Medium, Page, Pen, Run};
use crate::units::MmPoint;

impl Matrix {
    /// The dots of a page of dots, each at its height. None if the page is printed, or its device has no grid.
    pub fn of(page: &Page) -> Option<Self> {
        let Medium::Dots(DotMedium { area: DotArea::Grid(grid), .. }) = &page.medium else { return None };
        let mut matrix = Self::new(grid.columns.len(), grid.rows.len());
        for (at, height) in dots(page) {
            if let Some([x, y]) = grid.nearest(at) {
                matrix.raise(x, y, class(height));
            }
        }
        Some(matrix)
    }
}

/// The centres of all dots of a page of dots with their heights, layer by layer.
pub fn dots(page: &Page) -> Vec<(MmPoint, Height)> {
    let mut out = Vec::new();
    let mut all = |dots: &[MmPoint], height| out.extend(dots.iter().map(|&at| (at, height)));
    let run = |run: &Run| match run.pen {
        Pen::Dots(height) => height,
        Pen::Stroke => Height::High,
    };
    page.orientation_mark.iter().for_each(|mark| all(&mark.points, run(mark)));
    all(&page.frame.at, page.height_of_frame());
    for texture in &page.figure.textures {
        texture.glyphs.iter().for_each(|glyph| all(&[glyph.at], page.height_of_textures()));
    }
    page.figure.lines.iter().flat_map(|line| &line.runs).for_each(|piece| all(&piece.points, run(piece)));
    let labels = |dots: &Dots| dots.at.clone();
    page.labels.iter().for_each(|dots| all(&labels(dots), Height::High));
    out
}

/// The class of a height in a [`Matrix`].
fn class(height: Height) -> u8 {
    match height {
        Height::Low => 1,
        Height::Middle => 2,
        Height::High => Matrix::HIGHEST,
    }
}
