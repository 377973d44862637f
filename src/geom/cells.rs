//! Cells of a grid: those along a segment, those along the edge of the grid, and those that can be reached from some.

use lyon::geom::euclid::Point2D;

use super::components::four_neighbours;
use super::nearest_on_segment;
use crate::units::Size;

/// So much more than its half width a line covers, in cells: half the diagonal of a cell, so that no line has holes,
/// and a little.
pub const COVERS: f32 = 0.75;

/// Sets the cells whose middles lie no farther than `reach` from the segment `a`-`b`; all of these in cells.
pub fn set_along<U>(is_set: &mut [bool], size: Size, [a, b]: [Point2D<f32, U>; 2], reach: f32) {
    let range = |from: f32, to: f32, count: u32| {
        let (first, end) = ((from.min(to) - reach).floor(), (from.max(to) + reach).ceil());
        first.max(0.0) as usize..(end.max(0.0) as usize).min(count as usize)
    };
    let (columns, rows) = (range(a.x, b.x, size.width), range(a.y, b.y, size.height));
    for (x, y) in rows.flat_map(|y| columns.clone().map(move |x| (x, y))) {
        let middle = Point2D::new(x as f32 + 0.5, y as f32 + 0.5);
        is_set[y * size.width as usize + x] |= nearest_on_segment(middle, a, b).0 <= reach;
    }
}

/// The cells along the edge of a grid; none of one that has no cells.
pub fn edge_cells(size: Size) -> impl Iterator<Item = usize> {
    let (width, height) = if size.len() == 0 { (0, 0) } else { (size.width as usize, size.height as usize) };
    let rows = (0..width).flat_map(move |x| [x, (height - 1) * width + x]);
    rows.chain((0..height).flat_map(move |y| [y * width, y * width + width - 1]))
}

/// The cells that can be reached from some through open ones, side by side.
pub fn filled(size: Size, from: impl IntoIterator<Item = usize>, is_open: impl Fn(usize) -> bool) -> Vec<bool> {
    let mut is_in = vec![false; size.len()];
    let mut todo: Vec<usize> = from.into_iter().collect();
    while let Some(cell) = todo.pop() {
        if is_open(cell) && !std::mem::replace(&mut is_in[cell], true) {
            todo.extend(four_neighbours(cell, size));
        }
    }
    is_in
}

#[cfg(test)]
mod tests;
