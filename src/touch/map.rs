//! What is felt, as a picture: the pattern and the name of the class that is felt, cell by cell.
//!
//! Patterns and words say the same as the colours. Cells that are too near to a border or a line to be judged are pale.
//! Where another class is felt than is meant, crosses lie over the pattern and the name states the class that is meant;
//! where the reading is unclear, rings.

use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

use super::felt::{Cell, FeltCells};
use super::ink::Ink;
use super::letters;
use super::measure::CELLS_PER_MM;
use super::signs::Signs;
use crate::geom::components::{self, Connectivity};
use crate::geom::distance::distances;
use crate::page::{Class, Sign};
use crate::units::Size;

/// Resolution of the map.
const PX_PER_MM: u32 = 4;
/// Height of the letters, px.
const LETTERS: f32 = 13.0;
/// Period of the patterns, px: lines 3 mm apart.
const PERIOD: f32 = 12.0;
/// An area gets a name if one of its cells is this far from its border, in cells of half a millimetre.
const NAME_FROM: f32 = 7.0;
/// Samples of the legend, px.
const SAMPLE: u32 = 30;
const COLUMN: u32 = 190;
const ROW: u32 = 44;

/// How a cell looks on the map.
#[derive(Debug, Clone, Copy, PartialEq)]
struct CellLook {
    felt: Option<Class>,
    mark: Symbol,
    pale: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Symbol {
    None,
    Wrong,
    Unclear,
}

/// Draws the map as a PNG file; `None` if there is no memory for it.
pub fn png(ink: &Ink, felt: &FeltCells) -> Option<Vec<u8>> {
    let cells = felt.size;
    let per_cell = PX_PER_MM / CELLS_PER_MM;
    let size = Size::new(cells.width * per_cell, cells.height * per_cell);
    let signs = &felt.signs;
    let legend = legend(signs);
    let columns = (size.width / COLUMN).clamp(1, legend.len() as u32);
    let legend_rows = (legend.len() as u32).div_ceil(columns);
    let width = size.width.max(COLUMN);
    let mut canvas = Pixmap::new(width, size.height + legend_rows * ROW + 10)?;
    canvas.fill(resvg::tiny_skia::Color::WHITE);

    let lines = ink.lines.shrunk(size);
    for y in 0..size.height {
        for x in 0..size.width {
            let cell = &felt.cells[(y / per_cell * cells.width + x / per_cell) as usize];
            let line = lines.values[(y * size.width + x) as usize];
            let shown = look(cell).map_or([255.0; 3], |look| colour(look, signs, x as f32 + 0.5, y as f32 + 0.5));
            set(&mut canvas, x, y, shown.map(|value| value * (1.0 - line) + 40.0 * line));
        }
    }
    for (name, x, y) in names(felt) {
        let at = (x as f32 * per_cell as f32, y as f32 * per_cell as f32);
        name.iter().enumerate().for_each(|(row, word)| {
            let down = (row as f32 - 0.5 * (name.len() - 1) as f32) * 1.8 * LETTERS;
            letters::write(&mut canvas, word, (at.0, at.1 + down), LETTERS);
        });
    }
    for (number, (word, look)) in legend.into_iter().enumerate() {
        let (left, top) = (number as u32 % columns * COLUMN + 8, size.height + 10 + number as u32 / columns * ROW);
        for (x, y) in (0..SAMPLE * SAMPLE).map(|k| (left + k % SAMPLE, top + k / SAMPLE)) {
            let edge = [left, left + SAMPLE - 1].contains(&x) || [top, top + SAMPLE - 1].contains(&y);
            let shown = if edge { [40.0; 3] } else { colour(look, signs, x as f32 + 0.5, y as f32 + 0.5) };
            set(&mut canvas, x, y, shown);
        }
        let middle = (SAMPLE + 10) as f32 + 0.5 * letters::width(&word, LETTERS);
        letters::write(&mut canvas, &word, (left as f32 + middle, (top + SAMPLE / 2) as f32), LETTERS);
    }
    canvas.encode_png().ok()
}

/// How a cell is drawn; a cell without texture is left blank.
fn look(cell: &Cell) -> Option<CellLook> {
    let meant = cell.meant?;
    let mark = if !cell.judged {
        Symbol::None
    } else if !cell.clear {
        Symbol::Unclear
    } else if cell.felt != Some(meant) {
        Symbol::Wrong
    } else {
        Symbol::None
    };
    Some(CellLook { felt: cell.felt, mark, pale: !cell.judged })
}

fn legend(signs: &Signs) -> Vec<(String, CellLook)> {
    let plain = |felt| CellLook { felt, mark: Symbol::None, pale: false };
    let mut legend: Vec<_> = Class::ALL
        .iter()
        .filter(|class| signs.sign(**class).is_some())
        .map(|&class| (word(Some(class)), plain(Some(class))))
        .collect();
    legend.push(("WRONG".into(), CellLook { mark: Symbol::Wrong, ..plain(None) }));
    legend.push(("UNCLEAR".into(), CellLook { mark: Symbol::Unclear, ..plain(None) }));
    let first = legend.first().and_then(|(_, look)| look.felt);
    legend.push(("NOT JUDGED".into(), CellLook { pale: true, ..plain(first) }));
    legend
}

fn word(class: Option<Class>) -> String {
    class.map_or("blank", Class::name).to_uppercase()
}

/// The colour of a pixel, 0..=255: the class's own, darker where its pattern is, which runs as the rows of its sign.
fn colour(look: CellLook, signs: &Signs, x: f32, y: f32) -> [f32; 3] {
    // Colours that people with any kind of colour sight tell apart: M. Okabe and K. Ito, Color universal design, 2008.
    let own = match look.felt {
        Some(Class::Blue) => [86.0, 180.0, 233.0],
        Some(Class::Green) => [0.0, 158.0, 115.0],
        Some(Class::Yellow) => [240.0, 228.0, 66.0],
        Some(Class::Red) => [213.0, 94.0, 0.0],
        Some(Class::Grey) => [190.0; 3],
        None => [255.0; 3],
    };
    let off = |value: f32| (value.rem_euclid(PERIOD) - 0.5 * PERIOD).abs();
    let from_dot = off(x).hypot(off(y));
    let on_pattern = match look.felt.and_then(|class| signs.sign(class)) {
        Some(Sign::Rhombus { degrees }) => {
            // y points down here
            let (sin, cos) = degrees.to_radians().sin_cos();
            off(x * sin + y * cos) < 1.3
        }
        Some(Sign::Dot) => from_dot < 2.2,
        None => false,
    };
    let own = if on_pattern { own.map(|value| 0.35 * value) } else { own.map(|value| 0.5 * value + 127.5) };
    let own = if look.pale { own.map(|value| 0.35 * value + 0.65 * 255.0) } else { own };
    let marked = match look.mark {
        Symbol::None => false,
        Symbol::Wrong => (off(x) - off(y)).abs() < 1.3 && off(x) < 4.5,
        Symbol::Unclear => (from_dot - 4.0).abs() < 1.0,
    };
    if marked { [0.0; 3] } else { own }
}

fn set(canvas: &mut Pixmap, x: u32, y: u32, colour: [f32; 3]) {
    let [red, green, blue] = colour.map(|value| value.round().clamp(0.0, 255.0) as u8);
    let at = (y * canvas.width() + x) as usize;
    if let (Some(pixel), Some(colour)) =
        (canvas.pixels_mut().get_mut(at), PremultipliedColorU8::from_rgba(red, green, blue, 255))
    {
        *pixel = colour;
    }
}

/// The words on the areas, with the cell where they have most room.
fn names(felt: &FeltCells) -> Vec<(Vec<String>, usize, usize)> {
    let (width, height) = (felt.size.width as usize, felt.size.height as usize);
    let keys: Vec<_> = felt.cells.iter().map(|cell| cell.meant.map(|meant| (meant, cell.felt))).collect();
    let border: Vec<bool> = (0..width * height)
        .map(|at| {
            let (x, y) = (at % width, at / width);
            (x + 1 < width && keys[at + 1] != keys[at]) || (y + 1 < height && keys[at + width] != keys[at])
        })
        .collect();
    let room = distances(&border, felt.size);
    let mut names = Vec::new();
    for area in components::of_labels(&keys, felt.size, Connectivity::Four).iter() {
        // of those with most room the first in reading order
        let best = area.iter().copied().reduce(|a, b| if (room[b], a) > (room[a], b) { b } else { a });
        let Some((best, (meant, felt_as))) = best.and_then(|best| Some((best, keys[best]?))) else { continue };
        if room[best] >= NAME_FROM {
            let mut name = vec![word(felt_as)];
            if felt_as != Some(meant) {
                name.extend(["NOT".into(), word(Some(meant))]);
            }
            names.push((name, best % width, best / width));
        }
    }
    names
}

#[cfg(test)]
mod tests;
