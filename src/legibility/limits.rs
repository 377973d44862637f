//! The numbers that a page is held against: those of its profile, and a few that no profile has.

use crate::braille::CellSize;
use crate::page::Class;

/// What a page must keep, in millimetres on the sheet as it is felt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RuleLimits {
    /// Blank on all four sides.
    pub margin: f32,
    /// Least length of a line from tip to tip.
    pub line_length: f32,
    /// Least area of a texture, mm^2.
    pub texture_area: f32,
    /// Measures of braille cells.
    pub cell: CellSize,
    /// The least strength that contours must have.
    pub least_strength: f32,
    /// What only one kind of page has.
    pub medium: MediumLimits,
}

/// What only a printed page must keep, or only one of dots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MediumLimits {
    /// Of a printed page, mm.
    Print {
        /// Least width of a line.
        line_width: f32,
        /// Least blank between two lines.
        line_gap: f32,
        /// Least blank between a line and a glyph.
        texture_gap: f32,
        /// Least thickness of a glyph or dot.
        glyph: f32,
        /// Share of the figure that may be black, 0..=1.
        max_black: f32,
        /// Whether marks may have the direction of a neighbouring colour.
        fringe: bool,
    },
    /// Of a page of dots.
    Dots {
        /// Distance of dots, mm.
        pitch: f32,
        /// Farthest that a dot and the next one of its line lie apart, also diagonally, mm.
        farthest_next: f32,
        /// Empty dots between two lines, at least.
        line_gap: u32,
        /// Empty dots between a line and a texture, at least.
        texture_gap: u32,
    },
}

/// The last digit of the numbers of a page, which have two after the point, mm: each of them is off by up to a half.
pub(super) const LAST_DIGIT: f32 = 0.01;
/// Dots no farther apart than so many pitches are beside one another on an even grid or on none, also diagonally; a
/// longer step is a hole in a line, as where another crosses it.
pub(super) const NEXT_DOT: f32 = 1.5;
/// A blank is that much less or more by rounding, mm: of two marks three numbers are added up.
pub(super) const ROUNDING: f32 = 1.5 * LAST_DIGIT;

/// Side of the cells in which segments are looked for, mm: about the clearance of two lines. Chosen by us.
pub(super) const CELL: f32 = 5.0;
/// Most textures that readers keep apart (BANA, as quoted by others).
pub(super) const MOST_TEXTURES: usize = 5;
const _: () = assert!(Class::COUNT <= MOST_TEXTURES, "a page of all classes would break the rule");
/// Blank around braille, mm: as other programs leave around braille on graphics (MapGen).
pub(super) const BRAILLE_GAP: f32 = 3.0;
/// Least blank between a label and its own leader line, mm. Chosen by us: nearer the line's end is felt as one of the
/// dots of a letter, which are 2.5 mm apart.
pub(crate) const OWN_LEADER_GAP: f32 = 2.0;
/// Least side of a closed shape that an overview must show, in its own mm: a fingertip's width. Smaller ones are left
/// to the figure.
pub(super) const SHAPE: f32 = 12.0;
/// How far from a line or a mark of a texture the line of a label may end that names it, mm: less than half of what a
/// fingertip covers.
pub(crate) const LEADER_END: f32 = 6.0;
/// Rows of a texture on dots are beside a line up to this blank, mm. A study of guide maps (40 sighted testers) found
/// lines easiest to tell from a texture of dots from 5 mm on.
pub(super) const ROWS_BESIDE: f32 = 5.0;
/// Most of the length of lines that may have such rows on both sides. Chosen by us, by looking at pages for an embosser
/// with 2 mm from dot to dot: of the samples portrait, astronaut, landscape and map have 0.02 to 0.12, and chelsea,
/// cell, rocket and coffee, where fingers lose lines among rows, 0.15 to 0.29. Of 17 drawings of others one has more, a
/// map.
pub(super) const MOST_BESIDE_ROWS: f32 = 0.14;
/// Most ends of lines in 100 square cm of a photograph that lead to nothing, on paper and on dots, where lines lie
/// farther apart. Chosen by us, by looking at pages: those of the sample photographs have up to 15 and 10; of 39 other
/// pictures the two that are all scraps, of leaves and of grass, have 28 and 29, and 14 and 18 on an embosser.
const LOOSE_ENDS: f32 = 20.0;
const LOOSE_ENDS_OF_DOTS: f32 = 12.0;
/// How far a dot of braille may lie from its place in the cell, mm: EN ISO 17351 allows 4 % of 2.5 mm.
pub(super) const BRAILLE_OFF: f32 = 0.1;

impl RuleLimits {
    /// Distance of the middles of two lines, at least, mm.
    pub(super) fn spacing(&self) -> f32 {
        match self.medium {
            MediumLimits::Print { line_gap, line_width, .. } => line_gap + line_width,
            MediumLimits::Dots { pitch, line_gap, .. } => (line_gap + 1) as f32 * pitch,
        }
    }

    /// Distance of dots, mm; 0 on a printed page.
    pub(super) fn spacing_of_dots(&self) -> f32 {
        match self.medium {
            MediumLimits::Print { .. } => 0.0,
            MediumLimits::Dots { pitch, .. } => pitch,
        }
    }

    /// How far apart dots lie at most that follow one another, mm; 0 on a printed page.
    pub(super) fn next_dot(&self) -> f32 {
        match self.medium {
            MediumLimits::Print { .. } => 0.0,
            MediumLimits::Dots { pitch, farthest_next, .. } => (NEXT_DOT * pitch).max(farthest_next + 2.0 * LAST_DIGIT),
        }
    }

    /// Most ends of lines that lead to nothing in 100 square cm of a photograph.
    pub(super) fn loose_ends(&self) -> f32 {
        match self.medium {
            MediumLimits::Print { .. } => LOOSE_ENDS,
            MediumLimits::Dots { .. } => LOOSE_ENDS_OF_DOTS,
        }
    }

    /// The widest gap in a line that may be missed, mm: twice the least blank between two lines, of dots twice the
    /// least distance of their middles.
    pub(super) fn missed_gap(&self) -> f32 {
        match self.medium {
            MediumLimits::Print { line_gap, .. } => 2.0 * line_gap,
            MediumLimits::Dots { .. } => 2.0 * self.spacing(),
        }
    }
}
