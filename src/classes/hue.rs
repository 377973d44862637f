//! The class of one colour: fuzzy memberships that are continuous in hue, saturation and value (HSV).
//!
//! 1. **White** is what is lighter than `white_from` (HSL lightness).
//! 2. **Grey** is what is less saturated than a bound. From [`BRIGHT`] upwards the bound falls from `min_saturation`,
//!    since a light tint beside white paper is seen as a colour sooner; below [`BRIGHT`] it rises to 1 at `min_value`,
//!    where even a pure hue is black. With the default numbers that rising part is a constant chroma (saturation times
//!    value) of 0.15.
//! 3. **The hue is corrected** before it is cut into sectors, as in the paper (Rataj 2004): darkening turns yellow to
//!    green and orange to yellow. `hue + 70 min(0.5, 1 - value)^1.5 * w(hue) * min(1, saturation / 0.4)` degrees, where
//!    `w` is 1 from 45 to 75 degrees and falls to 0 at 15 and at 160; a drab, weakly saturated brown is not seen as
//!    olive, so it turns less.
//!
//! The paper names the directions of the corrections and the four centres, not the numbers. Those here were set on a
//! list of 182 named colours (`tests/colours/named.csv`), whose test counts which are classed as a person would.
//! `docs/colours/classes.svg` shows the result; `cargo run -p tactograph-tools --bin colours -- chart` draws it.
//!
//! Every decision is a [`Membership`] first: how far a colour belongs to each class, 0 to 1, with the boundary at one
//! half. Areas are decided by the memberships of all their cells, so a sky that varies around a boundary is not split
//! into pieces.

use super::class::{Class, Params};
use crate::raster::{Planes, Raster};

/// Where the sector of a class begins and between which hues the class is typical, degrees of corrected hue; the rest
/// of the sector is a fringe towards the neighbour on that side.
struct Sector {
    class: Class,
    from: f32,
    typical: [f32; 2],
}

/// All classes but grey, in the order of the colour wheel.
///
/// Boundaries: 24 separates pinkish orange (coral, 16) and red browns (sienna, 19, at
/// most 23 when corrected) from light orange (sandy brown, 28) and brown (25); 70 a slightly dark yellow (66) from
/// olive (80); 173 is where people separate green from blue (ismy.blue, an online test of 2024, found 174 as the
/// median); 285 is half way from blue to red, by our eye: violet is bluish, purple reddish. Typical: half way from the
/// middle of the class as we see it (blue 215, green 120, yellow 54, red 0) to its boundaries.
const SECTORS: [Sector; Class::COUNT - 1] = [
    Sector { class: Class::Yellow, from: 24.0, typical: [39.0, 62.0] },
    Sector { class: Class::Green, from: 70.0, typical: [95.0, 146.0] },
    Sector { class: Class::Blue, from: 173.0, typical: [194.0, 250.0] },
    Sector { class: Class::Red, from: 285.0, typical: [322.0, 372.0] },
];

/// Degrees that a dark yellow turns for each unit of lost value to the power below: takes olive (value 0.5) from 60 to
/// 85.
const DARK_TURN: f32 = 70.0;
/// Power of the lost value: a little less than full brightness (the shaded side of a lemon) hardly turns.
const DARK_POWER: f32 = 1.5;
/// Lost value from which colours do not turn further: darker than half, a brown stays brown (dark blond hair is not
/// olive).
const DARK_FULL: f32 = 0.5;
/// HSV saturation from which dark colours turn fully.
const FULL_TURN: f32 = 0.4;
/// Value from which upwards colours are bright.
const BRIGHT: f32 = 0.75;
/// Share by which the bound on saturation falls from [`BRIGHT`] to value 1: cream and beige (0.10 at 0.96) are colours.
const PALE_FALL: f32 = 0.6;

/// Half width of the transition from one hue to the next, degrees: within it people confuse the two as well.
const HUE_TRANSITION: f32 = 12.0;
/// Half width of the transition from grey to colour, as a factor on the bound.
const GREY_TRANSITION: f32 = 1.6;
/// Half width of the transition to white, HSL lightness.
const WHITE_TRANSITION: f32 = 0.03;

/// How far a colour belongs to each class, 0 to 1; grey has what the others leave.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Membership {
    pub(super) white: f32,
    /// In the order of [`SECTORS`].
    hues: [f32; SECTORS.len()],
}

impl Membership {
    /// How many numbers a membership has.
    pub(super) const PARTS: usize = 1 + SECTORS.len();

    pub(super) fn parts(self) -> [f32; Self::PARTS] {
        let [a, b, c, d] = self.hues;
        [self.white, a, b, c, d]
    }

    pub(super) fn from_parts([white, a, b, c, d]: [f32; Self::PARTS]) -> Self {
        Self { white, hues: [a, b, c, d] }
    }

    /// Membership in a class, or in white (`None`).
    pub(super) fn share(&self, label: Option<Class>) -> f32 {
        match label {
            None => self.white,
            Some(Class::Grey) => self.grey(),
            Some(class) => {
                SECTORS.iter().zip(self.hues).filter(|(sector, _)| sector.class == class).map(|(_, share)| share).sum()
            }
        }
    }

    fn coloured(&self) -> f32 {
        self.hues.iter().sum()
    }

    fn grey(&self) -> f32 {
        (1.0 - self.white - self.coloured()).max(0.0)
    }

    /// White or not is decided first, then grey or not, then the hue: a colour between two hues does not become grey.
    pub(super) fn label(&self) -> Option<Class> {
        if self.white > 0.5 {
            return None;
        }
        if self.coloured() <= self.grey() {
            return Some(Class::Grey);
        }
        let best = SECTORS.iter().zip(self.hues).max_by(|a, b| a.1.total_cmp(&b.1));
        best.map(|(sector, _)| sector.class)
    }
}

