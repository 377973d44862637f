//! Tests of `verdict`.

use super::*;
use crate::page::{Figure, Parts};
use crate::units::{MmRect, Size};

/// The share that is said of a page that lacks so many of 100 mm of contours, and nothing of which is found.
fn left_out(millimetres: u32, of_photograph: bool) -> Option<f32> {
    let place = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
    let left = LeftOut { millimetres, of: 100, of_photograph, ..LeftOut::default() };
    let parts = Parts { origin: left.to_origin(), ..Parts::of([100.0, 100.0], figure) };
    let page = Page::new(parts).expect("it is on the sheet");
    Verdict::of(&page, &[], Fingertip::NotAsked).left_out
}

/// Of photographs between a fifth and a third no finding says so.
#[test]
fn contours_that_are_not_on_the_page_are_said_from_a_fifth_on() {
    for of_photograph in [true, false] {
        assert_eq!(left_out(19, of_photograph), None);
        assert_eq!(left_out(20, of_photograph), Some(MUCH));
        assert_eq!(left_out(34, of_photograph), Some(0.34));
    }
}
