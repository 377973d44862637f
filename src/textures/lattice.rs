//! The positions of glyphs: one lattice for each class over the whole picture, so that regions of one colour share
//! their rows, and the density of lines from which on each position is filled.
//!
//! ```text
//!   x   x   x   x     base row                A 1 . A 2 . A    A is filled always, a hexagonal lattice;
//!     o   o   o       filled where dense       . A 3 . A 1 .   1, 2, 3 from one density to the next, each a
//!   x   x   x   x     base row                  1 . A 2 . A    hexagonal lattice too; the points never:
//!                                                              dense grey is a honeycomb
//! ```
//!
//! What was learned by measuring (a fingertip of 1.5 mm is the hard case; coherence, and the share read right in the
//! scenes of `tools/src/touch`):
//!
//! * **A row must outlast the blur.** A fingertip f leaves the fraction exp(-2 pi^2 f^2 / d^2) of rows at a distance d:
//!   at 1.5 mm 0.02 of rows 3.4 mm apart, 0.06 of rows 4.0 mm apart. The share of all positions that is read right at
//!   1.5 mm follows:
//!
//!   | rows, mm | 3.4 | 3.6 | 3.8 | 4.0 | 4.2 |
//!   |---|---|---|---|---|---|
//!   | read right | 0.72 | 0.87 | 0.94 | 0.988 | 0.995 |
//!
//!   4.0 is taken: little is left to gain, and nearer rows show smaller areas. Boldness hardly matters
//!   (coherence 0.80 for the lightest glyphs, 0.78 for the boldest), nor does it whether rhombuses stand 2.4 or 2.8 mm
//!   apart in a row.
//! * **Whole rows are added and left out**, never single rhombuses of one: a row of half its rhombuses has a period of
//!   two of them, and that is felt across the rows. Coherence fell from 0.5 to 0.2 where rows thinned out. The same
//!   where a colour fades: a pale sky that lost single rhombuses was felt as grey all over; losing rows it is felt as
//!   blue.
//! * **Two densities of rows are enough.** With three (every fourth row left out in between) the number of glyphs
//!   follows the map of lines as well (correlation 0.95 both), but bundles of three rows look and feel like a pattern
//!   of their own, and a little more is misread (0.006 against 0.004). Five are worse than two: their rows stand at
//!   uneven distances.
//! * **Grey needs structure of its own.** A full hexagonal lattice of 3 mm is flat under a fingertip of 1.5 mm, so that
//!   the next edge of the texture is all that is felt, and that has a direction: 0.90 of grey was read as grey. A
//!   honeycomb of the same distance has holes that are felt, alike on all sides: 0.95 with all else the same, and with
//!   the rest as it is now 0.974, 0.978, 0.992 and 0.988 at 2.8, 3.0, 3.2 and 3.4 mm.
//! * **Grey gets dense in small steps.** With a jump from a third of the positions to all, the change of ink itself is
//!   felt as a direction (coherence up to 0.44, where 0.35 is a direction); in steps of a ninth up to 0.31. Each step
//!   must be isotropic. In numbers a + b w, with w a third root of 1, the positions divisible by 1 - w are A, and the
//!   remainder by 3 says which of nine hexagonal lattices a position belongs to: a union of such lattices looks the
//!   same after a third of a turn about some position, and what has three equal axes has no direction.
//!
//! Every position of a density is a position of all higher ones. So there are no seams: where the density changes, no
//! gap is wider than in the sparser texture and none narrower than in the denser one.

use super::glyph::unit;
use super::params::Params;
use crate::classes::Class;
use crate::units::{MmPoint, MmRect, MmVector};

/// A position of the lattice.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LatticePoint {
    pub(crate) at: MmPoint,
    /// Density, 0..=1, from which it is filled; below 0 for those that always are.
    pub(crate) from_density: f32,
    /// The boldness, 0..1 of the range in which colours fade into white, from which on it is filled. Rows of rhombuses
    /// fade as a whole, dots one by one.
    pub(crate) from_boldness: f32,
}

/// Positions fade in this many steps, with as many positions each.
const FADING_STEPS: i32 = 16;

/// Visits the positions of a class's lattice in `area`, row by row. The lattice is centred in the area, so that the
/// rows of a mirrored picture are the mirrored rows. (Not so the order in which dots are filled: with threefold
/// symmetry it has a left and a right.)
pub(crate) fn each_position(class: Class, area: MmRect, params: &Params, mut visit: impl FnMut(LatticePoint)) {
    let (along, across, step, row) = match params.palette.degrees(class) {
        Some(degrees) => (unit(degrees), unit(degrees + 90.0), params.along, params.across),
        None => (unit(0.0), unit(90.0), params.dot_pitch, params.dot_pitch * 0.75_f32.sqrt()),
    };
    let is_dots = params.palette.degrees(class).is_none();
    let centre = area.center();
    let half = MmVector::new(0.5 * area.width(), 0.5 * area.height());
    let reach = |direction: MmVector| half.x * direction.x.abs() + half.y * direction.y.abs();
    let rows = (reach(across) / row).ceil() as i32;
    let columns = (reach(along) / step).ceil() as i32 + 1;
    for j in -rows..=rows {
        let stagger = if j % 2 == 0 { 0.0 } else { 0.5 };
        for i in -columns..=columns {
            let at = centre + along * ((i as f32 + stagger) * step) + across * (j as f32 * row);
            if area.contains_inclusive(at) {
                let (from_density, from_boldness) =
                    if is_dots { (of_dot(i, j), fading_of_dot(i, j)) } else { (of_row(j), fading_of_row(j)) };
                visit(LatticePoint { at, from_density, from_boldness });
            }
        }
    }
}

/// Odd rows are filled always, even ones where the texture is dense. The middle row is even, and what is above it and
/// below it are alike.
fn of_row(j: i32) -> f32 {
    if j % 2 == 0 { 0.5 } else { -1.0 }
}

/// Nine hexagonal lattices: three are filled always, three one after the other, three never.
fn of_dot(i: i32, j: i32) -> f32 {
    // In steps along the two axes of the hexagonal lattice, 60 degrees apart, the position is (a, j).
    let a = i - j.div_euclid(2);
    let coset = (a - j).rem_euclid(3);
    // In steps along the axes of the base lattice, (1, 1) and (-1, 2), the position is (m, n) beside its coset's first.
    let n = (j - (a - coset)).div_euclid(3);
    let m = a - coset + n;
    match coset {
        0 => -1.0,
        1 => ((m - n).rem_euclid(3) as f32 + 0.5) / 3.0,
        _ => f32::INFINITY,
    }
}

/// Rows fade as a whole: filled rows and those between them, each by themselves, and above the middle as below.
fn fading_of_row(j: i32) -> f32 {
    fading(j.abs() / 2 + if j % 2 == 0 { FADING_STEPS / 2 } else { 0 })
}

/// Dots fade one of sixteen at a time.
fn fading_of_dot(i: i32, j: i32) -> f32 {
    // 1 and 5 have no divisor in common with 16, nor has 3, the number of lattices: each has all steps alike
    fading(i - j.div_euclid(2) + 5 * j)
}

/// When the position of this number fades. Neighbours are far apart in the order.
fn fading(number: i32) -> f32 {
    const ORDER: [i32; FADING_STEPS as usize] = [0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15];
    (ORDER[number.rem_euclid(FADING_STEPS) as usize] as f32 + 0.5) / FADING_STEPS as f32
}

#[cfg(test)]
mod tests;
