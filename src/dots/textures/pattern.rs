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

/// Whether a device can tell the classes of a palette apart.
///
/// On a grid rows lie in one of four [`Way`]s, each direction in the nearest; where dots can stand anywhere, they lie as
/// asked for.
///
/// # Errors
/// All pairs of classes that would feel alike.
pub fn carried(palette: &Palette, room: &Room) -> Result<(), Vec<(Class, Class)>> {
    let signs = Class::ALL.map(|class| (class, sign(palette.sign(class), room)));
    let pairs = signs.iter().enumerate().flat_map(|(i, one)| signs[i + 1..].iter().map(move |other| (one, other)));
    let alike: Vec<_> = pairs.filter(|(a, b)| !a.1.differs_from(b.1)).map(|(a, b)| (a.0, b.0)).collect();
    if alike.is_empty() { Ok(()) } else { Err(alike) }
}

/// The pattern of a class on a grid.
#[derive(Debug, Clone, Copy)]
pub(super) enum Pattern {
    /// Rows of dots: of every `period` rows in this direction the first is set always, `second` where the texture is dense.
    Rows { way: Way, period: i32, second: i32 },
    /// Squares: dots of which every one is set in the `steps`-th halving of the grid, others where the texture is dense.
    Spots { steps: u32 },
}

/// Amount of texture (0..=1) from which it is dense.
pub(super) const DENSE_FROM: f32 = 0.6;
/// The same for the first half of the dots of grey that come and go.
const GREY_FROM: [f32; 2] = [0.45, 0.7];

impl Pattern {
    pub(super) fn of(sign: Sign, pitch: f32) -> Self {
        let every = |mm: f32, least: i32| ((mm / pitch).round() as i32).max(least);
        match sign {
            Sign::Rhombus { degrees } => {
                let way = Way::nearest(degrees);
                match way {
                    Way::Flat | Way::Upright => {
                        let second = every(4.6, 2);
                        Self::Rows { way, period: 2 * second, second }
                    }
                    Way::Up | Way::Down => {
                        let rows = every(4.6 * std::f32::consts::SQRT_2, 4);
                        if pitch >= 1.8 {
                            Self::Rows { way, period: rows, second: 1 }
                        } else {
                            Self::Rows { way, period: 2 * rows, second: rows }
                        }
                    }
                }
            }
            Sign::Dot => {
                let steps = (2.0 * (3.2 / pitch).log2()).round().max(1.0) as u32;
                Self::Spots { steps }
            }
        }
    }

    /// The amount of texture from which the dot in column `x` and row `y` of the grid, counted from the middle of the
    /// picture, is set; below 0 if it always is.
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
            Self::Spots { steps } => of_spot(x, y, steps),
        }
    }

    /// Distance of the rows or dots of the sparsest texture, mm.
    pub(super) fn reach(self, pitch: f32) -> f32 {
        match self {
            Self::Rows { way: Way::Flat | Way::Upright, period, .. } => period as f32 * pitch,
            Self::Rows { period, .. } => period as f32 * pitch * std::f32::consts::FRAC_1_SQRT_2,
            Self::Spots { steps } => pitch * 2.0_f32.powf(0.5 * (steps + 1) as f32),
        }
    }
}

/// Every step halves the grid: what is left of a checkerboard's black squares is a checkerboard turned by 45 degrees. In
/// complex numbers x + iy it is what can be divided by 1 + i once more.
fn of_spot(x: i32, y: i32, steps: u32) -> f32 {
    let (mut x, mut y) = (x, y);
    for _ in 0..steps {
        if (x + y) % 2 != 0 {
            return f32::INFINITY;
        }
        (x, y) = ((x + y) / 2, (y - x) / 2);
    }
    match ((x + y) % 2 == 0, y % 2 == 0) {
        (true, _) => -1.0,
        (false, true) => GREY_FROM[0],
        (false, false) => GREY_FROM[1],
    }
}
