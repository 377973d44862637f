//! Does ink grow as lightness falls, without steps?

use tactograph::internals::page::Class;
use tactograph::internals::textures::{Params, sample};
use tactograph::internals::units::{MmPoint, MmRect};

/// Levels of a ramp.
const LEVELS: usize = 256;

/// How the ink of a class follows lightness at one density.
#[derive(Debug, Clone, Copy)]
pub struct Boldness {
    /// Spearman's rank correlation of ink with darkness, over all levels that are not white.
    pub rank: f32,
    /// Largest change of ink from one level to the next, as a share of full ink.
    pub jump: f32,
    /// Whether ink never falls as lightness falls, and is none at white.
    pub monotone: bool,
}

/// Measures the ink of a class at all levels of lightness.
pub fn measure(class: Class, density: f32, params: &Params) -> Boldness {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(260.0, 260.0));
    let ink: Vec<f32> = (0..LEVELS)
        .map(|level| {
            let lightness = level as f32 / (LEVELS - 1) as f32;
            let glyphs = sample(class, lightness, density, area, params).glyphs;
            glyphs.iter().map(|glyph| glyph.area()).sum::<f32>() / area.area()
        })
        .collect();
    let jumps = ink.windows(2).map(|pair| (pair[0] - pair[1]).abs());
    let inked: Vec<f32> = ink.iter().copied().filter(|ink| *ink > 0.0).collect();
    Boldness {
        rank: rank_correlation(&inked),
        jump: jumps.fold(0.0, f32::max) / ink[0],
        monotone: ink.windows(2).all(|pair| pair[0] >= pair[1]) && ink[LEVELS - 1] == 0.0,
    }
}

/// Spearman's correlation of values with how far they are from the end; equal values share their ranks.
fn rank_correlation(values: &[f32]) -> f32 {
    let rank = |value: f32| {
        let below = values.iter().filter(|other| **other < value).count();
        let equal = values.iter().filter(|other| **other <= value).count() - below;
        below as f32 + 0.5 * (equal as f32 - 1.0)
    };
    let pairs: Vec<(f32, f32)> =
        values.iter().rev().enumerate().map(|(place, value)| (place as f32, rank(*value))).collect();
    super::density::correlation(&pairs)
}
