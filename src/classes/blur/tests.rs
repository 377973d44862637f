//! Tests of `blur`.

use super::*;

#[test]
fn open_diffusion_is_a_gaussian() {
    let size = Size::new(41, 41);
    let mut point = vec![0.0; size.len()];
    point[20 * 41 + 20] = 1.0;
    let gaussian = Plane { size, values: point.clone() }.blurred(1.5).values;
    let mut planes = [point];
    Conductance::open(size).diffuse(&mut planes, 1.5);
    let [spread] = planes;
    assert!((spread.iter().sum::<f32>() - 1.0).abs() < 1e-4);
    let variance: f32 = spread.iter().enumerate().map(|(i, v)| v * ((i % 41) as f32 - 20.0).powi(2)).sum();
    assert!((variance - 2.25).abs() < 0.01, "{variance}");
    let most = spread.iter().zip(&gaussian).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(most < 0.01, "{most} off, the peak is {}", gaussian[20 * 41 + 20]);
}

/// A slanted contour from edge to edge: what is poured in on one side stays there.
#[test]
fn nothing_leaks_through_a_contour() {
    let size = Size::new(30, 20);
    for (from, to) in [((7.3, -1.0), (21.9, 21.0)), ((-1.0, 6.0), (31.0, 11.7)), ((14.1, -1.0), (14.1, 21.0))] {
        let mut conductance = Conductance::open(size);
        let steps = 37;
        let at = |i: i32| {
            let share = i as f32 / steps as f32;
            (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
        };
        conductance.block((0..=steps).map(at));
        let side = |cell: usize| {
            let (x, y) = ((cell % 30) as f32 + 0.5, (cell / 30) as f32 + 0.5);
            (to.0 - from.0) * (y - from.1) - (to.1 - from.1) * (x - from.0) > 1e-3
        };
        let mut planes = [(0..size.len()).map(|cell| f32::from(u8::from(side(cell)))).collect::<Vec<f32>>()];
        let before = planes[0].clone();
        conductance.diffuse(&mut planes, 6.0);
        assert!(planes[0] == before, "{from:?} to {to:?}");
    }
}
