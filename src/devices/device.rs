//! What a device is, and what follows from its family alone.

use std::f32::consts::SQRT_2;

use crate::units::{MmPoint, MmRect};

/// From dot to dot at 20 dots per inch, mm.
pub(super) const DOT_20_DPI: f32 = 1.27;
/// From pin to pin, mm. The makers do not say or say about 2.5; nothing that is sent to a display depends on it.
pub(super) const PIN: f32 = 2.5;

/// From dot to dot in a cell, mm; this and the next two from NLS specification 800, as braille printed in that size
/// has them ([`CellSize`](crate::braille::CellSize), `us`; a test holds the two together).
pub(super) const CELL_DOT: f32 = 2.34;
/// From cell to cell, mm.
pub(super) const CELL: f32 = 6.2;
/// From line to line, mm.
pub(super) const LINE: f32 = 10.0;

/// An embosser or a pin display.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Device {
    /// As profiles name it, such as `index-basic-d-v5`.
    pub id: &'static str,
    /// As its maker calls it.
    pub name: &'static str,
    /// How it takes dots.
    pub(crate) family: Family,
    /// Widest sheet, mm.
    pub widest: f32,
    /// Longest sheet, mm.
    pub longest: f32,
}

/// Devices that take the same language.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Family {
    /// Index embossers of the third generation.
    IndexV3 {
        /// How they are told the size of the paper.
        paper: Paper,
    },
    /// Index embossers of the fourth and fifth generation, whoever sells them.
    IndexV4,
    /// Open hardware that moves a stylus anywhere.
    BrailleRap {
        /// How far the stylus goes across the sheet, mm.
        across: f32,
    },
    /// Embossers that take a picture of 20 dots per inch.
    ViewPlus,
    /// Displays of pins; the sheet is their field.
    Pins {
        /// Pins from left to right.
        columns: u16,
        /// Pins from top to bottom.
        rows: u16,
    },
    /// Cells of six dots at the spacing of braille: any embosser of text.
    Cells,
}

/// How an Index V3 is told the size of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Paper {
    /// In inches, with a digit for the fraction.
    Inches,
    /// In whole millimetres.
    Millimetres,
    /// Not at all: it is set at the embosser.
    Unsaid,
}

/// Distances from dot to dot that a device has, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Pitches {
    /// These.
    Listed(&'static [f32]),
    /// Any between the two.
    Between(f32, f32),
}

/// Where on a sheet a device can put dots.
#[derive(Debug, Clone, PartialEq)]
pub enum DotArea {
    /// On columns and rows.
    Grid(Grid),
    /// Anywhere in a rectangle, for the centres of dots. Its top left corner is the device's zero.
    Free(MmRect),
}

/// Columns and rows that dots lie on. They are not even for cells of braille, which stand apart.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Grid {
    /// The centre of every column, mm from the left edge of the sheet, ascending.
    pub columns: Vec<f32>,
    /// The centre of every row, mm from the top edge of the sheet, ascending.
    pub rows: Vec<f32>,
}

/// Lengths this near are the same, mm: the hundredths that Index drivers count in, and profiles say 215.9 for 8 1/2
/// inches.
pub(super) const SAME: f32 = 0.02;

impl Device {
    /// The pitches it has. Those of cells are from dot to dot in a cell.
    pub fn pitches(&self) -> Pitches {
        match self.family {
            Family::IndexV3 { .. } | Family::IndexV4 => Pitches::Listed(&[1.6, 2.0, 2.5]),
            // DesktopBrailleRAP takes 2.4 on paper and 1.8 on cans. Narrower than a dot of 1.6 they would cut the
            // paper in two; wider than 5, two fingertips apart, dots are no line any more. Both ends chosen by us.
            Family::BrailleRap { .. } => Pitches::Between(1.6, 5.0),
            Family::ViewPlus => Pitches::Listed(&[DOT_20_DPI]),
            Family::Pins { .. } => Pitches::Listed(&[PIN]),
            Family::Cells => Pitches::Listed(&[CELL_DOT]),
        }
    }

    /// Farthest that the next dot of a line lies from one, mm: the diagonal of its widest steps.
    pub fn farthest_next(&self, pitch: f32) -> f32 {
        match self.family {
            Family::Cells => (CELL - CELL_DOT).hypot(LINE - 2.0 * CELL_DOT),
            Family::IndexV3 { .. }
            | Family::IndexV4
            | Family::BrailleRap { .. }
            | Family::ViewPlus
            | Family::Pins { .. } => pitch * SQRT_2,
        }
    }

