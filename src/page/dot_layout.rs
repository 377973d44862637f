//! Where things lie on a device's grid of dots: as on paper, moved on to the grid.
//!
//! From left to right the picture is centred on the grid, so that a flipped one takes the same dots, flipped; from
//! top to bottom it begins in the middle between two rows.

use super::cells::CellGrid;
use super::frame;
use super::heading::Heading;
use super::medium::{DotMedium, Medium};
use super::parts::Run;
use super::sheet::{FrameParams, Layout, MarkParams, Params, Sheet, beside};
use crate::devices::DotArea;
use crate::units::{MmPoint, MmRect, MmVector};

/// Less than the distance of any two dots, mm.
const EPSILON_MM: f32 = 1e-3;

/// A picture whose width is `aspect` times its height, as large as the device allows on a sheet that lies this way,
/// but not wider than `widest`.
pub(super) fn fit(aspect: f32, widest: f32, size: [f32; 2], params: &Params, medium: DotMedium) -> Layout {
    let usable = medium.usable();
    let overview = params.overview;
    let params = Params {
        // The grid ends where the device does; on it the margin is as on any sheet.
        frame: params.frame.map(|params| band(&params, &medium)),
        mark: params.mark.map(|mark| MarkParams { width: medium.pitch, ..mark }),
        overview: None,
        ..*params
    };
    let size_of_usable = [usable.width(), usable.height()];
    let heading = params.heading.and_then(|heading| {
        let cells = CellGrid::of_dots(&medium, heading.cell);
        Heading::on(&heading, &cells, size_of_usable, params.margin, beside(params.mark, &cells))
    });
    let sheet = Sheet::new(size_of_usable, &params, heading.as_ref());
    let place = |widest: f32| {
        let at = sheet.lay_out(aspect, sheet.figure_width(aspect).min(widest));
        (on_grid(at.figure.translate(usable.min.to_vector()), &medium), at.mark)
    };
    let (figure, mark) = place(widest);
    let overview = overview.map(|overview| place(overview.scale * figure.width()).0);
    let mark = mark.map(|mark| {
        let moved = mark.points.iter().map(|&at| at + usable.min.to_vector()).collect();
        Run::stroke(mark.width, mark_on_grid(moved, &medium.area))
    });
    let heading = heading.map(|heading| heading.translated(usable.min.to_vector()));
    let medium = Medium::Dots(medium);
    Layout { sheet: size, figure, room: figure, overview, mark, heading, medium, sheets: None }
}

/// The band that a frame takes: one dot, and half a pitch for the grid, whose rows and columns are where they are.
pub(super) fn band(params: &FrameParams, medium: &DotMedium) -> FrameParams {
    let gap = frame::empty(params, medium) as f32 * medium.pitch;
    FrameParams { width: 1.5 * medium.pitch, dot: medium.diameter(), pitch: params.pitch, gap }
}

/// The same rectangle in the middle of the columns, its top in the middle between two rows.
pub(super) fn on_grid(figure: MmRect, medium: &DotMedium) -> MmRect {
    let DotArea::Grid(grid) = &medium.area else { return figure };
    let lowest = medium.usable().max.y - figure.height() + EPSILON_MM;
    let corner = |mm: f32, centres: &[f32]| {
        let index = centres.partition_point(|&centre| centre < mm);
        // the nearer one of the middles around; before the first dot it is half a pitch away
        let middle = |index: usize| match (index.checked_sub(1).and_then(|i| centres.get(i)), centres.get(index)) {
            (Some(a), Some(b)) => 0.5 * (a + b),
            (None, Some(b)) => b - 0.5 * medium.pitch,
            (Some(a), None) => a + 0.5 * medium.pitch,
            (None, None) => mm,
        };
        let around = [index.saturating_sub(1), index, index + 1].map(middle);
        let nearest = |a: &f32, b: &f32| (a - mm).abs().total_cmp(&(b - mm).abs());
        // rather higher than beyond the last row
        let inside = around.into_iter().filter(|at| *at <= lowest).min_by(nearest);
        inside.or_else(|| around.into_iter().min_by(nearest)).unwrap_or(mm)
    };
    // a hair narrower, so that no column lies on an edge
    let (middle, half) = (grid.bounds().center().x, 0.5 * figure.width());
    let top = corner(figure.min.y, &grid.rows);
    let min = MmPoint::new(middle - half + EPSILON_MM, top);
    MmRect::new(min, min + MmVector::new(figure.width() - 2.0 * EPSILON_MM, figure.height()))
}

/// The ends of the orientation mark on dots that are as many columns as rows apart; the lower right one is the
/// nearest, so that all of it keeps the margin.
pub(super) fn mark_on_grid(points: Vec<MmPoint>, area: &DotArea) -> Vec<MmPoint> {
    let (DotArea::Grid(grid), [a, .., b]) = (area, &points[..]) else { return points };
    let (from, to) = (grid.nearest(*a), grid.nearest(*b));
    let (Some([left, top]), Some([right, _])) = (from, to) else { return points };
    let steps = (right - left).max(2);
    [grid.at(right.saturating_sub(steps), top), grid.at(right, top + steps)].into_iter().flatten().collect()
}

#[cfg(test)]
mod tests;
