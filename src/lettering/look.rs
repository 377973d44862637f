//! One plane of a picture, looked at for text that is darker or lighter than its ground.

use super::chain::{RotatedLetter, axes, chains, groups, placed};
use super::character::{Likeness, likenesses};
use super::glyph::{LOCAL, LetterShape, Thin, contrast, glyphs};
use super::levels::{Colours, Levels};
use super::limits::{LetterLength, Strictness};
use super::line::{SmallShapes, TextLine, each_cell, line};
use super::shape::{Comparing, SMALL, are_unlike, rare};
use super::steps::at_even_steps;
use super::succession::successive;
use crate::geom::order::middle;
use crate::raster::contrast::distance;
use crate::raster::plane::Plane;
use crate::raster::residue::Polarity;

/// A letter has at least this contrast, in units of strength: a line is drawn from about 10 on.
const LEAST_CONTRAST: f32 = 10.0;
/// In a drawing, a letter has at least this many times the contrast of the ground with itself: a fainter stroke comes
/// apart in noise, and its pieces look like letters. Of four scans of a faint ring (20 of 255, in noise of 4 of 255) 3
/// leaves pieces in two, 3.5 in none; of nine noisy worksheets 5 loses no text.
const CONTRAST_OF_GROUND: f32 = 4.0;
/// In a photograph only what has this contrast, and is no less even, may be a letter.
const CONTRAST_IN_PHOTOGRAPH: f32 = 20.0;
const UNEVEN: f32 = 0.16;
/// Steps in which directions are tried, degrees: letters of a chain are straightened, so they need not be found at
/// their very angle.
const STEP: f32 = 7.5;
/// A line may lie at most so much off the angle at which it was found, degrees.
const OFF: f32 = 8.0;
/// Least share of letters that stand on a line that is aslant.
const ALIGNED_ASLANT: f32 = 0.75;
/// Lines that are more aslant than this, degrees, and short have so many letters that are no bars: dashes and a curve
/// that they cut to pieces are half bars.
const NEARLY_LEVEL: f32 = 15.0;
const COMPLEX_ASLANT: f32 = 0.6;
/// Directions in which short labels are looked for are those of others, the first of them.
const MOST_ANGLES: usize = 6;
/// Of directions that differ by less than this, degrees, one is enough.
const SAME_ANGLE: f32 = 2.0;
/// At even steps digits of up to this side, px, are unlike if a pixel of them is aside: of 0, 2, 4, 6 and 8 three look
/// alike otherwise.
const SMALL_AT_STEPS: f32 = 13.0;
/// Single letters anywhere, such as the names of points, are so many at least, of shapes that at most so many of them
/// have: more are marks. They are no higher than this, px, and clearer than others.
const FEWEST_ALONE: usize = 3;
const MOST_ALIKE: usize = 2;
const HIGHEST_ALONE: f32 = 20.0;
const CONTRAST_ALONE: f32 = 40.0;
const CLUTTER_ALONE: f32 = 0.1;
/// What a digit or a capital is can be seen from this height on, px; of more single shapes than this none is looked at.
const LEAST_NAMED: f32 = 10.0;
const MOST_NAMED: usize = 300;
/// Of more shapes than this it is not asked whether each stands by itself, which is asked of all others.
const MOST_SINGLE: usize = 3000;
/// It stands by itself: nothing that is about as high, and no bar and no dot, is so near beside it, in its heights.
const BESIDE: std::ops::RangeInclusive<f32> = -0.3..=0.8;
const BESIDE_HEIGHT: std::ops::RangeInclusive<f32> = 0.5..=1.5;
/// Least letters of a line that lies level, that stands upright, and that lies aslant: the less usual, the more.
const LEVEL: usize = 1;
const UPRIGHT: usize = 3;
const ASLANT: usize = 4;
/// Dots of `i`, accents and full stops are this near to a line, in heights of its letters: before and below it, behind
/// it, and above it.
const BEFORE: f32 = 0.25;
const BEHIND: f32 = 2.0 * BEFORE;
const ABOVE: f32 = 1.5 * BEFORE;
/// Clutter is looked for as far around a line as this, in heights of its letters.
const CLUTTER: f32 = 0.4;
/// The ground around a line is looked at from this far on, beyond the smoothing of letters, as far as that.
const GROUND_FROM: LetterLength = LetterLength::new(0.1, 1.0);
const GROUND_TO: LetterLength = LetterLength::new(0.3, 3.0);
/// Least distance of the letters' colour from that of the ground, as a share of their contrast.
const STANDS_OUT: f32 = 0.45;
/// In a plane of colour the contrast of letters is at least this share of that distance. Between white and some blues
/// a mixture of both, as smoothing leaves it beside a stroke, differs more in such a plane than the blue itself, and a
/// curve comes apart in pieces of such pixels: of `#1f77b4` they have .2 to .27, its strokes .55 in lightness and .83
/// in the other plane. What is lost here stands clearer there.
const OF_DISTANCE: f32 = 0.35;

