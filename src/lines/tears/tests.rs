//! Tests of `tears`.

use super::*;

fn line(points: &[(f32, f32)]) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex { at: MmPoint::new(x, y), strength: 20.0, width: 1.0, ..Vertex::TEST };
    let mut line = Polyline::open(points.iter().map(vertex).collect());
    line.fill();
    line
}

/// The length and the middle of what is missing, in whole millimetres, of these lines.
fn torn_of(lines: &[&Polyline<Vertex>], drawn: &[Polyline<Vertex>]) -> Vec<(f32, f32)> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(120.0, 80.0));
    let torn = torn(lines, drawn.iter(), area, &Params::TEST);
    torn.iter().map(|of| (of.length.round(), of.extent.center().x.round())).collect()
}

#[test]
fn a_curve_that_is_drawn_in_pieces_is_torn() {
    let curve = line(&[(10.0, 60.0), (60.0, 50.0), (110.0, 20.0)]);
    let of = |drawn: &[Polyline<Vertex>]| torn_of(&[&curve], drawn);
    let [start, end] = [line(&[(10.0, 60.0), (40.0, 54.0)]), line(&[(60.0, 50.0), (110.0, 20.0)])];
    assert!(of(std::slice::from_ref(&curve)).is_empty(), "it is whole");
    assert_eq!(of(&[start.clone(), end.clone()]), [(20.0, 50.0)]);
    let longer = line(&[(10.0, 60.0), (55.5, 50.9)]);
    assert!(of(&[longer, end.clone()]).is_empty(), "a finger slips over five millimetres");
    assert_eq!(of(&[end]), [(51.0, 35.0)], "its end is missing");
    assert!(of(&[line(&[(20.0, 58.0), (60.0, 50.0), (110.0, 20.0)])]).is_empty(), "it is a little shorter");
    assert!(of(&[]).is_empty(), "it is gone");
    let moved = line(&[(10.0, 60.0), (40.0, 56.5), (60.0, 53.0), (110.0, 20.0)]);
    assert!(of(&[moved]).is_empty(), "it is moved aside");
}

#[test]
fn two_curves_that_cross_are_whole_and_one_that_ends_before_the_other_is_not() {
    let level = line(&[(10.0, 40.0), (110.0, 40.0)]);
    let upright = line(&[(60.0, 5.0), (60.0, 75.0)]);
    let of = |drawn: &[Polyline<Vertex>]| torn_of(&[&level, &upright], drawn);
    let [above, below] = [line(&[(60.0, 5.0), (60.0, 40.0)]), line(&[(60.0, 40.0), (60.0, 75.0)])];
    assert!(of(&[level.clone(), above, below]).is_empty(), "it is cut in two where it crosses the other");
    let [above, below] = [line(&[(60.0, 5.0), (60.0, 28.0)]), line(&[(60.0, 52.0), (60.0, 75.0)])];
    // where the other is near nothing is missing
    assert_eq!(of(&[level.clone(), above, below]), [(18.0, 60.0)]);
    // where both run together one line stands for both
    let beside = line(&[(10.0, 45.0), (30.0, 40.5), (90.0, 40.5), (110.0, 45.0)]);
    let [start, end] = [line(&[(10.0, 45.0), (30.0, 40.5)]), line(&[(90.0, 40.5), (110.0, 45.0)])];
    assert!(torn_of(&[&beside, &level], &[level.clone(), start, end]).is_empty());
}
