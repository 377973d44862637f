//! Glyphs: rhombuses and dots, bold where the colour is dark.

use super::palette::Sign;
use super::params::Params;
use crate::classes::Class;
use crate::geom::{nearest_on_segment, right_of, segment_distance};
use crate::units::{MmPoint, MmVector};

/// A mark of a texture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glyph {
    /// Its centre on the sheet.
    pub at: MmPoint,
    /// What it is.
    pub shape: Shape,
}

/// The shape of a glyph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A diamond.
    Rhombus {
        /// Long diagonal, mm.
        length: f32,
        /// Short diagonal, mm.
        thickness: f32,
        /// Direction of the long diagonal: degrees counter-clockwise from the x axis as a reader sees the page,
        /// from 0 to below 180.
        degrees: f32,
    },
    /// A disc.
    Dot {
        /// Its diameter, mm.
        diameter: f32,
    },
}

/// The texture of one region.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The class of its colour.
    pub class: Class,
    /// The sign that stands for it.
    pub sign: Sign,
    /// The region's mean colour as sRGB red, green and blue.
    pub colour: [u8; 3],
    /// The region's area, including the gaps between glyphs, mm^2.
    pub area: f32,
    /// Its glyphs, row by row.
    pub glyphs: Vec<Glyph>,
}

/// How far a rhombus may be turned from the sign of its texture before it is another one, degrees: half the angle
/// between two directions of six.
const TURNED: f32 = 15.0;

impl Texture {
    /// Whether most of its glyphs are no signs of its class, as where somebody moved them to another group.
    pub fn has_other_signs(&self) -> bool {
        let is_other = |glyph: &&Glyph| match (glyph.shape, self.sign) {
            (Shape::Rhombus { degrees, .. }, Sign::Rhombus { degrees: sign }) => {
                let apart = (degrees - sign).rem_euclid(180.0);
                apart.min(180.0 - apart) > TURNED
            }
            (Shape::Dot { .. }, Sign::Dot) => false,
            (Shape::Dot { .. }, Sign::Rhombus { .. }) | (Shape::Rhombus { .. }, Sign::Dot) => true,
        };
        2 * self.glyphs.iter().filter(is_other).count() > self.glyphs.len()
    }
}

/// HSL lightness from which down a glyph is as bold as it gets. Chosen by us: dark shades (half of pure colours' 0.5
/// and less) are few in pictures, and more ink only fills the gaps between glyphs.
const BOLDEST_AT: f32 = 0.25;
/// Length of the lightest rhombus as a share of the boldest one's: it stays long enough to point somewhere.
const LIGHTEST_LENGTH: f32 = 0.75;
/// Diameter of the lightest dot as a share of the boldest one's.
const LIGHTEST_DOT: f32 = 0.6;

/// Below this boldness glyphs do not shrink further (they are the smallest already) but go, row after row. At the
/// profile's `white_from` of 0.92 that is lightness 0.892 to 0.92: just wide enough that no step of 256 takes more than
/// 8 % of full ink, so that pale skies keep their rows as long as can be.
const FADING: f32 = 0.042;

/// The unit vector on the sheet (y down) that points along `degrees` as a reader sees it (y up).
pub(crate) fn unit(degrees: f32) -> MmVector {
    let (sin, cos) = degrees.to_radians().sin_cos();
    MmVector::new(cos, -sin)
}

/// How bold a colour of this lightness is: 0 at white, 1 from [`BOLDEST_AT`] down.
pub(super) fn boldness(lightness: f32, params: &Params) -> f32 {
    boldness_of(lightness, params.white_from)
}

/// [`boldness`] where colours are white from `white_from` on.
pub(crate) fn boldness_of(lightness: f32, white_from: f32) -> f32 {
    let range = (white_from - BOLDEST_AT).max(f32::EPSILON);
    ((white_from - lightness) / range).clamp(0.0, 1.0)
}

