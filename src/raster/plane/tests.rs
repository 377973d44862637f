//! Tests of `plane`.

use super::*;

#[test]
fn a_blurred_constant_stays_and_a_blurred_point_keeps_its_sum() {
    let size = Size::new(31, 31);
    let flat = Plane::filled(size, 3.0).blurred(2.0);
    assert!(flat.values.iter().all(|v| (v - 3.0).abs() < 1e-5));
    let mut point = Plane::filled(size, 0.0);
    point.values[15 * 31 + 15] = 1.0;
    let sum: f32 = point.blurred(2.0).values.iter().sum();
    assert!((sum - 1.0).abs() < 1e-4);
}

#[test]
fn several_values_of_a_pixel_are_those_of_their_planes() {
    let size = Size::new(5, 4);
    let plane = |k: usize| Plane { size, values: (0..20).map(|i| (i * (i + k) % 7) as f32 / 3.0).collect() };
    let planes = [0, 1, 2, 3].map(plane);
    let together: Vec<[f32; 4]> = (0..20).map(|i| [0, 1, 2, 3].map(|k: usize| planes[k].values[i])).collect();
    for k in 0..60 {
        let place = SubpixelPosition::new(size, k as f32 / 11.0 - 0.2, 4.5 - k as f32 / 13.0);
        let one_by_one = [0, 1, 2, 3].map(|k: usize| place.look_up(&planes[k].values).to_bits());
        assert_eq!(place.look_up_each(&together).map(f32::to_bits), one_by_one, "{place:?}");
    }
}

#[test]
fn a_blur_is_that_of_both_axes_whatever_the_size() {
    for (width, height) in [(1, 1), (1, 9), (9, 1), (6, 3), (3, 30)] {
        let size = Size::new(width, height);
        let plane = Plane { size, values: (0..size.len()).map(|i| (i * i % 11) as f32).collect() };
        let kernel = gauss(0.9);
        let weight = |step: isize| kernel[step.unsigned_abs()];
        let reach = kernel.len() as isize - 1;
        let blurred = plane.blurred(0.9);
        for (cell, found) in blurred.values.iter().enumerate() {
            let (x, y) = ((cell % width as usize) as isize, (cell / width as usize) as isize);
            let at = |dx: isize, dy: isize| {
                let (x, y) = ((x + dx).clamp(0, width as isize - 1), (y + dy).clamp(0, height as isize - 1));
                plane.values[y as usize * width as usize + x as usize]
            };
            let row = |dy: isize| (-reach..=reach).map(|dx| weight(dx) * at(dx, dy)).sum::<f32>();
            let expected: f32 = (-reach..=reach).map(|dy| weight(dy) * row(dy)).sum();
            assert!((found - expected).abs() < 1e-4, "{found}, not {expected}, at {x}, {y} of {width} x {height}");
        }
    }
}

#[test]
fn values_at_several_positions_are_those_at_each() {
    for size in [Size::new(5, 4), Size::new(1, 4), Size::new(5, 1), Size::new(1, 1)] {
        let values = (0..size.len()).map(|i| (i * i % 7) as f32 / 3.0).collect();
        let plane = Plane { size, values };
        for k in 0..60 {
            let x = [-1.0, 0.2, 0.5, 1.7, 3.0].map(|x| x + k as f32 / 13.0);
            let y = [4.5, 0.3, 2.2, -0.5, 0.5].map(|y| y - k as f32 / 17.0);
            let one_by_one = [0, 1, 2, 3, 4].map(|i| plane.at(x[i], y[i]).to_bits());
            assert_eq!(plane.at_each(x, y).map(f32::to_bits), one_by_one, "{size:?} {x:?} {y:?}");
        }
    }
}
