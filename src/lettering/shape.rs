//! How many of the shapes in a row are unlike. Letters of a text are unlike one another; windows, bricks, ticks, dots
//! and dashes are alike.

use super::chain::RotatedLetter;
use super::glyph::LetterShape;

/// Two shapes may be alike if their sides differ by at most this share, or by so many px: what drawing one letter twice
/// between pixels does.
const SIDES: f32 = 0.13;
const LEAST_SIDES: f32 = 1.3;
/// The number of their pixels may differ by this factor and by so many more.
const PIXELS: f32 = 1.2;
const FEW_PIXELS: f32 = 3.0;
/// The shares of their hulls that they fill may differ by this.
const SOLIDITY: f32 = 0.1;
/// They are alike if this share of the pixels of each lies within a pixel of the other.
const SHARED: f32 = 0.93;
/// Of shapes with sides below this, px, a pixel aside is another letter, and this share of the pixels is the same.
pub(super) const SMALL: f32 = 9.0;
const SHARED_OF_SMALL: f32 = 0.8;
/// How many unlike shapes rows have at least, of up to so many letters: most words of four have three.
const UNLIKE: [(usize, usize); 3] = [(3, 2), (7, 3), (usize::MAX, 4)];
/// From this many letters on, at most half are of one shape.
const SEVERAL: usize = 4;

/// Letters compared: what they are of, the columns of the picture, and below which sides a pixel aside is another one.
#[derive(Clone, Copy)]
pub(super) struct Comparing<'a> {
    pub(super) glyphs: &'a [LetterShape],
    pub(super) width: usize,
    pub(super) small: f32,
}

/// Whether letters in a row are as unlike as those of a text.
pub(super) fn are_unlike(of: Comparing<'_>, letters: &[RotatedLetter]) -> bool {
    let n = letters.len();
    let wanted = UNLIKE.iter().find(|(most, _)| n <= *most).map_or(0, |(_, unlike)| n.min(*unlike));
    let (kinds, commonest) = shapes(of, letters);
    kinds >= wanted && (n < SEVERAL || 2 * commonest <= n)
}

/// Which of some letters have a shape that at most so many of them have.
pub(super) fn rare(of: Comparing<'_>, letters: &[RotatedLetter], most: usize) -> Vec<bool> {
    let is_rare = |letter: &RotatedLetter| letters.iter().filter(|other| alike(of, letter, other)).nth(most).is_none();
    letters.iter().map(is_rare).collect()
}

/// Number of unlike shapes, and how many letters have the commonest one.
fn shapes(of: Comparing<'_>, letters: &[RotatedLetter]) -> (usize, usize) {
    let mut kinds: Vec<&RotatedLetter> = Vec::new();
    let mut most = 0;
    for letter in letters {
        if !kinds.iter().any(|kind| alike(of, kind, letter)) {
            kinds.push(letter);
        }
        most = most.max(letters.iter().filter(|other| alike(of, letter, other)).count());
    }
    (kinds.len(), most)
}

/// Whether two letters may be one, drawn twice.
fn alike(of: Comparing<'_>, a: &RotatedLetter, b: &RotatedLetter) -> bool {
    let near = |a: f32, b: f32| (a - b).abs() <= (SIDES * a.max(b)).max(LEAST_SIDES);
    let (first, second) = (&of.glyphs[a.of], &of.glyphs[b.of]);
    let (few, many) = (first.cells.len().min(second.cells.len()), first.cells.len().max(second.cells.len()));
    near(a.width(), b.width())
        && near(a.height(), b.height())
        && many as f32 <= PIXELS * few as f32 + FEW_PIXELS
        && (first.solidity() - second.solidity()).abs() <= SOLIDITY
        && same_pixels(of, first, second)
}

/// Whether nearly all pixels of each of two things have one of the other within a pixel, when their boxes are laid on
/// one another; for small ones, whether most pixels are the same.
fn same_pixels(of: Comparing<'_>, a: &LetterShape, b: &LetterShape) -> bool {
    let width = of.width;
    let at = |glyph: &LetterShape, cell: usize| {
        [(cell % width) as i32 - glyph.min[0] as i32, (cell / width) as i32 - glyph.min[1] as i32]
    };
    let sides = [0, 1].map(|axis| (a.max[axis] + 1 - a.min[axis]).max(b.max[axis] + 1 - b.min[axis]) as i32);
    let mask = |glyph: &LetterShape| {
        let mut mask = vec![false; (sides[0] * sides[1]) as usize];
        for &cell in &glyph.cells {
            let [x, y] = at(glyph, cell);
            mask[(y * sides[0] + x) as usize] = true;
        }
        mask
    };
    let (first, second) = (mask(a), mask(b));
    let reach = i32::from(a.side().min(b.side()) >= of.small);
    let has = |mask: &[bool], x: i32, y: i32| {
        let inside = |x: i32, y: i32| (0..sides[0]).contains(&x) && (0..sides[1]).contains(&y);
        (y - reach..=y + reach)
            .any(|y| (x - reach..=x + reach).any(|x| inside(x, y) && mask[(y * sides[0] + x) as usize]))
    };
    let near = |glyph: &LetterShape, mask: &[bool]| {
        let near = glyph.cells.iter().map(|&cell| at(glyph, cell)).filter(|&[x, y]| has(mask, x, y)).count();
        near as f32 / glyph.cells.len() as f32
    };
    near(a, &second).min(near(b, &first)) >= if reach > 0 { SHARED } else { SHARED_OF_SMALL }
}
