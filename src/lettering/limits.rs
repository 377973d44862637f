//! What is asked of a row of shapes before it is taken for a line of text.
//!
//! The numbers were chosen together, on generated charts, maps, signs and worksheets (`tools --bin text` prints how
//! much text is found with them, and how much of the drawing is lost) and on 44 photographs. What tells text from rows
//! of anything else best is that hardly anything else lies around it (clutter), that its colour is even and its
//! contrast high; then that its shapes are unlike one another. In a photograph things form rows at random, so more is
//! asked there, and most of few letters.

use super::glyph::LetterShape;

/// A length that grows with the height of letters: so many heights, and so many pixels more, as at small sizes a
/// position is uncertain by about one.
#[derive(Debug, Clone, Copy)]
pub(super) struct LetterLength {
    heights: f32,
    px: f32,
}

impl LetterLength {
    pub(super) const fn new(heights: f32, px: f32) -> Self {
        Self { heights, px }
    }

    /// In px, of letters of this height.
    pub(super) fn of(self, height: f32) -> f32 {
        self.heights * height + self.px
    }
}

/// How much is asked of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Strictness {
    /// In a drawing: what is flat around it can hardly be anything else.
    Drawing,
    /// In a photograph: at random, things form rows as well.
    Photograph,
    /// Beside text of the same style, in a photograph.
    Context,
    /// Beside text of the same style, in a drawing.
    Label,
    /// One of several single letters of a drawing, in the style of text.
    Single,
    /// One of several in a drawing that look like digits or like capitals.
    Named,
}

/// What a row has at least and at most.
#[derive(Debug, Clone, Copy)]
struct RowLimits {
    /// Greatest standard deviation of the colour within a letter, as a share of the contrast: print is of one ink.
    unevenness: f32,
    /// Greatest standard deviation of the colour from letter to letter, as a share of the contrast.
    spread: f32,
    /// Greatest standard deviation of the width of strokes from letter to letter, as a share of that width.
    stroke_spread: f32,
    /// Most thin things around it, as a share of its own pixels.
    clutter: f32,
    /// Least mean contrast of its letters with their ground, in units of strength.
    contrast: f32,
    /// Least share of letters that stand on the line, or reach to its top.
    aligned: f32,
    /// Least share of letters that are neither bars nor dots.
    complex: f32,
    /// Greatest height of letters, px.
    height: f32,
}

/// Three letters or more of a drawing. Gridlines, leader lines and outlines run close by text in charts, so half as
/// many pixels as its own may lie around it.
const DRAWING: RowLimits = RowLimits {
    unevenness: 0.1,
    spread: 0.25,
    stroke_spread: 0.45,
    clutter: 0.5,
    contrast: 0.0,
    aligned: 0.6,
    complex: 0.4,
    height: f32::INFINITY,
};

/// Two letters of a drawing, such as the numbers at an axis: clear of other things, as two marks side by side are
/// common in drawings.
const PAIR_IN_DRAWING: RowLimits = RowLimits { clutter: 0.15, aligned: 0.0, complex: 0.5, height: 45.0, ..DRAWING };

/// Four letters or more of a photograph, where nothing else is around them: see [`CLUTTER_IN_PHOTOGRAPH`]. What is no
/// text is erased with what it is a part of: of 300 photographs of BSDS500 (train and val) a spread of .14, strokes
/// that differ by .25 and letters aligned to .7 took spots of leopards, windows and four elephants in a row for text
/// in 15, these numbers in 1. Print on a ship and on a wall has .02 to .06, .04 to .1 and 1; characters brushed on
/// lanterns (.13, .14 and .9) are lost.
const PHOTOGRAPH: RowLimits = RowLimits {
    unevenness: 0.08,
    spread: 0.08,
    stroke_spread: 0.17,
    clutter: 0.0,
    contrast: 25.0,
    aligned: 0.85,
    complex: 0.5,
    height: 48.0,
};

/// Three letters of a photograph: three windows, posts or bricks in a row are common, so more is asked of them than of
/// longer rows.
const THREE_IN_PHOTOGRAPH: RowLimits = RowLimits {
    unevenness: 0.06,
    spread: 0.06,
    stroke_spread: 0.14,
    clutter: 0.1,
    contrast: 45.0,
    aligned: 0.9,
    complex: 0.6,
    ..PHOTOGRAPH
};

/// Most clutter of a line of a photograph by how many letters it has (up to four, five, more): of letters of a usual
/// size that lie about level or upright, and of others.
const CLUTTER_IN_PHOTOGRAPH: [[f32; 2]; 3] = [[0.15, 0.05], [0.3, 0.15], [0.4, 0.3]];
/// Letters lie about level or upright if their line is off by no more, degrees.
const USUAL_ANGLE: f32 = 20.0;
/// Usual heights of letters, px.
const USUAL_HEIGHTS: std::ops::RangeInclusive<f32> = 6.0..=36.0;

/// Two letters or more beside text of the same style, which says much already.
const CONTEXT: RowLimits = RowLimits { clutter: 1.0, aligned: 0.0, complex: 0.5, ..DRAWING };

