//! Tests of `legend`.

use super::*;
use crate::lines::{Lost, Run};
use crate::units::MmPoint;

#[test]
fn of_the_patches_of_a_legend_all_are_drawn_or_none() {
    let place = |y: f32| MmRect::new(MmPoint::new(150.0, y), MmPoint::new(155.0, y + 5.0));
    let heights = [20.0, 30.0, 40.0];
    let entry = |y: f32| LegendEntry { place: Some(place(y)), ..LegendEntry::of_blank(Class::Red) };
    let entries = heights.map(entry);
    let square = |y: f32| {
        let MmRect { min, max } = place(y);
        let corners = [min, MmPoint::new(max.x, min.y), max, MmPoint::new(min.x, max.y), min];
        Line { strength: 90.0, runs: vec![Run::stroke(1.0, corners.to_vec())] }
    };
    // an outline elsewhere, and a stroke 2 mm beside a patch
    let stroke = Run::stroke(1.0, vec![MmPoint::new(157.0, 30.0), MmPoint::new(157.0, 35.0)]);
    let others = [square(60.0), Line { strength: 90.0, runs: vec![stroke] }];
    let kept = |lost: &[f32]| {
        let has_room = |y: &f32| !lost.contains(y);
        let lines = heights.into_iter().filter(has_room).map(square).chain(others.clone()).collect();
        let signs = lost.iter().map(|y| LostSign { at: place(*y).center(), kind: SignKind::Ring }).collect();
        let lost = Lost { signs, ..Lost::default() };
        let drawn = with_all_patches_or_none(Lines { lines, lost, ..Lines::default() }, &entries);
        (drawn.lines.len(), drawn.lost.signs.len())
    };
    assert_eq!(kept(&[]), (5, 0), "all have room");
    assert_eq!(kept(&[30.0, 40.0]), (2, 3), "one of three does not stay");
    assert_eq!(kept(&heights), (2, 3), "none had room");
}
