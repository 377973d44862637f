//! One plane of a picture, looked at for text that is darker or lighter than its ground.

use super::chain::{axes, chains, distance, groups, placed};
use super::glyph::{LetterShape, Thin, contrast, glyphs};
use super::levels::{Colours, Levels};
use super::limits::{LetterLength, Strictness};
use super::line::{TextLine, each_cell, line, median};
use super::shape::are_unlike;
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
/// Directions in which short labels are looked for are those of others, the first of them.
const MOST_ANGLES: usize = 6;
/// Of directions that differ by less than this, degrees, one is enough.
const SAME_ANGLE: f32 = 2.0;
/// Least letters of a line that lies level, that stands upright, and that lies aslant: the less usual, the more.
const LEVEL: usize = 1;
const UPRIGHT: usize = 3;
const ASLANT: usize = 4;
/// Dots of `i`, accents and full stops are this near to a line, in heights of its letters: before and below it, behind
/// it, and above it.
const BESIDE: f32 = 0.25;
const BEHIND: f32 = 2.0 * BESIDE;
const ABOVE: f32 = 1.5 * BESIDE;
/// Clutter is looked for as far around a line as this, in heights of its letters.
const CLUTTER: f32 = 0.4;
/// The ground around a line is looked at from this far on, beyond the smoothing of letters, as far as that.
const GROUND_FROM: LetterLength = LetterLength::new(0.1, 1.0);
const GROUND_TO: LetterLength = LetterLength::new(0.3, 3.0);
/// Least distance of the letters' colour from that of the ground, as a share of their contrast.
const STANDS_OUT: f32 = 0.45;

