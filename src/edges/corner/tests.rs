//! Corners of contours: that they are sharp, and where they lie.

use super::super::contour::testing::{circle, polyline};
use super::*;

const PICTURE: Size = Size::new(100, 100);

/// Two sides of 30 px that meet at (50, 50) at an angle, with the corner rounded over `rounding` px of either side.
fn rounded(degrees: f32, rounding: f32) -> Contour {
    let (y, x) = degrees.to_radians().sin_cos();
    let first = polyline(&[(20.0, 50.0), (50.0 - rounding, 50.0)]);
    let second = polyline(&[(50.0 - rounding * x, 50.0 + rounding * y), (50.0 - 30.0 * x, 50.0 + 30.0 * y)]);
    // one point inside the corner, at the middle of a parabola with its control point at the corner
    let (a, b) = (PxPoint::new(50.0 - rounding, 50.0), second.vertices[0].at);
    let middle = a.lerp(b, 0.5).lerp(PxPoint::new(50.0, 50.0), 0.5);
    let mut vertices = first.vertices;
    vertices.push(ContourPoint { at: middle, ..vertices[0] });
    vertices.extend(second.vertices);
    Contour::open(vertices)
}

/// Distance of the nearest point to (50, 50), px.
fn gap(contour: &Contour) -> f32 {
    let distances = contour.vertices.iter().map(|point| (point.at - PxPoint::new(50.0, 50.0)).length());
    distances.fold(f32::INFINITY, f32::min)
}

#[test]
fn a_rounded_corner_becomes_sharp_and_its_sides_straight() {
    for degrees in [60.0, 90.0, 120.0] {
        let mut contour = rounded(degrees, 2.0);
        let before = gap(&contour);
        sharpen(&mut contour, PICTURE, false);
        assert!(before > 0.4 && gap(&contour) < 0.01, "{degrees} degrees: {before}, then {}", gap(&contour));
        let (y, x) = degrees.to_radians().sin_cos();
        let off = |at: PxPoint| (at.y - 50.0).abs().min(((at.x - 50.0) * y + (at.y - 50.0) * x).abs());
        assert!(contour.vertices.iter().all(|point| off(point.at) < 0.01), "{degrees} degrees");
        assert!((contour.length() - 60.0).abs() < 0.05, "{degrees} degrees: {} px long", contour.length());
    }
}

#[test]
fn straight_lines_gentle_turns_circles_and_ends_have_no_corner() {
    for contour in [polyline(&[(0.0, 0.0), (60.0, 5.0)]), rounded(165.0, 1.0), circle(12.0), circle(25.0)] {
        let mut sharpened = contour.clone();
        sharpen(&mut sharpened, PICTURE, false);
        assert_eq!(sharpened, contour);
    }
    let mut short = polyline(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)]);
    let same = short.clone();
    sharpen(&mut short, PICTURE, false);
    assert_eq!(short, same, "too short for two sides");
}

#[test]
fn a_corner_stays_where_it_was_found_if_its_sides_fitted_anew_are_nearly_parallel() {
    // the sides cross 30 px beyond the turn
    let hairpin = polyline(&[(0.0, 50.0), (30.0, 50.0), (30.0, 50.5), (0.0, 51.0)]);
    let point = hairpin.vertices.iter().position(|vertex| vertex.at.x >= 30.0).expect("it turns there");
    let at = hairpin.vertices[point].at;
    let sides = [false, true].map(|forwards| hairpin.line_fit(point, forwards, 3.0, 10.0).expect("it is long enough"));
    assert!(refitted(&hairpin, &Corner { point, at, sides, rounding: 3.0, distance: 0.0 }).is_none());
}

#[test]
fn a_corner_beyond_the_border_of_the_picture_stays_as_it_was() {
    let contour = rounded(90.0, 2.0);
    let mut sharpened = contour.clone();
    sharpen(&mut sharpened, Size::new(49, 100), false);
    assert_eq!(sharpened, contour);
}

#[test]
fn a_closed_square_has_four_corners() {
    let corners = [(10.0, 8.0), (40.0, 8.0), (40.0, 38.0), (8.0, 38.0), (8.0, 9.0)];
    let mut square = polyline(&corners);
    square.closed = true;
    // the corner at (8, 8) is missing
    sharpen(&mut square, PICTURE, false);
    for (x, y) in [(8.0, 8.0), (40.0, 8.0), (40.0, 38.0), (8.0, 38.0)] {
        let nearest = square.vertices.iter().map(|point| (point.at - PxPoint::new(x, y)).length());
        assert!(nearest.fold(f32::INFINITY, f32::min) < 0.01, "no point at the corner ({x}, {y})");
    }
}
#[test]
fn the_tip_of_a_wedge_is_where_its_sides_meet_though_they_move_one_another_outwards() {
    const BLUR: f32 = 1.5; // of the points of the test's contours
    // where the slope across a bar is greatest whose sides are this far from its middle
    let steepest = |half: f32| {
        let slope = |x: f32| (-0.5 * ((x - half) / BLUR).powi(2)).exp() - (-0.5 * ((x + half) / BLUR).powi(2)).exp();
        let places = (0..1000).map(|k| half + 0.002 * k as f32);
        places.max_by(|a, b| slope(*a).total_cmp(&slope(*b))).expect("there are some")
    };
    // a wedge of 20 degrees with its tip at (60, 50)
    let upper: Vec<(f32, f32)> =
        (0..=45).map(|k| (15.0 + k as f32, (45 - k) as f32 * 10_f32.to_radians().tan())).collect();
    let sides = upper
        .iter()
        .map(|(x, y)| (*x, 50.0 - steepest(*y)))
        .chain(upper.iter().rev().map(|(x, y)| (*x, 50.0 + steepest(*y))));
    let contour = polyline(&sides.collect::<Vec<_>>());
    let off = |wedges: bool| {
        let mut contour = contour.clone();
        sharpen(&mut contour, PICTURE, wedges);
        contour.vertices.iter().map(|vertex| vertex.at.x).fold(0.0, f32::max) - 60.0
    };
    assert!(off(true).abs() < 1.0 && off(false) > 2.0, "{} {}", off(true), off(false));
}
