//! Tests of `unite`.

use super::*;

fn line(points: &[(f32, f32)], closed: bool) -> Polyline<Edgel> {
    let edgel = |&(x, y): &(f32, f32)| Edgel { at: PxPoint::new(x, y), strength: 50.0, contrast: [0.0; 3] };
    Polyline { vertices: points.iter().map(edgel).collect(), closed }
}

#[test]
fn the_longest_side_goes_from_corner_to_corner() {
    let hook = line(&[(0.0, 0.0), (10.0, 0.0), (20.0, 1.0), (30.0, 3.0), (30.0, 18.0)], false);
    assert!((longest_side(&hook) - 30.2).abs() < 0.1, "{}", longest_side(&hook));
}

#[test]
fn only_what_runs_along_a_contour_lies_on_it() {
    let mut covered = Covered::new(Size::new(100, 100));
    covered.add(&line(&[(10.0, 50.0), (90.0, 50.0)], false), 4.0, 0);
    let under = |a: (f32, f32), b: (f32, f32), is_stroke: bool| {
        covered.under(PxPoint::new(a.0, a.1), PxPoint::new(b.0, b.1), is_stroke)
    };
    assert_eq!(under((40.0, 52.0), (60.0, 52.0), false), Some(PxPoint::new(50.0, 50.0)));
    assert_eq!(under((50.0, 45.0), (50.0, 55.0), false), None, "across it");
    assert_eq!(under((40.0, 56.0), (60.0, 56.0), false), None, "beside it");
    assert_eq!(under((40.0, 52.0), (60.0, 52.0), true), None, "the middle of a stroke is another");
    assert!(covered.is_near(PxPoint::new(50.0, 53.0)) && !covered.is_near(PxPoint::new(50.0, 55.0)));
}

#[test]
fn a_window_is_told_from_its_wall_and_a_line_drawn_twice_is_not() {
    let of = |corners: &[(f32, f32)], strengths: &[f32]| {
        let mut drawn = line(corners, false);
        drawn.vertices.iter_mut().zip(strengths).for_each(|(vertex, strength)| vertex.strength = *strength);
        vec![Confirmed { line: drawn, stroke: Some(8.0), on_borders: 0, faint: false }]
    };
    // the wall has the contrast of the window where that lies on it
    let wall =
        of(&[(10.0, 50.0), (30.0, 50.0), (50.0, 50.0), (70.0, 50.0), (90.0, 50.0)], &[99.0, 99.0, 99.0, 126.0, 126.0]);
    let merged = |window: Vec<Confirmed>| merged_coincident(vec![wall.clone(), window], Size::new(100, 100));
    let window = |strength: f32| of(&[(70.0, 50.0), (80.0, 50.0), (90.0, 50.0)], &[strength; 3]);
    let (kept, overlaid) = merged(window(126.0));
    assert_eq!((kept.len(), overlaid), (1, vec![PxPoint::new(80.0, 50.0)]));
    assert!(merged(window(99.0)).1.is_empty(), "the same colour");
    let tick = of(&[(74.0, 50.0), (80.0, 50.0), (86.0, 50.0)], &[126.0; 3]);
    assert!(merged(tick).1.is_empty(), "so short that what crosses it may give it its contrast");
    let below = merged_coincident(vec![window(126.0), wall.clone()], Size::new(100, 100));
    assert!(below.1.is_empty(), "the wall hides it");
}

#[test]
fn the_line_of_a_grid_on_an_axis_is_no_window() {
    let level = |y: f32, strength: f32, width: f32| {
        let mut drawn = line(&[(10.0, y), (50.0, y), (90.0, y)], false);
        drawn.vertices.iter_mut().for_each(|vertex| vertex.strength = strength);
        vec![Confirmed { line: drawn, stroke: Some(width), on_borders: 0, faint: false }]
    };
    let overlaid = |grid: &[f32]| {
        let lines = || grid.iter().map(|y| level(*y, 99.0, 2.0));
        let axis = || std::iter::once(level(50.0, 126.0, 3.0));
        let count = |all: Vec<Vec<Confirmed>>| merged_coincident(all, Size::new(100, 100)).1.len();
        // every second one drawn from the right, and of a width that rounding makes another
        let other_way = lines().enumerate().map(|(number, mut of)| {
            if number % 2 == 1 {
                of[0].line.vertices.reverse();
                of[0].stroke = Some(2.000_001);
            }
            of
        });
        let counts = [count(axis().chain(lines()).collect()), count(axis().chain(other_way).collect())];
        assert_eq!(counts[0], counts[1], "{grid:?}");
        counts[0]
    };
    assert_eq!([overlaid(&[50.0]), overlaid(&[30.0, 50.0]), overlaid(&[30.0, 50.0, 70.0])], [1, 1, 0]);
}

#[test]
fn the_border_of_an_area_that_its_neighbours_have_too_is_no_window() {
    let area = |corners: &[(f32, f32)], strength: f32| {
        let mut drawn = line(corners, true);
        drawn.vertices.iter_mut().for_each(|vertex| vertex.strength = strength);
        vec![Confirmed { line: drawn, stroke: Some(2.0), on_borders: 0, faint: false }]
    };
    // of two with one outline the second lies on the first
    let square = [(10.0, 10.0), (90.0, 10.0), (90.0, 90.0), (10.0, 90.0)];
    let (kept, overlaid) = merged_coincident(vec![area(&square, 99.0), area(&square, 126.0)], Size::new(100, 100));
    assert_eq!((kept.len(), overlaid), (1, Vec::new()));
}