/// The membership of a colour given as sRGB values 0..=1.
pub(super) fn membership(rgb: [f32; 3], params: &Params) -> Membership {
    let (least, value) = range(rgb);
    let white = transition((lightness(rgb) - params.white_from) / WHITE_TRANSITION);
    let saturation = if value > 0.0 { (value - least) / value } else { 0.0 };
    let bound = grey_bound(value, params);
    let coloured = if saturation <= 0.0 || value <= 0.0 {
        0.0
    } else {
        transition((saturation / bound.max(f32::MIN_POSITIVE)).ln() / GREY_TRANSITION.ln())
    };
    let coloured = coloured * (1.0 - white);
    let mut hues = [0.0; SECTORS.len()];
    if coloured > 0.0 {
        let hue = corrected(hue(rgb, least, value), saturation, value);
        let own = sector_of(hue);
        let (before, after) = ((own + SECTORS.len() - 1) % SECTORS.len(), (own + 1) % SECTORS.len());
        // Every sector is wider than two transitions, so at most one neighbour has a share.
        let above = (hue - SECTORS[own].from).rem_euclid(360.0);
        let below = (SECTORS[after].from - hue).rem_euclid(360.0);
        let (other, distance) = if above < below { (before, above) } else { (after, below) };
        hues[other] = coloured * (1.0 - transition(distance / HUE_TRANSITION));
        hues[own] = coloured - hues[other];
    }
    Membership { white, hues }
}

/// The membership of a grey given as an sRGB value 0..=1; no hue is looked at.
pub(super) fn membership_of_grey(value: f32, params: &Params) -> Membership {
    Membership { white: transition((value - params.white_from) / WHITE_TRANSITION), hues: [0.0; SECTORS.len()] }
}

/// A linear transition from 0 at -1 to 1 at 1.
fn transition(x: f32) -> f32 {
    (0.5 + 0.5 * x).clamp(0.0, 1.0)
}

fn sector_of(hue: f32) -> usize {
    SECTORS.iter().rposition(|sector| hue >= sector.from).unwrap_or(SECTORS.len() - 1)
}

/// The class of a colour given as sRGB values 0..=1; `None` is white. The blurred picture's cells are sorted by it.
pub fn class_of(rgb: [f32; 3], params: &Params) -> Option<Class> {
    membership(rgb, params).label()
}

/// The class of one pixel of a picture, by its number; `None` is white.
pub fn class_at(raster: &Raster, at: usize, params: &Params) -> Option<Class> {
    match raster.planes() {
        Planes::Colour(planes) => class_of(planes.each_ref().map(|plane| encoded(plane[at])), params),
        Planes::Grey(plane) => class_of([encoded(plane[at]); 3], params),
    }
}

/// The neighbour on the colour wheel that a colour of class `class` leans to, if it is not typical of its class.
pub fn leaning(rgb: [f32; 3], class: Class) -> Option<Class> {
    let (least, value) = range(rgb);
    let at = SECTORS.iter().position(|sector| sector.class == class)?;
    if value <= least {
        return None;
    }
    let hue = corrected(hue(rgb, least, value), (value - least) / value, value);
    let [low, high] = SECTORS[at].typical;
    let off = (hue - 0.5 * (low + high) + 180.0).rem_euclid(360.0) - 180.0;
    let half = 0.5 * (high - low);
    let count = SECTORS.len();
    if off < -half {
        Some(SECTORS[(at + count - 1) % count].class)
    } else if off > half {
        Some(SECTORS[(at + 1) % count].class)
    } else {
        None
    }
}

/// HSV saturation up to which a colour of this value is grey.
fn grey_bound(value: f32, params: &Params) -> f32 {
    let (least, black) = (params.min_saturation, params.min_value);
    let bright = BRIGHT.max(black);
    if value >= bright {
        return least * (1.0 - PALE_FALL * (value - BRIGHT) / (1.0 - BRIGHT));
    }
    // From `least` at BRIGHT to 1 at `black` and on beyond it, so that the product with the value is a line in it.
    let dark = (black / value) * (bright - value) / (bright - black).max(f32::EPSILON);
    least + (1.0 - least) * dark
}

/// HSL lightness: pure colours have 0.5, white 1.
pub(super) fn lightness(rgb: [f32; 3]) -> f32 {
    let (least, most) = range(rgb);
    0.5 * (least + most)
}

fn range([r, g, b]: [f32; 3]) -> (f32, f32) {
    (r.min(g).min(b), r.max(g).max(b))
}

/// Hue of HSV, degrees 0..360.
fn hue([r, g, b]: [f32; 3], least: f32, most: f32) -> f32 {
    let chroma = most - least;
    if chroma <= 0.0 {
        return 0.0;
    }
    let sixth = if most <= r {
        (g - b) / chroma
    } else if most <= g {
        2.0 + (b - r) / chroma
    } else {
        4.0 + (r - g) / chroma
    };
    (60.0 * sixth).rem_euclid(360.0)
}

/// The hue as people see it: step 3 of the module's list.
fn corrected(hue: f32, saturation: f32, value: f32) -> f32 {
    let weight = ((hue - 15.0) / 30.0).min((160.0 - hue) / 85.0).clamp(0.0, 1.0);
    let dark = (1.0 - value).clamp(0.0, DARK_FULL).powf(DARK_POWER);
    hue + DARK_TURN * dark * weight * (saturation / FULL_TURN).min(1.0)
}

/// Linear light to sRGB (IEC 61966-2-1).
pub(super) fn encoded(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests;
