//! Tests of `given`.

use super::*;
use crate::edges::{ChainKind, Edgel};

#[test]
fn a_line_that_was_added_and_erased_again_takes_no_room() {
    let size = Size::new(200, 100);
    let row = |y: f32| (10..190).map(move |x| PxPoint::new(x as f32, y));
    let edgels = |y: f32| row(y).map(|at| Edgel { at, strength: 40.0, contrast: [0.0; 3] });
    let mut edges = Edges::none(size);
    edges.push(edgels(20.0), false);
    edges.push_as(ChainKind { added: true, ..ChainKind::default() }, edgels(70.0), false);
    let outline = |y: f32| TracedContour {
        vertices: row(y).map(|at| TracePoint { at, strength: 40.0 }).collect(),
        closed: false,
    };
    let outline = |y: f32| RegionOutline { contour: outline(y), region: 0 };
    let mut room_without = |erased: &[[f32; 4]]| {
        erase(&mut edges, erased);
        let decisions = Decisions { erased: erased.to_vec(), room_of_added: 8.0, ..Decisions::default() };
        [22.0, 72.0].map(|y| with_room(vec![outline(y)], &edges, &decisions).len())
    };
    assert_eq!(room_without(&[]), [1, 0], "only what was added takes room");
    assert_eq!(room_without(&[[0.0, 0.6, 1.0, 0.65]]), [1, 0], "nothing was erased");
    assert_eq!(room_without(&[[0.0, 0.68, 1.0, 0.71]]), [1, 1]);
}

#[test]
fn of_lines_that_a_person_gave_all_are_drawn() {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    for (key, value) in [("lines.detail", "0.5"), ("lines.shapes", "3")] {
        profile.set(key, value).expect("a key and its value");
    }
    let of = |lines: Option<GivenLines>| {
        let plan = Given { lines, ..Given::default() }.plan(&profile).expect("it makes sense");
        (plan.lines().detail, plan.lines().most_shapes)
    };
    assert_eq!(of(None), (0.5, Some(3)));
    assert_eq!(of(Some(GivenLines::Picture(Vec::new()))), (1.0, None));
}

#[test]
fn what_is_around_boxes_is_everything_else() {
    let boxes = [[0.1, 0.2, 0.5, 0.6], [0.4, 0.4, 1.0, 0.8], [0.0, 0.9, 0.3, 1.0]];
    let left = around(&boxes);
    for x in 0..50 {
        for y in 0..50 {
            let at = [(x as f32 + 0.5) / 50.0, (y as f32 + 0.5) / 50.0];
            assert_ne!(is_in(at, &left), is_in(at, &boxes), "{at:?}");
        }
    }
}