/// What is thin in a plane, and what of it may be letters.
pub(super) struct Look {
    pub(super) thin: Thin,
    glyphs: Vec<LetterShape>,
    letters: Vec<usize>,
    strict: Strictness,
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
        Some(Self { thin, glyphs, letters, strict })
    }

    /// Lines of text: first those that lie level, then those that stand upright, then those aslant.
    pub(super) fn lines(&self, colours: &Colours<'_>) -> Vec<TextLine> {
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
                let Some(line) = line(&self.glyphs, &chain, angle) else { continue };
                let fits = line.letters.len() >= least
                    && (line.angle - angle).abs() <= OFF
                    && (least == LEVEL || line.is_aligned(ALIGNED_ASLANT));
                if fits && self.is_text(&line, self.strict, colours) {
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
        let mut lines = Vec::new();
        for angle in angles.into_iter().take(MOST_ANGLES) {
            let mut chains = chains(&self.glyphs, &self.letters, angle);
            chains.extend(placed(&self.glyphs, &self.letters, angle).into_iter().map(|one| vec![one]));
            for chain in chains {
                let Some(line) = line(&self.glyphs, &chain, angle) else { continue };
                let mut like = others.iter().filter(|other| line.is_styled_as(other));
                let is_like = match line.letters.len() {
                    1 => like.any(|other| line.is_in_row_with(other)),
                    _ => like.next().is_some(),
                };
                if is_like && (line.angle - angle).abs() <= OFF && self.is_text(&line, Strictness::Context, colours) {
                    lines.push(line);
                }
            }
        }
        lines.sort_by(|a, b| b.score.total_cmp(&a.score));
        lines
    }

    /// The pixels of a line's letters, and of the dots between and above them.
    pub(super) fn cells(&self, line: &TextLine) -> Vec<usize> {
        let [along, across] = axes(line.angle);
        let (beside, behind, above) = (BESIDE * line.height, BEHIND * line.height, ABOVE * line.height);
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

    fn is_text(&self, line: &TextLine, strict: Strictness, colours: &Colours<'_>) -> bool {
        // what costs more comes last
        line.is_text(strict, 0.0)
            && are_unlike(&self.glyphs, &line.letters, self.width())
            && line.is_text(strict, self.clutter(line))
            && self.stands_out(line, colours)
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
        let around = [0, 1, 2].map(|axis| median(ring.iter().map(|colour| colour[axis]).collect()));
        !ring.is_empty() && distance(around, line.colour) >= STANDS_OUT * line.contrast
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Raster;
    use crate::units::Size;

    const SIZE: Size = Size { width: 320, height: 120 };

    /// Letters of 5 x 7 pixels.
    const LETTERS: [(char, [&str; 7]); 7] = [
        ('A', [" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"]),
        ('E', ["#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"]),
        ('N', ["#   #", "##  #", "# # #", "#  ##", "#   #", "#   #", "#   #"]),
        ('P', ["#### ", "#   #", "#   #", "#### ", "#    ", "#    ", "#    "]),
        ('R', ["#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"]),
        ('S', [" ####", "#    ", "#    ", " ### ", "    #", "    #", "#### "]),
        ('5', ["#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "]),
    ];
    /// Side of a pixel of a letter, px.
    const SCALE: usize = 3;

    /// A picture of ink and paper, each by its light.
    struct Sheet {
        is_ink: Vec<bool>,
    }

    impl Sheet {
        fn of(texts: &[(&str, [usize; 2])]) -> Self {
            let mut sheet = Self { is_ink: vec![false; SIZE.len()] };
            for (text, [left, top]) in texts {
                for (i, letter) in text.chars().enumerate() {
                    let (_, rows) = LETTERS.iter().find(|(known, _)| *known == letter).expect("a known letter");
                    for (y, row) in rows.iter().enumerate() {
                        for (x, _) in row.chars().enumerate().filter(|(_, pixel)| *pixel == '#') {
                            sheet.bar([left + (6 * i + x) * SCALE, top + y * SCALE], [SCALE, SCALE]);
                        }
                    }
                }
            }
            sheet
        }

        fn bar(&mut self, [left, top]: [usize; 2], [width, height]: [usize; 2]) {
            for row in top..top + height {
                self.is_ink[row * SIZE.width as usize + left..][..width].fill(true);
            }
        }

        /// Looks for text that is darker or lighter than its ground, in a picture of ink and paper of this light, and
        /// gives what `of` makes of it; none if nothing thin is there.
        fn look<T>(
            &self,
            [ink, paper]: [f32; 2],
            polarity: Polarity,
            strict: Strictness,
            of: impl FnOnce(&Look, &Colours<'_>) -> T,
        ) -> Option<T> {
            let light = self.is_ink.iter().map(|is_ink| if *is_ink { ink } else { paper }).collect();
            let raster = Raster::grey(SIZE, light);
            let colours = Colours::new(&raster, strict == Strictness::Drawing);
            let plane = &colours.planes[0];
            Look::new((plane, &Levels::of(plane)), polarity, &colours, strict).map(|look| of(&look, &colours))
        }

        /// How many letters each line of dark text in a drawing has.
        fn letters(&self) -> Vec<usize> {
            let lines = |look: &Look, colours: &Colours<'_>| look.lines(colours);
            let lines = self.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, lines).unwrap_or_default();
            lines.iter().map(|line| line.letters.len()).collect()
        }
    }

    #[test]
    fn a_word_is_one_line_with_all_its_letters() {
        assert_eq!(Sheet::of(&[("SPARE", [40, 40])]).letters(), [5]);
        assert_eq!(Sheet::of(&[("SPARE", [40, 20]), ("NEAR", [160, 80])]).letters().iter().sum::<usize>(), 9);
        assert_eq!(Sheet::of(&[]).letters(), [0_usize; 0]);
    }

    #[test]
    fn light_text_is_seen_by_the_look_for_light_things_only() {
        let sheet = Sheet::of(&[("SPARE", [40, 40])]);
        let count =
            |polarity| sheet.look([1.0, 0.0], polarity, Strictness::Drawing, |look, colours| look.lines(colours).len());
        assert_eq!(count(Polarity::Above), Some(1));
        assert_eq!(count(Polarity::Below).unwrap_or(0), 0);
    }

    #[test]
    fn a_digit_alone_is_text_only_beside_others_of_its_style() {
        let sheet = Sheet::of(&[("SPARE", [40, 40]), ("5", [200, 40])]);
        let found = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, |look, colours| {
            let words: Vec<TextLine> = look.lines(colours).into_iter().filter(|line| line.letters.len() == 5).collect();
            let alone = |others: &[TextLine]| {
                look.in_style(colours, others).iter().filter(|line| line.letters.len() == 1).count()
            };
            (words.len(), alone(&words), alone(&[]))
        });
        assert_eq!(found, Some((1, 1, 0)));
    }

    #[test]
    fn bars_side_by_side_are_no_text() {
        let mut bars = Sheet::of(&[]);
        (0..8).for_each(|i| bars.bar([40 + 24 * i, 40], [4, 30]));
        assert_eq!(bars.letters(), [0_usize; 0]);
    }

    #[test]
    fn hatching_around_a_word_is_clutter() {
        let mut hatched = Sheet::of(&[("SPARE", [40, 40])]);
        for row in (22..100).step_by(6) {
            // between the rows of pixels of letters, too
            hatched.bar([20, row], [140, 2]);
        }
        assert_eq!(hatched.letters(), [0_usize; 0]);
    }

    #[test]
    fn in_a_photograph_pale_letters_are_not_looked_at() {
        let sheet = Sheet::of(&[("SPARE", [40, 40])]);
        let count = |ink: f32, strict: Strictness| {
            let count = |look: &Look, _: &Colours<'_>| look.letters.len();
            sheet.look([ink, 0.5], Polarity::Below, strict, count).unwrap_or(0)
        };
        // 0.3 is darker than 0.5 by 15 of 100 of lightness, 0.05 by 50
        assert_eq!([0.3, 0.05].map(|ink| count(ink, Strictness::Drawing)), [5, 5]);
        assert_eq!([0.3, 0.05].map(|ink| count(ink, Strictness::Photograph)), [0, 5]);
    }

    #[test]
    fn the_cells_of_a_line_are_those_of_its_letters() {
        let mut sheet = Sheet::of(&[("SPARE", [40, 40])]);
        let ink = sheet.is_ink.iter().filter(|is_ink| **is_ink).count() as f32;
        sheet.bar([10, 100], [300, 3]);
        let cells =
            |look: &Look, colours: &Colours<'_>| look.lines(colours).iter().map(|line| look.cells(line).len()).sum();
        let cells: Option<usize> = sheet.look([0.0, 1.0], Polarity::Below, Strictness::Drawing, cells);
        let cells = cells.expect("something thin") as f32;
        assert!((cells / ink - 1.0).abs() < 0.1, "{cells} cells of {ink}");
    }
}
