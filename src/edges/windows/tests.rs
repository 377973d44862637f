//! Tests of `windows`.

use super::*;
use crate::edges::contour::testing::polyline;

fn stroke(width: f32, points: &[(f32, f32)]) -> FoundContour {
    let contour = polyline(points);
    FoundContour { whole: contour.length(), contour, stroke: Some(width), tint: None }
}

/// The walls on both sides of a window from 100 to 150 px, at this height.
fn walls(left: f32, right: f32) -> Vec<FoundContour> {
    vec![stroke(8.0, &[(20.0, left), (100.0, left)]), stroke(8.0, &[(150.0, right), (240.0, right)])]
}

fn with(mut walls: Vec<FoundContour>, panes: &[&[(f32, f32)]]) -> Vec<FoundContour> {
    walls.extend(panes.iter().map(|points| stroke(1.5, points)));
    merged(walls)
}

const UPPER: [(f32, f32); 2] = [(101.0, 57.0), (149.0, 57.0)];
const LOWER: [(f32, f32); 2] = [(99.0, 63.0), (152.0, 63.0)];

#[test]
fn the_panes_of_a_window_are_one_stroke_from_wall_to_wall() {
    let found = with(walls(60.0, 60.0), &[&UPPER, &LOWER]);
    assert_eq!(found.len(), 3, "two walls and a window");
    let (window, ends) = (&found[2], [&found[2].contour.vertices[0], &found[2].contour.vertices[50]]);
    assert!(window.stroke == Some(1.5) && window.contour.vertices.len() == 51);
    assert_eq!(ends.map(|end| (end.at.x, end.at.y)), [(100.0, 60.0), (150.0, 60.0)]);
    // one that is drawn as a thin rectangle
    let ring = [(100.0, 57.0), (150.0, 57.0), (150.0, 63.0), (100.0, 63.0), (100.0, 58.0)];
    assert_eq!(with(walls(60.0, 60.0), &[&ring]).len(), 3);
}

#[test]
fn other_lines_beside_walls_are_no_windows() {
    let count = |walls: Vec<FoundContour>, panes: &[&[(f32, f32)]]| with(walls, panes).len();
    assert_eq!(count(walls(60.0, 60.0), &[&[(101.0, 70.0), (149.0, 70.0)]]), 3, "a sill beside it");
    assert_eq!(count(walls(60.0, 60.0), &[&[(101.0, 57.0), (130.0, 57.0)]]), 3, "no longer than a part of it");
    let leaf = [(100.0, 60.0), (100.0, 100.0), (130.0, 90.0), (150.0, 62.0)];
    assert_eq!(count(walls(60.0, 60.0), &[&leaf]), 3, "the leaf of a door");
    let found = with(walls(60.0, 75.0), &[&UPPER, &LOWER]);
    assert!(found.len() == 4 && found[2].contour == polyline(&UPPER), "the walls lie in two lines");
}
