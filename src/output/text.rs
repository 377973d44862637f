//! Pieces of text, and numbers, that several formats share.

use crate::page::Glyph;
use crate::units::{MmPoint, MmVector};

/// Text that XML and other formats may hold: control characters are replaced.
pub(super) fn plain(text: &str) -> String {
    let allowed = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => '\u{fffd}',
        c => c,
    };
    text.chars().map(allowed).collect()
}

/// The corners of a rhombus in whole steps of 0.01 mm, opposite ones equally far from its middle: so its middle, its
/// diagonals and its direction can be read back.
pub(super) fn written_corners(glyph: &Glyph) -> [MmPoint; 4] {
    let round = |mm: f32| ((100.0 * mm).abs() + 1e-3).round().copysign(mm) / 100.0;
    let middle = MmPoint::new(round(glyph.at.x), round(glyph.at.y));
    let [along, across, ..] = glyph.corners().map(|corner| {
        let off = corner - glyph.at;
        let (x, y) = (off.x.abs(), off.y.abs());
        // of a rhombus that lies at 45 degrees both parts of a diagonal are rounded the same way
        let [x, y] = if (x - y).abs() < EQUAL { [x.max(y); 2] } else { [x, y] };
        MmVector::new(round(x).copysign(off.x), round(y).copysign(off.y))
    });
    [middle + along, middle + across, middle - along, middle - across]
}

/// Lengths that differ by less are equal but for rounding, mm.
const EQUAL: f32 = 1e-4;

/// How a page was made, as lines `name = value`.
pub(super) fn origin_lines(origin: &[(String, String)]) -> impl Iterator<Item = String> {
    origin.iter().map(|(name, value)| plain(&format!("{name} = {value}")))
}

/// Adds a finite number with at most `DECIMALS` decimals and no zeros at its end; from 2^64 of its last units on it
/// is cut. Numbers are most of a document: without the machinery of `format!` they take a third of the time.
pub(super) fn push_number<const DECIMALS: u32>(out: &mut String, value: f32) {
    let unit = 10_u64.pow(DECIMALS);
    let units = (f64::from(value.abs()) * unit as f64 + 0.5) as u64;
    if value < 0.0 && units > 0 {
        out.push('-');
    }
    push_digits(out, units / unit, 1);
    let (mut part, mut places) = (units % unit, DECIMALS as usize);
    if part > 0 {
        while part.is_multiple_of(10) {
            part /= 10;
            places -= 1;
        }
        out.push('.');
        push_digits(out, part, places);
    }
}

/// Adds a number of hundredths with exactly two decimals.
pub(super) fn push_hundredths(out: &mut String, hundredths: u32) {
    push_digits(out, u64::from(hundredths / 100), 1);
    out.push('.');
    push_digits(out, u64::from(hundredths % 100), 2);
}

/// Adds a whole number with zeros before it up to so many `places`.
fn push_digits(out: &mut String, value: u64, places: usize) {
    if value >= 10 || places > 1 {
        push_digits(out, value / 10, places.saturating_sub(1));
    }
    out.push(char::from(b'0' + (value % 10) as u8));
}

#[cfg(test)]
mod tests;
