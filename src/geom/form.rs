//! Which form an open line has, as far as it is certain, and from where to where it leads.

use super::{polyline, right_of};
use crate::units::{MmPoint, MmVector};

/// An open line is straight if its ends are so far apart, of its length, and it lies nowhere farther off the straight
/// between them than this share of that, or than a finger finds. An arc so far off turns by 9 degrees from end to end,
/// as much as a level line may be off level. The first alone takes an arc that turns by 49 degrees.
const STRAIGHTNESS: f32 = 0.97;
const OFF_STRAIGHT: f32 = 0.02;
/// From so far apart on, of its length, it is told how far the line lies off the straight between its ends; an arc that
/// turns by 146 degrees. Chosen by us: of a hook that says little.
const NEARLY_STRAIGHT: f32 = 0.75;
/// A straight line is level or upright within 10 degrees.
const LEVEL: f32 = 0.985;
/// Where the ends of a line are nearer to one another than this share of its length, it is not said from where to where
/// it leads. Chosen by us: of a hook that says little.
const FAR_APART: f32 = 0.5;

/// How far a line of a page may lie off the straight between its ends and be told as straight, and an open rectangle
/// off its sides, mm.
pub const SLACK: f32 = 1.0;

/// Which form an open line has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Straight, and level.
    Level,
    /// Straight, and upright.
    Upright,
    /// Straight, and neither.
    Slanting,
    /// Bent so much that nothing more is said.
    Bent,
    /// On both sides of the straight between its ends.
    Winding,
    /// On one side of it.
    Bowed,
}

/// The form of an open line, and how it lies beside the straight between its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OpenForm {
    /// Which one it is.
    pub form: Form,
    /// How far it lies off that straight, mm.
    pub off: f32,
    /// The step from there to where it lies farthest off.
    pub aside: MmVector,
}

impl OpenForm {
    /// That of a line along `path`, of this length and so far off a straight line at most where it is one, mm.
    pub fn of(path: &[MmPoint], length: f32, slack: f32) -> Self {
        let [first, last] = ends(path);
        let chord = last - first;
        let along = chord.length();
        let side = right_of(chord) / along.max(f32::MIN_POSITIVE);
        let off = path.iter().map(|at| (*at - first).dot(side));
        let (least, most) = off.fold((0.0_f32, 0.0_f32), |(least, most), off| (least.min(off), most.max(off)));
        let (limit, far) = (slack.max(OFF_STRAIGHT * along), most.max(-least));
        let aside = side * (if most >= -least { most } else { least });
        let [dx, dy] = [chord.x, chord.y].map(|way| way.abs() / along.max(f32::MIN_POSITIVE));
        let form = match far <= limit {
            true if along < STRAIGHTNESS * length => Form::Bent,
            true if dx >= LEVEL => Form::Level,
            true if dy >= LEVEL => Form::Upright,
            true => Form::Slanting,
            false if along < NEARLY_STRAIGHT * length => Form::Bent,
            false if most > limit && -least > limit => Form::Winding,
            false => Form::Bowed,
        };
        Self { form, off: far, aside }
    }
}

/// The two ends of a path.
fn ends(path: &[MmPoint]) -> [MmPoint; 2] {
    [path.first(), path.last()].map(|end| end.copied().unwrap_or_default())
}

/// From where to where an open line leads, in words and from its left end; nothing where its ends are near to one
/// another.
pub fn from_to(path: &[MmPoint]) -> &'static str {
    let [first, last] = ends(path);
    let (chord, length) = (last - first, polyline::length(path));
    let along = chord.length();
    if along <= 0.0 || along < FAR_APART * length {
        return "";
    }
    match (chord.x.abs() >= LEVEL * along, chord.y.abs() >= LEVEL * along) {
        (true, _) => "from left to right",
        (_, true) => "from top to bottom",
        _ if (chord.x > 0.0) == (chord.y > 0.0) => "from upper left to lower right",
        _ => "from lower left to upper right",
    }
}

#[cfg(test)]
mod tests;
