//! The class of a colour, as in `classes::hue`.

use tactograph::Class;
use tactograph::internals::classes::{Params, class_of};

/// Where the sector of a class begins, degrees of corrected hue.
const SECTORS: [(Class, f64); 4] =
    [(Class::Yellow, 24.0), (Class::Green, 70.0), (Class::Blue, 173.0), (Class::Red, 285.0)];

/// What an sRGB colour (0..=1) is, white being none, and how near a decision on the way was: the least distance from a
/// boundary, as a share of the width of its transition.
pub fn class(rgb: [f64; 3], params: &Params) -> (Option<Class>, f64) {
    let [r, g, b] = rgb;
    let (least, value) = (r.min(g).min(b), r.max(g).max(b));
    let white = (0.5 * (least + value) - f64::from(params.white_from)) / 0.03;
    if white > 0.0 {
        return (None, white);
    }
    let saturation = if value > 0.0 { (value - least) / value } else { 0.0 };
    if saturation <= 0.0 {
        return (Some(Class::Grey), white.abs());
    }
    let (low, black) = (f64::from(params.min_saturation), f64::from(params.min_value));
    let bright = black.max(0.75);
    let bound = if value >= bright {
        low * (1.0 - 0.6 * (value - 0.75) / 0.25)
    } else {
        low + (1.0 - low) * (black / value) * (bright - value) / (bright - black).max(f64::from(f32::EPSILON))
    };
    // below white, colours are diluted by it: more than half of what is left decides
    let diluted = (0.5 + 0.5 * white).clamp(0.0, 1.0);
    let coloured =
        (0.5 + 0.5 * (saturation / bound.max(f64::from(f32::MIN_POSITIVE))).ln() / 1.6_f64.ln()).clamp(0.0, 1.0);
    let (coloured, grey) = (coloured * (1.0 - diluted), (1.0 - coloured) * (1.0 - diluted));
    let near = white.abs().min((coloured - grey).abs());
    if coloured <= grey {
        return (Some(Class::Grey), near);
    }
    let chroma = value - least;
    let sixth = if value <= r {
        (g - b) / chroma
    } else if value <= g {
        2.0 + (b - r) / chroma
    } else {
        4.0 + (r - g) / chroma
    };
    let hue = (60.0 * sixth).rem_euclid(360.0);
    let weight = ((hue - 15.0) / 30.0).min((160.0 - hue) / 85.0).clamp(0.0, 1.0);
    let dark = (1.0 - value).clamp(0.0, 0.5).powf(1.5);
    let hue = hue + 70.0 * dark * weight * (saturation / 0.4).min(1.0);
    let class = SECTORS.iter().rev().find(|(_, from)| hue >= *from).map_or(Class::Red, |(class, _)| *class);
    let away = |from: f64| ((hue - from + 180.0).rem_euclid(360.0) - 180.0).abs() / 12.0;
    (Some(class), SECTORS.iter().map(|(_, from)| away(*from)).fold(near, f64::min))
}

/// Of so many colours, how many the program puts into another class, and how far the farthest of them is from a
/// boundary.
#[derive(Debug, Clone, Copy, Default)]
pub struct Difference {
    /// All colours.
    pub colours: usize,
    /// Those in another class.
    pub other: usize,
    /// How far, as a share of the width of the transition.
    pub farthest: f64,
}

/// Holds the program's classes of these colours against these. Of a colour on a boundary, to the last digit, both
/// answers are right; it is counted all the same, with its distance from the boundary.
pub fn compare(colours: impl Iterator<Item = [f32; 3]>, params: &Params) -> Difference {
    let mut found = Difference::default();
    for rgb in colours {
        let (exact, away) = class(rgb.map(f64::from), params);
        found.colours += 1;
        if class_of(rgb, params) != exact {
            found.other += 1;
            found.farthest = found.farthest.max(away);
        }
    }
    found
}
