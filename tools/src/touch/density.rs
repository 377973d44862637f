//! Does the density of glyphs follow the density of lines?

use std::collections::BTreeSet;

use tactograph::Page;
use tactograph::internals::page::{Class, Line};
use tactograph::internals::units::MmPoint;

/// Sigma of the map of lines, mm: the profile's.
const BLUR: f32 = 8.0;
/// Sigma of the window in which glyphs are counted, mm: that of the map, for what changes faster cannot be felt as a density.
const WINDOW: f32 = 8.0;
/// Places are looked at this far from one another, mm.
const EVERY: f32 = 4.0;
/// Fewer glyphs than this (of the densest texture, by their weight in the window) are too few to count.
const LEAST: f32 = 20.0;

/// Pairs of a local density of lines, 0..=1, and the share of glyphs that are there of those in the densest texture.
/// `dense` is the same page with the densest texture all over.
pub fn pairs(page: &Page, dense: &Page, class: Class) -> Vec<(f32, f32)> {
    let key = |at: MmPoint| ((at.x * 100.0).round() as i32, (at.y * 100.0).round() as i32);
    let glyphs = |page: &Page| -> Vec<MmPoint> {
        let textures = page.figure.textures.iter().filter(|texture| texture.class == class);
        textures.flat_map(|texture| &texture.glyphs).map(|glyph| glyph.at).collect()
    };
    let there: BTreeSet<_> = glyphs(page).into_iter().map(key).collect();
    let sites: Vec<(MmPoint, f32, f32)> = glyphs(dense)
        .into_iter()
        .map(|at| (at, lines_near(&page.figure.lines, at), f32::from(u8::from(there.contains(&key(at))))))
        .collect();
    let place = page.figure.place;
    let mut pairs = Vec::new();
    let steps = |side: f32| (side / EVERY) as u32;
    for (i, j) in (0..steps(place.height())).flat_map(|j| (0..steps(place.width())).map(move |i| (i, j))) {
        let at = place.min + tactograph::internals::units::MmVector::new(i as f32 * EVERY, j as f32 * EVERY);
        let (mut weight, mut lines, mut glyphs) = (0.0, 0.0, 0.0);
        for (site, density, is_there) in &sites {
            let square = (*site - at).square_length() / (WINDOW * WINDOW);
            if square < 9.0 {
                let share = (-0.5 * square).exp();
                weight += share;
                lines += share * density;
                glyphs += share * is_there;
            }
        }
        if weight >= LEAST {
            pairs.push((lines / weight, glyphs / weight));
        }
    }
    pairs
}

/// The paper's map of lines at a place: marked, blurred, 1 on a lone straight line, at most 1.
fn lines_near(lines: &[Line], at: MmPoint) -> f32 {
    let segments = lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.polyline().segments());
    let sum: f32 = segments
        .map(|(&a, &b)| {
            let (way, length) = (b - a, (b - a).length());
            let steps = (length / 0.5).ceil().max(1.0) as u32;
            (0..steps)
                .map(|k| {
                    let here = a + way * ((k as f32 + 0.5) / steps as f32);
                    (-0.5 * (here - at).square_length() / (BLUR * BLUR)).exp() * length / steps as f32
                })
                .sum::<f32>()
        })
        .sum();
    (sum / (std::f32::consts::TAU.sqrt() * BLUR)).min(1.0)
}

/// Pearson's correlation.
pub fn correlation(pairs: &[(f32, f32)]) -> f32 {
    let count = pairs.len() as f32;
    let mean = |value: &dyn Fn(&(f32, f32)) -> f32| pairs.iter().map(value).sum::<f32>() / count;
    let (a, b) = (mean(&|p| p.0), mean(&|p| p.1));
    let covariance = mean(&|p| (p.0 - a) * (p.1 - b));
    covariance / (mean(&|p| (p.0 - a).powi(2)) * mean(&|p| (p.1 - b).powi(2))).sqrt()
}
