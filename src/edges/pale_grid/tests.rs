//! Tests of `pale_grid`.

use super::*;
use crate::edges::contour::ContourPoint;

const PICTURE: Size = Size::new(600, 400);

/// A level stroke at `y`, with these contrasts from and to these places.
fn level(y: f32, pieces: &[(std::ops::Range<u16>, f32)]) -> Contour {
    let point = |x: u16, strength: f32| ContourPoint {
        at: PxPoint::new(f32::from(x), y),
        strength,
        contrast: [0.0; 3],
        blur: 1.0,
        position_sigma: 0.1,
    };
    let vertices = pieces.iter().flat_map(|(of, strength)| of.clone().map(|x| point(x, *strength))).collect();
    Polyline::open(vertices)
}

/// The side of a bar, up to `top`.
fn side(x: f32, top: u16) -> Contour {
    let mut side = level(0.0, &[(top..350, 140.0)]);
    side.vertices.iter_mut().for_each(|point| point.at = PxPoint::new(x, point.at.x));
    side
}

fn parted_strokes(contours: Vec<Contour>) -> Vec<Weighed> {
    let widths = vec![Some(1.0); contours.len()];
    parted(contours, &widths, PICTURE)
}

/// From where to where the faint ones run.
fn faint(all: &[Weighed]) -> Vec<[f32; 2]> {
    let ends = |contour: &Contour| [contour.vertices[0].at.x, contour.vertices[contour.vertices.len() - 1].at.x];
    all.iter().filter(|(_, _, faint)| *faint).map(|(contour, ..)| ends(contour)).collect()
}

#[test]
fn a_bar_keeps_its_top_on_a_gridline() {
    let grid = |y: f32| level(y, &[(50..550, 13.0)]);
    // the change is found two pixels beside the corner
    let with_top = level(200.0, &[(50..302, 13.0), (302..380, 140.0), (380..550, 13.0)]);
    let contours = vec![grid(100.0), grid(150.0), with_top, grid(250.0), side(300.0, 200), side(379.0, 200)];
    let all = parted_strokes(contours);
    assert_eq!(all.len(), 8);
    assert_eq!(faint(&all), [[50.0, 549.0], [50.0, 549.0], [50.0, 300.0], [379.0, 549.0], [50.0, 549.0]]);
}

#[test]
fn shapes_whose_sides_lie_on_squared_paper_are_parted_from_its_lines() {
    // most of each line is pale, and nothing else is strong
    let with_side = |y: f32| level(y, &[(50..200, 13.0), (200..300, 100.0), (300..550, 13.0)]);
    let all = parted_strokes([100.0, 150.0, 200.0, 250.0].map(with_side).to_vec());
    assert_eq!((all.len(), faint(&all).len()), (12, 8));
}

#[test]
fn a_line_across_the_grid_does_not_part_it() {
    let grid = |y: f32| level(y, &[(50..55, 140.0), (55..300, 13.0), (300..304, 140.0), (304..550, 13.0)]);
    let all = parted_strokes(vec![grid(100.0), grid(150.0), grid(200.0), side(300.0, 60), side(50.0, 60)]);
    assert_eq!(faint(&all), [[50.0, 549.0]; 3]);
    let backwards = |y: f32| {
        let mut line = grid(y);
        line.vertices.reverse();
        line
    };
    let all = parted_strokes(vec![backwards(100.0), backwards(150.0), backwards(200.0), side(300.0, 60)]);
    assert_eq!(faint(&all), [[549.0, 50.0]; 3], "whichever way they run");
}

#[test]
fn pale_lines_that_are_no_grid_or_have_nothing_stronger_stay_as_they_are() {
    let pale = |y: f32| level(y, &[(50..550, 13.0)]);
    let uneven = parted_strokes(vec![pale(100.0), pale(130.0), pale(200.0), pale(291.0), side(300.0, 60)]);
    assert!(faint(&uneven).is_empty());
    assert!(faint(&parted_strokes(vec![pale(100.0), pale(150.0), pale(200.0)])).is_empty());
}
