//! Whether a chain of things is a line of text: its measures, which [`super::limits`] judges, and its style; and which
//! pixels it covers.

use super::chain::{RotatedLetter, axes, placed};
use super::glyph::{LARGEST, LetterShape, PixelPoint};
use super::limits::{LetterLength, Row, Strictness};
use crate::geom::order::middle;
use crate::raster::contrast::distance;
use crate::units::Size;

/// Least height of letters, px.
const LEAST_HEIGHT: f32 = 3.5;
/// Widths of strokes, in heights of letters: between hairline and black.
const THINNEST: f32 = 0.04;
const THICKEST: f32 = 0.45;
/// The height of a line is the upper quartile of those of its letters, three of four: most lines have some letters that
/// reach higher than the others, and a few that also hang below.
const HEIGHT_OF_LINE: [usize; 2] = [3, 4];
/// What is wider than this, in heights, is no letter but a word of letters that touch one another.
const WIDEST: f32 = 1.3;
/// Widest gap between letters on the whole (the median), and between words of letters that touch.
const GAP: LetterLength = LetterLength::new(0.45, 1.0);
const GAP_OF_WORDS: LetterLength = LetterLength::new(0.9, 0.0);
/// Letters reach over at most so much across their line, in heights: from the top of an accent to the foot of a `g`.
const ACROSS: f32 = 2.2;
/// Breadth in heights by which the letters of a word that touch one another are counted.
const BREADTH: f32 = 0.75;
/// Letters that reach to one line above count as so much of those that stand on one line.
const HANGING: f32 = 0.9;
/// What letters count that are bars or dots when the clearest of several lines is taken; others count 1 more.
const SIMPLE: f32 = 0.5;
/// How far letters stand off their line.
const OFF_LINE: LetterLength = LetterLength::new(0.1, 0.8);
/// A line that turns by less than this lies as it was found, degrees.
const LEAST_TURN: f32 = 0.7;
/// A line of fewer letters than this is turned only if that sets this share more of them on the line: one that hangs
/// below turns a short word.
const FEW: usize = 6;
const BETTER_OF_FEW: f32 = 0.1;
/// A longer one is turned unless that sets fewer of them on it; the hundredth is for rounding.
const BETTER: f32 = -0.01;
/// Digits of a number differ in height by at most this, and have at most this gap, in heights.
const HEIGHTS_OF_PAIR: LetterLength = LetterLength::new(0.2, 1.0);
const GAP_OF_PAIR: f32 = 0.5;
/// A decimal point or a comma between two digits is at most so high and so wide, and hangs below them by less, in
/// heights. Chosen by us: in usual fonts a point is about .15 high, a comma .3.
const POINT: f32 = 0.4;
/// It is looked for in gaps that are wider than this, in heights, of numbers of at most so many digits. Chosen by us:
/// without a point digits are about .15 apart, with one .5.
const GAP_OF_POINT: f32 = 0.4;
const MOST_DIGITS: usize = 6;
/// A minus is so long, in heights, and so thick at most; its middle lies in this part of the height of the number, from
/// the top. It is so near to the number. Chosen by us: a hyphen is about a third of the height of digits long, a minus
/// two thirds.
const MINUS: [f32; 2] = [0.25, 1.0];
const MINUS_THICK: LetterLength = LetterLength::new(0.15, 1.0);
const MINUS_AT: std::ops::RangeInclusive<f32> = 0.3..=0.75;
const MINUS_GAP: LetterLength = LetterLength::new(0.35, 0.5);
/// Texts have one style if their heights, their strokes and their contrasts differ at most by these factors, and by so
/// many pixels or units more, and their colours by this share of their contrast.
const STYLE_HEIGHT: f32 = 1.35;
const STYLE_STROKE: f32 = 1.3;
const STYLE_CONTRAST: f32 = 1.3;
const STYLE_UNSURE: f32 = 0.7;
const STYLE_COLOUR: f32 = 0.15;
/// Single letters are as high as those of other texts but for this.
const SAME_HEIGHT: LetterLength = LetterLength::new(0.08, 1.0);
/// Texts belong to one row or column if their angles differ by at most this, degrees, and their heights by this.
const ROW_ANGLE: f32 = 2.0;
const ROW_HEIGHT: LetterLength = LetterLength::new(0.15, 1.0);
/// In a row they stand on one line but for this, and at most so many heights apart, as numbers below an axis do.
const ROW_LEVEL: LetterLength = LetterLength::new(0.2, 0.8);
const ROW_GAP: f32 = 15.0;
/// In a column their left ends, right ends or middles are at one place but for this, and they are at most so many
/// heights apart, as numbers beside an axis are.
const COLUMN_END: LetterLength = LetterLength::new(0.25, 1.0);
const COLUMN_GAP: f32 = 8.0;

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
    /// Whether a decimal point or a comma stands between its letters.
    pub(super) has_point: bool,
    /// Widest gap between its letters, px; on both sides of a point it has two.
    widest_gap: f32,
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

