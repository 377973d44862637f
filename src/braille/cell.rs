//! Braille cells in millimetres: how far dots, cells and lines lie apart, and where the dots of a row of cells
//! are. And the few letters and numbers that label samples and sheets, which are the same in nearly every code.

use crate::units::{MmPoint, MmVector};

/// How far the parts of braille lie apart, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellSize {
    /// Its name in profiles: the country that has it.
    pub name: &'static str,
    /// From dot to dot in a cell.
    pub dot: f32,
    /// From a cell to the same dot of the next.
    pub cell: f32,
    /// From a line to the same dot of the next.
    pub line: f32,
}

impl CellSize {
    /// Marburg Medium, the usual one in Germany and most of Europe: of blista at Marburg (<https://blista.de/node/74>;
    /// the figures: <https://br.doczz.net/doc/1264093/blindenschrift>), which DIN 32976:2007-08 and EN ISO 17351 use.
    pub const MARBURG: Self = Self { name: "de", dot: 2.5, cell: 6.0, line: 10.0 };

    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::MARBURG,
        // No standard of France for paper was found; on packages of medicine the European Union has these (EN ISO
        // 17351).
        Self { name: "fr", ..Self::MARBURG },
        // Nor one of the United Kingdom; embossing programs take the same there and in Australia: 6.0 and 10.0 mm in
        // libembosser of the American Printing House (https://github.com/aphtech/libembosser, BrlCell).
        Self { name: "uk", ..Self::MARBURG },
        // Library of Congress, NLS specification 800 of February 2008, 3.2.3 and 3.2.4, quoted by the Braille
        // Authority of North America (https://brailleauthority.org/node/63). `devices` has the same for embossers of
        // text.
        Self { name: "us", dot: 2.34, cell: 6.2, line: 10.0 },
        // Norway: 10 +- 0.1 mm from line to line (https://www.blindeforbundet.no/universell-utforming/punktskrift).
        Self { name: "no", dot: 2.5, cell: 6.1, line: 10.0 },
        // Large braille, for fingers that feel less: DIN 32976:2007-08, 3.2.2 (Grossdruck), Marburg Large of blista.
        Self { name: "large", dot: 2.7, cell: 6.6, line: 10.8 },
    ];

    /// The one of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|size| size.name == name)
    }

    /// Width and height of cells in a row with dots of this diameter.
    pub fn extent(&self, cells: usize, diameter: f32) -> MmVector {
        MmVector::new((cells as f32 - 1.0).max(0.0) * self.cell + self.dot + diameter, 2.0 * self.dot + diameter)
    }

    /// How many cells a row of this width holds.
    pub fn cells_in(&self, width: f32, diameter: f32) -> usize {
        // what rounding takes off is no dot
        let free = width - self.extent(1, diameter).x + 1e-3;
        if free < 0.0 { 0 } else { (free / self.cell) as usize + 1 }
    }

    /// The centres of all dots of cells in a row that begins in the corner (0, 0).
    ///
    /// ```text
    ///  1 4
    ///  2 5
    ///  3 6
    /// ```
    pub fn dots(&self, cells: &[u8], diameter: f32) -> Vec<MmPoint> {
        let first = MmVector::new(0.5 * diameter, 0.5 * diameter);
        let of_cell = |(i, &cell): (usize, &u8)| {
            let raised = (0..6_u8).filter(move |dot| cell & (1 << dot) != 0);
            raised.map(move |dot| {
                let [column, row] = [dot / 3, dot % 3].map(f32::from);
                MmPoint::new(i as f32 * self.cell + column * self.dot, row * self.dot) + first
            })
        };
        cells.iter().enumerate().flat_map(of_cell).collect()
    }
}

/// Diameter that dots are printed with, mm. A dot of Marburg Medium has 1.6 mm; on swell paper it grows, which is why
/// the fonts made for it are set at 24 points in place of 29 to come out the same: 1.6 x 24 / 29.
pub const PRINTED: f32 = 1.3;

/// Says that digits follow; digits are the letters a to j.
const NUMBER: u8 = dots_of(&[3, 4, 5, 6]);
const LETTERS: [u8; 10] = [
    dots_of(&[1]),
    dots_of(&[1, 2]),
    dots_of(&[1, 4]),
    dots_of(&[1, 4, 5]),
    dots_of(&[1, 5]),
    dots_of(&[1, 2, 4]),
    dots_of(&[1, 2, 4, 5]),
    dots_of(&[1, 2, 5]),
    dots_of(&[2, 4]),
    dots_of(&[2, 4, 5]),
];
/// A full cell and the letters of "dot": dots as near as they come, and a word to read.
pub const TRIAL: [u8; 4] =
    [dots_of(&[1, 2, 3, 4, 5, 6]), dots_of(&[1, 4, 5]), dots_of(&[1, 3, 5]), dots_of(&[2, 3, 4, 5])];

const fn dots_of(dots: &[u8]) -> u8 {
    let (mut cell, mut i) = (0, 0);
    while i < dots.len() {
        cell |= 1 << (dots[i] - 1);
        i += 1;
    }
    cell
}

/// The letter of this number, from 0 for a.
pub fn letter(number: usize) -> Vec<u8> {
    vec![LETTERS[number % LETTERS.len()]]
}

/// A number, with its sign.
pub fn number(number: usize) -> Vec<u8> {
    // In braille 1 is a, and 0 is j.
    let digit = |c: char| LETTERS[(c.to_digit(10).unwrap_or(0) as usize + 9) % 10];
    std::iter::once(NUMBER).chain(number.to_string().chars().map(digit)).collect()
}

#[cfg(test)]
mod tests;