/// What is thin in a plane, and what of it may be letters.
pub(super) struct Look {
    pub(super) thin: Thin,
    glyphs: Vec<LetterShape>,
    letters: Vec<usize>,
    /// What may be a decimal point or a minus: looked for in drawings.
    small: Option<SmallShapes>,
    strict: Strictness,
    /// Whether the plane is one of colour, and not of lightness.
    of_colour: bool,
}

impl Look {
    /// Of a plane among those of a picture, and the same in levels; none if nothing thin is in it.
    pub(super) fn new(
        (plane, levels): (&Plane, &Levels),
        polarity: Polarity,
        colours: &Colours<'_>,
        strict: Strictness,
    ) -> Option<Self> {
        let is_drawing = strict == Strictness::Drawing;
        let wanted = if is_drawing { LEAST_CONTRAST } else { CONTRAST_IN_PHOTOGRAPH };
        let contrast = contrast(levels, polarity, wanted)?;
        let of_ground = if is_drawing { CONTRAST_OF_GROUND * contrast.of_ground() } else { 0.0 };
        let thin = Thin { set: contrast.at_least_half(LEAST_CONTRAST.max(of_ground)), contrast };
        let is_clear = |contrast, unevenness| is_drawing || contrast >= wanted && unevenness <= UNEVEN;
        let glyphs = glyphs(&thin, plane, colours, is_clear);
        let letters = (0..glyphs.len()).filter(|&i| glyphs[i].is_letter).collect();
        let small = is_drawing.then(|| SmallShapes::of(&glyphs));
        let of_colour = !colours.planes.first().is_some_and(|lightness| std::ptr::eq(lightness, plane));
        Some(Self { thin, glyphs, letters, small, strict, of_colour })
    }

    /// Lines of text: first those that lie level, then those that stand upright, then those aslant.
    pub(super) fn lines(&self, colours: &Colours<'_>) -> Vec<TextLine> {
        let is_drawing = self.strict == Strictness::Drawing;
        let mut groups = groups(&self.glyphs, &self.letters);
        let mut lines: Vec<TextLine> = Vec::new();
        let aslant = (1..(90.0 / STEP) as usize)
            .map(|step| STEP * step as f32)
            .flat_map(|angle| [(angle, ASLANT), (-angle, ASLANT)]);
        for (angle, least) in [(0.0, LEVEL), (90.0, UPRIGHT), (-90.0, UPRIGHT)].into_iter().chain(aslant) {
            // a line lies in one group
            let wanted = self.strict.least_letters().max(least);
            groups.retain(|group| group.len() >= wanted && self.strict.may_have_text(&self.glyphs, group));
            let mut left = groups.concat();
            left.sort_unstable();
            if left.is_empty() {
                break;
            }
            let mut used = vec![false; self.glyphs.len()];
            for chain in chains(&self.glyphs, &left, angle) {
                let fits = |line: &TextLine| {
                    line.letters.len() >= least
                        && (line.angle - angle).abs() <= OFF
                        && (least == LEVEL || line.is_aligned(ALIGNED_ASLANT))
                        && (!is_drawing
                            || angle.abs() % 90.0 <= NEARLY_LEVEL
                            || line.is_long_or_complex(COMPLEX_ASLANT))
                };
                let line = self.line(&chain, angle).filter(fits);
                if let Some(line) = line.and_then(|line| self.text(line, self.strict, colours)) {
                    line.letters.iter().for_each(|letter| used[letter.of] = true);
                    lines.push(line);
                }
            }
            groups.iter_mut().for_each(|group| group.retain(|&i| !used[i]));
        }
        lines
    }

    /// Short labels, down to a single digit, in the style of others.
    pub(super) fn in_style(&self, colours: &Colours<'_>, others: &[TextLine]) -> Vec<TextLine> {
        let mut angles: Vec<f32> = Vec::new();
        for other in others {
            if !angles.iter().any(|angle| (angle - other.angle).abs() < SAME_ANGLE) {
                angles.push(other.angle);
            }
        }
        let is_drawing = self.strict == Strictness::Drawing;
        let strict = if is_drawing { Strictness::Label } else { Strictness::Context };
        let mut lines = Vec::new();
        for angle in angles.into_iter().take(MOST_ANGLES) {
            let like = |chain: Vec<RotatedLetter>| {
                let line = self.line(&chain, angle).filter(|line| (line.angle - angle).abs() <= OFF)?;
                others.iter().any(|other| line.is_styled_as(other)).then_some(line)
            };
            let chains = chains(&self.glyphs, &self.letters, angle);
            lines.extend(chains.into_iter().filter_map(like).filter_map(|line| self.text(line, strict, colours)));
            let placed = placed(&self.glyphs, &self.letters, angle);
            let singles: Vec<TextLine> = placed.into_iter().filter_map(|one| like(vec![one])).collect();
            let is_in_row =
                |line: &&TextLine| others.iter().any(|other| line.is_styled_as(other) && line.is_in_row_with(other));
            let in_rows = singles.iter().filter(is_in_row);
            lines.extend(in_rows.filter_map(|line| self.text(line.clone(), strict, colours)));
            if is_drawing {
                lines.extend(self.several_singles(singles, others, colours));
            }
        }
        lines.sort_by(|a, b| b.score.total_cmp(&a.score));
        lines
    }

