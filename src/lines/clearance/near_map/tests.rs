//! Tests of `near_map`.

use super::*;

#[test]
fn outside_of_the_area_nothing_is_missed() {
    let mut map = NearMap::new(MmRect::new(MmPoint::new(10.0, 5.0), MmPoint::new(50.3, 40.0)), 5.0);
    map.mark(MmPoint::new(30.0, -20.0));
    map.mark(MmPoint::new(80.0, 60.0));
    for at in [(32.0, -23.0), (28.0, 1.0), (77.0, 64.0)] {
        assert!(map.may_be_near(MmPoint::from(at)), "{at:?}");
    }
    assert!(!map.may_be_near(MmPoint::new(12.0, -20.0)));
}

#[test]
fn what_is_in_reach_is_on_the_map_and_what_is_far_is_not() {
    let mut map = NearMap::new(MmRect::new(MmPoint::new(10.0, 5.0), MmPoint::new(50.3, 40.0)), 5.0);
    let path = |share: f32| MmPoint::new(20.0, 15.0).lerp(MmPoint::new(35.0, 30.0), share);
    let steps = (15.0 * 2.0_f32.sqrt() / MARK).ceil();
    (0..=steps as u32).for_each(|k| map.mark(path(k as f32 / steps)));
    for i in 0..=400 {
        for j in 0..=340 {
            let at = MmPoint::new(10.0 + 0.1 * i as f32, 5.0 + 0.1 * j as f32);
            let distance = (0..=200).map(|k| (path(k as f32 / 200.0) - at).length()).fold(f32::MAX, f32::min);
            assert!(map.may_be_near(at) || distance > 5.0, "{at:?} is {distance} mm away");
            assert!(!map.may_be_near(at) || distance < 8.5, "{at:?} is {distance} mm away");
        }
    }
}
