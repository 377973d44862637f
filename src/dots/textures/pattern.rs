//! Which dots of a grid make which texture.
//!
//! ```text
//!  0 degrees     45 degrees    45, from 2.2 mm   none
//!  A A A A A A   A . . b . .   A b . . A b       A . A . A .     A is always set, b where the texture is dense.
//!  . . . . . .   . . b . . A   b . . A b .       . b . . . b     A dense texture contains the sparse one, so
//!  b b b b b b   . b . . A .   . . A b . .       A . A . A .     there are no seams. Finer grids have more empty
//!  . . . . . .   b . . A . .   . A b . . A       . . . b . .     rows between, and grey the same pattern larger,
//!                                                                or larger and turned by 45 degrees.
//! ```
//!
//! Measured (coherence as in [`crate::touch`]; a fingertip of 1.0 mm, 0.30 is a direction; dots of 1.0 to
//! 1.5 mm, and from 2.0 mm on scenes with one empty dot round each line):
//!
//! * **Straight rows** some 4.6 mm apart are felt at every pitch, 0.9 and more as single rows, 0.85 and more as
//!   double rows, with all their dots. With every second dot left out they are not felt: 0.0 to 0.2 at 2.0 and 2.5
//!   mm.
//! * **Diagonal rows** are harder, since along them dots are 1.4 pitches apart. In dots across the row, coherence at
//!   2.5 mm: every 2nd 0.00 (a checkerboard), every 3rd 0.45, every 4th 0.45, and every 4th two dots wide 0.62; at
//!   2.0 mm every 3rd 0.80, double 0.92. So on coarse grids dense means double rows. On scenes double rows are
//!   misread half as often at 2.5 mm (0.002 of places against 0.004); at 2.0 mm it is 0.0003 against 0.0006, and
//!   single rows lie nearer to one another, so that more of them fit into small areas.
//! * **Grey must have holes**, as among rhombuses: with a whole checkerboard as its dense texture a fingertip of 1.5
//!   mm reads 0.83 to 0.93 of it right, with a quarter of it left out 0.97 and more. Each is the same after a quarter
//!   turn.
//! * **Two levels** are enough: lightness and lines together select one. A third level would be bundles of rows.
//!
//! Read right on the pages that profiles ship, with two empty dots round lines, of the scenes of `tools/src/touch`
//! (`--dots PROFILE`; all kinds, seeds 1000 to 1005, never tuned to; in brackets seeds 0 to 5; the last two rows
//! before narrow areas kept one empty dot):
//!
//! | profile, pitch in mm | dot, mm | 0.5 mm | 1.0 mm | 1.5 mm | grey, 1.0 mm | grey, 1.5 mm |
//! |---|---|---|---|---|---|---|
//! | `viewplus-columbia`, 1.27 | 1.0 | 1.000 | 1.000 (1.000) | 0.999 | 1.000 | 0.997 |
//! | `index-basic-d`, 1.6 | 1.6 | 0.999 | 0.999 | 0.994 | 1.000 | 0.977 |
//! | `index-basic-d`, 2.0 | 1.6 | 0.648 | 0.996 | 0.916 | 0.991 | 0.956 |
//! | `index-basic-d`, 2.5 | 1.6 | 0.637 | 0.975 | 0.964 | 0.988 | 0.903 |
//! | `braillerap`, anywhere, 2.5 | 1.6 | 0.983 | 0.991 | 0.813 | 0.985 | 0.856 |
//! | `dot-pad`, 2.5, three rows | 1.5 | 0.619 | 0.965 (0.971) | 0.964 | 0.992 | 0.927 |
//! | `braille-cells`, 2.34 | 1.44 | 0.373 | 0.538 (0.459) | 0.598 | 0.837 | 0.728 |
//!
//! What is misread lies in narrow areas: two empty dots beside each line take 15 mm of a stripe at 2.5 mm. With
//! `dots.texture_gap` 1, 0.996 were read right at 2.5 mm.
//!
//! Diameters are those of [`crate::devices::Device::diameter`].
//!
//! **What a device cannot carry.**
//!
//! * From 2.0 mm on the finest fingertip (0.5 mm) feels single dots: diagonal rows have no direction for it
//!   (coherence 0.0 at 2.5 mm, up to 0.10 at 2.0 mm, where 0.12 is one), whatever the pattern. Straight rows do.
//! * A pitch of 3.0 mm has no diagonals at 1.0 mm either: green and red are read as grey.
//! * Braille cells of six dots carry rows (0 degrees), columns (90 degrees) and dots. Of all patterns that repeat
//!   after one to four cells, line by line the same or shifted by one or two cells, tried one by one, the most
//!   diagonal is one letter in every other cell, with a coherence of 0.38 and a direction of 62 degrees: too little.
//!   Diagonal rows are set all the same, since a broader fingertip does feel them (samples 0.88 at 1.5 mm), and
//!   [`carried`] tells which classes they leave alike.
//! * Directions other than the four [`RowDirection`]s: rows would be stairs. Each is set in the nearest of the four.
//! * Fringes: a single dot has no direction to turn.

