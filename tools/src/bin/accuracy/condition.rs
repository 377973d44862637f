//! Under which conditions the scenes are photographed.

use crate::draw::{Clean, Picture};
use crate::scene::Scene;

/// Blur and noise of one photograph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Condition {
    /// Sigma of the lens's point spread, px.
    pub(crate) psf: f64,
    /// Sigma of the noise, code values.
    pub(crate) noise: f64,
    /// Whether grey scenes too get noise of their own in each channel, as a colour camera gives them.
    pub(crate) per_channel: bool,
}

/// Point spreads of `--all`, px; the first is that of the targets.
pub(crate) const PSFS: [f64; 3] = [0.7, 1.0, 2.0];

/// Where the time is measured.
pub(crate) const TIMED: Condition = Condition::new(0.7, 5.0, false);

impl Condition {
    const fn new(psf: f64, noise: f64, per_channel: bool) -> Self {
        Self { psf, noise, per_channel }
    }

    /// The conditions with this point spread: noise 0, 5, 10, or also 2 and 20 if `all`.
    pub(crate) fn list(psf: f64, all: bool, colour_noise: bool) -> Vec<Self> {
        let noises: &[f64] = if all { &[0.0, 2.0, 5.0, 10.0, 20.0] } else { &[0.0, 5.0, 10.0] };
        let grey = noises.iter().map(|&noise| Self::new(psf, noise, false));
        let colour = noises.iter().filter(|noise| colour_noise && **noise > 0.0);
        grey.chain(colour.map(|&noise| Self::new(psf, noise, true))).collect()
    }

    /// For file names.
    pub(crate) fn name(self) -> String {
        format!("psf{}-noise{}{}", self.psf, self.noise, if self.per_channel { "-colour" } else { "" })
    }

    /// The noise, for the head of a column.
    pub(crate) fn label(self) -> String {
        format!("{}{}", self.noise, if self.per_channel { "c" } else { "" })
    }

    /// A photograph of a scene; always the same one.
    pub(crate) fn shoot(self, scene: &Scene, clean: &Clean) -> Picture {
        // FNV-1a, so that each scene and condition has noise of its own
        let name = self.name() + &scene.name;
        let seed = name.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
        clean.shot(self.noise, self.per_channel, seed)
    }
}

/// Side of the square of [`mosaic`], px.
pub(crate) const MOSAIC: usize = 1000;

/// A picture of one megapixel out of 16 of these, each repeated to fill a square: to measure the time.
pub(crate) fn mosaic(pictures: &[Picture]) -> Picture {
    const ACROSS: usize = 4;
    let cell = MOSAIC / ACROSS;
    let mut rgb = Vec::with_capacity(3 * MOSAIC * MOSAIC);
    for y in 0..MOSAIC {
        for x in 0..MOSAIC {
            let number = y / cell * ACROSS + x / cell;
            let picture = &pictures[(2 * number + 1) * pictures.len() / (2 * ACROSS * ACROSS)];
            let at = (y % cell % picture.size[1]) * picture.size[0] + x % cell % picture.size[0];
            rgb.extend(&picture.rgb[3 * at..3 * at + 3]);
        }
    }
    Picture { size: [MOSAIC; 2], rgb }
}
