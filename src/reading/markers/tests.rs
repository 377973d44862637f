//! Tests of `markers`.

use super::*;

#[test]
fn triangles_that_point_away_from_the_line_are_heads() {
    let points = |of: &[(f32, f32)]| of.iter().map(|&at| MmPoint::from(at)).collect::<Vec<_>>();
    let line = points(&[(0.0, 0.0), (20.0, 0.0)]);
    let line = [Subpath { named: line.clone(), points: line, closed: false, curved: false }];
    let end = |of: &[(f32, f32)]| head(&points(of), &line).map(|(_, tip, toward)| (tip.x, toward.x));
    assert_eq!(end(&[(18.0, -2.0), (22.0, 0.0), (18.0, 2.0)]), Some((22.0, 1.0)));
    assert_eq!(end(&[(18.0, -2.0), (22.0, 0.0), (18.0, 2.0), (19.0, 0.0)]), Some((22.0, 1.0)), "with a notch");
    assert_eq!(end(&[(2.0, -2.0), (-2.0, 0.0), (2.0, 2.0)]), Some((-2.0, -1.0)), "at the beginning");
    assert_eq!(end(&[(22.0, -2.0), (18.0, 0.0), (22.0, 2.0)]), None, "it points back");
    assert_eq!(end(&[(18.0, -2.0), (22.0, -2.0), (22.0, 2.0), (18.0, 2.0)]), None, "a square");
    assert_eq!(end(&[(8.0, -2.0), (12.0, 0.0), (8.0, 2.0)]), None, "in the middle");
}