use super::small_components::LatticeSpacing;
use crate::classes::Class;
use crate::devices::{DotArea, Grid};
use crate::textures::{Palette, Sign};

/// The directions that rows of dots can have on a grid: along its rows and columns, and its two diagonals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowDirection {
    /// 0 degrees.
    Flat,
    /// 45 degrees: up to the right.
    Up,
    /// 90 degrees.
    Upright,
    /// 135 degrees: down to the right.
    Down,
}

impl RowDirection {
    const ALL: [Self; 4] = [Self::Flat, Self::Up, Self::Upright, Self::Down];

    /// The one nearest to a direction in degrees counter-clockwise from the x axis as a reader sees the page.
    pub fn nearest(degrees: f32) -> Self {
        Self::ALL[(degrees.rem_euclid(180.0) / 45.0).round() as usize % 4]
    }

    /// Its direction, degrees counter-clockwise from the x axis as a reader sees the page.
    pub fn degrees(self) -> f32 {
        match self {
            Self::Flat => 0.0,
            Self::Up => 45.0,
            Self::Upright => 90.0,
            Self::Down => 135.0,
        }
    }
}

/// The sign of the palette as dots in this area can form it.
pub(super) fn sign(sign: Sign, area: &DotArea) -> Sign {
    match (sign, area) {
        (Sign::Rhombus { degrees }, DotArea::Grid(_)) => {
            Sign::Rhombus { degrees: RowDirection::nearest(degrees).degrees() }
        }
        (Sign::Rhombus { .. }, DotArea::Free(_)) | (Sign::Dot, _) => sign,
    }
}

/// Whether fingers can tell the classes of a palette apart on a device.
///
/// On a grid rows lie in one of four [`RowDirection`]s, each direction in the nearest. On a grid of braille cells, or
/// one coarser than 2.6 mm, the two diagonal ones cannot be told from one another nor from dots. Where dots can lie
/// anywhere, rows have the direction that the palette states.
///
/// # Errors
/// All pairs of classes that feel alike, in the order of [`Class::ALL`].
pub fn carried(palette: &Palette, area: &DotArea) -> Result<(), Vec<(Class, Class)>> {
    let is_even = |places: &[f32]| GridSteps::of(places, 0.0, 0.0).is_even();
    let is_apart = |places: &[f32]| GridSteps::of(places, 0.0, 0.0).mean > DIAGONALS_TO;
    let without_diagonals = match area {
        DotArea::Grid(Grid { columns, rows }) => {
            [columns, rows].iter().any(|places| !is_even(places) || is_apart(places))
        }
        DotArea::Free(_) => false,
    };
    let felt = |class| match sign(palette.sign(class), area) {
        Sign::Rhombus { degrees }
            if without_diagonals && matches!(RowDirection::nearest(degrees), RowDirection::Up | RowDirection::Down) =>
        {
            Sign::Dot
        }
        sign => sign,
    };
    let signs = Class::ALL.map(|class| (class, felt(class)));
    let pairs = signs.iter().enumerate().flat_map(|(i, one)| signs[i + 1..].iter().map(move |other| (one, other)));
    let alike: Vec<_> = pairs.filter(|(a, b)| !a.1.differs_from(b.1)).map(|(a, b)| (a.0, b.0)).collect();
    if alike.is_empty() { Ok(()) } else { Err(alike) }
}