/// The glyph of a class with this boldness. It never is smaller than the least that can be felt; where a colour fades
/// to white, [`is_left`] leaves out one after the other instead.
pub(super) fn bold(class: Class, at: MmPoint, boldness: f32, params: &Params) -> Glyph {
    let between = |least: f32, most: f32| least + (most - least) * boldness;
    let shape = match params.palette.degrees(class) {
        Some(degrees) => Shape::Rhombus {
            length: params.length * between(LIGHTEST_LENGTH, 1.0),
            thickness: between(params.min_glyph, params.thickness),
            degrees,
        },
        None => Shape::Dot { diameter: between((LIGHTEST_DOT * params.dot).max(params.min_glyph), params.dot) },
    };
    Glyph { at, shape }
}

/// Whether a glyph that needs `from_boldness` (0..1 of [`FADING`]) is there at this boldness.
pub(super) fn is_left(from_boldness: f32, boldness: f32) -> bool {
    boldness > FADING * from_boldness
}

impl Glyph {
    /// Farthest extent from the centre, mm.
    pub fn radius(&self) -> f32 {
        match self.shape {
            Shape::Rhombus { length, thickness, .. } => 0.5 * length.max(thickness),
            Shape::Dot { diameter } => 0.5 * diameter,
        }
    }

    /// A rhombus turned to another direction; a dot stays as it is.
    pub(super) fn turned(self, to: f32) -> Self {
        match self.shape {
            Shape::Rhombus { length, thickness, .. } => {
                Self { at: self.at, shape: Shape::Rhombus { length, thickness, degrees: to } }
            }
            Shape::Dot { .. } => self,
        }
    }

    /// The corners of a rhombus in order; for a dot the ends of its four main radii.
    pub fn corners(&self) -> [MmPoint; 4] {
        let (along, length, thickness) = match self.shape {
            Shape::Rhombus { length, thickness, degrees } => (unit(degrees), length, thickness),
            Shape::Dot { diameter } => (MmVector::new(1.0, 0.0), diameter, diameter),
        };
        let across = right_of(along);
        let (along, across) = (along * (0.5 * length), across * (0.5 * thickness));
        [self.at + along, self.at + across, self.at - along, self.at - across]
    }

    /// Ink, mm^2.
    pub fn area(&self) -> f32 {
        match self.shape {
            Shape::Rhombus { length, thickness, .. } => 0.5 * length * thickness,
            Shape::Dot { diameter } => std::f32::consts::PI * 0.25 * diameter * diameter,
        }
    }

    /// Distance of the glyph's outline to a segment, mm. `corners` are its own, given so that they are computed once.
    pub(super) fn distance_to(&self, segment: (MmPoint, MmPoint), corners: &[MmPoint]) -> f32 {
        match self.shape {
            Shape::Dot { diameter } => nearest_on_segment(self.at, segment.0, segment.1).0 - 0.5 * diameter,
            Shape::Rhombus { .. } => (0..corners.len())
                .map(|i| segment_distance((corners[i], corners[(i + 1) % corners.len()]), segment))
                .fold(f32::MAX, f32::min),
        }
    }

    /// Distance of the outlines of two glyphs, neither of which lies in the other, mm; less than 0 where discs overlap.
    pub(crate) fn distance_to_glyph(&self, other: &Self) -> f32 {
        let is_dot = |glyph: &Self| matches!(glyph.shape, Shape::Dot { .. });
        if is_dot(self) && is_dot(other) {
            return (self.at - other.at).length() - self.radius() - other.radius();
        }
        let (from, to) = if is_dot(other) { (other, self) } else { (self, other) };
        let (own, corners) = (from.corners(), to.corners());
        let sides = (0..corners.len()).map(|i| (corners[i], corners[(i + 1) % corners.len()]));
        sides.map(|side| from.distance_to(side, &own)).fold(f32::MAX, f32::min)
    }
}

#[cfg(test)]
mod tests;
