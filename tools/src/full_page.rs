//! Pages as full as pages get, of any size: what the time of a check is measured on.

use tactograph::internals::page::{Class, Figure, Glyph, Line, Page, Parts, Run, Shape, Sign, Texture};
use tactograph::internals::units::{MmPoint, MmRect, MmVector, Size};

/// Sheets, each twice as large as the one before and as full: name, contours, glyphs, width and height in mm.
pub const SIZES: [(&str, usize, usize, [f32; 2]); 4] = [
    ("A5", 150, 3000, [148.0, 210.0]),
    ("A4", 300, 6000, [210.0, 297.0]),
    ("A3", 600, 12_000, [297.0, 420.0]),
    ("A2", 1200, 24_000, [420.0, 594.0]),
];

/// Wavy contours in rows, with glyphs between them.
///
/// # Errors
/// If marks reach beyond the sheet, which they do on none of [`SIZES`].
pub fn page(contours: usize, glyphs: usize, sheet: [f32; 2]) -> Result<Page, tactograph::Error> {
    let [width, height] = sheet.map(|side| side - 20.0);
    let columns = (contours as f32 * 0.5 * width / height).sqrt().ceil().max(1.0);
    let rows = (contours as f32 / columns).ceil();
    let (across, down) = (width / columns, height / rows);
    let line = |number: usize| {
        let (column, row) = (number % columns as usize, number / columns as usize);
        let at = |k: usize| {
            let share = k as f32 / 60.0;
            let x = 10.0 + column as f32 * across + 3.0 + share * (across - 6.0);
            MmPoint::new(x, 10.0 + (row as f32 + 0.5) * down + 0.2 * down * (12.0 * share + number as f32).sin())
        };
        Line { strength: 20.0, runs: vec![Run::stroke(1.2, (0..=60).map(at).collect())] }
    };
    // as many glyphs as are asked for, in rows
    let step = (width * height / glyphs as f32).sqrt();
    let in_row = (width / step) as usize;
    let glyph = |number: usize| {
        let at = MmPoint::new((number % in_row) as f32, (number / in_row) as f32) * step + MmVector::new(11.5, 11.5);
        Glyph { at, shape: Shape::Rhombus { length: 2.2, thickness: 1.2, degrees: 45.0 } }
    };
    let texture = Texture {
        class: Class::Green,
        sign: Sign::Rhombus { degrees: 45.0 },
        colour: [0, 128, 0],
        area: width * height,
        glyphs: (0..glyphs).map(glyph).collect(),
    };
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(10.0 + width, 10.0 + height));
    let lines = (0..contours).map(line).collect();
    Page::new(Parts::of(sheet, Figure { place, source: Size::new(100, 100), textures: vec![texture], lines }))
}
