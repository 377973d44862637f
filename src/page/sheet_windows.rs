//! Which part of a picture each of several sheets shows, and how a place is called where there are several.

use crate::note::from_edges;
use crate::units::{MmPoint, MmVector};

/// The windows of a picture on its sheets, in the space of all sheets together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetWindows {
    /// How many sheets lie side by side, and one above the other.
    pub(super) counts: [u32; 2],
    /// The top left corner of the first window.
    pub(super) first: MmPoint,
    /// From window to window.
    pub(super) step: MmVector,
    /// From the edges of a window to the middle of an overlap.
    pub(super) half: MmVector,
    /// The top left corner of a window on its sheet.
    pub(super) corner: MmPoint,
}

/// What the sheet in this column and row is called, such as `b1`.
pub(super) fn sheet_name(column: u32, row: u32) -> String {
    format!("{}{}", char::from(b'a' + row as u8), column + 1)
}

impl SheetWindows {
    /// The name of the sheet that shows a place, and where on it that is. Of two that show it, the one that it lies
    /// nearer to the middle of.
    fn on_sheet(&self, at: MmPoint) -> (String, MmPoint) {
        let off = at - self.first - self.half;
        let index =
            |off: f32, step: f32, count: u32| (off / step).floor().clamp(0.0, count.saturating_sub(1) as f32) as u32;
        let [across, down] = self.counts;
        let (column, row) = (index(off.x, self.step.x, across), index(off.y, self.step.y, down));
        let window = self.first + MmVector::new(column as f32, row as f32).component_mul(self.step);
        (sheet_name(column, row), self.corner + (at - window))
    }
}

/// A place in words: `20, 30 mm`, and where there are several sheets `20, 30 mm on sheet b1`.
pub fn place_in_words(at: MmPoint, sheets: Option<&SheetWindows>) -> String {
    let mm = |at: MmPoint| format!("{:.0}, {:.0} mm", at.x, at.y);
    match sheets.map(|sheets| sheets.on_sheet(at)) {
        Some((sheet, at)) => format!("{} on sheet {sheet}", mm(at)),
        None => mm(at),
    }
}

/// The same with what the numbers count from: `20, 30 mm from the left and the top of the sheet`; `name` is what a
/// single one is called, such as `display`.
pub fn place_from_edges(at: MmPoint, sheets: Option<&SheetWindows>, name: &str) -> String {
    let (of, at) = match sheets.map(|sheets| sheets.on_sheet(at)) {
        Some((sheet, at)) => (format!("sheet {sheet}"), at),
        None => (format!("the {name}"), at),
    };
    format!("{:.0}, {:.0} mm{}", at.x, at.y, from_edges(&of))
}

#[cfg(test)]
mod tests;
