//! Tests of `small_areas`.

use super::*;
use crate::classes::{Class, Region};
use crate::raster::plane::Plane;

/// Twenty by ten cells of a square mm with boxes of a class: left, top, width, height.
fn classes(boxes: &[(Class, [usize; 4])]) -> Classes {
    let size = Size::new(20, 10);
    let mut region = vec![None; size.len()];
    let mut regions = Vec::new();
    for (number, &(class, [left, top, width, height])) in (0..).zip(boxes) {
        for y in top..top + height {
            region[y * 20 + left..y * 20 + left + width].fill(Some(number));
        }
        regions.push(Region { class, colour: [0; 3], cells: (width * height) as u32 });
    }
    Classes { size, region, regions, lightness: Plane::filled(size, 0.5), fringe: Vec::new() }
}

#[test]
fn small_areas_that_are_gone_are_lost_and_strokes_and_large_ones_are_not() {
    let bar = (Class::Yellow, [1, 1, 7, 8]);
    let (stroke, large) = ((Class::Red, [10, 0, 2, 10]), (Class::Blue, [13, 0, 7, 10]));
    let lost = |kept: &[(Class, [usize; 4])]| {
        let lost = lost(&classes(kept), &classes(&[bar, stroke, large]), 1.0, 60.0);
        lost.into_iter().map(|(region, _)| region).collect::<Vec<_>>()
    };
    assert_eq!(lost(&[large]), [0]);
    assert!(lost(&[bar, large]).is_empty(), "it is there");
    assert_eq!(lost(&[(Class::Green, bar.1), large]), [0], "with another sign");
}
