//! Whether a chain of things is a line of text.
//!
//! The numbers were found on generated charts, maps and signs (`tools --bin text`) and on 44 photographs. What tells
//! text from rows of anything else best is that hardly anything else lies around it (clutter), that its colour is even
//! and its contrast high; then that its shapes are unlike one another.

use super::chain::{RotatedLetter, distance, placed};
use super::glyph::{Glyph, LARGEST};

/// Least height of letters, px.
const LEAST_HEIGHT: f32 = 3.5;
/// Largest letters that are believed in a photograph, px.
const LARGEST_IN_PHOTOGRAPH: f32 = 48.0;
/// Widths of strokes, in heights of letters: between hairline and black.
const THINNEST: f32 = 0.04;
const THICKEST: f32 = 0.45;

/// What lines of a photograph have at least of contrast, and at most of unevenness.
const CONTRAST_IN_PHOTOGRAPH: f32 = 25.0;
const UNEVEN_IN_PHOTOGRAPH: f32 = 0.08;

/// How much is asked of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Strictness {
    /// In a drawing: what is flat around it can hardly be anything else.
    Drawing,
    /// In a photograph: at random, things form rows as well.
    Photograph,
    /// Beside text of the same style.
    Context,
}

impl Strictness {
    /// How many letters a line has at least.
    pub(super) fn least_letters(self) -> usize {
        match self {
            Self::Drawing => 2,
            Self::Photograph => 3,
            Self::Context => 1,
        }
    }

    /// Whether any of some letters together can be even and clear enough for a line: of a photograph, those that are
    /// most so.
    pub(super) fn may_have_text(self, glyphs: &[Glyph], which: &[usize]) -> bool {
        let least = self.least_letters();
        let best_mean = |of: &dyn Fn(&Glyph) -> f32| {
            let mut values: Vec<f32> = which.iter().map(|&i| of(&glyphs[i])).collect();
            values.sort_unstable_by(f32::total_cmp);
            values.iter().take(least).sum::<f32>() / least.min(values.len()).max(1) as f32
        };
        self != Self::Photograph
            || best_mean(&|glyph| glyph.unevenness) <= UNEVEN_IN_PHOTOGRAPH
                && -best_mean(&|glyph| -glyph.contrast) >= CONTRAST_IN_PHOTOGRAPH
    }
}

/// A row of things that may be a line of text.
#[derive(Debug, Clone)]
pub(super) struct TextLine {
    /// Its letters, in their order.
    pub(super) letters: Vec<RotatedLetter>,
    /// Degrees counter-clockwise from left to right.
    pub(super) angle: f32,
    /// Height of its letters without what hangs below, px.
    pub(super) height: f32,
    /// From where to where it reaches in its direction, px.
    pub(super) along: [f32; 2],
    /// From where to where it reaches across its direction, px.
    pub(super) across: [f32; 2],
    /// Mean colour of the letters.
    pub(super) colour: [f32; 3],
    /// Mean contrast.
    pub(super) contrast: f32,
    /// How much speaks for text.
    pub(super) score: f32,
    /// Width of strokes, px.
    stroke: f32,
    /// Standard deviation of the width of strokes from letter to letter, in widths.
    stroke_spread: f32,
    /// Standard deviation of the colour within a letter, in contrasts.
    unevenness: f32,
    /// Standard deviation of the colour from letter to letter, in contrasts.
    spread: f32,
    /// Share of letters that stand on the line, or reach to its top.
    aligned: f32,
    /// Share of letters that are neither bars nor dots.
    complex: f32,
}

/// The middle one of some values; 0 of none.
pub(super) fn median(mut values: Vec<f32>) -> f32 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f32::total_cmp).1
}

/// The angle of the line that letters stand on, relative to that at which they lie (Theil 1950 and Sen 1968).
fn slope(letters: &[RotatedLetter]) -> f32 {
    let height = median(letters.iter().map(RotatedLetter::height).collect());
    let mut slopes = Vec::new();
    for (i, a) in letters.iter().enumerate() {
        for b in &letters[i + 1..] {
            let along = 0.5 * ((b.along[0] + b.along[1]) - (a.along[0] + a.along[1]));
            if along > height {
                slopes.push((b.across[1] - a.across[1]) / along);
            }
        }
    }
    median(slopes).atan().to_degrees()
}