    /// Those of some single letters that speak for one another: at even steps, as at an axis, or of shapes that few of
    /// them have, as the names of points.
    fn several_singles(&self, singles: Vec<TextLine>, others: &[TextLine], colours: &Colours<'_>) -> Vec<TextLine> {
        let is_free = |line: &TextLine| !others.iter().any(|other| other.letters.len() > 1 && line.is_within(other));
        let free = singles.into_iter().filter(is_free);
        let text = |line: TextLine| self.text(line, Strictness::Single, colours);
        let singles: Vec<TextLine> = free.filter_map(text).collect();
        let small = Comparing { small: SMALL_AT_STEPS, ..self.comparing() };
        let is_at_step = at_even_steps(&singles, |letters| are_unlike(small, letters));
        let (mut lines, alone): (Vec<_>, Vec<_>) = singles.into_iter().zip(is_at_step).partition(|(_, is)| *is);
        let stands_clear = |(line, _): &(TextLine, bool)| {
            line.height <= HIGHEST_ALONE
                && line.contrast >= CONTRAST_ALONE
                && others.iter().any(|other| line.is_styled_as(other) && line.is_size_of(other))
                && self.clutter(line) <= CLUTTER_ALONE
        };
        let alone: Vec<(TextLine, bool)> = alone.into_iter().filter(stands_clear).collect();
        let letters: Vec<RotatedLetter> = alone.iter().map(|(line, _)| line.letters[0]).collect();
        let is_rare = rare(self.comparing(), &letters, MOST_ALIKE);
        if is_rare.iter().filter(|is| **is).count() >= FEWEST_ALONE {
            lines.extend(alone.into_iter().zip(is_rare).filter(|(_, is)| *is).map(|(one, _)| one));
        }
        lines.into_iter().map(|(line, _)| line).collect()
    }

    /// Single digits and capitals of a drawing that follow one another, as 1, 2 and 3, beside these lines.
    pub(super) fn in_succession(&self, colours: &Colours<'_>, lines: &[TextLine]) -> Vec<TextLine> {
        if self.strict != Strictness::Drawing {
            return Vec::new();
        }
        let placed = placed(&self.glyphs, &self.letters, 0.0);
        let may_be_one = |line: &TextLine| {
            line.height >= LEAST_NAMED
                && line.is_text(Strictness::Named, 0.0)
                && !lines.iter().any(|other| line.is_within(other))
        };
        let one = |letter: &RotatedLetter| self.line(&[*letter], 0.0).filter(may_be_one);
        let mut singles: Vec<TextLine> = placed.iter().filter_map(one).collect();
        if singles.len() > MOST_SINGLE {
            return Vec::new();
        }
        singles.retain(|single| !self.is_in_word(&single.letters[0], &placed));
        if singles.len() > MOST_NAMED {
            return Vec::new();
        }
        singles.retain(|single| !self.is_piece(single.letters[0].of));
        let named = |line: TextLine| {
            let names = likenesses(&self.glyphs[line.letters[0].of], self.width());
            let line = if names.is_empty() { Some(line) } else { self.text(line, Strictness::Named, colours) };
            line.zip(Some(names))
        };
        let (singles, names): (Vec<TextLine>, Vec<Vec<Likeness>>) = singles.into_iter().filter_map(named).unzip();
        let is_one = successive(&singles, &names);
        singles.into_iter().zip(is_one).filter(|(_, is)| *is).map(|(line, _)| line).collect()
    }

    /// Whether one of some shapes stands beside a letter as one of the same word does, or as a unit beside a number.
    fn is_in_word(&self, letter: &RotatedLetter, all: &[RotatedLetter]) -> bool {
        let height = letter.height();
        let is_beside = |other: &RotatedLetter| {
            let overlap = other.across[1].min(letter.across[1]) - other.across[0].max(letter.across[0]);
            let apart = (other.along[0] - letter.along[1]).max(letter.along[0] - other.along[1]);
            BESIDE_HEIGHT.contains(&(other.height() / height))
                && overlap >= 0.5 * height.min(other.height())
                && BESIDE.contains(&(apart / height))
                && !self.glyphs[other.of].is_solid()
        };
        all.iter().any(is_beside)
    }

