//! Tests of `standing`.

use super::super::join::join;
use super::super::tests::area;
use super::*;

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

fn line(from: (f32, f32), to: (f32, f32)) -> Polyline<Vertex> {
    let [from, to] = [from, to].map(|(x, y)| MmPoint::new(x, y));
    let vertex = |k: u32| Vertex { at: from.lerp(to, k as f32 / 20.0), ..Vertex::TEST };
    Polyline::open((0..=20).map(vertex).collect())
}

/// The wires of a capacitor and its plates, of this length and so far apart.
fn capacitor(length: f32, apart: f32) -> Vec<Polyline<Vertex>> {
    let (low, high) = (50.0 - 0.5 * apart, 50.0 + 0.5 * apart);
    let plate = |y: f32| line((50.0 - 0.5 * length, y), (50.0 + 0.5 * length, y));
    vec![line((50.0, 10.0), (50.0, low)), plate(low), plate(high), line((50.0, high), (50.0, 90.0))]
}

#[test]
fn wires_that_end_on_plates_are_not_joined_over_the_gap() {
    let wires = |mut lines: Vec<Polyline<Vertex>>| {
        let standing = StandingEnds::of(&mut lines, area(), &PARAMS);
        let joined = join(lines, 3.0, &standing, true);
        joined.iter().filter(|line| line.length() > 30.0).count()
    };
    assert_eq!(wires(capacitor(12.0, 2.0)), 2);
    let [first, _, _, second] = &capacitor(12.0, 2.0)[..] else { panic!("four lines") };
    assert_eq!(wires(vec![first.clone(), second.clone()]), 1, "a line with a gap");
    // both on one line, which a stroke across has parted
    let across =
        vec![line((50.0, 10.0), (50.0, 49.98)), line((30.0, 50.0), (70.0, 50.0)), line((50.0, 50.02), (50.0, 90.0))];
    assert_eq!(wires(across), 2, "the line across, and both halves as one");
}

#[test]
fn plates_are_moved_apart_with_their_wires_until_there_is_room() {
    let parted = |length: f32, apart: f32| {
        let mut lines = capacitor(length, apart);
        StandingEnds::of(&mut lines, area(), &PARAMS);
        let at = |line: usize, vertex: usize| lines[line].vertices[vertex].at;
        assert!((at(0, lines[0].vertices.len() - 1).y - at(1, 0).y).abs() < 1e-3, "the wire ends on its plate");
        at(2, 0).y - at(1, 0).y
    };
    let spacing = PARAMS.max_clearance();
    assert!(parted(12.0, 0.6 * spacing) >= spacing);
    assert!((parted(12.0, spacing + 1.0) - spacing - 1.0).abs() < 1e-3, "there is room");
    assert!((parted(60.0, 0.6 * spacing) - 0.6 * spacing).abs() < 1e-3, "lines by themselves");
}

#[test]
fn plates_at_both_ends_of_one_wire_are_moved_apart_too() {
    let [first, low, high, second] = &capacitor(12.0, 0.6 * PARAMS.max_clearance())[..] else { panic!("four lines") };
    // up from the first plate, round on the right, and back to the second: each side 20 pieces
    let way = [(50.0, 10.0), (90.0, 10.0), (90.0, 90.0), (50.0, 90.0)];
    let round = way.windows(2).flat_map(|side| line(side[0], side[1]).vertices);
    let [up, back] = [first, second].map(|wire| wire.clone().reversed().vertices);
    let vertices = up.into_iter().chain(round).chain(back).collect();
    let mut lines = vec![Polyline::open(vertices), low.clone(), high.clone()];
    StandingEnds::of(&mut lines, area(), &PARAMS);
    let ends = [Tip::First, Tip::Last].map(|which| which.of(&lines[0]).map(|end| end.at.y));
    let plates = [1, 2].map(|plate| lines[plate].vertices[0].at.y);
    assert!(plates[1] - plates[0] >= PARAMS.max_clearance(), "{plates:?}");
    let stand = ends.iter().zip(plates).all(|(end, plate)| end.is_some_and(|end| (end - plate).abs() < 1e-3));
    assert!(stand, "both ends of the wire are on their plates: {ends:?}, {plates:?}");
}