    /// Diameter of one of its dots as felt, mm.
    pub fn diameter(&self) -> f32 {
        match self.family {
            // A dot of Marburg Medium, which Index and BrailleRAP emboss; the drivers of Index leave as much at the
            // edge.
            Family::IndexV3 { .. } | Family::IndexV4 | Family::BrailleRap { .. } => 1.6,
            // Its makers do not say. Dots 1.27 apart can still be told from a bar, so they are smaller. Chosen by us.
            Family::ViewPlus => 1.0,
            // Makers do not say; round tips that leave room between pins 2.5 apart. Chosen by us.
            Family::Pins { .. } => 1.5,
            // NLS specification 800: the base of a dot.
            Family::Cells => 1.44,
        }
    }

    /// Whether it has three heights of dots that fingers tell apart, and not just one. ViewPlus embossers have eight,
    /// of which blind readers told the lower three apart best (Kouroupetroglou et al. 2016).
    pub fn has_heights(&self) -> bool {
        match self.family {
            Family::ViewPlus => true,
            Family::IndexV3 { .. }
            | Family::IndexV4
            | Family::BrailleRap { .. }
            | Family::Pins { .. }
            | Family::Cells => false,
        }
    }

    /// Columns and rows of dots in a cell of text, for devices whose dots lie in such cells, with wider gaps between.
    pub(crate) fn cell_dots(&self) -> Option<[usize; 2]> {
        match self.family {
            Family::Cells => Some([2, 3]),
            Family::IndexV3 { .. }
            | Family::IndexV4
            | Family::BrailleRap { .. }
            | Family::ViewPlus
            | Family::Pins { .. } => None,
        }
    }

    /// Whether it takes sheets of paper, of which there can be several, in more than one size.
    pub(crate) fn takes_paper(&self) -> bool {
        self.field().is_none()
    }

    /// The only sheet of a pin display: its field, mm. None for devices that take paper.
    pub fn field(&self) -> Option<[f32; 2]> {
        match self.family {
            Family::Pins { columns, rows } => Some([columns, rows].map(|pins| f32::from(pins) * PIN)),
            Family::IndexV3 { .. } | Family::IndexV4 | Family::BrailleRap { .. } | Family::ViewPlus | Family::Cells => {
                None
            }
        }
    }
}

impl Pitches {
    /// This pitch, mm, as the device knows it; none if it has no such pitch.
    pub fn find(self, pitch: f32) -> Option<f32> {
        match self {
            Self::Listed(pitches) => pitches.iter().copied().find(|&listed| same(listed, pitch)),
            Self::Between(least, most) => (least..=most).contains(&pitch).then_some(pitch),
        }
    }
}

impl std::fmt::Display for Pitches {
    /// As in "1.6, 2 or 2.5 mm".
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Listed([rest @ .., last]) => {
                for (i, pitch) in rest.iter().enumerate() {
                    write!(f, "{}{pitch}", if i == 0 { "" } else { ", " })?;
                }
                write!(f, "{}{last} mm", if rest.is_empty() { "" } else { " or " })
            }
            Self::Listed([]) => f.write_str("none"),
            Self::Between(least, most) => write!(f, "any from {least} to {most} mm"),
        }
    }
}

impl Grid {
    /// Where the dot of this column and row is, if there are so many.
    pub fn at(&self, column: usize, row: usize) -> Option<MmPoint> {
        Some(MmPoint::new(*self.columns.get(column)?, *self.rows.get(row)?))
    }

    /// The column and row whose dot is nearest to a place, of two the first; none on an empty grid.
    pub fn nearest(&self, at: MmPoint) -> Option<[usize; 2]> {
        let nearest = |mm: f32, centres: &[f32]| {
            let after = centres.partition_point(|&centre| centre < mm).min(centres.len().checked_sub(1)?);
            let before = after.saturating_sub(1);
            let off = |index: usize| (centres[index] - mm).abs();
            Some(if off(before) <= off(after) { before } else { after })
        };
        Some([nearest(at.x, &self.columns)?, nearest(at.y, &self.rows)?])
    }

    /// From the first dot's centre to the last one's; an empty grid's is empty.
    pub fn bounds(&self) -> MmRect {
        let end = |at: fn(&[f32]) -> Option<&f32>| [&self.columns, &self.rows].map(|of| at(of).copied().unwrap_or(0.0));
        MmRect::new(end(<[f32]>::first).into(), end(<[f32]>::last).into())
    }
}

impl DotArea {
    /// The rectangle that holds the centres of all dots.
    pub fn bounds(&self) -> MmRect {
        match self {
            Self::Grid(grid) => grid.bounds(),
            Self::Free(rect) => *rect,
        }
    }
}

pub(super) fn same(a: f32, b: f32) -> bool {
    (a - b).abs() <= SAME
}