    /// Whether a shape is a piece of a larger one, as the tip of a leaf is, whose pixels come apart from the rest of
    /// its outline: within [`LOCAL`] px of a pixel that stands out more, those between are none of a stroke.
    fn is_piece(&self, of: usize) -> bool {
        let shape = &self.glyphs[of];
        let is_larger = |other: &LetterShape| other.side() > shape.side() && shape.is_within(other, LOCAL);
        self.glyphs.iter().enumerate().any(|(i, other)| i != of && is_larger(other))
    }

    fn comparing(&self) -> Comparing<'_> {
        Comparing { glyphs: &self.glyphs, width: self.width(), small: SMALL }
    }

    /// The pixels of a line's letters, and of the dots between and above them.
    pub(super) fn cells(&self, line: &TextLine) -> Vec<usize> {
        let [along, across] = axes(line.angle);
        let (beside, behind, above) = (BEFORE * line.height, BEHIND * line.height, ABOVE * line.height);
        let is_letter = |i: usize| line.letters.iter().any(|letter| letter.of == i);
        let is_inside = |glyph: &LetterShape| {
            let (u, v) = (glyph.reach(along), glyph.reach(across));
            u[0] >= line.along[0] - beside
                && u[1] <= line.along[1] + behind
                && v[0] >= line.across[0] - above
                && v[1] <= line.across[1] + beside
        };
        let own = self.glyphs.iter().enumerate().filter(|(i, glyph)| is_letter(*i) || is_inside(glyph));
        own.flat_map(|(_, glyph)| glyph.cells.iter().copied()).collect()
    }

    fn width(&self) -> usize {
        self.thin.contrast.size.width as usize
    }

    fn line(&self, chain: &[RotatedLetter], angle: f32) -> Option<TextLine> {
        line(&self.glyphs, chain, angle, self.small.as_ref())
    }

    /// A line with its minus, if it is text.
    fn text(&self, line: TextLine, strict: Strictness, colours: &Colours<'_>) -> Option<TextLine> {
        // the digits of a number such as 0.0 or 11 may be alike; what costs more comes last
        let may_be_alike = || strict == Strictness::Label && (line.has_point || self.is_double_digit(&line));
        let are_letters = line.is_text(strict, 0.0) && (are_unlike(self.comparing(), &line.letters) || may_be_alike());
        if !are_letters {
            return None;
        }
        let line = match &self.small {
            Some(small) => line.with_minus(small),
            None => line,
        };
        (line.is_text(strict, self.clutter(&line)) && self.stands_out(&line, colours)).then_some(line)
    }

    /// Whether a pair is one digit twice, as in 11: not 0, as two rings side by side are.
    fn is_double_digit(&self, line: &TextLine) -> bool {
        let digit = |letter: &RotatedLetter| {
            let names = likenesses(&self.glyphs[letter.of], self.width());
            let most = names.into_iter().min_by(|a, b| a.off.total_cmp(&b.off))?.character;
            (most.is_ascii_digit() && most != '0').then_some(most)
        };
        let [first, second] = &line.letters[..] else { return false };
        digit(first).is_some_and(|digit_of_first| digit(second) == Some(digit_of_first))
    }

    /// Thin things around a line that are none of its own, in shares of its own pixels.
    fn clutter(&self, line: &TextLine) -> f32 {
        let own = self.cells(line).len() as f32;
        let mut all = 0;
        let around = line.grown(CLUTTER * line.height);
        each_cell(self.thin.contrast.size, &around, |cell| all += usize::from(self.thin.set[cell]));
        (all as f32 - own).max(0.0) / own
    }

    /// Whether its letters have another colour than what is around them. The gaps between letters, which form rows as
    /// well, have the same.
    fn stands_out(&self, line: &TextLine, colours: &Colours<'_>) -> bool {
        let size = self.thin.contrast.size;
        let mut is_inner = std::collections::BTreeSet::new();
        each_cell(size, &line.grown(GROUND_FROM.of(line.height)), |cell| {
            is_inner.insert(cell);
        });
        let mut ring = Vec::new();
        each_cell(size, &line.grown(GROUND_TO.of(line.height)), |cell| {
            if !self.thin.set[cell] && !is_inner.contains(&cell) {
                ring.push(colours.at(cell));
            }
        });
        let around = [0, 1, 2].map(|axis| middle(ring.iter().map(|colour| colour[axis]).collect()));
        let apart = distance(around, line.colour);
        let is_own_colour = !self.of_colour || line.contrast >= OF_DISTANCE * apart;
        !ring.is_empty() && apart >= STANDS_OUT * line.contrast && is_own_colour
    }
}

#[cfg(test)]
mod tests;
