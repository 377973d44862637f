//! Tests of `clearance`.

use super::*;
use crate::units::MmPoint;

/// Clears lines by their own saliencies.
pub(in crate::lines) fn clear_all(lines: Vec<(Polyline<Vertex>, Rank)>, area: MmRect, params: &Params) -> Vec<Cleared> {
    let saliencies: Vec<f32> = lines.iter().map(|(line, _)| saliency(line, params)).collect();
    clear(lines, &saliencies, area, params)
}

/// A line of the greatest width with vertices as close as those of lines in the making.
pub(in crate::lines) fn polyline(points: &[(f32, f32)], closed: bool) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex {
        at: MmPoint::new(x, y),
        strength: 60.0,
        contrast: [60.0, 0.0, 0.0],
        width: Params::TEST.width_max,
        ..Vertex::TEST
    };
    let mut polyline = Polyline { vertices: points.iter().map(vertex).collect(), closed };
    polyline.subdivide(0.4);
    polyline
}

/// Lines that are drawn on a square of 100 mm.
pub(super) fn drawn(lines: &[&[(f32, f32)]]) -> DrawnLines<'static> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let mut drawn = DrawnLines::new(area, &Params::TEST);
    lines.iter().for_each(|points| {
        let mut line = polyline(points, false);
        drawn.snap(&mut line);
        let junctions = drawn.passage(line.view()).junctions;
        draw(line, &junctions, Rank::Ordinary, &mut drawn);
    });
    drawn
}

/// The decision on a line where another runs along y = 50.
fn decision(points: &[(f32, f32)], closed: bool) -> Decision {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let mut own = Nearby::new(area, Params::TEST.max_spacing());
    let (polyline, rank) = (polyline(points, closed), Rank::Ordinary);
    let line = QueuedLine { polyline, rank, round: 0, is_part: false };
    judge(line, &drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]), &mut own)
}

#[test]
fn a_ring_without_room_is_opened_or_left_out_as_a_whole() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let square = |low: f32, high: f32| polyline(&[(low, low), (high, low), (high, high), (low, high)], true);
    // on one side the inner one comes too near to the outer one
    let inner = polyline(&[(12.0, 30.0), (60.0, 30.0), (60.0, 60.0), (12.0, 60.0)], true);
    let cleared = |whole_rings: bool| {
        let params = Params { whole_rings, ..Params::TEST };
        let all =
            clear_all([square(10.0, 90.0), inner.clone()].map(|ring| (ring, Rank::Ordinary)).to_vec(), area, &params);
        all.iter().map(|line| line.polyline.closed).collect::<Vec<_>>()
    };
    assert_eq!(cleared(false), [true, false]);
    assert_eq!(cleared(true), [true]);
}

/// The lengths of lines of a drawing that are drawn, in the order in which they are given.
fn lengths_drawn(lines: &[&[(f32, f32)]]) -> Vec<f32> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let params = Params { of_drawing: true, ..Params::TEST };
    let all: Vec<_> = lines.iter().map(|points| (polyline(points, false), Rank::Ordinary)).collect();
    let cleared = clear_all(all, area, &params);
    let middle = |points: &[(f32, f32)]| MmPoint::from(points[0]).lerp(points[1].into(), 0.5);
    let of = |points: &&[(f32, f32)]| {
        let is_it = |line: &&Cleared| line.polyline.path().any(|vertex| (vertex.at - middle(points)).length() < 0.5);
        cleared.iter().find(is_it).map_or(0.0, |line| line.polyline.length())
    };
    lines.iter().map(of).collect()
}

#[test]
fn lines_that_end_on_another_at_nearly_one_place_meet_there_unless_they_run_beside_one_another() {
    let base: &[(f32, f32)] = &[(10.0, 50.0), (90.0, 50.0)];
    let petals = lengths_drawn(&[base, &[(50.0, 50.0), (30.0, 30.0)], &[(52.0, 50.0), (72.0, 30.0)]]);
    assert!(petals[1..].iter().all(|length| *length > 28.0), "{petals:?}");
    let beside = lengths_drawn(&[base, &[(50.0, 50.0), (50.0, 20.0)], &[(53.0, 50.0), (53.0, 25.0)]]);
    assert!(beside[1] > 29.0 && beside[2] < 1.0, "{beside:?}");
}

