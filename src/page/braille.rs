//! Braille dots for the few letters and numbers that label samples.

use crate::units::{MmPoint, MmVector};

/// From dot to dot, mm: Marburg Medium, the same for most of Europe.
const DOT: f32 = 2.5;
/// From cell to cell, mm: Marburg Medium.
const CELL: f32 = 6.0;
/// Diameter that dots are printed with, mm. A dot of Marburg Medium has 1.6 mm; on swell paper it grows, which is why
/// the fonts made for it are set at 24 points in place of 29 to come out the same: 1.6 x 24 / 29.
pub(crate) const PRINTED: f32 = 1.3;

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
pub(crate) const TRIAL: [u8; 4] =
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
pub(crate) fn letter(number: usize) -> Vec<u8> {
    vec![LETTERS[number % LETTERS.len()]]
}

/// A number, with its sign.
pub(crate) fn number(number: usize) -> Vec<u8> {
    // In braille 1 is a, and 0 is j.
    let digit = |c: char| LETTERS[(c.to_digit(10).unwrap_or(0) as usize + 9) % 10];
    std::iter::once(NUMBER).chain(number.to_string().chars().map(digit)).collect()
}

/// Width and height of cells in a row with dots of this diameter, mm.
pub(crate) fn size(cells: &[u8], diameter: f32) -> MmVector {
    MmVector::new((cells.len() as f32 - 1.0).max(0.0) * CELL + DOT + diameter, 2.0 * DOT + diameter)
}

/// The centres of all dots of cells in a row that begins in the corner (0, 0).
///
/// ```text
///  1 4
///  2 5
///  3 6
/// ```
pub(crate) fn dots(cells: &[u8], diameter: f32) -> Vec<MmPoint> {
    let first = MmVector::new(0.5 * diameter, 0.5 * diameter);
    let of_cell = |(i, &cell): (usize, &u8)| {
        let raised = (0..6_u8).filter(move |dot| cell & (1 << dot) != 0);
        raised
            .map(move |dot| MmPoint::new(i as f32 * CELL + f32::from(dot / 3) * DOT, f32::from(dot % 3) * DOT) + first)
    };
    cells.iter().enumerate().flat_map(of_cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_read_as_in_unicode() {
        let unicode = |cells: Vec<u8>| -> String {
            cells.iter().map(|&cell| char::from_u32(0x2800 + u32::from(cell)).expect("braille")).collect()
        };
        assert_eq!(unicode(letter(0)) + &unicode(letter(9)), "⠁⠚");
        assert_eq!(unicode(number(1)), "⠼⠁");
        assert_eq!(unicode(number(1023)), "⠼⠁⠚⠃⠉");
        assert_eq!(unicode(TRIAL.to_vec()), "⠿⠙⠕⠞");
    }

    #[test]
    fn dots_fill_their_size_and_lie_in_their_columns() {
        let (cells, size) = (number(8), size(&number(8), PRINTED));
        let dots = dots(&cells, PRINTED);
        assert_eq!(dots.len(), 4 + 3);
        let edge = |at: fn(&MmPoint) -> f32| dots.iter().map(at).fold(0.0, f32::max) + 0.5 * PRINTED;
        assert!((edge(|dot| dot.x) - size.x).abs() < 1e-4 && (edge(|dot| dot.y) - size.y).abs() < 1e-4);
        // dot 1 of the second cell
        assert!(dots.iter().any(|dot| (*dot - MmPoint::new(6.65, 0.65)).length() < 1e-4), "{dots:?}");
    }
}
