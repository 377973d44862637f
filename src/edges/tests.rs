//! Tests of `edges`.

use super::ridge::EdgeProfile;
use super::*;
use crate::units::{PxPoint, PxVector};

#[test]
fn the_border_of_a_picture_is_what_runs_along_it_close_by() {
    let is_border = |x: f32, y: f32, across: (f32, f32)| {
        let profile = EdgeProfile { maximum: 8.0, curvature: 0.25, pedestal: [0.0; 2], distance: 4.5 };
        let (at, normal) = (PxPoint::new(x, y), PxVector::new(across.0, across.1));
        let (column, row) = (x as u32, y as u32);
        super::is_border(&RidgePoint { at, normal, profile, height: 30.0, blur: 2.0, column, row }, Size::new(80, 60))
    };
    let (upright, level) = ((1.0, 0.0), (0.0, -1.0));
    assert!(is_border(1.5, 30.0, upright) && is_border(78.5, 30.0, upright));
    assert!(is_border(40.0, 1.5, level) && is_border(40.0, 58.5, level));
    assert!(!is_border(4.0, 30.0, upright) && !is_border(40.0, 50.0, level), "farther in");
    assert!(!is_border(1.5, 30.0, level) && !is_border(40.0, 58.5, upright), "it leads out of the picture");
}