/// The angle of the line that letters stand on, relative to that at which they lie (Theil 1950 and Sen 1968).
fn slope(letters: &[RotatedLetter]) -> f32 {
    let height = middle(letters.iter().map(RotatedLetter::height).collect());
    let mut slopes = Vec::new();
    for (i, a) in letters.iter().enumerate() {
        for b in &letters[i + 1..] {
            let along = 0.5 * ((b.along[0] + b.along[1]) - (a.along[0] + a.along[1]));
            if along > height {
                slopes.push((b.across[1] - a.across[1]) / along);
            }
        }
    }
    middle(slopes).atan().to_degrees()
}

/// The boxes of things that may be a decimal point or a minus, by the row at which they end.
#[derive(Debug)]
pub(super) struct SmallShapes(Vec<[PixelPoint; 2]>);

impl SmallShapes {
    pub(super) fn of(glyphs: &[LetterShape]) -> Self {
        let is_low = |[[_, top], [_, bottom]]: &[PixelPoint; 2]| bottom - top <= POINT * LARGEST as f32;
        Self::sorted(glyphs.iter().map(LetterShape::bounds).filter(is_low).collect())
    }

    fn sorted(mut boxes: Vec<[PixelPoint; 2]>) -> Self {
        boxes.sort_by(|[_, a], [_, b]| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
        Self(boxes)
    }

    /// Those that end from one row on, before another.
    fn ending(&self, from: f32, before: f32) -> impl Iterator<Item = [PixelPoint; 2]> {
        let first = self.0.partition_point(|[_, end]| end[1] < from);
        self.0[first..].iter().copied().take_while(move |[_, end]| end[1] < before)
    }
}

/// The gap between two digits of a level number with a decimal point or a comma between them: the wider one of those
/// beside it. None where there is no point.
fn gap_at_point(small: &SmallShapes, a: &RotatedLetter, b: &RotatedLetter, height: f32) -> Option<f32> {
    let (left, right, foot) = (a.along[1], b.along[0], a.across[1].min(b.across[1]));
    let is_point = |[[from, top], [to, bottom]]: &[PixelPoint; 2]| {
        (to - from).max(bottom - top) <= POINT * height && *top < foot && *from >= left && *to <= right
    };
    let points = small.ending(foot - OFF_LINE.of(height), foot + POINT * height).filter(is_point);
    let [[from, _], [to, _]] = points.min_by(|[a, _], [b, _]| a[0].total_cmp(&b[0]))?;
    Some((from - left).max(right - to))
}

/// The gaps between letters, and whether one of these shapes is a point in one of them, where letters are few.
fn gaps(small: Option<&SmallShapes>, letters: &[RotatedLetter], height: f32) -> (Vec<f32>, bool) {
    let small = small.filter(|_| letters.len() <= MOST_DIGITS);
    let gap = |pair: &[RotatedLetter]| {
        let gap = pair[1].along[0] - pair[0].along[1];
        let small = small.filter(|_| gap > GAP_OF_POINT * height);
        let at_point = small.and_then(|small| gap_at_point(small, &pair[0], &pair[1], height));
        (at_point.unwrap_or(gap), at_point.is_some())
    };
    let all: Vec<(f32, bool)> = letters.windows(2).map(gap).collect();
    (all.iter().map(|(gap, _)| *gap).collect(), all.iter().any(|(_, has_point)| *has_point))
}

/// The line that a chain of letters is, if their heights, gaps and strokes are those of text. Points between digits are
/// looked for among `small` shapes.
pub(super) fn line(
    glyphs: &[LetterShape],
    chain: &[RotatedLetter],
    angle: f32,
    small: Option<&SmallShapes>,
) -> Option<TextLine> {
    let (letters, angle) = straightened(glyphs, chain, angle);
    let n = letters.len();
    let mut heights: Vec<f32> = letters.iter().map(RotatedLetter::height).collect();
    heights.sort_by(f32::total_cmp);
    let height = heights[(HEIGHT_OF_LINE[0] * n / HEIGHT_OF_LINE[1]).min(n - 1)];
    let stroke = middle(letters.iter().map(|letter| glyphs[letter.of].stroke).collect());
    let is_size = (LEAST_HEIGHT..=LARGEST as f32).contains(&height);
    if !is_size || stroke > THICKEST * height || stroke < THINNEST * height {
        return None;
    }
    let (gaps, has_point) = gaps(small.filter(|_| angle.abs() < LEAST_TURN), &letters, height);
    // words of letters that touch stand further apart
    let is_spaced = middle(letters.iter().map(RotatedLetter::width).collect()) <= WIDEST * height;
    let widest = if is_spaced { GAP } else { GAP_OF_WORDS };
    if middle(gaps.clone()) > widest.of(height) {
        return None;
    }
    let top = middle(letters.iter().map(|letter| letter.across[0]).collect());
    let low = letters.iter().map(|letter| letter.across[0]).fold(f32::MAX, f32::min);
    let high = letters.iter().map(|letter| letter.across[1]).fold(f32::MIN, f32::max);
    if high - low > ACROSS * height {
        return None;
    }
    let share =
        |of: &dyn Fn(&RotatedLetter) -> bool| letters.iter().filter(|letter| of(letter)).count() as f32 / n as f32;
    let at_top = share(&|letter| (letter.across[0] - top).abs() <= OFF_LINE.of(height));
    let aligned = on_line(&letters, height).max(HANGING * at_top);
    let complex = share(&|letter| !glyphs[letter.of].is_solid());
    let mean =
        |of: &dyn Fn(&LetterShape) -> f32| letters.iter().map(|letter| of(&glyphs[letter.of])).sum::<f32>() / n as f32;
    let contrast = mean(&|glyph| glyph.contrast);
    let colour = [0, 1, 2].map(|i| mean(&|glyph| glyph.colour[i]));
    let variance = (0..3).map(|i| mean(&|glyph| (glyph.colour[i] - colour[i]).powi(2))).sum::<f32>();
    // letters of a word that touch one another count
    let count: usize = letters.iter().map(|letter| ((letter.width() / (BREADTH * height)) as usize).max(1)).sum();
    Some(TextLine {
        along: [letters[0].along[0], letters.iter().map(|letter| letter.along[1]).fold(f32::MIN, f32::max)],
        across: [low, high],
        score: count as f32 * aligned * (SIMPLE + complex),
        has_point,
        widest_gap: gaps.into_iter().fold(f32::MIN, f32::max),
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

/// Share of letters that stand on the line, as most do.
fn on_line(letters: &[RotatedLetter], height: f32) -> f32 {
    let bottom = middle(letters.iter().map(|letter| letter.across[1]).collect());
    let stands = |letter: &&RotatedLetter| (letter.across[1] - bottom).abs() <= OFF_LINE.of(height);
    letters.iter().filter(stands).count() as f32 / letters.len() as f32
}

/// Letters of a chain as they lie at the angle of the line that they stand on, and that angle; as they are, where that
/// does not set more of them on the line: short words seem to be aslant where letters hang below it.
fn straightened(glyphs: &[LetterShape], chain: &[RotatedLetter], angle: f32) -> (Vec<RotatedLetter>, f32) {
    let turn = if chain.len() < 3 { 0.0 } else { slope(chain) };
    if turn.abs() <= LEAST_TURN {
        return (chain.to_vec(), angle);
    }
    let which: Vec<usize> = chain.iter().map(|letter| letter.of).collect();
    let turned = placed(glyphs, &which, angle - turn);
    let height = middle(chain.iter().map(RotatedLetter::height).collect());
    let better = if chain.len() < FEW { BETTER_OF_FEW } else { BETTER };
    if on_line(&turned, height) > on_line(chain, height) + better {
        (turned, angle - turn)
    } else {
        (chain.to_vec(), angle)
    }
}

impl TextLine {
    /// Whether it is text, if its letters are unlike one another and what lies around it has this `clutter` (thin
    /// things, in shares of its own pixels).
    pub(super) fn is_text(&self, strict: Strictness, clutter: f32) -> bool {
        strict.allows(&Row {
            letters: self.letters.len(),
            is_pair: self.is_pair(),
            angle: self.angle,
            width: self.letters[0].width(),
            unevenness: self.unevenness,
            spread: self.spread,
            stroke_spread: self.stroke_spread,
            clutter,
            contrast: self.contrast,
            aligned: self.aligned,
            complex: self.complex,
            height: self.height,
        })
    }

    /// Whether so large a share of letters stands on the line.
    pub(super) fn is_aligned(&self, share: f32) -> bool {
        self.aligned >= share
    }

    /// Whether two letters stand as those of a number do.
    fn is_pair(&self) -> bool {
        let [a, b] = self.letters[..] else { return false };
        let level = (a.across[1] - b.across[1]).abs() <= OFF_LINE.of(self.height)
            && (a.height() - b.height()).abs() <= HEIGHTS_OF_PAIR.of(self.height);
        level && self.widest_gap <= GAP_OF_PAIR * self.height
    }

    /// The same with the minus before it, if it is level and no longer than a number, and one of these shapes may be
    /// that.
    pub(super) fn with_minus(mut self, small: &SmallShapes) -> Self {
        if self.letters.len() > MOST_DIGITS || self.angle.abs() >= LEAST_TURN {
            return self;
        }
        let (start, [top, foot], height) = (self.along[0], self.across, self.height);
        let is_minus = |[[from, upper], [to, lower]]: &[PixelPoint; 2]| {
            let at = (0.5 * (upper + lower) - top) / (foot - top);
            (MINUS[0] * height..=MINUS[1] * height).contains(&(to - from))
                && lower - upper <= MINUS_THICK.of(height)
                && 2.0 * (lower - upper) <= to - from
                && MINUS_AT.contains(&at)
                && (0.0..=MINUS_GAP.of(height)).contains(&(start - to))
        };
        let ends = [MINUS_AT.start(), MINUS_AT.end()].map(|at| top + at * (foot - top));
        // half a pixel more for rounding
        let near = small.ending(ends[0] - 0.5, ends[1] + 0.5 * MINUS_THICK.of(height) + 0.5).filter(is_minus);
        if let Some([[from, _], _]) = near.max_by(|[_, a], [_, b]| a[0].total_cmp(&b[0])) {
            self.along[0] = from;
        }
        self
    }

    /// Whether another line has its style: height and stroke of letters, colour and contrast.
    pub(super) fn is_styled_as(&self, other: &Self) -> bool {
        let near = |a: f32, b: f32, most: f32| a.max(b) <= most * a.min(b) + STYLE_UNSURE;
        near(self.height, other.height, STYLE_HEIGHT)
            && near(self.stroke, other.stroke, STYLE_STROKE)
            && distance(self.colour, other.colour) <= STYLE_COLOUR * other.contrast
            && near(self.contrast, other.contrast, STYLE_CONTRAST)
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

    /// Whether its letters are as high as those of another one, which small letters beside capitals are not.
    pub(super) fn is_size_of(&self, other: &Self) -> bool {
        (other.height - self.height).abs() <= SAME_HEIGHT.of(self.height)
    }

    /// Whether it is long, or so large a share of its letters is neither a bar nor a dot.
    pub(super) fn is_long_or_complex(&self, share: f32) -> bool {
        self.letters.len() >= FEW || self.complex >= share
    }

    /// Whether its middle lies in the box of another one at the same angle.
    pub(super) fn is_within(&self, other: &Self) -> bool {
        let middle = |range: [f32; 2]| 0.5 * (range[0] + range[1]);
        let is_in = |at: f32, range: [f32; 2]| (range[0]..=range[1]).contains(&at);
        (self.angle - other.angle).abs() <= ROW_ANGLE
            && is_in(middle(self.along), other.along)
            && is_in(middle(self.across), other.across)
    }

    /// Whether another one stands on the same line, or above or below it with an end or the middle at the same place,
    /// as the numbers at an axis do.
    pub(super) fn is_in_row_with(&self, other: &Self) -> bool {
        let height = self.height;
        if (other.angle - self.angle).abs() > ROW_ANGLE || (other.height - height).abs() > ROW_HEIGHT.of(height) {
            return false;
        }
        let gap = |a: [f32; 2], b: [f32; 2]| (a[0] - b[1]).max(b[0] - a[1]);
        let near = |a: f32, b: f32| (a - b).abs() <= COLUMN_END.of(height);
        let is_level = (other.across[1] - self.across[1]).abs() <= ROW_LEVEL.of(height)
            && gap(other.along, self.along) <= ROW_GAP * height;
        let is_stacked = (near(other.along[0], self.along[0])
            || near(other.along[1], self.along[1])
            || near(other.along[0] + other.along[1], self.along[0] + self.along[1]))
            && gap(other.across, self.across) <= COLUMN_GAP * height;
        is_level || is_stacked
    }
}

/// The corners of a line's box, px from the top left of the picture.
pub(super) fn corners(line: &TextLine) -> [[f32; 2]; 4] {
    let [along, across] = axes(line.angle);
    let ends = [(0, 0), (1, 0), (1, 1), (0, 1)];
    ends.map(|(u, v)| [0, 1].map(|axis| along[axis] * line.along[u] + across[axis] * line.across[v]))
}

/// Visits the pixels of a picture whose middle lies in the box of a line.
pub(super) fn each_cell(size: Size, line: &TextLine, mut of: impl FnMut(usize)) {
    let [along, across] = axes(line.angle);
    let corners = corners(line);
    let range = |axis: usize, most: u32| {
        let low = corners.iter().map(|at| at[axis]).fold(f32::MAX, f32::min).max(0.0) as usize;
        let high = corners.iter().map(|at| at[axis]).fold(f32::MIN, f32::max).max(0.0).ceil() as usize;
        low..high.min(most as usize)
    };
    let columns = range(0, size.width);
    for y in range(1, size.height) {
        for x in columns.clone() {
            let at = [x as f32 + 0.5, y as f32 + 0.5];
            let (u, v) = (along[0] * at[0] + along[1] * at[1], across[0] * at[0] + across[1] * at[1]);
            if (line.along[0]..=line.along[1]).contains(&u) && (line.across[0]..=line.across[1]).contains(&v) {
                of(y * size.width as usize + x);
            }
        }
    }
}

#[cfg(test)]
mod tests;