/// The line that a chain of letters is, if their heights, gaps and strokes are those of text.
pub(super) fn line(glyphs: &[Glyph], chain: &[RotatedLetter], angle: f32) -> Option<TextLine> {
    let (letters, angle) = straightened(glyphs, chain, angle);
    let n = letters.len();
    let mut heights: Vec<f32> = letters.iter().map(RotatedLetter::height).collect();
    heights.sort_by(f32::total_cmp);
    let height = heights[(3 * n / 4).min(n - 1)];
    let stroke = median(letters.iter().map(|letter| glyphs[letter.of].stroke).collect());
    let is_size = (LEAST_HEIGHT..=LARGEST as f32).contains(&height);
    if !is_size || stroke > THICKEST * height || stroke < THINNEST * height {
        return None;
    }
    let gaps = letters.windows(2).map(|pair| pair[1].along[0] - pair[0].along[1]).collect();
    // words of letters that touch stand further apart
    let is_spaced = median(letters.iter().map(RotatedLetter::width).collect()) <= 1.3 * height;
    if median(gaps) > if is_spaced { 0.45 * height + 1.0 } else { 0.9 * height } {
        return None;
    }
    let top = median(letters.iter().map(|letter| letter.across[0]).collect());
    let low = letters.iter().map(|letter| letter.across[0]).fold(f32::MAX, f32::min);
    let high = letters.iter().map(|letter| letter.across[1]).fold(f32::MIN, f32::max);
    if high - low > 2.2 * height {
        return None;
    }
    let share =
        |of: &dyn Fn(&RotatedLetter) -> bool| letters.iter().filter(|letter| of(letter)).count() as f32 / n as f32;
    let at_top = share(&|letter| (letter.across[0] - top).abs() <= tolerance(height));
    let aligned = on_line(&letters, height).max(0.9 * at_top);
    let complex = share(&|letter| !glyphs[letter.of].is_solid());
    let mean = |of: &dyn Fn(&Glyph) -> f32| letters.iter().map(|letter| of(&glyphs[letter.of])).sum::<f32>() / n as f32;
    let contrast = mean(&|glyph| glyph.contrast);
    let colour = [0, 1, 2].map(|i| mean(&|glyph| glyph.colour[i]));
    let variance = (0..3).map(|i| mean(&|glyph| (glyph.colour[i] - colour[i]).powi(2))).sum::<f32>();
    // letters of a word that touch one another count
    let count: usize = letters.iter().map(|letter| ((letter.width() / (0.75 * height)) as usize).max(1)).sum();
    Some(TextLine {
        along: [letters[0].along[0], letters.iter().map(|letter| letter.along[1]).fold(f32::MIN, f32::max)],
        across: [low, high],
        score: count as f32 * aligned * (0.5 + complex),
        stroke_spread: mean(&|glyph| (glyph.stroke / stroke - 1.0).powi(2)).sqrt(),
        unevenness: mean(&|glyph| glyph.unevenness),
        spread: variance.sqrt() / contrast,
        letters,
        angle,
        height,
        colour,
        contrast,
        stroke,
        aligned,
        complex,
    })
}

/// How far letters may stand off their line, px.
fn tolerance(height: f32) -> f32 {
    0.1 * height + 0.8
}

/// Share of letters that stand on the line, as most do.
fn on_line(letters: &[RotatedLetter], height: f32) -> f32 {
    let bottom = median(letters.iter().map(|letter| letter.across[1]).collect());
    let stands = |letter: &&RotatedLetter| (letter.across[1] - bottom).abs() <= tolerance(height);
    letters.iter().filter(stands).count() as f32 / letters.len() as f32
}

/// Letters of a chain as they lie at the angle of the line that they stand on, and that angle; as they are, where that
/// does not set more of them on the line: short words seem to be aslant where letters hang below it.
fn straightened(glyphs: &[Glyph], chain: &[RotatedLetter], angle: f32) -> (Vec<RotatedLetter>, f32) {
    let turn = if chain.len() < 3 { 0.0 } else { slope(chain) };
    if turn.abs() <= 0.7 {
        return (chain.to_vec(), angle);
    }
    let which: Vec<usize> = chain.iter().map(|letter| letter.of).collect();
    let turned = placed(glyphs, &which, angle - turn);
    let height = median(chain.iter().map(RotatedLetter::height).collect());
    let most = if chain.len() < 6 { 0.1 } else { -0.01 };
    if on_line(&turned, height) > on_line(chain, height) + most {
        (turned, angle - turn)
    } else {
        (chain.to_vec(), angle)
    }
}

