//! Tests of `residue`.

use super::*;
use crate::raster::plane::Plane;

const SIZE: Size = Size::new(30, 20);

fn plane(value: impl Fn(usize, usize) -> f32) -> Plane {
    let width = SIZE.width as usize;
    Plane { size: SIZE, values: (0..SIZE.len()).map(|i| value(i % width, i / width)).collect() }
}

#[test]
fn the_greatest_value_around_each_pixel_is_that_of_its_square() {
    let plane = plane(|x, y| ((x * 7 + y * 13) % 17) as f32);
    let most = square_max(&plane.values, SIZE, 2, false);
    for (y, x) in (0..20_usize).flat_map(|y| (0..30_usize).map(move |x| (y, x))) {
        let rows = y.saturating_sub(2)..(y + 3).min(20);
        let around = rows.flat_map(|y| (x.saturating_sub(2)..(x + 3).min(30)).map(move |x| (y, x)));
        let expected = around.map(|(y, x)| plane.values[y * 30 + x]).fold(f32::MIN, f32::max);
        assert!((most[y * 30 + x] - expected).abs() < f32::EPSILON, "{x}, {y}");
    }
}

#[test]
fn a_thin_stroke_between_two_grounds_is_left_and_their_edge_is_not() {
    let ground = |x: usize| if x < 15 { 80.0 } else { 60.0 };
    let edge = plane(|x, _| ground(x));
    assert!(residue(&edge.values, SIZE, 3, Polarity::Below).iter().all(|value| *value == 0.0));
    let stroke = plane(|x, _| if (14..16).contains(&x) { 10.0 } else { ground(x) });
    let below = residue(&stroke.values, SIZE, 3, Polarity::Below);
    assert_eq!(below[5 * 30..][12..18], [0.0, 0.0, 50.0, 50.0, 0.0, 0.0]);
    assert!(residue(&stroke.values, SIZE, 3, Polarity::Above).iter().all(|value| *value == 0.0));
}

#[test]
fn levels_have_the_residue_of_numbers() {
    let levels = plane(|x, y| ((x * 7 + y * 13 + x * y) % 41) as f32);
    for polarity in [Polarity::Below, Polarity::Above] {
        let bytes: Vec<u8> = levels.values.iter().map(|value| *value as u8).collect();
        let found: Vec<f32> = residue(&bytes, SIZE, 2, polarity).into_iter().map(f32::from).collect();
        assert_eq!(found, residue(&levels.values, SIZE, 2, polarity));
        assert!(found.iter().any(|value| *value > 0.0));
    }
}
