//! The list of scenes. Places, angles and contrasts are drawn from each scene's own fixed seed, so leaving scenes out
//! does not change the others.

use crate::rng::Rng;
use crate::scene::{Family, Fill, P, Scene};
use crate::shapes::{direction, ellipse, half_plane, whole_line};

/// All scenes.
pub(crate) fn all() -> Vec<Scene> {
    let mut scenes = Vec::new();
    (0..36).for_each(|i| scenes.push(straight(i)));
    for (i, radius) in
        [5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 45.0, 60.0, 90.0, 130.0, 200.0].into_iter().enumerate()
    {
        let times = if radius < 100.0 { 2 } else { 1 };
        (0..times).for_each(|k| scenes.push(disc(2 * i + k, radius)));
    }
    (0..3).for_each(|i| scenes.push(flat(i)));
    scenes
}

/// Greys on both sides of a step; contrasts 40 to 120, either sign.
fn greys(rng: &mut Rng, number: usize) -> [f64; 2] {
    let contrast = [40.0, 60.0, 80.0, 120.0][number % 4];
    let low = rng.between(25.0, 230.0 - contrast).round();
    if rng.coin() { [low, low + contrast] } else { [low + contrast, low] }
}

/// A place less than a pixel from the middle of a scene.
fn middle(rng: &mut Rng, size: [usize; 2]) -> P {
    size.map(|n| 0.5 * n as f64 + rng.between(-0.5, 0.5))
}

fn start(family: Family, number: usize) -> (Rng, String) {
    (Rng::new(1000 * family as u64 + number as u64), format!("{}-{number:02}", family.name()))
}

fn straight(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Straight, number);
    let size = [160, 160];
    let [paper, ink] = greys(&mut rng, number);
    let (at, along) = (middle(&mut rng, size), direction(5.0 * number as f64));
    Scene::new(name, Family::Straight, size, Fill::grey(paper)).paint(half_plane(at, along), Fill::grey(ink)).contour(
        whole_line(at, along, size),
        false,
        (ink - paper).abs(),
    )
}

fn disc(number: usize, radius: f64) -> Scene {
    let family = if radius <= 30.0 { Family::SmallDisc } else { Family::LargeDisc };
    let (mut rng, name) = start(family, number);
    let side = 2 * radius.ceil() as usize + 40;
    let [paper, ink] = greys(&mut rng, number);
    let (outline, truth) = ellipse(middle(&mut rng, [side; 2]), radius, radius, [1.0, 0.0]);
    Scene::new(format!("{name}-r{radius}"), family, [side; 2], Fill::grey(paper))
        .paint(outline, Fill::grey(ink))
        .contour(truth, true, (ink - paper).abs())
}

fn flat(number: usize) -> Scene {
    let (_, name) = start(Family::Flat, number);
    Scene::new(name, Family::Flat, [256, 256], Fill::grey([60.0, 128.0, 200.0][number]))
}
