//! Scenes without contours: whatever is traced is false.

use super::start;
use crate::scene::{Family, Fill, P, Scene};
use crate::shapes::{direction, moved};

const SIDE: usize = 256;

/// Nothing but the noise.
pub(super) fn flat(number: usize) -> Scene {
    let (_, name) = start(Family::Flat, number);
    Scene::new(name, Family::Flat, [SIDE; 2], Fill::grey([60.0, 128.0, 200.0][number]))
}

/// Light that falls off smoothly, at most 2.5 code values from pixel to pixel.
pub(super) fn shading(number: usize) -> Scene {
    let (_, name) = start(Family::Shading, number);
    let side = SIDE as f64;
    let tau = std::f64::consts::TAU;
    let fill: Box<dyn Fn(P) -> [f64; 3]> = match number {
        0 => Box::new(move |p| [40.0 + 170.0 * p[0] / side; 3]),
        1 => Box::new(move |p| [230.0 - 200.0 * ((p[0] - 90.0).hypot(p[1] - 100.0) / side).powi(2).min(1.0); 3]),
        2 => Box::new(move |p| [128.0 + 50.0 * (tau * (0.8 * p[0] + 0.6 * p[1]) / 128.0).sin(); 3]),
        // a sky: from blue to the orange near the horizon
        _ => Box::new(move |p| {
            let t = p[1] / side;
            [90.0 + 130.0 * t, 140.0 + 30.0 * t, 220.0 - 120.0 * t]
        }),
    };
    let mut scene = Scene::new(name, Family::Shading, [SIDE; 2], Fill::Varying(fill));
    scene.colour = number == 3;
    scene
}

/// A lawn: 2000 blades over one another, in greys or greens.
pub(super) fn texture(number: usize) -> Scene {
    let (mut rng, name) = start(Family::Texture, number);
    let green = number == 2;
    let shade = move |light: f64| if green { [0.65 * light, light, 0.4 * light] } else { [light; 3] };
    let mut scene = Scene::new(name, Family::Texture, [SIDE; 2], Fill::Flat(shade(90.0)));
    scene.colour = green;
    for _ in 0..2000 {
        let side = SIDE as f64;
        let root = [rng.between(-10.0, side + 10.0), rng.between(0.0, side + 40.0)];
        let (length, width) = (rng.between(12.0, 40.0), rng.between(1.5, 4.0));
        let up = direction(-90.0 + 14.0 * rng.normal());
        let outline =
            vec![moved(root, up, 0.0, -0.5 * width), moved(root, up, length, 0.0), moved(root, up, 0.0, 0.5 * width)];
        scene = scene.paint(outline, Fill::Flat(shade(rng.between(40.0, 170.0))));
    }
    scene
}