/// The pattern of a class on a grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pattern {
    /// Rows of dots: of every `period` rows of the grid in this direction the first is set always, `second` where the
    /// texture is dense.
    Rows { direction: RowDirection, period: i32, second: i32 },
    /// Squares: the dots left when the grid is halved so many times, some of them only where the texture is dense.
    Spots { halvings: u32 },
}

/// Distance of rows in dense textures, mm.
const ROWS: f32 = 4.6;
/// Distance of dots in dense grey, mm.
const SPOTS: f32 = 3.2;
/// Pitch from which dense diagonal rows are double rows, mm: with more single rows they would be felt less (see above).
const COARSE: f32 = 2.2;
/// Pitch up to which diagonal rows are felt as such, mm.
const DIAGONALS_TO: f32 = 2.6;
/// Gaps between cells are wider than those in cells by more than this factor. Told from the places, as parts of a sheet
/// are asked about too; a test holds that it says the same of all devices as [`crate::devices::Device::cell_dots`].
const WIDE: f32 = 1.2;
/// Finest pitch of a grid that patterns are made for, mm: a tenth of what devices have. Chosen by us.
const FINEST: f32 = 0.1;
/// Amount of texture, 0..=1, from which it is dense.
pub(super) const DENSE_FROM: f32 = 0.6;

/// How the columns or the rows of a grid lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GridSteps {
    /// How many are in a cell, if wider gaps lie between such groups; else 1.
    count: i32,
    /// The index that patterns are counted from: the first of a cell, or the one in the middle of the picture.
    pub(super) origin: i32,
    /// Mean distance, mm; 0 where there are fewer than two.
    mean: f32,
    /// Widest gap, mm.
    widest: f32,
}

impl GridSteps {
    /// The steps between `centres`, counted from the middle of `from` and `to`.
    pub(super) fn of(centres: &[f32], from: f32, to: f32) -> Self {
        let gaps: Vec<f32> = centres.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let least = gaps.iter().copied().fold(f32::MAX, f32::min);
        let widest = gaps.iter().copied().fold(0.0, f32::max);
        let mean = gaps.iter().sum::<f32>() / gaps.len().max(1) as f32;
        let mut wide = (0..gaps.len()).filter(|&number| gaps[number] > WIDE * least);
        if let (Some(first), Some(second)) = (wide.next(), wide.next()) {
            return Self { count: (second - first) as i32, origin: first as i32 + 1, mean, widest };
        }
        let off = |number: usize| (centres[number] - 0.5 * (from + to)).abs();
        let middle = (0..centres.len()).min_by(|a, b| off(*a).total_cmp(&off(*b)));
        Self { count: 1, origin: middle.unwrap_or(0) as i32, mean, widest }
    }

    /// Whether all are the same distance apart.
    fn is_even(self) -> bool {
        self.count == 1
    }
}

