//! Ends of contours: where they lead, and to what they are joined.

use super::super::contour::testing::polyline;
use super::*;

const SIGMA: f32 = 1.8;

/// In a picture that all corners lie in.
fn join_corners(found: Vec<FoundContour>, sigma: f32, is_seen: &IsSeen<'_>) -> Vec<FoundContour> {
    super::join_corners(found, sigma, Size::new(300, 300), is_seen)
}

fn stroke(points: &[(f32, f32)]) -> FoundContour {
    FoundContour { stroke: Some(4.0), ..FoundContour::edge(polyline(points)) }
}

#[test]
fn the_sides_of_a_sharp_corner_meet_at_its_tip() {
    // 28 degrees between the sides, whose tip is at (100, 50)
    let sides = [stroke(&[(-60.0, 10.0), (90.0, 47.5)]), stroke(&[(-60.0, 90.0), (92.0, 52.0)])];
    let corner = join_corners(sides.to_vec(), SIGMA, &|_, _, _, _| true);
    assert_eq!(corner.len(), 1);
    let at = |(x, y)| {
        let distances = corner[0].contour.vertices.iter().map(|vertex| (vertex.at - PxPoint::new(x, y)).length());
        distances.fold(f32::INFINITY, f32::min)
    };
    assert!(at((100.0, 50.0)) < 0.1 && at((-60.0, 10.0)) < 0.1 && at((-60.0, 90.0)) < 0.1);
}

#[test]
fn a_stroke_whose_own_ends_make_a_corner_is_closed() {
    let triangle =
        join_corners(vec![stroke(&[(92.0, 48.0), (20.0, 30.0), (20.0, 70.0), (90.0, 52.5)])], SIGMA, &|_, _, _, _| {
            true
        });
    assert!(triangle.len() == 1 && triangle[0].contour.closed);
    assert!((triangle[0].contour.length() - 2.0 * 82.46 - 40.0).abs() < 0.5);
}

#[test]
fn what_is_one_in_a_closed_thread_does_not_depend_on_which_part_comes_first() {
    // a triangle of two strokes, which make a corner, and an edge
    let stroke = |points: &[(f32, f32)]| stroke(points);
    let sides = [
        stroke(&[(20.0, 100.0), (100.0, 20.0)]),
        stroke(&[(104.0, 20.0), (184.0, 100.0)]),
        FoundContour { stroke: None, ..stroke(&[(182.0, 103.0), (22.0, 103.0)]) },
    ];
    for first in 0..3 {
        for reversed in 0..8 {
            let mut sides = sides.clone();
            sides.rotate_left(first);
            for (k, side) in sides.iter_mut().enumerate() {
                if reversed & (1 << k) != 0 {
                    side.contour.reverse();
                }
            }
            let met = join_corners(sides.to_vec(), SIGMA, &|_, _, _, _| true);
            let mut lengths: Vec<f32> = met.iter().map(|found| found.contour.length()).collect();
            lengths.sort_by(f32::total_cmp);
            let [edge, two] = lengths[..] else { panic!("{lengths:?} from {first}, {reversed:b} reversed") };
            let is_as_ever = (edge - 170.0).abs() < 0.5 && (two - 2.0 * 85.0 * 2.0_f32.sqrt()).abs() < 0.5;
            assert!(is_as_ever, "{lengths:?} from {first}, {reversed:b} reversed");
        }
    }
}

#[test]
fn ends_that_make_no_corner_stay() {
    let parallel = [stroke(&[(-60.0, 46.0), (90.0, 46.0)]), stroke(&[(-60.0, 54.0), (90.0, 54.0)])];
    assert_eq!(join_corners(parallel.to_vec(), SIGMA, &|_, _, _, _| true).len(), 2);
    let far = [stroke(&[(-80.0, 5.0), (46.0, 36.5)]), stroke(&[(-80.0, 95.0), (46.0, 63.5)])];
    assert_eq!(join_corners(far.to_vec(), SIGMA, &|_, _, _, _| true).len(), 2, "27 px apart are more than 26");
    let steps = [stroke(&[(20.0, 30.0), (160.0, 30.0)]), stroke(&[(165.0, 34.0), (300.0, 34.0)])];
    assert_eq!(join_corners(steps.to_vec(), SIGMA, &|_, _, _, _| true).len(), 2);
}

#[test]
fn a_short_stroke_makes_a_corner_if_the_way_to_its_tip_is_seen() {
    // 14 px, as of the eaves of a small house
    let corner = [stroke(&[(86.0, 50.0), (100.0, 50.0)]), stroke(&[(-60.0, 109.4), (92.0, 53.5)])];
    assert_eq!(join_corners(corner.to_vec(), SIGMA, &|_, _, _, _| false).len(), 2);
    assert_eq!(join_corners(corner.to_vec(), SIGMA, &|_, _, _, _| true).len(), 1);
    let crumb = [stroke(&[(94.0, 50.0), (100.0, 50.0)]), corner[1].clone()];
    assert_eq!(join_corners(crumb.to_vec(), SIGMA, &|_, _, _, _| true).len(), 2, "6 px are no line");
}

