//! Scenes where a small change is most likely to turn a decision.

use std::f32::consts::TAU;

use tactograph_tools::rng::Rng;

use crate::picture::{Fault, Picture};

/// A grey value at a place, px.
type Grey = dyn Fn(f32, f32) -> f32;

/// Names and pictures of all scenes.
pub(crate) fn all() -> Result<Vec<(&'static str, Picture)>, Fault> {
    let painted: [(&'static str, &Grey); 6] = [
        // steps of one grey value: plateaus, equal neighbours, a gradient of 1/255 over many pixels
        ("ramp of 1/255 every 12 px", &|x, _| 100.0 + (x / 12.0).floor()),
        ("checkerboard of 16 px", &|x, y| {
            if ((x / 16.0).floor() + (y / 16.0).floor()) % 2.0 == 0.0 { 40.0 } else { 220.0 }
        }),
        ("checkerboard of 2 px", &|x, y| {
            if ((x / 2.0).floor() + (y / 2.0).floor()) % 2.0 == 0.0 { 40.0 } else { 220.0 }
        }),
        // beyond the picture's own resolution in the corners
        ("zone plate", &|x, y| {
            let r = (x - 450.0).hypot(y - 300.0);
            127.5 + 110.0 * (TAU * r * r / 2400.0).cos()
        }),
        ("contrast at the threshold", &|x, y| {
            // discs whose contrast grows from 1 to 24 grey values
            let (column, row) = ((x / 150.0).floor(), (y / 150.0).floor());
            let away = (x - 150.0 * column - 75.0).hypot(y - 150.0 * row - 75.0);
            let contrast = 1.0 + row * 6.0 + column;
            200.0 - contrast * (50.5 - away).clamp(0.0, 1.0)
        }),
        ("strokes at every angle", &|x, y| {
            let (dx, dy) = (x - 450.3, y - 300.6);
            let (r, angle) = (dx.hypot(dy), dy.atan2(dx));
            let spoke = TAU / 48.0;
            let off = ((angle / spoke).round() * spoke - angle).sin().abs() * r;
            if (110.0..270.0).contains(&r) { 255.0 - 215.0 * (1.25 - off).clamp(0.0, 1.0) } else { 255.0 }
        }),
    ];
    let mut scenes: Vec<(&'static str, Picture)> =
        painted.into_iter().map(|(name, value)| (name, paint(|x, y| [value(x, y); 3]))).collect();
    let mut rng = Rng::new(3);
    let mut noise = paint(|_, _| [128.0; 3]);
    noise.rgb.iter_mut().for_each(|sample| *sample = rng.between(0.0, 255.0) as f32);
    scenes.push(("noise", noise));
    scenes.push((
        "saturated and near black",
        paint(|x, y| {
            // hues round the circle, from nearly black to full, where sorting by colour turns
            let (hue, value) = (6.0 * x / 900.0, 4.0 * 1.4_f32.powf(16.0 * (y / 600.0)).floor());
            [0.0, 2.0, 4.0].map(|peak: f32| {
                let away = ((hue - peak).rem_euclid(6.0) - 3.0).abs();
                value.min(255.0) * (away - 1.0).clamp(0.0, 1.0)
            })
        }),
    ));
    let polygon = |inside: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'><rect width='900' height='600' fill='#9ec9e8'/>{inside}</svg>"
        )
    };
    // a closed polygon that once was whole at 135 mm and torn at 146
    let five =
        polygon("<path d='M180 140L520 70L760 260L640 520L230 470Z' fill='#c9b2d9' stroke='#333' stroke-width='2'/>");
    scenes.push(("closed polygon", Picture::open(five.as_bytes())?));
    Ok(scenes)
}

/// 900 x 600 px, by the value at the middle of each.
fn paint(value: impl Fn(f32, f32) -> [f32; 3]) -> Picture {
    let (width, height) = (900, 600);
    let at = |i: usize| ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
    let rgb = (0..width * height).flat_map(|i| value(at(i).0, at(i).1)).collect();
    Picture { width, height, rgb }
}
