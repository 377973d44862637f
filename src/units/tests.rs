//! Tests of `units`.

use super::*;

#[test]
fn a_picture_fills_its_rectangle_and_points_come_back() {
    let place = MmRect::new(MmPoint::new(20.0, 30.0), MmPoint::new(120.0, 80.0));
    let transform = PageTransform::new(Size::new(400, 200), place);
    assert!((transform.mm_per_px() - 0.25).abs() < 1e-6);
    assert!((transform.to_mm(PxPoint::new(400.0, 200.0)) - place.max).length() < 1e-4);
    // Half a pixel that rounding took from the height is not missing at the bottom.
    let rounded = PageTransform::new(Size::new(400, 199), MmRect::new(place.min, MmPoint::new(120.0, 79.9)));
    assert!((rounded.to_mm(PxPoint::new(400.0, 199.0)) - MmPoint::new(120.0, 79.9)).length() < 1e-4);
    let at = PxPoint::new(123.4, 56.7);
    assert!((transform.to_px(transform.to_mm(at)) - at).length() < 1e-3);
}
