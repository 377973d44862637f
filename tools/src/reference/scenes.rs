//! Pictures on which rounding may turn a decision.

use std::f64::consts::{PI, TAU};

use tactograph::internals::raster::{Planes, Raster};
use tactograph::internals::units::Size;

use crate::rng::Rng;

/// Names and pictures, in linear light.
pub fn all() -> Vec<(&'static str, Raster)> {
    let mut scenes = vec![
        (
            "steps of one unit in the last place",
            grey([240, 160], |x, y| {
                let one = 0.5_f32;
                let up = ((x / 24.0) as u32 + (y / 40.0) as u32) % 3;
                f64::from(f32::from_bits(one.to_bits() + up))
            }),
        ),
        (
            "plateaus: two equal greatest gradients",
            grey([240, 160], |x, _| linear([40.0, 120.0, 200.0][(x / 2.0) as usize % 3])),
        ),
        (
            "equal neighbours: edges between pixels",
            grey([240, 160], |x, y| {
                linear(if ((x / 30.0) as u32 + (y / 20.0) as u32).is_multiple_of(2) { 60.0 } else { 190.0 })
            }),
        ),
        (
            "edges at 45 degrees",
            grey([240, 160], |x, y| linear(if (x + y).rem_euclid(40.0) < 20.0 { 60.0 } else { 190.0 })),
        ),
        ("1/255 over 2048 px", grey([2048, 24], |x, y| linear(100.0 + (x + 3.0 * y) / 2048.0))),
        ("ramp of 1/255 every 12 px", grey([600, 60], |x, _| linear(100.0 + (x / 12.0).floor()))),
        ("ramp of 16 bits", grey([600, 60], |x, y| linear((255.0 * (x * 60.0 + y)).floor() / 36_000.0))),
        (
            "checkerboards of 1 to 8 px",
            grey([256, 128], |x, y| {
                let cell = 1.0 + (x / 32.0).floor();
                linear(if ((x / cell).floor() + (y / cell).floor()) % 2.0 == 0.0 { 40.0 } else { 220.0 })
            }),
        ),
        (
            "zone plate",
            grey([400, 400], |x, y| {
                let r = (x - 200.0).hypot(y - 200.0);
                linear(127.5 + 110.0 * (TAU * r * r / 1200.0).cos())
            }),
        ),
        (
            "strokes at all offsets and angles",
            grey([500, 500], |x, y| {
                let (dx, dy) = (x - 250.3, y - 249.6);
                let (r, angle) = (dx.hypot(dy), dy.atan2(dx));
                let spoke = TAU / 64.0;
                let off = ((angle / spoke).round() * spoke - angle).sin().abs() * r;
                linear(if (60.0..240.0).contains(&r) { 255.0 - 215.0 * (1.0 - off).clamp(0.0, 1.0) } else { 255.0 })
            }),
        ),
        (
            "saturated, and nearly black",
            colour([480, 240], |x, y| {
                let (hue, value) = (6.0 * x / 480.0, (1.6_f64.powf(12.0 * y / 240.0)).floor());
                hues(hue).map(|share| linear((value * share).min(255.0)))
            }),
        ),
        (
            "hue round the circle",
            colour([720, 60], |x, _| hues(6.0 * (x / 10.0).floor() / 72.0).map(|share| linear(60.0 + 160.0 * share))),
        ),
        ("8 x 8 px", grey([8, 8], |x, y| linear(if x + y < 8.0 { 30.0 } else { 230.0 }))),
        ("1 x 400 px", grey([1, 400], |_, y| linear(if y < 200.0 { 30.0 } else { 230.0 }))),
        ("400 x 1 px", grey([400, 1], |x, _| linear(if x < 200.0 { 30.0 } else { 230.0 }))),
        ("400 x 3 px", grey([400, 3], |x, _| linear(127.0 + 100.0 * (PI * x / 40.0).sin()))),
    ];
    for (name, share) in [("noise of 1 %", 0.01), ("noise of 10 %", 0.1), ("noise of 100 %", 1.0)] {
        let mut rng = Rng::new(9);
        let mut noise = move || linear(127.5 + 127.5 * rng.between(-share, share));
        let planes = [0; 3].map(|_: u8| (0..200 * 200).map(|_| noise() as f32).collect());
        scenes.push((name, Raster::new(Size::new(200, 200), Planes::Colour(planes))));
    }
    scenes
}

/// Linear light of a code value 0..=255 (IEC 61966-2-1).
pub fn linear(code: f64) -> f64 {
    let value = code / 255.0;
    if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// Red, green and blue of a hue of 0..6.
fn hues(hue: f64) -> [f64; 3] {
    [0.0, 2.0, 4.0].map(|peak: f64| (((hue - peak).rem_euclid(6.0) - 3.0).abs() - 1.0).clamp(0.0, 1.0))
}

fn grey([width, height]: [u32; 2], value: impl Fn(f64, f64) -> f64) -> Raster {
    let at = |i: u32| value(f64::from(i % width) + 0.5, f64::from(i / width) + 0.5) as f32;
    Raster::new(Size::new(width, height), Planes::Grey((0..width * height).map(at).collect()))
}

fn colour([width, height]: [u32; 2], value: impl Fn(f64, f64) -> [f64; 3]) -> Raster {
    let plane = |channel: usize| {
        let at = |i: u32| value(f64::from(i % width) + 0.5, f64::from(i / width) + 0.5)[channel] as f32;
        (0..width * height).map(at).collect()
    };
    Raster::new(Size::new(width, height), Planes::Colour([plane(0), plane(1), plane(2)]))
}
