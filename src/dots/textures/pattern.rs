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
/// Gaps between cells are wider than those in cells by more than this factor.
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
mod tests {
    use super::*;
    use crate::units::{MmPoint, MmRect};

    fn even(pitch: f32) -> GridSteps {
        let places: Vec<f32> = (0..61).map(|i| i as f32 * pitch).collect();
        GridSteps::of(&places, 0.0, 60.0 * pitch)
    }

    fn of(degrees: Option<f32>, pitch: f32) -> Pattern {
        let sign = degrees.map_or(Sign::Dot, |degrees| Sign::Rhombus { degrees });
        Pattern::of(sign, even(pitch), even(pitch)).expect("a grid of many dots")
    }

    fn drawn(pattern: Pattern, amount: f32) -> Vec<String> {
        let dot = |x, y| if pattern.needed_amount(x, y) <= amount { 'o' } else { '.' };
        (0..6).map(|y| (0..12).map(|x| dot(x, y)).collect()).collect()
    }

    #[test]
    fn rows_run_as_a_reader_sees_them() {
        for (degrees, sparse, dense) in [
            (
                0.0,
                ["oooooooooooo", "............", "............", "............", "oooooooooooo", "............"],
                ["oooooooooooo", "............", "oooooooooooo", "............", "oooooooooooo", "............"],
            ),
            (
                45.0,
                ["o...o...o...", "...o...o...o", "..o...o...o.", ".o...o...o..", "o...o...o...", "...o...o...o"],
                ["oo..oo..oo..", "o..oo..oo..o", "..oo..oo..oo", ".oo..oo..oo.", "oo..oo..oo..", "o..oo..oo..o"],
            ),
            (90.0, ["o...o...o..."; 6], ["o.o.o.o.o.o."; 6]),
            (
                135.0,
                ["o...o...o...", ".o...o...o..", "..o...o...o.", "...o...o...o", "o...o...o...", ".o...o...o.."],
                ["o..oo..oo..o", "oo..oo..oo..", ".oo..oo..oo.", "..oo..oo..oo", "o..oo..oo..o", "oo..oo..oo.."],
            ),
        ] {
            assert_eq!(drawn(of(Some(degrees), 2.5), 0.0), sparse, "{degrees} degrees, sparse");
            assert_eq!(drawn(of(Some(degrees), 2.5), 1.0), dense, "{degrees} degrees, dense");
        }
    }

    #[test]
    fn grey_is_the_same_after_a_quarter_turn_about_one_of_its_dots() {
        for pitch in [1.27, 1.6, 2.0, 2.5, 3.0] {
            for amount in [0.0, 1.0] {
                let pattern = of(None, pitch);
                let is_set = |x, y| pattern.needed_amount(x, y) <= amount;
                let dots = || (-9..9).flat_map(|y| (-9..9).map(move |x| (x, y)));
                let turns = |(x, y): (i32, i32)| dots().all(|(i, j)| is_set(x + i, y + j) == is_set(x - j, y + i));
                assert!(dots().any(|at| is_set(at.0, at.1) && turns(at)), "{pitch} mm at {amount}");
            }
        }
    }

    #[test]
    fn rows_and_dots_lie_as_far_apart_as_was_measured() {
        for (pitch, straight, diagonal, grey) in
            [(1.27, 5.08, 4.49, 3.59), (1.6, 4.8, 4.53, 3.2), (2.0, 4.0, 4.24, 2.83), (2.5, 5.0, 7.07, 3.54)]
        {
            let rows = |degrees, unit: f32| match of(Some(degrees), pitch) {
                Pattern::Rows { period, second: 1, .. } => period as f32 * unit,
                Pattern::Rows { second, .. } => second as f32 * unit,
                Pattern::Spots { .. } => f32::NAN,
            };
            let slope = pitch * std::f32::consts::FRAC_1_SQRT_2;
            let Pattern::Spots { halvings } = of(None, pitch) else { unreachable!("grey has no rows") };
            let spots = pitch * 2.0_f32.powf(0.5 * halvings as f32);
            let found = [rows(0.0, pitch), rows(90.0, pitch), rows(45.0, slope), rows(135.0, slope), spots];
            let near = |(a, b): (&f32, f32)| (a - b).abs() < 0.01;
            assert!(found.iter().zip([straight, straight, diagonal, diagonal, grey]).all(near), "{pitch}: {found:?}");
        }
    }

