//! Tests of `lost_colours`.

use super::*;

fn path(from: (f32, f32), to: (f32, f32)) -> Vec<MmPoint> {
    (0..=20).map(|k| MmPoint::from(from).lerp(MmPoint::from(to), k as f32 / 20.0)).collect()
}

fn lost(points: &[MmPoint]) -> LostLine {
    let (extent, length) = (MmRect::from_points(points), polyline::length(points));
    LostLine { extent, length, closed: false, is_faint: false, form: None }
}

/// A blue and a red line that cross, and a grey one below them.
fn strokes() -> [ColouredStroke; 3] {
    let of = |class, from, to| ColouredStroke::new(class, path(from, to));
    [
        of(Class::Blue, (20.0, 20.0), (120.0, 60.0)),
        of(Class::Red, (20.0, 60.0), (120.0, 30.0)),
        of(Class::Grey, (20.0, 80.0), (120.0, 80.0)),
    ]
}

#[test]
fn the_colour_of_a_lost_line_is_told_with_its_share() {
    let told = |lost: &[LostLine]| told_of(lost, &strokes()).map(|note| note.to_string()).unwrap_or_default();
    let [blue, red, grey] = strokes().map(|stroke| stroke.points);
    let whole = told(&[lost(&red)]);
    assert!(whole.contains("100 percent of the red lines (104 mm): there is no room"), "{whole}");
    let both = told(&[lost(&blue[4..11]), lost(&red[8..])]);
    assert!(both.contains("30 percent of the blue lines (32 mm) and 60 percent of the red lines (63 mm): "), "{both}");
    assert_eq!(told(&[lost(&red[..4])]), "", "16 mm are 15 percent");
    assert_eq!(told(&[lost(&grey)]), "", "grey is no colour");
    assert_eq!(told(&[lost(&path((20.0, 5.0), (120.0, 9.0)))]), "", "no stroke of the picture");
}

#[test]
fn of_two_lines_in_one_box_neither_colour_is_told() {
    let mut strokes = strokes().to_vec();
    strokes[1] = ColouredStroke::new(Class::Red, path((20.0, 60.0), (120.0, 20.0)));
    assert_eq!(told_of(&[lost(&strokes[1].points)], &strokes), None);
    strokes[0].class = Class::Red;
    assert!(told_of(&[lost(&strokes[1].points)], &strokes).is_some(), "both are red");
}

#[test]
fn of_lines_of_one_colour_it_is_not_told() {
    let strokes = strokes().map(|stroke| ColouredStroke { class: Class::Blue, ..stroke });
    assert_eq!(told_of(&[lost(&strokes[0].points)], &strokes), None);
    assert_eq!(told_of(&[lost(&strokes[0].points)], &[]), None);
}

#[test]
fn no_share_is_told_where_more_is_missing_than_strokes_are_known() {
    let strokes = strokes();
    let blue = lost(&strokes[0].points);
    let told = told_of(&[blue, blue], &strokes).map(|note| note.to_string()).unwrap_or_default();
    assert!(told.contains("215 mm of the blue lines: there is no room"), "{told}");
}

#[test]
fn most_of_a_stroke_says_its_colour() {
    assert_eq!(most_common(&[Class::Red, Class::Blue, Class::Red, Class::Grey]), Some(Class::Red));
    assert_eq!(most_common(&[]), None);
}
