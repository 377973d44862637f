//! Tests of `side_statistics`.

use super::*;

const SIZE: Size = Size::new(120, 120);

/// The statistics of a picture of one colour plane with this gradient.
fn statistics(colour: impl Fn(usize, usize) -> f32, gradient: impl Fn(usize, usize) -> [f32; 2]) -> SideStatistics {
    let mut builder = StatisticsBuilder::new(SIZE, 1, &Params::default(), 0..SIZE.height as usize);
    let width = SIZE.width as usize;
    for y in 0..SIZE.height as usize {
        builder.push_colours(&[(0..width).map(|x| colour(x, y)).collect()]);
        let mut row = TensorRow::default();
        for [gx, gy] in (0..width).map(|x| gradient(x, y)) {
            row.xx.push(gx * gx);
            row.xy.push(gx * gy);
            row.yy.push(gy * gy);
            row.length.push(gx.hypot(gy));
        }
        builder.push_tensor(&row);
    }
    builder.finish(&[], &[], 0.0)
}

fn flat(_: usize, _: usize) -> [f32; 2] {
    [0.0, 0.0]
}

const MIDDLE: PxPoint = PxPoint::new(60.0, 60.0);
const RIGHT: PxVector = PxVector::new(1.0, 0.0);

#[test]
fn a_flat_picture_has_no_difference_variance_or_surround() {
    let flat = statistics(|_, _| 50.0, flat);
    for at in [MIDDLE, PxPoint::new(0.0, 0.0), PxPoint::new(120.0, 120.0)] {
        let Sides { difference, variance } = flat.sides(at, RIGHT);
        assert!(difference < 1e-3 && variance < 1e-2, "{at:?}: {difference}, {variance}");
        assert!(flat.surround(at) < 1e-3, "{at:?}: {}", flat.surround(at));
    }
}

#[test]
fn the_variance_is_that_of_the_calmer_side() {
    // texture of +-10 on both sides, or on one only
    let texture = |x: usize, y: usize| if (x + y).is_multiple_of(2) { 10.0 } else { -10.0 };
    let both = statistics(texture, flat).sides(MIDDLE, RIGHT).variance;
    assert!((both - 100.0).abs() < 1.0, "{both}");
    let one = statistics(|x, y| if x < 60 { texture(x, y) } else { 0.0 }, flat).sides(MIDDLE, RIGHT).variance;
    assert!(one < 1e-2, "{one}");
}

#[test]
fn the_surround_counts_edges_but_not_those_in_one_direction() {
    let fence = statistics(|_, _| 0.0, |_, _| [1.0, 0.0]).surround(MIDDLE);
    let lawn = statistics(|_, _| 0.0, |x, y| if (x + y).is_multiple_of(2) { [1.0, 0.0] } else { [0.0, 1.0] });
    let lawn = lawn.surround(MIDDLE);
    // heights on a line through the window: sqrt(tau) times its sigma times the mean gradient
    let expected = std::f32::consts::TAU.sqrt() * SURROUND * Params::default().side_cell;
    assert!(fence < 0.01 * expected, "{fence}");
    assert!((lawn / expected - 1.0).abs() < 0.05, "{lawn}, not {expected}");
}

#[test]
fn of_edges_in_two_directions_the_surround_counts_those_in_the_less_common_one() {
    let mixed = |_: usize, y: usize| if y.is_multiple_of(16) { [0.0, 1.0] } else { [1.0, 0.0] };
    let all = std::f32::consts::TAU.sqrt() * SURROUND * Params::default().side_cell;
    let found = statistics(|_, _| 0.0, mixed).surround(MIDDLE);
    // 15 of 16 rows less the other one run in parallel
    let expected = all * NOT_PARALLEL * (1.0 - 14.0 / 16.0);
    assert!((found / expected - 1.0).abs() < 0.2, "{found}, not {expected}");
}
