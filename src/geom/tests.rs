//! Tests of `geom`.

use super::*;
use crate::units::PxVector;

#[test]
fn the_first_eigenvector_has_the_direction_of_greatest_extent() {
    for degrees in 0..180 {
        let (y, x) = (degrees as f32).to_radians().sin_cos();
        let along: PxVector = first_eigenvector(9.0 * x * x, 9.0 * x * y, 9.0 * y * y).expect("one direction");
        assert!(along.dot(PxVector::new(x, y)).abs() > 0.9999, "{degrees} degrees: {along:?}");
    }
    assert_eq!(first_eigenvector::<()>(2.0, 0.0, 2.0), None);
}
