//! Tests of `tree`.

use super::*;
use crate::units::Size;

/// A plane of which the value of each cell is told by its column and row.
fn plane(width: u32, height: u32, value: impl Fn(usize, usize) -> f32) -> Plane {
    let size = Size::new(width, height);
    Plane { size, values: (0..size.len()).map(|cell| value(cell % width as usize, cell / width as usize)).collect() }
}

#[test]
fn the_gradient_of_a_slope_is_how_steep_it_is_and_planes_add_up() {
    let slope = plane(30, 30, |x, y| 3.0 * x as f32 + 4.0 * y as f32);
    let other = plane(30, 30, |x, _| 2.0 * x as f32);
    let grid = RegionGrid::new(slope.size);
    for (planes, square) in [(vec![slope.clone()], 25.0), (vec![slope, other], 29.0)] {
        let found = squared_gradient(&planes, grid)[15 * 30 + 15];
        assert!((found - square).abs() < 0.01, "{found}, not {square}");
    }
}

#[test]
fn columns_count_as_rows_do_up_to_the_edges() {
    let value = |x: usize, y: usize| ((x * 7919 + y * 104_729) % 97) as f32;
    for (width, height) in [(1, 9), (2, 9), (3, 9), (12, 7), (1, 1)] {
        let found = |plane: Plane| squared_gradient(std::slice::from_ref(&plane), RegionGrid::new(plane.size));
        let upright = found(plane(width, height, value));
        let turned = found(plane(height, width, |x, y| value(y, x)));
        let (width, height) = (width as usize, height as usize);
        assert!(width * height == 1 || upright.iter().any(|square| *square > 1.0), "{width} x {height}");
        for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
            let [a, b] = [upright[y * width + x], turned[x * height + y]];
            assert!((a - b).abs() < 1e-3 * (1.0 + a), "{a} and {b} at {x}, {y} of {width} x {height}");
        }
    }
}