#[test]
fn a_long_line_that_leaves_another_a_little_too_flat_begins_on_it_a_little_later() {
    let base: &[(f32, f32)] = &[(10.0, 50.0), (90.0, 50.0)];
    // at 17.5 degrees it is cut where the two are apart, 16 mm from where they meet
    let [steep, flat] = [17.5_f32, 12.0].map(|angle| {
        let (sine, cosine) = angle.to_radians().sin_cos();
        lengths_drawn(&[base, &[(20.0, 50.0), (20.0 + 60.0 * cosine, 50.0 - 60.0 * sine)]])[1]
    });
    assert!((56.0..60.0).contains(&steep), "{steep}");
    assert!(flat < 40.0, "10 mm later would be elsewhere: {flat}");
    // two flat ones from one place leave room for the one between them
    let fan = lengths_drawn(&[
        base,
        &[(50.0, 50.0), (50.0 + 60.0 * 0.963, 50.0 - 60.0 * 0.269)],
        &[(50.0, 50.0), (50.0 - 60.0 * 0.963, 50.0 - 60.0 * 0.269)],
        &[(50.0, 50.0), (50.0, 20.0)],
    ]);
    assert!(fan[1] > 53.0 && fan[2] > 53.0 && fan[3] > 29.9, "at 15.6 degrees: {fan:?}");
}

#[test]
fn a_line_from_one_line_to_another_may_be_short_and_goes_if_they_do() {
    let (one, other): (&[_], &[_]) = (&[(10.0, 50.0), (90.0, 50.0)], &[(10.0, 44.0), (90.0, 44.0)]);
    let bond: &[(f32, f32)] = &[(50.0, 50.0), (50.0, 44.0)];
    assert!((lengths_drawn(&[one, other, bond])[2] - 6.0).abs() < 0.1);
    // what the contour lacks to the lines is added
    assert!((lengths_drawn(&[one, other, &[(50.0, 49.0), (50.0, 44.8)]])[2] - 6.0).abs() < 0.1);
    assert!(lengths_drawn(&[one, bond])[1] < 0.1);
}

#[test]
fn a_line_that_is_apart_or_crosses_steeply_is_drawn() {
    assert!(matches!(decision(&[(10.0, 60.0), (90.0, 60.0)], false), Decision::Draw { .. }));
    assert!(matches!(decision(&[(50.1, 20.1), (50.1, 80.0)], false), Decision::Draw { .. }));
    assert!(matches!(decision(&[(20.0, 60.0), (60.0, 60.0), (60.0, 90.0), (20.0, 90.0)], true), Decision::Draw { .. }));
}

/// The states of the vertices of a line where another runs along y = 50.
fn states(points: &[(f32, f32)], closed: bool) -> Vec<LineState> {
    drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]).states(&polyline(points, closed))
}

#[test]
fn a_spike_that_only_just_crosses_a_line_does_not_join_it() {
    let spike = [(46.0, 52.5), (49.8, 52.5), (50.01, 49.96), (50.2, 52.5), (54.0, 52.5)];
    assert!(states(&spike, false).iter().all(|state| *state == LineState::TooNear));
    // the same over the start of a ring
    let ring = [(50.01, 49.96), (50.2, 52.5), (54.0, 52.5), (54.0, 70.0), (46.0, 70.0), (46.0, 52.5), (49.8, 52.5)];
    assert_eq!(states(&ring, true)[0], LineState::TooNear);
    // a line that ends up on the other side joins
    let through = [(49.8, 80.1), (49.8, 52.5), (50.01, 49.96), (50.2, 20.1)];
    assert!(!states(&through, false).contains(&LineState::TooNear));
}

#[test]
fn a_line_that_only_touches_the_corner_of_another_does_not_join_it() {
    let roof = drawn(&[&[(30.0, 70.0), (50.0, 50.0), (70.0, 70.0)]]);
    let states = |points: &[(f32, f32)]| roof.states(&polyline(points, false));
    assert!(states(&[(30.0, 30.0), (50.0, 50.0), (70.0, 30.0)]).contains(&LineState::TooNear));
    assert!(!states(&[(50.0, 20.0), (50.0, 50.0), (50.0, 80.0)]).contains(&LineState::TooNear));
}

#[test]
fn a_line_whose_two_ends_meet_on_another_will_be_a_ring_and_does_not_join_it() {
    let drop = [(50.0, 50.0), (58.0, 60.0), (42.0, 60.0), (50.0, 50.0)];
    assert_eq!(states(&drop, false)[0], LineState::TooNear);
    assert_eq!(states(&drop[..2], false)[0], LineState::Meets);
    let almost = [drop[0], drop[1], drop[2], (50.0, 50.05)];
    assert!(!matches!(decision(&almost, false), Decision::Draw { .. }), "its ends are drawn in one place");
}

#[test]
fn each_way_of_being_too_near_has_its_decision() {
    assert!(matches!(decision(&[(50.1, 20.1), (50.1, 52.0)], false), Decision::Shorten(_)));
    assert!(matches!(decision(&[(10.0, 54.5), (90.0, 54.5)], false), Decision::Displace(_)));
    assert!(matches!(decision(&[(10.0, 60.0), (40.0, 52.0), (90.0, 52.0)], false), Decision::Split(_)));
    assert_eq!(decision(&[(15.0, 52.0), (85.0, 52.0)], false), Decision::Split(Vec::new()), "nothing is left");
}

