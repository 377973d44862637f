//! How many of the shapes in a row are unlike. Letters of a text are unlike one another; windows, bricks, ticks, dots
//! and dashes are alike.

use super::chain::RotatedLetter;
use super::glyph::Glyph;

/// Whether letters in a row are as unlike as those of a text.
pub(super) fn are_unlike(glyphs: &[Glyph], letters: &[RotatedLetter], width: usize) -> bool {
    let n = letters.len();
    let wanted = match n {
        0..=3 => n.min(2),
        4..=7 => 3,
        _ => 4,
    };
    let (kinds, commonest) = shapes(glyphs, letters, width);
    kinds >= wanted && (n < 4 || 2 * commonest <= n)
}

/// Number of unlike shapes, and how many letters have the commonest one.
fn shapes(glyphs: &[Glyph], letters: &[RotatedLetter], width: usize) -> (usize, usize) {
    let alike = |a: &RotatedLetter, b: &RotatedLetter| {
        let near = |a: f32, b: f32| (a - b).abs() <= (0.13 * a.max(b)).max(1.3);
        let (first, second) = (&glyphs[a.of], &glyphs[b.of]);
        let (few, many) = (first.cells.len().min(second.cells.len()), first.cells.len().max(second.cells.len()));
        near(a.width(), b.width())
            && near(a.height(), b.height())
            && many as f32 <= 1.2 * few as f32 + 3.0
            && (first.solidity() - second.solidity()).abs() <= 0.1
            && same_pixels(first, second, width)
    };
    let mut kinds: Vec<&RotatedLetter> = Vec::new();
    let mut most = 0;
    for letter in letters {
        if !kinds.iter().any(|kind| alike(kind, letter)) {
            kinds.push(letter);
        }
        most = most.max(letters.iter().filter(|other| alike(letter, other)).count());
    }
    (kinds.len(), most)
}

/// Whether nearly all pixels of each of two things have one of the other within a pixel, when their boxes are laid on
/// one another; for small ones, whether most pixels are the same.
fn same_pixels(a: &Glyph, b: &Glyph, width: usize) -> bool {
    let at = |glyph: &Glyph, cell: usize| {
        [(cell % width) as i32 - glyph.min[0] as i32, (cell / width) as i32 - glyph.min[1] as i32]
    };
    let sides = [0, 1].map(|axis| (a.max[axis] + 1 - a.min[axis]).max(b.max[axis] + 1 - b.min[axis]) as i32);
    let mask = |glyph: &Glyph| {
        let mut mask = vec![false; (sides[0] * sides[1]) as usize];
        for &cell in &glyph.cells {
            let [x, y] = at(glyph, cell);
            mask[(y * sides[0] + x) as usize] = true;
        }
        mask
    };
    let (first, second) = (mask(a), mask(b));
    let reach = i32::from(a.side().min(b.side()) >= 9.0);
    let has = |mask: &[bool], x: i32, y: i32| {
        let inside = |x: i32, y: i32| (0..sides[0]).contains(&x) && (0..sides[1]).contains(&y);
        (y - reach..=y + reach)
            .any(|y| (x - reach..=x + reach).any(|x| inside(x, y) && mask[(y * sides[0] + x) as usize]))
    };
    let near = |glyph: &Glyph, mask: &[bool]| {
        let near = glyph.cells.iter().map(|&cell| at(glyph, cell)).filter(|&[x, y]| has(mask, x, y)).count();
        near as f32 / glyph.cells.len() as f32
    };
    near(a, &second).min(near(b, &first)) >= if reach > 0 { 0.93 } else { 0.8 }
}