impl Pattern {
    /// The pattern for a sign on a grid; none on one of a single column or row, which has no directions.
    pub(super) fn of(sign: Sign, columns: GridSteps, rows: GridSteps) -> Option<Self> {
        if ![columns, rows].iter().all(|steps| steps.mean >= FINEST) {
            return None;
        }
        let pitch = columns.mean.min(rows.mean);
        let every = |mm: f32| (mm / pitch).round() as i32;
        let Sign::Rhombus { degrees } = sign else {
            return Some(Self::Spots { halvings: (2.0 * (SPOTS / pitch).log2()).round().max(1.0) as u32 });
        };
        let direction = RowDirection::nearest(degrees);
        let straight = |steps: GridSteps| {
            if steps.is_even() {
                let second = every(ROWS).max(2);
                Self::Rows { direction, period: 2 * second, second }
            } else {
                // the first of every cell, and the last of it if that is not its neighbour
                Self::Rows { direction, period: steps.count, second: if steps.count > 2 { steps.count - 1 } else { 0 } }
            }
        };
        Some(match direction {
            RowDirection::Flat => straight(rows),
            RowDirection::Upright => straight(columns),
            RowDirection::Up | RowDirection::Down => {
                let rows = every(std::f32::consts::SQRT_2 * ROWS);
                if pitch >= COARSE {
                    Self::Rows { direction, period: rows.max(4), second: 1 }
                } else {
                    Self::Rows { direction, period: 2 * rows, second: rows }
                }
            }
        })
    }

    /// The amount of texture from which the dot in column `x` and row `y` of the grid, counted from
    /// [`GridSteps::origin`], is set; below 0 if it always is.
    pub(super) fn needed_amount(self, x: i32, y: i32) -> f32 {
        match self {
            Self::Rows { direction, period, second } => {
                let across = match direction {
                    RowDirection::Flat => y,
                    RowDirection::Up => x + y,
                    RowDirection::Upright => x,
                    RowDirection::Down => y - x,
                };
                match across.rem_euclid(period) {
                    0 => -1.0,
                    row if row == second => DENSE_FROM,
                    _ => f32::INFINITY,
                }
            }
            Self::Spots { halvings } => of_spot(x, y, halvings),
        }
    }

    /// How far the dots of the sparsest texture are apart.
    pub(super) fn spacing(self, columns: GridSteps, rows: GridSteps, pitch: f32) -> LatticeSpacing {
        let (mean, slope) = (columns.mean.max(rows.mean), columns.widest.hypot(rows.widest));
        let (along, across) = match self {
            Self::Rows { direction: RowDirection::Flat, period, .. } => (columns.widest, period as f32 * rows.mean),
            Self::Rows { direction: RowDirection::Upright, period, .. } => (rows.widest, period as f32 * columns.mean),
            Self::Rows { period, .. } => (slope, period as f32 * mean * std::f32::consts::FRAC_1_SQRT_2),
            Self::Spots { halvings } => (slope, mean * 2.0_f32.powf(0.5 * (halvings + 1) as f32)),
        };
        // on even grids rows are straight; between cells they have kinks
        let kink = (columns.widest.max(rows.widest) - pitch).max(0.0) * std::f32::consts::FRAC_1_SQRT_2;
        LatticeSpacing { pitch, along, off: 0.3 * pitch + kink, across }
    }
}

/// Each halving keeps every other black square of a checkerboard, which is a checkerboard turned by 45 degrees. As
/// complex numbers x + iy these are the multiples of a power of 1 + i (quincunx subsampling).
fn of_spot(x: i32, y: i32, halvings: u32) -> f32 {
    // Shifted so that the pattern of the optional dots is symmetric about the middle of the picture.
    let middle = if halvings % 2 == 1 { 1 << (halvings / 2) } else { 0 };
    let (mut x, mut y) = (x + middle, y + middle);
    for _ in 0..halvings {
        if (x + y) % 2 != 0 {
            return f32::INFINITY;
        }
        (x, y) = ((x + y) / 2, (y - x) / 2);
    }
    match ((x + y) % 2 == 0, y % 2 == 0) {
        (true, _) => -1.0,
        (false, true) => DENSE_FROM,
        (false, false) => f32::INFINITY,
    }
}

#[cfg(test)]
mod tests;