impl TextLine {
    /// Whether it is text, if its letters are unlike one another and what lies around it has this `clutter` (thin
    /// things, in shares of its own pixels).
    pub(super) fn is_text(&self, strict: Strictness, clutter: f32) -> bool {
        let n = self.letters.len();
        if strict == Strictness::Photograph && self.height > LARGEST_IN_PHOTOGRAPH {
            return false;
        }
        let even = self.unevenness <= 0.1 && self.spread <= 0.25 && self.stroke_spread <= 0.45;
        match strict {
            Strictness::Drawing if n == 2 => {
                self.is_pair() && even && clutter <= 0.15 && self.height <= 45.0 && self.complex >= 0.5
            }
            Strictness::Drawing => n >= 3 && even && clutter <= 0.5 && self.aligned >= 0.6 && self.complex >= 0.4,
            Strictness::Photograph if n <= 3 => {
                n == 3
                    && self.contrast >= 45.0
                    && self.unevenness <= 0.06
                    && self.spread <= 0.06
                    && self.stroke_spread <= 0.3
                    && self.aligned >= 0.9
                    && self.complex >= 0.6
                    && clutter <= 0.1
            }
            Strictness::Photograph => {
                self.contrast >= CONTRAST_IN_PHOTOGRAPH
                    && self.unevenness <= UNEVEN_IN_PHOTOGRAPH
                    && self.spread <= 0.14
                    && self.stroke_spread <= 0.25
                    && self.aligned >= 0.7
                    && self.complex >= 0.5
                    && clutter <= self.most_clutter_in_photograph()
            }
            Strictness::Context => {
                n >= 2 && even && clutter <= 1.0 && self.complex >= 0.5 && (n > 2 || self.is_pair())
                    || n == 1
                        && self.letters[0].width() <= 0.85 * self.height
                        && self.complex > 0.0
                        && clutter <= 0.1
                        && self.unevenness <= 0.08
            }
        }
    }

    /// Few letters, small ones and large ones, and those that lie aslant have to stand clearer of what is around them.
    fn most_clutter_in_photograph(&self) -> f32 {
        let n = self.letters.len();
        let off = self.angle.abs().min((self.angle.abs() - 90.0).abs());
        let is_usual = off <= 20.0 && (6.0..=36.0).contains(&self.height);
        match (n, is_usual) {
            (..=4, false) => 0.05,
            (..=4, true) | (5, false) => 0.15,
            (5, true) | (_, false) => 0.3,
            (_, true) => 0.4,
        }
    }

    /// Whether so large a share of letters stands on the line.
    pub(super) fn is_aligned(&self, share: f32) -> bool {
        self.aligned >= share
    }

    /// Whether two letters stand as those of a number do.
    fn is_pair(&self) -> bool {
        let [a, b] = self.letters[..] else { return false };
        let level = (a.across[1] - b.across[1]).abs() <= tolerance(self.height)
            && (a.height() - b.height()).abs() <= 0.2 * self.height + 1.0;
        level && b.along[0] - a.along[1] <= 0.5 * self.height
    }

    /// Whether another line has its style: height and stroke of letters, colour and contrast.
    pub(super) fn is_styled_as(&self, other: &Self) -> bool {
        let near = |a: f32, b: f32, most: f32| a.max(b) <= most * a.min(b) + 0.7;
        near(self.height, other.height, 1.35)
            && near(self.stroke, other.stroke, 1.3)
            && distance(self.colour, other.colour) <= 0.15 * other.contrast
            && near(self.contrast, other.contrast, 1.3)
    }
}

impl TextLine {
    /// The same with a margin around it, px.
    pub(super) fn grown(&self, margin: f32) -> Self {
        Self {
            along: [self.along[0] - margin, self.along[1] + margin],
            across: [self.across[0] - margin, self.across[1] + margin],
            ..self.clone()
        }
    }

    /// Whether another one stands on the same line, or above or below it with an end or the middle at the same place,
    /// as the numbers at an axis do.
    pub(super) fn is_in_row_with(&self, other: &Self) -> bool {
        let height = self.height;
        if (other.angle - self.angle).abs() > 2.0 || (other.height - height).abs() > 0.15 * height + 1.0 {
            return false;
        }
        let gap = |a: [f32; 2], b: [f32; 2]| (a[0] - b[1]).max(b[0] - a[1]);
        let near = |a: f32, b: f32| (a - b).abs() <= 0.25 * height + 1.0;
        let is_level = (other.across[1] - self.across[1]).abs() <= 0.2 * height + 0.8
            && gap(other.along, self.along) <= 15.0 * height;
        let is_stacked = (near(other.along[0], self.along[0])
            || near(other.along[1], self.along[1])
            || near(other.along[0] + other.along[1], self.along[0] + self.along[1]))
            && gap(other.across, self.across) <= 8.0 * height;
        is_level || is_stacked
    }
}