    #[test]
    fn cells_are_seen_as_such_and_even_grids_as_even() {
        let cells: Vec<f32> = (0..30).map(|i| 11.0 + (i / 3) as f32 * 10.0 + (i % 3) as f32 * 2.34).collect();
        let steps = GridSteps::of(&cells, 11.0, 105.0);
        assert_eq!((steps.count, steps.origin % 3), (3, 0));
        assert!(even(2.0).is_even() && even(2.0).origin == 30);
        let flat = Pattern::of(Sign::Rhombus { degrees: 0.0 }, steps, steps).expect("a grid of many dots");
        let set_at = |amount: f32| [0, 1, 2].map(|y| flat.needed_amount(7, y) <= amount);
        assert_eq!((set_at(0.0), set_at(1.0)), ([true, false, false], [true, false, true]));
        let few = GridSteps::of(&[3.0], 0.0, 9.0);
        assert!(few.is_even() && GridSteps::of(&[], 0.0, 9.0).is_even(), "a device with hardly a dot does no harm");
        assert_eq!(few.origin, 0);
    }

    #[test]
    fn one_column_or_row_has_no_pattern() {
        let of = |places: &[f32]| GridSteps::of(places, 0.0, 9.0);
        let signs = [0.0, 45.0, 90.0, 135.0].map(|degrees| Sign::Rhombus { degrees }).into_iter().chain([Sign::Dot]);
        for sign in signs {
            for few in [&[][..], &[3.0], &[3.0, 3.0], &[3.0, 3.0 + 1e-6], &[3.0, f32::NAN]] {
                assert_eq!(Pattern::of(sign, of(few), even(2.5)), None, "{sign:?}, columns at {few:?}");
                assert_eq!(Pattern::of(sign, even(2.5), of(few)), None, "{sign:?}, rows at {few:?}");
            }
            assert!(Pattern::of(sign, of(&[3.0, 5.5]), even(2.5)).is_some(), "{sign:?}, two columns");
        }
    }

    #[test]
    fn palettes_that_a_device_cannot_carry_are_told() {
        let grid = |rows: Vec<f32>| DotArea::Grid(Grid { columns: (0..40).map(|i| i as f32 * 2.5).collect(), rows });
        let even = grid((0..40).map(|i| i as f32 * 2.5).collect());
        let cells = grid((0..30).map(|i| (i / 3) as f32 * 10.0 + (i % 3) as f32 * 2.5).collect());
        let free = DotArea::Free(MmRect::new(MmPoint::zero(), MmPoint::new(90.0, 90.0)));
        let mut leaning = Palette::PAPER;
        leaning.signs[0] = Sign::Rhombus { degrees: 30.0 };
        leaning.signs[1] = Sign::Rhombus { degrees: 60.0 };
        let (green, red, grey) = (Class::Green, Class::Red, Class::Grey);
        assert_eq!(carried(&Palette::PAPER, &even), Ok(()));
        assert_eq!(carried(&Palette::PAPER, &free), Ok(()));
        assert_eq!(carried(&Palette::PAPER, &cells), Err(vec![(green, red), (green, grey), (red, grey)]));
        let coarse: Vec<f32> = (0..40).map(|i| i as f32 * 3.0).collect();
        let coarse = DotArea::Grid(Grid { columns: coarse.clone(), rows: coarse });
        assert_eq!(carried(&Palette::PAPER, &coarse), Err(vec![(green, red), (green, grey), (red, grey)]));
        assert_eq!(carried(&leaning, &free), Ok(()));
        assert_eq!(carried(&leaning, &even), Err(vec![(Class::Blue, green)]));
    }
}
