//! Tests of `flatten`.

use super::*;
use resvg::tiny_skia::{PathBuilder, Stroke};

const SIZE: Size = Size::new(100, 100);

fn painted(path: Path, width: Option<f32>) -> [PaintedPath; 1] {
    let stroke = width.map(|width| Stroke { width, ..Stroke::default() });
    [PaintedPath { stroke, ..PaintedPath::filled(path) }]
}

#[test]
fn of_a_shape_that_reaches_far_away_only_what_is_in_sight_has_points() {
    let mut path = PathBuilder::new();
    for (number, (x, y)) in [(20.0, 30.0), (60.0, 30.0), (60.0, 4e9), (20.0, 4e9)].into_iter().enumerate() {
        if number == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    path.close();
    let proposals = proposals(&painted(path.finish().expect("a path"), None), 8.0, SIZE);
    let line = &proposals[0].line;
    assert!(line.closed && (180..200).contains(&line.vertices.len()), "{} points", line.vertices.len());
    let in_picture = line.vertices.iter().filter(|at| at.y <= 100.0);
    assert!(in_picture.clone().all(|at| at.x > 19.9 && at.x < 60.1 && at.y > 29.9));
    assert!(in_picture.count() > 170);
}

#[test]
fn a_circle_is_closed_and_round() {
    let circle = PathBuilder::from_circle(50.0, 50.0, 30.0).expect("a circle");
    let proposals = proposals(&painted(circle, None), 8.0, SIZE);
    assert_eq!(proposals.len(), 1);
    assert!(proposals[0].line.closed);
    for at in &proposals[0].line.vertices {
        assert!(((*at - PxPoint::new(50.0, 50.0)).length() - 30.0).abs() < 0.05, "{at:?}");
    }
}

#[test]
fn a_thin_stroke_has_one_line_and_a_wide_one_two_sides() {
    let mut line = PathBuilder::new();
    line.move_to(10.0, 50.0);
    line.line_to(90.0, 50.0);
    let line = line.finish().expect("a line");
    let thin = proposals(&painted(line.clone(), Some(3.0)), 8.0, SIZE);
    assert!(matches!(&thin[..], [one] if one.stroke == Some(3.0) && !one.line.closed));
    assert!((thin[0].line.length() - 80.0).abs() < 1e-3);
    let wide = proposals(&painted(line, Some(20.0)), 8.0, SIZE);
    assert!(matches!(&wide[..], [one] if one.stroke.is_none() && one.line.closed));
    assert!((wide[0].line.length() - 200.0).abs() < 1e-2);
}

#[test]
fn what_lies_outside_the_picture_is_left_out() {
    let circle = PathBuilder::from_circle(500.0, 50.0, 30.0).expect("a circle");
    assert_eq!(proposals(&painted(circle, None), 8.0, SIZE), []);
}

#[test]
fn of_a_disc_in_the_colour_of_its_outline_the_sides_are_contours_and_of_a_square_the_middle() {
    let strokes = |path: Path, filled_alike: bool| {
        let mut painted = painted(path, Some(4.0));
        painted[0].filled_alike = filled_alike;
        let proposals = proposals(&painted, 8.0, SIZE);
        (proposals.len(), proposals.iter().filter(|proposal| proposal.stroke.is_some()).count())
    };
    let disc = || PathBuilder::from_circle(50.0, 50.0, 10.0).expect("a circle");
    assert_eq!(strokes(disc(), true), (2, 0));
    assert_eq!(strokes(disc(), false), (1, 1));
    let square =
        PathBuilder::from_rect(resvg::tiny_skia::Rect::from_xywh(20.0, 20.0, 30.0, 30.0).expect("it has sides"));
    assert_eq!(strokes(square, true), (1, 1));
}

/// As documents paint the lines of a grid that are filled and drawn: the outline would go before the thin stroke.
#[test]
fn lines_that_are_filled_have_no_outline() {
    let filled = |corners: &[(f32, f32)]| {
        let mut path = PathBuilder::new();
        for (number, &(x, y)) in corners.iter().enumerate() {
            if number == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        proposals(&painted(path.finish().expect("a path"), None), 8.0, SIZE).len()
    };
    assert_eq!(filled(&[(10.0, 50.0), (90.0, 50.0)]), 0);
    assert_eq!(filled(&[(10.0, 20.0), (50.0, 40.0), (90.0, 60.0), (30.0, 30.0)]), 0, "there and back");
    assert_eq!(filled(&[(10.0, 50.0), (90.0, 50.0), (50.0, 50.5)]), 1, "a thin wedge");
}
