//! Tests of `mask`.

use super::*;
use crate::units::Size;

#[test]
fn inside_of_a_ring_is_what_it_surrounds() {
    let grid = RegionGrid::new(Size::new(40, 30));
    // an L
    let ring = [(5.0, 5.0), (15.0, 5.0), (15.0, 20.0), (30.0, 20.0), (30.0, 25.0), (5.0, 25.0)];
    let mask = Mask::of_ring(grid, &ring.map(|(x, y)| PxPoint::new(x, y)));
    assert_eq!(mask.cells(), 10 * 20 + 15 * 5);
    for (x, y, is_in) in [(6.0, 6.0, true), (29.0, 24.0, true), (29.0, 10.0, false), (2.0, 10.0, false)] {
        assert_eq!(mask.contains(PxPoint::new(x, y)), is_in, "{x}, {y}");
    }
    let square = [(20.0, 5.0), (30.0, 5.0), (30.0, 15.0), (20.0, 15.0)].map(|(x, y)| PxPoint::new(x, y));
    assert_eq!(mask.extent(), Some([PxPoint::new(5.0, 5.0), PxPoint::new(30.0, 25.0)]));
    let (border, of_sides) = (mask.border(), 10 + 20 + 25 + 5 + 15 + 15);
    // four corners have two sides in one cell; none of the corner inside is one
    assert_eq!(border.len(), of_sides - 5, "{border:?}");
    assert!(border.contains(&PxPoint::new(5.5, 10.5)) && !border.contains(&PxPoint::new(7.5, 10.5)));
    // each side but the corner inside, where two meet
    assert_eq!(mask.clone().grown(1.0).cells(), mask.cells() + 10 + 20 + 25 + 5 + 15 + 15 - 1);
    assert_eq!(mask.united(&Mask::of_ring(grid, &square)).cells(), 10 * 20 + 15 * 5 + 100);
}
