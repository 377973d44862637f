//! The class of one colour: hue corrected by value, then cut into sectors.
//!
//! The paper corrects the hue by saturation as well, without saying how; here saturation decides between colour and grey,
//! more strictly for dark colours.

use super::{Class, Params};
use crate::raster::plane::Plane;

/// Hues at which one class ends and the next begins, degrees (red 0, yellow 60, green 120, blue 240), and the class from
/// there on. Chosen by us: orange (39) is yellowish, pink and magenta are reddish, cyan and indigo are bluish to most
/// people; the paper names only the four centres.
const SECTORS: [(f32, Class); 4] =
    [(32.0, Class::Yellow), (75.0, Class::Green), (168.0, Class::Blue), (285.0, Class::Red)];

/// How far a dark yellow is turned towards green, degrees per unit of lost value. The paper gives the direction (a dark
/// yellow is olive, a dark orange is yellowish); 40 takes olive (value 0.5) from 60 to 80.
const DARK_TURN: f32 = 40.0;

/// Dark colours need more saturation to be seen as coloured: below this value (HSV) the bound rises.
const DIM: f32 = 0.35;
/// ... by this much per unit of value.
const DIM_RISE: f32 = 1.0;

/// Light tints (a pale sky, pink) are seen as colours at a lower saturation: above this value (HSV) the bound falls ...
const PALE_FROM: f32 = 0.7;
/// ... by this share at the lightest. Pale pink, blue and green of drawings have a saturation of 0.1 to 0.18.
const PALE_FALL: f32 = 0.5;

/// The class of every cell (`None` is white) and its lightness, from blurred planes in linear light.
pub(super) fn classify(planes: &[Plane], params: &Params) -> (Vec<Option<Class>>, Plane) {
    let size = planes[0].size;
    let mut labels = Vec::with_capacity(size.len());
    let mut lightness = Plane { size, values: Vec::with_capacity(size.len()) };
    for i in 0..size.len() {
        let (label, light) = match planes {
            [red, green, blue] => {
                let rgb = [red, green, blue].map(|plane| encoded(plane.values[i]));
                (class_of(rgb, params), lightness_of(rgb))
            }
            _ => {
                let grey = encoded(planes[0].values[i]);
                ((grey <= params.white_from).then_some(Class::Grey), grey)
            }
        };
        labels.push(label);
        lightness.values.push(light);
    }
    (labels, lightness)
}

/// HSL lightness: pure colours have 0.5, white 1.
fn lightness_of(rgb: [f32; 3]) -> f32 {
    let (least, most) = range(rgb);
    0.5 * (least + most)
}

fn range([r, g, b]: [f32; 3]) -> (f32, f32) {
    (r.min(g).min(b), r.max(g).max(b))
}

/// The class of a colour given as sRGB values 0..=1.
fn class_of(rgb: [f32; 3], params: &Params) -> Option<Class> {
    let (least, value) = range(rgb);
    if lightness_of(rgb) > params.white_from {
        return None;
    }
    let saturation = if value > 0.0 { (value - least) / value } else { 0.0 };
    let pale = ((value - PALE_FROM) / (1.0 - PALE_FROM)).max(0.0);
    let bound = params.min_saturation * (1.0 - PALE_FALL * pale) + DIM_RISE * (DIM - value).max(0.0);
    if value < params.min_value || saturation < bound {
        return Some(Class::Grey);
    }
    let hue = corrected(hue_of(rgb, least, value), value);
    let sector = SECTORS.iter().rev().find(|(from, _)| hue >= *from);
    Some(sector.map_or(Class::Red, |(_, class)| *class))
}

/// Hue of HSV, degrees 0..360.
fn hue_of([r, g, b]: [f32; 3], least: f32, most: f32) -> f32 {
    let chroma = most - least;
    if chroma <= 0.0 {
        return 0.0;
    }
    let sixth = if most <= r {
        (g - b) / chroma
    } else if most <= g {
        2.0 + (b - r) / chroma
    } else {
        4.0 + (r - g) / chroma
    };
    (60.0 * sixth).rem_euclid(360.0)
}

/// Turns dark oranges towards yellow and dark yellows towards green: fully from 45 to 75 degrees (amber to lime), fading out
/// to none at 15 (red must stay red) and 120 (green is green already).
fn corrected(hue: f32, value: f32) -> f32 {
    let weight = ((hue - 15.0) / 30.0).min((120.0 - hue) / 45.0).clamp(0.0, 1.0);
    hue + DARK_TURN * (1.0 - value) * weight
}

/// Linear light to sRGB (IEC 61966-2-1).
fn encoded(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARAMS: Params =
        Params { cell: 1.0, blur: 0.0, min_saturation: 0.18, min_value: 0.15, white_from: 0.92, min_area: 0.0 };

    #[test]
    fn colours_have_the_class_that_a_person_would_say() {
        use Class::{Blue, Green, Grey, Red, Yellow};
        for (name, rgb, want) in [
            ("blue", 0x0000ff, Some(Blue)),
            ("sky blue", 0x87ceeb, Some(Blue)),
            ("navy", 0x000080, Some(Blue)),
            ("green", 0x008000, Some(Green)),
            ("lime", 0x00ff00, Some(Green)),
            ("olive, a dark yellow", 0x808000, Some(Green)),
            ("yellow", 0xffff00, Some(Yellow)),
            ("gold", 0xffd700, Some(Yellow)),
            ("orange", 0xffa500, Some(Yellow)),
            ("a darkened orange", 0xb36b00, Some(Yellow)),
            ("red", 0xff0000, Some(Red)),
            ("pink", 0xff69b4, Some(Red)),
            ("brown", 0xa52a2a, Some(Red)),
            ("black", 0x000000, Some(Grey)),
            ("grey", 0x808080, Some(Grey)),
            ("a warm grey", 0x8a8078, Some(Grey)),
            ("nearly black, with a hue", 0x140a0a, Some(Grey)),
            ("pale sky", 0xd2e6fa, Some(Blue)),
            ("pale pink", 0xffd6dc, Some(Red)),
            ("pale green", 0xd4f2d4, Some(Green)),
            ("a white wall", 0xe8e4dc, Some(Grey)),
            ("white", 0xffffff, None),
            ("ivory", 0xfffff8, None),
        ] {
            let channel = |shift: u32| (rgb >> shift & 0xff) as f32 / 255.0;
            assert_eq!(class_of([channel(16), channel(8), channel(0)], &PARAMS), want, "{name}");
        }
    }

    #[test]
    fn the_corrected_hue_never_runs_backwards() {
        for value in [0.15, 0.4, 0.7, 1.0] {
            let hues: Vec<f32> = (0..3600).map(|tenth| corrected(tenth as f32 / 10.0, value)).collect();
            assert!(hues.is_sorted(), "at value {value}");
        }
    }
}
