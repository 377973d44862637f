//! Which sign stands for which class.

use std::str::FromStr;

use crate::Error;
use crate::classes::Class;

/// Two rows of rhombuses whose directions are nearer than this, degrees, cannot be told apart. Chosen by us: the
/// paper's four directions are 45 degrees apart; five classes of rhombuses, evenly spread, would be 36 apart.
pub const LEAST_ANGLE: f32 = 30.0;

/// What stands for a class.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sign {
    /// Rows of rhombuses that lie along the rows.
    Rhombus {
        /// Direction of the rows: degrees counter-clockwise from the x axis as a reader sees the page, from 0 to below
        /// 180.
        degrees: f32,
    },
    /// Dots on a lattice without a direction.
    Dot,
}

impl Sign {
    /// The sign as it is seen from the back of the sheet.
    #[must_use]
    pub fn mirrored(self) -> Self {
        match self {
            Self::Rhombus { degrees } => Self::Rhombus { degrees: (180.0 - degrees).rem_euclid(180.0) },
            Self::Dot => Self::Dot,
        }
    }

    /// Whether a finger can tell the two apart.
    pub fn differs_from(self, other: Self) -> bool {
        match (self, other) {
            (Self::Rhombus { degrees: a }, Self::Rhombus { degrees: b }) => {
                let apart = (a - b).rem_euclid(180.0);
                apart.min(180.0 - apart) >= LEAST_ANGLE
            }
            (Self::Dot, Self::Dot) => false,
            (Self::Dot, Self::Rhombus { .. }) | (Self::Rhombus { .. }, Self::Dot) => true,
        }
    }
}

/// As profiles and pages write it: `rhombus 45`, `dot`.
impl std::fmt::Display for Sign {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Rhombus { degrees } => write!(f, "rhombus {degrees}"),
            Self::Dot => f.write_str("dot"),
        }
    }
}

impl Sign {
    /// The sign that is written so, such as `rhombus 45` or `dot`; none if the text is no sign.
    pub(crate) fn named(text: &str) -> Option<Self> {
        let mut words = text.split_whitespace();
        let sign = match (words.next(), words.next().map(str::parse::<f32>)) {
            (Some("dot"), None) => Self::Dot,
            // Adding nothing turns minus zero, which is written oddly, into zero.
            (Some("rhombus"), Some(Ok(degrees))) if (0.0..180.0).contains(&degrees) => {
                Self::Rhombus { degrees: degrees + 0.0 }
            }
            _ => return None,
        };
        words.next().is_none().then_some(sign)
    }
}

impl FromStr for Sign {
    type Err = Error;

    /// From `rhombus 45` or `dot`.
    ///
    /// # Errors
    /// [`Error::NotASign`] for any other text.
    fn from_str(text: &str) -> Result<Self, Error> {
        Self::named(text).ok_or(Error::NotASign)
    }
}

/// The signs of all classes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Palette {
    /// In the order of [`Class::ALL`].
    pub signs: [Sign; Class::COUNT],
}

impl Palette {
    /// That of the paper (Rataj 2004), with its reasons: water lies flat; `/` is the sweep of the right hand, calm as
    /// green; then on round the colour wheel; grey has no direction, by contrast.
    pub const PAPER: Self = Self {
        signs: [
            Sign::Rhombus { degrees: 0.0 },
            Sign::Rhombus { degrees: 45.0 },
            Sign::Rhombus { degrees: 90.0 },
            Sign::Rhombus { degrees: 135.0 },
            Sign::Dot,
        ],
    };

    /// The sign of a class.
    pub fn sign(&self, class: Class) -> Sign {
        let [blue, green, yellow, red, grey] = self.signs;
        match class {
            Class::Blue => blue,
            Class::Green => green,
            Class::Yellow => yellow,
            Class::Red => red,
            Class::Grey => grey,
        }
    }

    /// The direction of a class's rows, degrees; none for dots.
    pub fn degrees(&self, class: Class) -> Option<f32> {
        match self.sign(class) {
            Sign::Rhombus { degrees } => Some(degrees),
            Sign::Dot => None,
        }
    }
}

#[cfg(test)]
mod tests;
