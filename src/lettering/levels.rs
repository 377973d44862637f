//! The planes in which text is looked for: of colours, and each in so few levels that a pixel is a byte: a vector holds
//! four times as many, and as much less is copied.

use pulp::Arch;

use crate::raster::plane::Plane;
use crate::raster::residue::{Polarity, residue, square_max};
use crate::raster::{Raster, lab};
use crate::units::Size;

/// Lightness and twice a and b of a picture: of a drawing whole planes, all of which are looked at; of a photograph
/// lightness alone, and the rest where it is asked for.
pub(super) struct Colours<'a> {
    raster: &'a Raster,
    pub(super) planes: Vec<Plane>,
}

impl<'a> Colours<'a> {
    pub(super) fn new(raster: &'a Raster, is_drawing: bool) -> Self {
        let planes = if is_drawing { lab::whole(raster) } else { vec![lab::whole_lightness(raster)] };
        Self { raster, planes }
    }

    /// The colour of a pixel.
    pub(super) fn at(&self, cell: usize) -> [f32; 3] {
        match &self.planes[..] {
            [l, a, b] => [l.values[cell], a.values[cell], b.values[cell]],
            // of a photograph, or grey
            _ => lab::pixel(self.raster, cell),
        }
    }
}

/// Between the least value of a plane and the greatest there are so many levels: of lightness less than half a unit.
const LEVELS: f32 = 255.0;
/// A level is no finer than this, in units of strength, however even a plane is.
const FINEST: f32 = 0.1;

/// So much of a picture, at least, is taken to be ground.
const GROUND: f32 = 0.25;

/// A plane in levels.
pub(super) struct Levels {
    size: Size,
    /// How much a level is, in units of strength.
    unit: f32,
    values: Vec<u8>,
}

/// The contrast of each pixel with its ground, in levels.
pub(super) struct Contrast {
    pub(super) size: Size,
    unit: f32,
    values: Vec<u8>,
    /// The largest contrast around each pixel.
    most: Vec<u8>,
}

impl Levels {
    pub(super) fn of(plane: &Plane) -> Self {
        let (low, high) = range(&plane.values);
        let unit = ((high - low) / LEVELS).max(FINEST);
        let mut values = vec![0; plane.values.len()];
        Arch::new().dispatch(|| {
            for (level, value) in values.iter_mut().zip(&plane.values) {
                *level = ((value - low) * (1.0 / unit) + 0.5) as u8;
            }
        });
        Self { size: plane.size, unit, values }
    }

    /// What a square of `2 radius + 1` px does not fit into, compared with the most of it within `local` px; none if
    /// nothing has the contrast `wanted`, in units of strength.
    pub(super) fn contrast(&self, radius: usize, local: usize, polarity: Polarity, wanted: f32) -> Option<Contrast> {
        let Self { size, unit, .. } = *self;
        let values = residue(&self.values, size, radius, polarity);
        let greatest = values.iter().fold(0, |most: u8, value| most.max(*value));
        (f32::from(greatest) * unit >= wanted).then(|| {
            let most = square_max(&values, size, local, false);
            Contrast { size, unit, values, most }
        })
    }
}

impl Contrast {
    /// In units of strength.
    pub(super) fn at(&self, cell: usize) -> f32 {
        f32::from(self.values[cell]) * self.unit
    }

    /// The contrast of the ground with itself, in units of strength: a low quantile of the largest around each pixel.
    /// It is 0 on an even ground, and a few standard deviations of the noise on a noisy one.
    pub(super) fn of_ground(&self) -> f32 {
        let mut counts = [0_usize; 1 << u8::BITS];
        self.most.iter().for_each(|&most| counts[usize::from(most)] += 1);
        let wanted = (GROUND * self.most.len() as f32) as usize;
        let mut below = 0;
        let level = counts.iter().position(|count| {
            below += count;
            below > wanted
        });
        level.unwrap_or(0) as f32 * self.unit
    }

    /// Whether a pixel has at least this share of the largest contrast around it.
    pub(super) fn has_share(&self, cell: usize, share: f32) -> bool {
        f32::from(self.values[cell]) >= share * f32::from(self.most[cell])
    }

    /// The pixels that have at least half of the largest contrast around them, and at least `least`, in units of
    /// strength.
    pub(super) fn at_least_half(&self, least: f32) -> Vec<bool> {
        let least = (least / self.unit).ceil().min(LEVELS) as u8;
        let mut set = vec![false; self.values.len()];
        for ((set, &value), &most) in set.iter_mut().zip(&self.values).zip(&self.most) {
            *set = (value >= least) & (value >= most - value.min(most));
        }
        set
    }
}

/// The least and the greatest of some values, which are taken side by side as vectors hold them.
fn range(values: &[f32]) -> (f32, f32) {
    const LANES: usize = 8;
    let (mut low, mut high) = ([f32::MAX; LANES], [f32::MIN; LANES]);
    Arch::new().dispatch(|| {
        for part in values.chunks(LANES) {
            for ((low, high), value) in low.iter_mut().zip(&mut high).zip(part) {
                *low = if value < low { *value } else { *low };
                *high = if value > high { *value } else { *high };
            }
        }
    });
    (low.into_iter().fold(f32::MAX, f32::min), high.into_iter().fold(f32::MIN, f32::max))
}

#[cfg(test)]
mod tests;