/// A single letter or digit in a row with text of the same style. It is no bar and no dot.
const ONE_IN_CONTEXT: RowLimits = RowLimits { unevenness: 0.08, clutter: 0.1, complex: 1.0, ..CONTEXT };
/// One of several single letters in that style. Ticks lead to those at an axis.
const ONE_OF_SEVERAL: RowLimits = RowLimits { clutter: 0.4, ..ONE_IN_CONTEXT };
/// In a drawing letters of up to this height, px, have strokes of one or two pixels, no two of which are covered alike:
/// they may be less even by this factor. Of 568 texts with letters of 8 to 16 px in 22 charts, plans and maps .95 are
/// found with it, .93 with 1.4 and .83 with 1.
const SMALL: f32 = 18.0;
const LESS_EVEN: f32 = 1.8;
/// Rows aslant of a drawing with less contrast than this, in units of strength, are of one colour but for this: in
/// planes of colour the blurred border of a line in a JPEG comes apart, in pieces that differ by .12 to .24. In 60
/// drawings as JPEG 94 rows of such pieces are no text any more, and 22 others are. Level ones may be white on yellow.
const FAINT: f32 = 30.0;
const SPREAD_OF_FAINT: f32 = 0.1;
/// Greatest width of a single letter, in its height: wider ones are other things.
const WIDEST_LETTER: f32 = 0.85;
/// One that looks like a capital may be an M or a W.
pub(super) const WIDEST_CAPITAL: f32 = 1.3;

/// A row of letters, measured: what [`RowLimits`] is about, in the same units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    /// How many letters it has.
    pub(super) letters: usize,
    /// Whether they are two that stand as those of a number do.
    pub(super) is_pair: bool,
    /// Degrees counter-clockwise from left to right.
    pub(super) angle: f32,
    /// Width of the first of its letters, px.
    pub(super) width: f32,
    pub(super) unevenness: f32,
    pub(super) spread: f32,
    pub(super) stroke_spread: f32,
    pub(super) clutter: f32,
    pub(super) contrast: f32,
    pub(super) aligned: f32,
    pub(super) complex: f32,
    pub(super) height: f32,
}

impl RowLimits {
    /// What is asked of such a row; none if it is too short for a line of text whatever it looks like.
    fn of(strict: Strictness, row: &Row) -> Option<Self> {
        let is_long = row.letters > 2 || row.is_pair;
        let is_narrow = row.width <= WIDEST_LETTER * row.height;
        let may_be_capital = row.width <= WIDEST_CAPITAL * row.height;
        match (strict, row.letters) {
            (Strictness::Drawing, 2) if row.is_pair => Some(PAIR_IN_DRAWING),
            (Strictness::Drawing, 3..) => Some(DRAWING),
            (Strictness::Photograph, 3) => Some(THREE_IN_PHOTOGRAPH),
            (Strictness::Photograph, 4..) => Some(Self { clutter: clutter_in_photograph(row), ..PHOTOGRAPH }),
            (Strictness::Context | Strictness::Label, 1) if is_narrow => Some(ONE_IN_CONTEXT),
            (Strictness::Context | Strictness::Label, 2..) if is_long => Some(CONTEXT),
            (Strictness::Single, 1) if is_narrow => Some(ONE_OF_SEVERAL),
            (Strictness::Named, 1) if may_be_capital => Some(ONE_OF_SEVERAL),
            _ => None,
        }
    }

    /// The same for rows of a drawing, which may be small or faint.
    fn of_drawing(self, row: &Row) -> Self {
        match row.contrast < FAINT && row.angle.abs() % 90.0 > USUAL_ANGLE {
            true => Self { spread: self.spread.min(SPREAD_OF_FAINT), ..self },
            false if row.height <= SMALL => Self { unevenness: LESS_EVEN * self.unevenness, ..self },
            false => self,
        }
    }

    /// Whether a row is within them.
    fn hold(&self, row: &Row) -> bool {
        row.unevenness <= self.unevenness
            && row.spread <= self.spread
            && row.stroke_spread <= self.stroke_spread
            && row.clutter <= self.clutter
            && row.contrast >= self.contrast
            && row.aligned >= self.aligned
            && row.complex >= self.complex
            && row.height <= self.height
    }
}

/// Few letters, small ones and large ones, and those that lie aslant have to stand clearer of what is around them.
fn clutter_in_photograph(row: &Row) -> f32 {
    let off = row.angle.abs().min((row.angle.abs() - 90.0).abs());
    let is_usual = off <= USUAL_ANGLE && USUAL_HEIGHTS.contains(&row.height);
    CLUTTER_IN_PHOTOGRAPH[row.letters.clamp(4, 6) - 4][usize::from(!is_usual)]
}

impl Strictness {
    /// Whether a row is within what is asked of it, if its letters are unlike one another.
    pub(super) fn allows(self, row: &Row) -> bool {
        let limits = RowLimits::of(self, row).map(|limits| match self {
            Self::Photograph | Self::Context => limits,
            Self::Drawing | Self::Label | Self::Single | Self::Named => limits.of_drawing(row),
        });
        limits.is_some_and(|limits| limits.hold(row))
    }

    /// How many letters a line has at least.
    pub(super) fn least_letters(self) -> usize {
        match self {
            Self::Drawing => 2,
            Self::Photograph => 3,
            Self::Context | Self::Label | Self::Single | Self::Named => 1,
        }
    }

    /// Whether any of some letters together can be even and clear enough for a line: of a photograph, those that are
    /// most so.
    pub(super) fn may_have_text(self, glyphs: &[LetterShape], which: &[usize]) -> bool {
        let least = self.least_letters();
        let best_mean = |of: &dyn Fn(&LetterShape) -> f32| {
            let mut values: Vec<f32> = which.iter().map(|&i| of(&glyphs[i])).collect();
            values.sort_unstable_by(f32::total_cmp);
            values.iter().take(least).sum::<f32>() / least.min(values.len()).max(1) as f32
        };
        self != Self::Photograph
            || best_mean(&|glyph| glyph.unevenness) <= PHOTOGRAPH.unevenness
                && -best_mean(&|glyph| -glyph.contrast) >= PHOTOGRAPH.contrast
    }
}

#[cfg(test)]
mod tests;