#[test]
fn a_stroke_goes_on_over_a_gap() {
    let aligned = [stroke(&[(20.0, 30.0), (160.0, 30.0)]), stroke(&[(165.0, 30.0), (300.0, 30.0)])];
    let one = join_corners(aligned.to_vec(), SIGMA, &|_, _, _, _| true);
    assert!(matches!(&one[..], [one] if (one.contour.length() - 280.0).abs() < 1.0));
}

#[test]
fn strokes_of_two_tints_make_a_corner_only_where_they_touch_and_go_on_in_their_own_first() {
    let of = |colour: [f32; 3], points: &[(f32, f32)]| FoundContour { tint: Tint::of(colour), ..stroke(points) };
    let (grey, blue) = ([-30.0, 0.0, 0.0], [-50.0, -8.0, -80.0]);
    // up to an x, 28 degrees between the sides
    let corner = |second, x: f32| {
        let off = 0.25 * (100.0 - x);
        let sides = [of(grey, &[(-60.0, 10.0), (x, 50.0 - off)]), of(second, &[(-60.0, 90.0), (x, 50.0 + off)])];
        join_corners(sides.to_vec(), SIGMA, &|_, _, _, _| true).len()
    };
    assert_eq!([corner(grey, 76.0), corner(blue, 76.0), corner(blue, 92.0)], [1, 2, 1]);
    // the blue end is nearer to the grey one than the other grey end is
    let row = |third| {
        let pieces = vec![
            of(grey, &[(20.0, 30.0), (140.0, 30.0)]),
            of(grey, &[(155.0, 30.0), (280.0, 30.0)]),
            of(third, &[(149.0, 30.5), (290.0, 50.0)]),
        ];
        let joined = join_corners(pieces, SIGMA, &|_, _, _, _| true);
        joined.iter().map(|found| found.contour.length()).fold(0.0, f32::max)
    };
    assert!((row(grey) - 271.4).abs() < 1.0, "{}", row(grey));
    assert!((row(blue) - 260.0).abs() < 1.0, "{}", row(blue));
}

#[test]
fn a_gridline_that_runs_into_a_corner_of_a_figure_is_none_of_its_sides() {
    // the sides of a figure meet at (100, 50); 14 degrees from one of them a thin line leads there, too
    let thin = |width: f32| FoundContour { stroke: Some(width), ..stroke(&[(-60.0, 50.0), (88.0, 50.0)]) };
    let sides = [stroke(&[(-60.0, 90.0), (94.0, 51.5)]), stroke(&[(102.0, 54.0), (140.0, 130.0)])];
    let figure = |width: f32| {
        let all = [thin(width), sides[0].clone(), sides[1].clone()];
        let mut lengths: Vec<f32> =
            join_corners(all.to_vec(), SIGMA, &|_, _, _, _| true).iter().map(|found| found.contour.length()).collect();
        lengths.sort_by(f32::total_cmp);
        lengths
    };
    let [line, figure_of_two] = figure(2.0)[..] else { panic!("{:?}", figure(2.0)) };
    assert!((line - 148.0).abs() < 0.5 && (figure_of_two - 164.9 - 89.4).abs() < 3.0, "{line} {figure_of_two}");
    // as wide as the sides it is taken for one
    let [left, corner] = figure(4.0)[..] else { panic!("{:?}", figure(4.0)) };
    assert!(left < 90.0 && corner > 300.0, "{left} {corner}");
    // led aside by a side, it points at the other one
    let onward = |width: f32| {
        let side = stroke(&[(108.0, 53.5), (188.0, 83.0)]);
        join_corners(vec![thin(width), side], SIGMA, &|_, _, _, _| true).len()
    };
    assert_eq!([onward(2.0), onward(4.0)], [2, 1]);
}

#[test]
fn wires_that_end_on_plates_are_not_joined_over_a_gap_in_which_nothing_is_seen() {
    let wires = [stroke(&[(100.0, 20.0), (100.0, 120.0)]), stroke(&[(100.0, 135.0), (100.0, 250.0)])];
    let plates = [stroke(&[(80.0, 120.0), (120.0, 120.0)]), stroke(&[(85.0, 135.0), (115.0, 135.0)])];
    let count = |found: Vec<FoundContour>, is_seen: bool| join_corners(found, SIGMA, &|_, _, _, _| is_seen).len();
    let battery = || [wires.clone(), plates.clone()].concat();
    assert_eq!(count(battery(), false), 4);
    assert_eq!(count(battery(), true), 3, "a line that was found in pieces");
    assert_eq!(count(wires.to_vec(), false), 1, "a line with a gap");
    // a wire round the battery, whose ends are those of one line
    let round = stroke(&[(100.0, 120.0), (100.0, 20.0), (200.0, 20.0), (200.0, 250.0), (100.0, 250.0), (100.0, 135.0)]);
    let circuit = join_corners([vec![round], plates.to_vec()].concat(), SIGMA, &|_, _, _, _| false);
    assert!(circuit.len() == 3 && circuit.iter().all(|found| !found.contour.closed));
    // both on one line, which they cross
    let crossed = [
        stroke(&[(100.0, 20.0), (100.0, 119.0)]),
        stroke(&[(60.0, 120.0), (140.0, 120.0)]),
        stroke(&[(100.0, 121.0), (100.0, 250.0)]),
    ];
    assert_eq!(count(crossed.to_vec(), false), 2);
}

