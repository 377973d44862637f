//! Which dots of a grid make which texture.

use crate::classes::Class;
use crate::devices::Room;
use crate::textures::{Palette, Sign};

/// The directions that rows of dots can have on a grid: along its rows and columns, and its two diagonals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// 0 degrees.
    Flat,
    /// 45 degrees: up to the right.
    Up,
    /// 90 degrees.
    Upright,
    /// 135 degrees: down to the right.
    Down,
}

impl Way {
    const ALL: [Self; 4] = [Self::Flat, Self::Up, Self::Upright, Self::Down];

    /// The way nearest to a direction in degrees counter-clockwise from the x axis as a reader sees the page.
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

/// The sign that dots make of a sign of the palette.
pub(super) fn sign(sign: Sign, room: &Room) -> Sign {
    match (sign, room) {
        (Sign::Rhombus { degrees }, Room::Grid(_)) => Sign::Rhombus { degrees: Way::nearest(degrees).degrees() },
        _ => sign,
    }
}

/// Whether fingers can tell the classes of a palette apart on a device.
///
/// On a grid rows lie in one of four [`Way`]s, each direction in the nearest. On a grid of braille cells the two diagonal ones
/// are not told from one another nor from dots. Where dots can stand anywhere, rows lie as asked for.
///
/// # Errors
/// All pairs of classes that feel alike, in the order of [`Class::ALL`].
pub fn carried(palette: &Palette, room: &Room) -> Result<(), Vec<(Class, Class)>> {
    let is_even = |places: &[f32]| Steps::of(places, 0.0, 0.0).is_even();
    let in_cells = matches!(room, Room::Grid(grid) if !is_even(&grid.columns) || !is_even(&grid.rows));
    let felt = |class| match sign(palette.sign(class), room) {
        Sign::Rhombus { degrees } if in_cells && matches!(Way::nearest(degrees), Way::Up | Way::Down) => Sign::Dot,
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
    /// Rows of dots: of every `period` rows of the grid in this direction the first is set always, `second` where the texture
    /// is dense.
    Rows { way: Way, period: i32, second: i32 },
    /// Squares: the dots left when the grid is halved so many times, some of them where the texture is dense.
    Spots { halvings: u32 },
}

/// Distance of rows in dense textures, mm.
const ROWS: f32 = 4.6;
/// Distance of dots in dense grey, mm.
const SPOTS: f32 = 3.2;
/// Pitch from which on diagonal rows get dense by getting thick, mm: more rows would be too near.
const COARSE: f32 = 1.8;
/// Gaps between cells are wider than those in cells by more than this.
const WIDE: f32 = 1.2;
/// Amount of texture, 0..=1, from which it is dense.
pub(super) const DENSE_FROM: f32 = 0.6;

/// How the columns or the rows of a grid lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Steps {
    /// How many are in a cell, if wider gaps lie between such groups; else 1.
    count: i32,
    /// The one that patterns are counted from: the first of a cell, or the one in the middle of the picture.
    pub(super) origin: i32,
    /// Mean distance, mm.
    mean: f32,
    /// Widest gap, mm.
    widest: f32,
}

impl Steps {
    /// How `places` lie, seen from the middle between two of them.
    pub(super) fn of(places: &[f32], from: f32, to: f32) -> Self {
        let gaps: Vec<f32> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let least = gaps.iter().copied().fold(f32::MAX, f32::min);
        let widest = gaps.iter().copied().fold(0.0, f32::max);
        let mean = gaps.iter().sum::<f32>() / gaps.len().max(1) as f32;
        let mut wide = (0..gaps.len()).filter(|&number| gaps[number] > WIDE * least);
        if let (Some(first), Some(second)) = (wide.next(), wide.next()) {
            return Self { count: (second - first) as i32, origin: first as i32 + 1, mean, widest };
        }
        let off = |number: usize| (places[number] - 0.5 * (from + to)).abs();
        let middle = (0..places.len()).min_by(|a, b| off(*a).total_cmp(&off(*b)));
        Self { count: 1, origin: middle.unwrap_or(0) as i32, mean, widest }
    }

    /// Whether all are the same distance apart.
    fn is_even(self) -> bool {
        self.count == 1
    }
}

impl Pattern {
    /// The pattern for a sign on a grid.
    pub(super) fn of(sign: Sign, columns: Steps, rows: Steps) -> Self {
        let pitch = columns.mean.min(rows.mean).max(f32::MIN_POSITIVE);
        let every = |mm: f32| (mm / pitch).round() as i32;
        let Sign::Rhombus { degrees } = sign else {
            return Self::Spots { halvings: (2.0 * (SPOTS / pitch).log2()).round().max(1.0) as u32 };
        };
        let way = Way::nearest(degrees);
        let straight = |steps: Steps| {
            if steps.is_even() {
                let second = every(ROWS).max(2);
                Self::Rows { way, period: 2 * second, second }
            } else {
                // the first of every cell, and the last of it if that is not its neighbour
                Self::Rows { way, period: steps.count, second: if steps.count > 2 { steps.count - 1 } else { 0 } }
            }
        };
        match way {
            Way::Flat => straight(rows),
            Way::Upright => straight(columns),
            Way::Up | Way::Down => {
                let rows = every(std::f32::consts::SQRT_2 * ROWS).max(4);
                let second = if pitch >= COARSE { 1 } else { rows };
                Self::Rows { way, period: if second == 1 { rows } else { 2 * rows }, second }
            }
        }
    }

    /// The amount of texture from which the dot in column `x` and row `y` of the grid, counted from [`Steps::origin`], is
    /// set; below 0 if it always is.
    pub(super) fn from_amount(self, x: i32, y: i32) -> f32 {
        match self {
            Self::Rows { way, period, second } => {
                let across = match way {
                    Way::Flat => y,
                    Way::Up => x + y,
                    Way::Upright => x,
                    Way::Down => y - x,
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

    /// Dots of a texture are no further apart than this, mm.
    pub(super) fn reach(self, columns: Steps, rows: Steps) -> f32 {
        let mean = columns.mean.max(rows.mean);
        let apart = match self {
            Self::Rows { way: Way::Flat, period, .. } => period as f32 * rows.mean,
            Self::Rows { way: Way::Upright, period, .. } => period as f32 * columns.mean,
            Self::Rows { period, .. } => period as f32 * mean * std::f32::consts::FRAC_1_SQRT_2,
            Self::Spots { halvings } => mean * 2.0_f32.powf(0.5 * (halvings + 1) as f32),
        };
        apart.max(columns.widest.hypot(rows.widest))
    }
}

/// Every step halves the grid: what is left of a checkerboard's black squares is a checkerboard turned by 45 degrees. In
/// complex numbers x + iy it is what can be divided by 1 + i once more.
fn of_spot(x: i32, y: i32, halvings: u32) -> f32 {
    let (mut x, mut y) = (x, y);
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
