//! Tests of `painted_signs`.

use resvg::tiny_skia::{PathBuilder, Rect, Stroke};

use super::*;
use crate::edges::edgel::Edges;
use crate::raster::Raster;

const SIZE: Size = Size::new(400, 300);
const PX_PER_MM: f32 = 4.0;
const BLACK: [u8; 4] = [0, 0, 0, 255];
/// Nowhere in rows or columns.
const PLACES: [(f32, f32); 8] = [
    (61.0, 47.0),
    (103.0, 202.0),
    (148.0, 91.0),
    (190.0, 251.0),
    (233.0, 33.0),
    (287.0, 160.0),
    (322.0, 222.0),
    (350.0, 75.0),
];

/// A square with sides of 10 px around its middle.
fn square((x, y): (f32, f32), colour: [u8; 4]) -> PaintedPath {
    let path = PathBuilder::from_rect(Rect::from_xywh(x - 5.0, y - 5.0, 10.0, 10.0).expect("it has sides"));
    PaintedPath { colours: [Some(colour), None], ..PaintedPath::filled(path) }
}

fn squares(places: &[(f32, f32)]) -> Vec<PaintedPath> {
    places.iter().map(|at| square(*at, BLACK)).collect()
}

fn stroke(through: &[(f32, f32)]) -> PaintedPath {
    let mut path = PathBuilder::new();
    for (number, &(x, y)) in through.iter().enumerate() {
        if number == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    PaintedPath { stroke: Some(Stroke::default()), ..PaintedPath::filled(path.finish().expect("a path")) }
}

/// A white picture with black squares at these places.
fn picture(places: &[(f32, f32)]) -> Lab {
    let width = SIZE.width as usize;
    let is_inside = |x: f32, y: f32| places.iter().any(|at| (x - at.0).abs().max((y - at.1).abs()) < 5.0);
    let pixel = |cell: usize| f32::from(!is_inside((cell % width) as f32 + 0.5, (cell / width) as f32 + 0.5));
    Lab::of(&Raster::grey(SIZE, (0..SIZE.len()).map(pixel).collect()))
}

/// How many filled and hollow signs there are among paths in a picture of squares, and how many paths are theirs.
fn found(paths: &[PaintedPath], places: &[(f32, f32)]) -> [usize; 3] {
    let Some((signs, are_signs)) = find(paths, &picture(places), &Params::default(), PX_PER_MM, SIZE) else {
        return [0; 3];
    };
    let mut edges = Edges::none(SIZE);
    signs.add_to(&mut edges);
    let filled = edges.chains.iter().filter(|chain| chain.kind.stroke.is_none()).count();
    [filled, edges.chains.len() - filled, are_signs.into_iter().filter(|is_sign| *is_sign).count()]
}

#[test]
fn scattered_squares_are_signs_and_rows_of_them_are_none() {
    assert_eq!(found(&squares(&PLACES), &PLACES), [8, 0, 8]);
    assert_eq!(found(&squares(&PLACES[..3]), &PLACES), [0; 3], "three");
    let windows: Vec<(f32, f32)> =
        (0..12).map(|k| (80.0 + 41.0 * (k % 4) as f32, 60.0 + 57.0 * (k / 4) as f32)).collect();
    assert_eq!(found(&squares(&windows), &windows), [0; 3], "windows");
}

#[test]
fn what_is_hidden_is_no_sign_and_no_contour() {
    assert_eq!(found(&squares(&PLACES), &PLACES[..6]), [6, 0, 8]);
}

#[test]
fn of_two_colours_the_second_are_hollow() {
    // scattered, each four by themselves
    let is_black = [true, false, true, false, true, false, false, true];
    let coloured = |(at, is_black): (&(f32, f32), bool)| square(*at, if is_black { BLACK } else { [200, 0, 0, 255] });
    let paths: Vec<PaintedPath> = PLACES.iter().zip(is_black).map(coloured).collect();
    assert_eq!(found(&paths, &PLACES), [4, 4, 8]);
}

#[test]
fn two_strokes_around_one_middle_are_one_sign() {
    let strokes = |at: &(f32, f32)| {
        let corner = |x: f32, y: f32| (at.0 + x, at.1 + y);
        [stroke(&[corner(-5.0, -5.0), corner(5.0, 5.0)]), stroke(&[corner(-5.0, 5.0), corner(5.0, -5.0)])]
    };
    let paths: Vec<PaintedPath> = PLACES.iter().flat_map(strokes).collect();
    let things = small_things(&paths, 22.0);
    assert_eq!(things.len(), 8);
    let kinds = kinds(things, &paths);
    assert!(kinds.len() == 1 && kinds[0][3].may_mark(&paths));
    assert!((kinds[0][3].middle() - PxPoint::new(190.0, 251.0)).length() < 0.01);
}

#[test]
fn points_of_a_curve_and_ends_of_lines_are_no_signs_and_points_below_a_straight_line_are() {
    let with = |lines: &[PaintedPath]| found(&[&squares(&PLACES)[..], lines].concat(), &PLACES);
    assert_eq!(with(&[stroke(&PLACES)]), [0; 3], "a curve");
    assert_eq!(with(&[stroke(&[(10.0, 10.0), (390.0, 290.0)])]), [8, 0, 8], "a line that fits");
    let shafts: Vec<PaintedPath> = PLACES.iter().map(|at| stroke(&[(at.0, at.1 + 5.0), (200.0, 290.0)])).collect();
    assert_eq!(with(&shafts), [0; 3], "heads of arrows");
    let errors: Vec<PaintedPath> =
        PLACES.iter().map(|at| stroke(&[(at.0, at.1 - 12.0), (at.0, at.1 + 12.0)])).collect();
    assert_eq!(with(&errors), [0; 3], "bars of errors");
}

/// Level lines through the middles of all squares, so long to both sides of each or else from 10 to 390.
#[test]
fn stops_of_level_routes_are_no_signs_and_points_on_lines_of_a_grid_are() {
    let with = |reach: Option<f32>| {
        let line = |at: &(f32, f32)| match reach {
            Some(reach) => stroke(&[(at.0 - reach, at.1), (at.0 + 1.5 * reach, at.1)]),
            None => stroke(&[(10.0, at.1), (390.0, at.1)]),
        };
        let lines: Vec<PaintedPath> = PLACES.iter().map(line).collect();
        found(&[lines, squares(&PLACES)].concat(), &PLACES)
    };
    assert_eq!([with(Some(40.0)), with(None)], [[0; 3], [8, 0, 8]]);
}

/// As the heads of arrows between the boxes of a food web, whose upright shafts are as alike as lines of a grid.
#[test]
fn heads_at_the_ends_of_equal_shafts_are_no_signs() {
    let places = [(180.0, 32.0), (64.0, 96.0), (180.0, 96.0), (296.0, 96.0)];
    let shafts: Vec<PaintedPath> = places.iter().map(|&(x, y)| stroke(&[(x, y + 50.0), (x, y + 5.0)])).collect();
    assert_eq!(found(&squares(&places), &places), [4, 0, 4], "without shafts they are");
    assert_eq!(found(&[shafts, squares(&places)].concat(), &places), [0; 3]);
}

/// As in a figure of geometry.
#[test]
fn points_on_a_circle_are_no_signs() {
    let on_circle = |degrees: f32| {
        let (y, x) = degrees.to_radians().sin_cos();
        (200.0 + 110.0 * x, 150.0 + 110.0 * y)
    };
    let places = [10.0, 55.0, 130.0, 200.0, 290.0, 335.0].map(on_circle);
    let circle = PathBuilder::from_circle(200.0, 150.0, 110.0).expect("a circle");
    let circle = PaintedPath { stroke: Some(Stroke::default()), ..PaintedPath::filled(circle) };
    assert_eq!(found(&squares(&places), &places), [6, 0, 6], "without it they are");
    assert_eq!(found(&[squares(&places), vec![circle]].concat(), &places), [0; 3]);
}

#[test]
fn what_has_something_small_beside_it_is_a_letter() {
    let stems: Vec<PaintedPath> = PLACES.iter().map(|at| square((at.0 + 14.0, at.1 + 4.0), [9, 9, 9, 255])).collect();
    let long: Vec<PaintedPath> =
        PLACES.iter().map(|at| stroke(&[(at.0 + 8.0, at.1 - 5.0), (at.0 + 9.0, at.1 + 5.0)])).collect();
    assert_eq!(found(&[squares(&PLACES), long].concat(), &PLACES), [0; 3]);
    assert_eq!(found(&[squares(&PLACES), stems[..1].to_vec()].concat(), &PLACES), [8, 0, 8], "one of them");
}
