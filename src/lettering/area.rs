//! The area of a line of text, in pixels.

use super::chain::axes;
use super::line::TextLine;
use crate::units::Size;

/// The corners of a line's box, px from the top left of the picture.
pub(super) fn corners(line: &TextLine) -> [[f32; 2]; 4] {
    let [along, across] = axes(line.angle);
    let ends = [(0, 0), (1, 0), (1, 1), (0, 1)];
    ends.map(|(u, v)| [0, 1].map(|axis| along[axis] * line.along[u] + across[axis] * line.across[v]))
}

/// Visits the pixels of a picture whose middle lies in the box of a line.
pub(super) fn each_cell(size: Size, line: &TextLine, mut of: impl FnMut(usize)) {
    let [along, across] = axes(line.angle);
    let corners = corners(line);
    let range = |axis: usize, most: u32| {
        let low = corners.iter().map(|at| at[axis]).fold(f32::MAX, f32::min).max(0.0) as usize;
        let high = corners.iter().map(|at| at[axis]).fold(f32::MIN, f32::max).max(0.0).ceil() as usize;
        low..high.min(most as usize)
    };
    let columns = range(0, size.width);
    for y in range(1, size.height) {
        for x in columns.clone() {
            let at = [x as f32 + 0.5, y as f32 + 0.5];
            let (u, v) = (along[0] * at[0] + along[1] * at[1], across[0] * at[0] + across[1] * at[1]);
            if (line.along[0]..=line.along[1]).contains(&u) && (line.across[0]..=line.across[1]).contains(&v) {
                of(y * size.width as usize + x);
            }
        }
    }
}
