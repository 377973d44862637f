//! Tests of rims.

use super::*;
use crate::units::Size;

/// A photograph of a slope of light, with a rim so wide on each side, of a linear light that varies a little.
fn picture(widths: [f32; 4], light: f32) -> Raster {
    let size = Size::new(240, 160);
    let value = |at: usize| {
        let (x, y) = ((at % 240) as f32 + 0.5, (at / 240) as f32 + 0.5);
        let sides = [x, y, 240.0 - x, 160.0 - y].into_iter().zip(widths).filter(|(_, width)| *width > 0.0);
        let distance = sides.map(|(to, width)| to - width);
        let inside = (distance.fold(f32::MAX, f32::min) / 2.0).clamp(0.0, 1.0);
        let grain = ((at * 7919) % 13) as f32 * 0.0003;
        light + grain + inside * (0.25 + 0.3 * x / 240.0 - light)
    };
    Raster::grey(size, (0..size.len()).map(value).collect())
}

#[test]
fn dark_and_white_rims_are_found_on_the_sides_that_have_them() {
    for light in [0.001, 0.02, 0.99] {
        let Rim([left, top, right, bottom]) = Rim::of(&picture([4.0, 0.0, 0.0, 6.0], light)).expect("a rim");
        assert!((5..=9).contains(&left) && (7..=11).contains(&bottom), "{light}: {left} {bottom}");
        assert_eq!([top, right], [0, 0], "{light}");
    }
}

/// Of a slide that was not put in straight: 1.8 pixels at the top and 0.3 at the bottom.
#[test]
fn a_slanted_rim_is_found_where_it_is_narrower_than_a_pixel() {
    let rimmed = |widest: f32| {
        let plain = picture([0.0; 4], 0.001);
        let covered = |(at, value): (usize, &f32)| {
            let (x, y) = ((at % 240) as f32, (at / 240) as f32);
            let dark = (widest - 1.5 * y / 160.0 - x).clamp(0.0, 1.0);
            dark * 0.001 + (1.0 - dark) * value
        };
        let values = plain.planes().as_slice()[0].iter().enumerate().map(covered).collect();
        Rim::of(&Raster::grey(plain.size(), values))
    };
    let Rim([left, top, right, bottom]) = rimmed(1.8).expect("a rim");
    assert!((3..=6).contains(&left), "{left}");
    assert_eq!([top, right, bottom], [0; 3]);
    assert_eq!(rimmed(1.0), None, "hardly any");
}

#[test]
fn what_is_wide_or_grey_or_has_no_straight_border_is_no_rim() {
    assert_eq!(Rim::of(&picture([0.0; 4], 0.001)), None);
    assert_eq!(Rim::of(&picture([4.0, 0.0, 0.0, 0.0], 0.15)), None, "grey");
    assert_eq!(Rim::of(&picture([14.0, 0.0, 0.0, 0.0], 0.001)), None, "wide");
    // a dark hill along the lower side
    let plain = picture([0.0; 4], 0.001);
    let hill = |(at, value): (usize, &f32)| {
        let (x, y) = ((at % 240) as f32, (at / 240) as f32);
        if y > 156.0 - 10.0 * (x / 38.0).sin().abs() { 0.001 } else { *value }
    };
    let values = plain.planes().as_slice()[0].iter().enumerate().map(hill).collect();
    assert_eq!(Rim::of(&Raster::grey(plain.size(), values)), None, "a hill");
}

#[test]
fn in_place_of_a_rim_there_is_what_lies_behind_it() {
    let rimmed = picture([4.0, 3.0, 5.0, 6.0], 0.001);
    let filled = Rim::of(&rimmed).expect("a rim").filled(&rimmed);
    assert_eq!(Rim::of(&filled), None);
    let plain = picture([0.0; 4], 0.001);
    let values = |raster: &Raster| raster.planes().as_slice()[0].clone();
    let far = values(&filled).iter().zip(values(&plain)).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(far < 0.3 * 12.0 / 240.0 + 0.01, "{far}");
}