#[test]
fn a_gridline_and_the_parts_of_a_line_stay_at_their_height() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let params = Params { of_drawing: true, ..Params::TEST };
    let heights = |rank: Rank, is_crossed: bool| {
        // one along most of it is a little too near, and one crosses it
        let near = polyline(&[(30.0, 54.5), (60.0, 54.5)], false);
        let wall = polyline(&[(70.0, 49.0), (95.0, 49.0), (95.0, 52.0)], false);
        let line = polyline(&[(5.0, 50.0), (99.0, 50.0)], false);
        let walls = if is_crossed { vec![(wall, Rank::Subject)] } else { Vec::new() };
        let lines = walls.into_iter().chain([(near, Rank::Untorn), (line, rank)]).collect();
        let cleared = clear_all(lines, area, &params);
        let own = cleared.iter().filter(|line| line.rank == rank).flat_map(|line| &line.polyline.vertices);
        own.map(|vertex| (vertex.at.y - 50.0).abs()).fold(0.0, f32::max)
    };
    assert!(heights(Rank::Faint, false) < 0.01);
    assert!(heights(Rank::Ordinary, false) > 0.1, "a whole line may move");
    assert!(heights(Rank::Ordinary, true) < 0.01, "the parts of one are at one height");
}

#[test]
fn what_comes_back_to_itself_is_opened_or_cut() {
    let flat_ring = [(20.0, 60.0), (80.0, 60.0), (80.0, 62.0), (20.0, 62.0)];
    assert!(matches!(decision(&flat_ring, true), Decision::Open(line) if !line.closed));
    let hairpin = [(20.0, 60.0), (80.0, 60.0), (80.0, 63.0), (20.0, 63.0)];
    let Decision::DrawBody { body, rest } = decision(&hairpin, false) else { panic!("it comes back") };
    assert!((60.0..70.0).contains(&body.length()) && rest.length() > 50.0);
}

#[test]
fn a_body_that_is_too_short_without_the_rest_is_judged_anew() {
    // it comes back 7 mm from its start, and the least length is 8
    let coil = [(20.0, 60.0), (24.0, 60.0), (24.0, 61.0), (20.0, 61.0), (20.0, 90.0)];
    assert!(matches!(decision(&coil, false), Decision::Split(_)), "{:?}", decision(&coil, false));
}

#[test]
fn an_outline_goes_before_a_more_salient_line_and_a_long_stroke_before_both() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let line = |y: f32, x: f32| polyline(&[(10.0, y), (x, y)], false);
    let clear = |ranks: [Rank; 3]| {
        let lines = [line(50.0, 90.0), line(52.0, 60.0), line(54.0, 40.0)];
        let cleared = clear_all(lines.into_iter().zip(ranks).collect(), area, &Params::TEST);
        let mut lengths: Vec<(Rank, u32)> =
            cleared.iter().map(|line| (line.rank, line.polyline.length().round() as u32)).collect();
        lengths.sort_unstable();
        lengths
    };
    assert_eq!(clear([Rank::Ordinary; 3]), [(Rank::Ordinary, 80)]);
    let drawn = clear([Rank::Ordinary, Rank::Outline, Rank::Ordinary]);
    assert_eq!(drawn.last(), Some(&(Rank::Outline, 50)), "the outline is whole");
    assert!(drawn.iter().all(|line| line.1 < 80), "{drawn:?}");
    let drawn = clear([Rank::Ordinary, Rank::Outline, Rank::Untorn]);
    assert_eq!(drawn.last(), Some(&(Rank::Untorn, 30)), "the stroke is whole");
}

#[test]
fn a_link_that_goes_a_little_beyond_the_rings_that_it_joins_ends_on_them() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let params = Params { of_drawing: true, ..Params::TEST };
    let circle = |x: f32, radius: f32| {
        let at = |step: i32| (std::f32::consts::TAU * step as f32 / 60.0).sin_cos();
        let points: Vec<(f32, f32)> = (0..60).map(|k| (x + radius * at(k).1, 50.0 + radius * at(k).0)).collect();
        polyline(&points, true)
    };
    let bond = polyline(&[(37.9, 50.0), (45.6, 50.0)], false);
    let lines = [circle(30.0, 8.5), circle(58.5, 13.0), bond].map(|line| (line, Rank::Ordinary));
    let cleared = clear_all(lines.to_vec(), area, &params);
    assert_eq!(cleared.len(), 3);
    let bond = &cleared[2].polyline;
    assert!((bond.length() - 7.0).abs() < 0.1, "{}", bond.length());
}