#[test]
fn an_edge_and_a_stroke_meet_and_stay_two() {
    let edge = FoundContour { stroke: None, ..stroke(&[(-60.0, 109.4), (92.0, 53.5)]) };
    let both = join_corners(vec![stroke(&[(-60.0, 50.0), (98.0, 50.0)]), edge], SIGMA, &|_, _, _, _| true);
    assert_eq!(both.len(), 2);
    let ends = both.iter().map(|found| found.contour.vertices.iter().map(|v| v.at.x).fold(0.0, f32::max));
    assert!(ends.into_iter().all(|x| (x - 101.5).abs() < 0.2));
}

#[test]
fn a_right_angle_is_closed_over_a_small_gap_and_a_tip_that_is_not_seen_is_none() {
    let corner = [stroke(&[(20.0, 50.0), (96.0, 50.0)]), stroke(&[(100.0, 54.0), (100.0, 150.0)])];
    assert_eq!(join_corners(corner.to_vec(), SIGMA, &|_, _, _, _| true).len(), 1);
    let far = [stroke(&[(20.0, 50.0), (88.0, 50.0)]), stroke(&[(100.0, 62.0), (100.0, 150.0)])];
    assert_eq!(join_corners(far.to_vec(), SIGMA, &|_, _, _, _| true).len(), 2);
    let sides = [stroke(&[(-60.0, 10.0), (80.0, 45.0)]), stroke(&[(-60.0, 90.0), (80.0, 55.0)])];
    assert_eq!(join_corners(sides.to_vec(), SIGMA, &|_, _, _, _| false).len(), 2);
}

#[test]
fn an_edge_goes_on_in_a_stroke_as_one_line() {
    let edge = FoundContour { stroke: None, ..stroke(&[(20.0, 30.0), (60.0, 30.0)]) };
    let one = join_corners(vec![edge, stroke(&[(65.0, 30.0), (300.0, 30.0)])], SIGMA, &|_, _, _, _| true);
    assert!(matches!(&one[..], [one] if one.stroke.is_some() && (one.contour.length() - 280.0).abs() < 1.0));
}

#[test]
fn a_tip_beyond_the_border_of_the_picture_is_none() {
    // what lies beyond cannot be seen, and looks as the border does
    let sides = vec![stroke(&[(-60.0, 10.0), (90.0, 47.5)]), stroke(&[(-60.0, 90.0), (92.0, 52.0)])];
    let met_in =
        |width, height| super::join_corners(sides.clone(), SIGMA, Size::new(width, height), &|_, _, _, _| true);
    assert_eq!(met_in(101, 100).len(), 1);
    let apart = met_in(95, 100);
    let farthest = apart.iter().flat_map(|found| &found.contour.vertices).map(|vertex| vertex.at.x).fold(0.0, f32::max);
    assert!(apart.len() == 2 && farthest < 95.0, "the tip is at (100, 50): {farthest}");
    assert_eq!(met_in(300, 49).len(), 2);
}

#[test]
fn two_edges_make_a_sharp_corner_and_no_other_and_do_not_go_on_in_one_another() {
    let edge = |points: &[(f32, f32)]| FoundContour::edge(polyline(points));
    let met = |found: [FoundContour; 2]| join_corners(found.to_vec(), SIGMA, &|_, _, _, _| true);
    // 28 degrees between the sides, whose tip is at (100, 50)
    let sharp = met([edge(&[(-60.0, 10.0), (96.0, 49.0)]), edge(&[(-60.0, 90.0), (96.0, 51.0)])]);
    let [sharp] = &sharp[..] else { panic!("{} contours", sharp.len()) };
    let to_tip = sharp.contour.vertices.iter().map(|vertex| (vertex.at - PxPoint::new(100.0, 50.0)).length());
    assert!(to_tip.fold(f32::INFINITY, f32::min) < 0.1 && sharp.stroke.is_none());
    for other in [[(163.0, 33.0), (163.0, 160.0)], [(165.0, 30.0), (290.0, 30.0)]] {
        let edges = [edge(&[(20.0, 30.0), (160.0, 30.0)]), edge(&other)];
        let stay = met(edges.clone());
        assert!(stay.len() == 2 && edges.iter().all(|edge| stay.contains(edge)), "a right angle, and straight on");
        assert_eq!(met([stroke(&[(20.0, 30.0), (160.0, 30.0)]), stroke(&other)]).len(), 1, "strokes do");
    }
}
