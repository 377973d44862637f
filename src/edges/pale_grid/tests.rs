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
    parted(contours, &widths, PICTURE, Vec::new())
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

/// A contour from place to place, with a point on each pixel, as pale as a gridline.
fn along_gridlines(places: &[(u16, u16)], closed: bool) -> Contour {
    let next = places.iter().skip(1).chain(places.first().filter(|_| closed));
    let vertices = places.iter().zip(next).flat_map(|(&(x0, y0), &(x1, y1))| {
        let steps = x0.abs_diff(x1).max(y0.abs_diff(y1));
        (0..steps).map(move |step| {
            let share = f32::from(step) / f32::from(steps);
            let between = |a: u16, b: u16| f32::from(a) + share * (f32::from(b) - f32::from(a));
            let mut point = level(0.0, &[(0..1, 13.0)]).vertices[0];
            point.at = PxPoint::new(between(x0, x1), between(y0, y1));
            point
        })
    });
    Polyline { vertices: vertices.collect(), closed }
}

#[test]
fn gridlines_that_turn_into_one_another_and_the_edge_of_the_paper_are_lines_of_the_grid() {
    let shape = level(330.0, &[(20..590, 140.0)]);
    let grid = |y: u16| level(f32::from(y), &[(50..550, 13.0)]);
    let upright = |x: u16| along_gridlines(&[(x, 50), (x, 300)], false);
    let edge = along_gridlines(&[(50, 50), (550, 50), (550, 300), (50, 300)], true);
    let corner = along_gridlines(&[(50, 200), (300, 200), (300, 50)], false);
    let all = parted_strokes(vec![grid(100), grid(150), grid(250), upright(175), upright(425), edge, corner, shape]);
    // four sides of the edge, two of the corner
    assert_eq!(all.iter().filter(|(_, _, faint)| *faint).count(), 5 + 4 + 2);
    assert!(all.iter().all(|(contour, ..)| !contour.closed));
    assert!(all.iter().filter(|(_, _, faint)| *faint).all(|(contour, ..)| straight_ends(contour.view()).is_some()));
}

/// As inside of a triangle on squared paper, where one line of the paper was as broad as the triangle's.
#[test]
fn a_gridline_that_turns_off_along_the_side_of_a_shape_is_parted_there() {
    let grid = |y: f32| level(y, &[(50..550, 13.0)]);
    let mut turning = level(200.0, &[(50..300, 13.0), (300..330, 140.0)]);
    turning.vertices.iter_mut().for_each(|point| point.at.y += 0.6 * (point.at.x - 300.0).max(0.0));
    let all = parted_strokes(vec![grid(100.0), grid(150.0), turning, grid(250.0), side(300.0, 60)]);
    assert_eq!(all.len(), 6);
    assert_eq!(faint(&all), [[50.0, 549.0], [50.0, 549.0], [50.0, 299.0], [50.0, 549.0]]);
    let mut bent = level(200.0, &[(50..550, 13.0)]);
    bent.vertices.iter_mut().for_each(|point| point.at.y += 0.6 * (point.at.x - 300.0).max(0.0));
    let all = parted_strokes(vec![grid(100.0), grid(150.0), bent, grid(250.0), side(300.0, 60)]);
    assert_eq!((all.len(), faint(&all).len()), (5, 3), "a pale line that is bent is none of the grid");
}

#[test]
fn gridlines_that_were_led_aside_at_an_end_are_straight() {
    let led = |y: f32| {
        let mut line = level(y, &[(50..550, 13.0)]);
        line.vertices.iter_mut().for_each(|point| point.at.y += 0.4 * (point.at.x - 535.0).max(0.0));
        line
    };
    let all = parted_strokes(vec![led(100.0), led(150.0), led(200.0), side(300.0, 60)]);
    assert_eq!(faint(&all).len(), 3);
    let heights = |number: usize| all[number].0.vertices.iter().map(|point| point.at.y);
    assert!((0..3).all(|number| heights(number).all(|y| (y - 100.0 - 50.0 * number as f32).abs() < 0.01)));
}

#[test]
fn lines_of_a_dark_grid_are_as_pale_as_most_of_it() {
    let grid = |last: f32| {
        let line = |(number, strength): (u8, f32)| level(100.0 + 50.0 * f32::from(number), &[(50..550, strength)]);
        let mut all: Vec<Contour> = [(0, 40.0), (1, 40.0), (2, 40.0), (3, last)].map(line).to_vec();
        all.extend([side(280.0, 60), side(300.0, 60), side(320.0, 60)]);
        faint(&parted_strokes(all)).len()
    };
    assert_eq!([grid(55.0), grid(70.0)], [4, 3], "an axis is none of them");
}

#[test]
fn a_pale_shape_that_is_no_grid_stays_whole() {
    let square = along_gridlines(&[(100, 100), (300, 100), (300, 250), (100, 250)], true);
    let all = parted_strokes(vec![square, level(330.0, &[(20..590, 140.0)])]);
    assert!(all[0].0.closed && all.iter().all(|(_, _, faint)| !faint));
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
