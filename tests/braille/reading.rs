//! Dots on a page, read back as cells: how a person who knows the measures of braille would take them.

use tactograph::internals::braille::CellSize;
use tactograph::internals::units::MmPoint;

/// How far a dot may lie from where its cell has it, mm: pages are written in hundredths.
const EXACT: f32 = 0.05;

/// The lines of a text in Unicode braille. Panics if a dot is off the measures.
pub(super) fn lines(dots: &[MmPoint], size: CellSize) -> Vec<String> {
    let mut rest = dots.to_vec();
    rest.sort_by(|a, b| a.y.total_cmp(&b.y));
    let mut lines = Vec::new();
    while let Some(first) = rest.first().copied() {
        // the highest dot of a line is in its first row, unless no cell has one there
        let of_line = |at: &MmPoint| at.y < first.y + 2.0 * size.dot + EXACT;
        let (line, below): (Vec<_>, Vec<_>) = rest.iter().partition(|at| of_line(at));
        lines.push(read_line(&line, size));
        rest = below;
    }
    lines
}

/// Whether lines say what these cells do, with a blank or a hyphen of the text between two lines, or with a word
/// divided there, which brings a hyphen of its own.
pub(super) fn say(lines: &[String], cells: &str) -> bool {
    let blank = '\u{2800}';
    let rest = lines.iter().try_fold(cells, |rest, line| {
        let divided = || line.strip_suffix('⠤').and_then(|line| rest.strip_prefix(line));
        let rest = rest.strip_prefix(line.as_str()).or_else(divided)?;
        Some(rest.trim_start_matches(blank))
    });
    rest == Some("")
}

/// The cells of one line.
fn read_line(dots: &[MmPoint], size: CellSize) -> String {
    let least = |of: fn(&MmPoint) -> f32| dots.iter().map(of).fold(f32::INFINITY, f32::min);
    let (left, top) = (least(|at| at.x), least(|at| at.y));
    // the leftmost dot may be in the right column of its cell, where the left one is blank
    let cells = [0.0, size.dot].iter().find_map(|shift| cells(dots, left - shift, top, size));
    let cells = cells.unwrap_or_else(|| panic!("dots are off the measures of braille: {dots:?}"));
    cells.iter().map(|&cell| char::from_u32(0x2800 + u32::from(cell)).expect("a cell")).collect()
}

fn cells(dots: &[MmPoint], left: f32, top: f32, size: CellSize) -> Option<Vec<u8>> {
    let mut cells = Vec::new();
    for at in dots {
        let (across, down) = (at.x - left, at.y - top);
        let cell = ((across + EXACT) / size.cell).floor();
        let column = ((across - cell * size.cell) / size.dot).round();
        let row = (down / size.dot).round();
        let off = (across - cell * size.cell - column * size.dot).abs().max((down - row * size.dot).abs());
        if off > EXACT || !(0.0..=1.0).contains(&column) || !(0.0..=2.0).contains(&row) {
            return None;
        }
        let cell = cell as usize;
        cells.resize(cells.len().max(cell + 1), 0_u8);
        cells[cell] |= 1 << (3 * column as usize + row as usize);
    }
    Some(cells)
}
