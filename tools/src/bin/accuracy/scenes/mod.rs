//! The list of scenes. Places, angles and contrasts are drawn from each scene's own fixed seed, so leaving scenes out
//! does not change the others.

mod close;
mod lone;
mod quiet;

use crate::scene::{Family, P, Scene};
use tactograph_tools::rng::Rng;

/// Radii of the discs, px; each is drawn twice.
const RADII: [f64; 13] = [5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 30.0, 45.0, 60.0, 90.0, 130.0, 200.0];

/// All scenes, or every third of them (and at least one of each family).
pub(crate) fn all(quick: bool) -> Vec<Scene> {
    let mut scenes = Vec::new();
    scenes.extend((0..36).map(lone::straight));
    let discs = RADII.into_iter().flat_map(|radius| [radius; 2]);
    scenes.extend(discs.enumerate().map(|(number, radius)| lone::disc(number, radius)));
    scenes.extend((0..8).map(lone::ellipse));
    scenes.extend((0..6).map(lone::sine));
    scenes.extend((0..12).map(lone::polygon));
    scenes.extend((0..8).map(close::t_junction));
    scenes.extend((0..6).map(close::x_junction));
    scenes.extend((0..14).map(close::bar));
    scenes.extend((0..12).map(close::parallel));
    scenes.extend((0..4).map(close::stair));
    scenes.extend((0..6).map(lone::ramp));
    scenes.extend((0..6).map(lone::iso_colour));
    scenes.extend((0..3).map(quiet::flat));
    scenes.extend((0..4).map(quiet::shading));
    scenes.extend((0..3).map(quiet::texture));
    if quick {
        scenes = scenes.into_iter().enumerate().filter(|(i, _)| i % 3 == 1).map(|(_, scene)| scene).collect();
    }
    scenes
}

/// Steps of straight edges, code values. With these and [`STEPS`] a detector of Devernay's kind errs as much as on the
/// scenes that the targets were taken from, at every noise: its error goes with noise by step.
const FAINT_STEPS: [f64; 4] = [24.0, 40.0, 32.0, 64.0];
/// Steps of all other contours, code values.
const STEPS: [f64; 4] = [50.0, 30.0, 80.0, 120.0];

/// Greys on both sides of one of these steps, either sign.
fn greys(rng: &mut Rng, steps: [f64; 4], number: usize) -> [f64; 2] {
    let contrast = steps[number % 4];
    let low = rng.between(25.0, 230.0 - contrast).round();
    if rng.coin() { [low, low + contrast] } else { [low + contrast, low] }
}

/// A place less than a pixel from the middle of a scene.
fn middle(rng: &mut Rng, size: [usize; 2]) -> P {
    size.map(|n| 0.5 * n as f64 + rng.between(-0.5, 0.5))
}

/// A scene's own random numbers and its name.
fn start(family: Family, number: usize) -> (Rng, String) {
    (Rng::new(1000 * family as u64 + number as u64), format!("{}-{number:02}", family.name()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quick_leaves_out_no_family_and_names_are_unlike() {
        for family in Family::ALL {
            assert!(all(true).iter().any(|scene| scene.family == family), "{family:?}");
        }
        let mut names: Vec<String> = all(false).into_iter().map(|scene| scene.name).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
    }

    #[test]
    fn true_points_are_near_one_another() {
        for scene in all(false) {
            for curve in &scene.curves {
                assert_eq!(curve.points.len(), curve.contrast.len());
                for pair in curve.points.windows(2) {
                    let step = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
                    assert!(step < 0.3, "{}: {step}", scene.name);
                }
            }
        }
    }
}
