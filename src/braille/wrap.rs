//! Cells in lines.

use super::Braille;

/// Cells in lines of a width.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrapped {
    /// The lines, none empty.
    pub lines: Vec<Vec<u8>>,
    /// Whether a word is longer than a line, and was cut.
    pub cut: bool,
}

/// Braille in lines of at most `width` cells: lines end at a blank or behind a hyphen that the text has. A word that is
/// longer than a line is cut.
pub fn wrap(braille: &Braille, width: usize) -> Wrapped {
    let (cells, width) = (&braille.cells, width.max(1));
    let mut wrapped = Wrapped { lines: Vec::new(), cut: false };
    let mut from = 0;
    while let Some(begin) = cells[from..].iter().position(|&cell| cell != 0) {
        from += begin;
        let longest = (from + width).min(cells.len());
        let can_end = |&end: &usize| end == cells.len() || cells[end] == 0 || braille.breaks.contains(&end);
        let end = (from + 1..=longest).rev().find(can_end);
        wrapped.cut |= end.is_none();
        let end = end.unwrap_or(longest);
        let length = cells[from..end].iter().rposition(|&cell| cell != 0).map_or(0, |last| last + 1);
        wrapped.lines.push(cells[from..from + length].to_vec());
        from = end;
    }
    wrapped
}
