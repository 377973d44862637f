//! Tests of `jpeg`.

use super::*;

#[test]
fn the_scale_is_the_smallest_that_is_enough_on_both_sides() {
    for (size, target, want) in [
        ((4000, 3000), (500, 375), 1),
        ((4000, 3000), (501, 375), 2),
        ((4000, 3000), (500, 376), 2),
        ((4000, 3000), (850, 638), 2),
        ((4000, 3000), (1001, 1), 4),
        ((4000, 3000), (2001, 1), 8),
        ((1, 10_000), (1, 100), 8),
        ((15, 15), (1, 1), 8),
        ((4001, 1000), (500, 125), 1),
    ] {
        assert_eq!(eighths(Size::new(size.0, size.1), Size::new(target.0, target.1)), want, "{size:?} {target:?}");
    }
}
