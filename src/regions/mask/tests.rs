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

#[test]
fn a_place_inside_is_far_from_the_border_and_from_the_edge_of_the_picture() {
    let grid = RegionGrid::new(Size::new(40, 30));
    let of = |ring: &[(f32, f32)]| Mask::of_ring(grid, &ring.iter().map(|&at| PxPoint::from(at)).collect::<Vec<_>>());
    // a hook, whose middle is not in it
    let hook = of(&[(5.0, 5.0), (30.0, 5.0), (30.0, 8.0), (14.0, 8.0), (14.0, 25.0), (5.0, 25.0)]);
    let at = hook.inside().expect("it has cells");
    assert!((8.0..11.0).contains(&at.x) && hook.contains(at), "{at:?}");
    assert!(hook.on_picture_edge() <= 0.0);
    let half = of(&[(0.0, 0.0), (20.0, 0.0), (20.0, 30.0), (0.0, 30.0)]);
    assert!((half.on_picture_edge() - 0.7).abs() < 0.02, "{}", half.on_picture_edge());
    // the left half: not where it is farthest from the other one
    let at = half.inside().expect("it has cells");
    assert!((9.0..11.0).contains(&at.x) && (9.0..21.0).contains(&at.y), "{at:?}");
    // all of the picture
    let at = of(&[(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 30.0)]).inside().expect("it has cells");
    assert!((14.0..16.0).contains(&at.y), "{at:?}");
    assert_eq!(of(&[(1.0, 1.0), (1.0, 1.2), (1.2, 1.0)]).inside(), None);
}

#[test]
fn lines_that_meet_enclose_what_no_edge_of_the_picture_can_be_reached_from() {
    let grid = RegionGrid::new(Size::new(60, 40));
    let point = |(x, y): (f32, f32)| PxPoint::new(x, y);
    let frame = [(10.0, 10.0), (50.0, 10.0), (50.0, 30.0), (10.0, 30.0), (10.0, 10.0)].map(point).to_vec();
    let middle = [(30.0, 10.0), (30.0, 30.0)].map(point).to_vec();
    let eye = [(18.0, 18.0), (22.0, 18.0), (22.0, 22.0), (18.0, 22.0), (18.0, 18.0)].map(point).to_vec();
    let lines = [frame, middle, eye];
    let enclosed = |lines: &[Vec<PxPoint>], at| Mask::enclosed(grid, lines, point(at));
    let left = enclosed(&lines, (13.0, 13.0)).expect("it is closed");
    assert!(left.contains(point((20.0, 20.0))), "with what lies in it");
    assert!(!left.contains(point((40.0, 20.0))), "but not beyond the line across");
    assert_eq!(left.extent(), Some([point((10.0, 10.0)), point((31.0, 31.0))]), "with the lines around it");
    assert_eq!(enclosed(&lines, (20.5, 20.5)).map(|eye| eye.contains(point((13.0, 13.0)))), Some(false));
    assert_eq!(enclosed(&lines, (5.0, 20.0)), None, "outside");
    assert_eq!(enclosed(&lines, (30.5, 20.0)), None, "on a line");
    assert_eq!(enclosed(&lines[1..], (40.0, 20.0)), None, "open");
    assert_eq!(enclosed(&lines, (70.0, 20.0)), None, "beyond the picture");
}

#[test]
fn what_is_large_or_reaches_three_sides_fills_a_picture() {
    let grid = RegionGrid::new(Size::new(40, 40));
    let mask = |left: f32, top: f32, right: f32, bottom: f32| {
        let ring = [(left, top), (right, top), (right, bottom), (left, bottom)].map(|(x, y)| PxPoint::new(x, y));
        Mask::of_ring(grid, &ring)
    };
    assert!(mask(0.0, 0.0, 40.0, 20.0).fills(0.7), "three sides");
    assert!(mask(2.0, 2.0, 38.0, 38.0).fills(0.7), "large");
    assert!(!mask(0.0, 0.0, 20.0, 20.0).fills(0.7) && !mask(5.0, 5.0, 30.0, 30.0).fills(0.7));
}
