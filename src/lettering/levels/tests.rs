//! Tests of `levels`.

use super::*;

/// A row of lightness, as high as wide, so that nothing is thin in the other direction.
fn plane(row: &[f32]) -> Plane {
    let size = Size::new(row.len() as u32, row.len() as u32);
    Plane { size, values: row.repeat(row.len()) }
}

#[test]
fn contrasts_are_those_of_the_plane_to_half_a_level() {
    let row = [80.0, 80.0, 80.0, 80.0, 33.3, 80.0, 80.0, 80.0, 95.7, 80.0, 80.0, 80.0];
    let levels = Levels::of(&plane(&row));
    let contrast = |polarity| levels.contrast(3, 2, polarity, 10.0).expect("there is some");
    let (below, above) = (contrast(Polarity::Below), contrast(Polarity::Above));
    let level = (95.7 - 33.3) / 255.0;
    assert!((below.at(4) - 46.7).abs() <= level && (above.at(8) - 15.7).abs() <= level);
    assert!(below.at(8) <= 0.0 && above.at(4) <= 0.0);
    assert!(levels.contrast(3, 2, Polarity::Above, 20.0).is_none());
}

#[test]
fn half_of_the_largest_contrast_around_a_pixel_is_enough_and_less_is_not() {
    let row = [200.0, 200.0, 200.0, 149.0, 100.0, 151.0, 200.0, 200.0, 195.0, 200.0, 455.0, 455.0];
    let contrast = Levels::of(&plane(&row)).contrast(3, 1, Polarity::Below, 10.0).expect("there is some");
    let set = contrast.at_least_half(10.0);
    assert_eq!(set[..9], [false, false, false, true, true, false, false, false, false]);
    assert!(contrast.has_share(4, 0.85) && !contrast.has_share(3, 0.85));
}

#[test]
fn an_even_ground_has_no_contrast_with_itself_and_a_noisy_one_that_of_its_noise() {
    let row = |noise: f32| -> Vec<f32> {
        let mut row: Vec<f32> = (0..60).map(|x| 80.0 - noise * (x * 7 % 5) as f32).collect();
        row[20..23].fill(20.0);
        row
    };
    let of_ground = |noise: f32| {
        let contrast = Levels::of(&plane(&row(noise))).contrast(6, 3, Polarity::Below, 10.0);
        contrast.expect("there is a stroke").of_ground()
    };
    assert!(of_ground(0.0) <= 0.0);
    assert!((3.0..5.0).contains(&of_ground(1.0)), "{}", of_ground(1.0));
}
