//! Which contours are heads of arrows, and what is drawn of them.

use super::shapes::LENGTHS;
use super::*;
use crate::lines::vertex::{FoundIn, SPACING};
use crate::lines::{Line, weight};
use crate::units::MmPoint;

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

fn contour(points: &[(f32, f32)], closed: bool) -> Polyline<Vertex> {
    let vertex = |&(x, y): &(f32, f32)| Vertex {
        at: MmPoint::new(x, y),
        strength: 60.0,
        width: PARAMS.width_max,
        source: FoundIn::Vector,
        ..Vertex::TEST
    };
    let mut line = Polyline { vertices: points.iter().map(vertex).collect(), closed };
    line.subdivide(SPACING);
    line
}

fn area() -> MmRect {
    MmRect::new(MmPoint::zero(), MmPoint::new(150.0, 100.0))
}

fn shaft() -> Polyline<Vertex> {
    contour(&[(10.0, 50.0), (60.0, 50.0)], false)
}

/// The heads among contours, and how many contours are left.
fn taken(mut contours: Vec<Polyline<Vertex>>) -> (Vec<HeadMark>, Vec<Polyline<Vertex>>) {
    let heads = take(&mut contours, area(), &PARAMS);
    (heads, contours)
}

/// Ways in which drawings have a head at the right end of the shaft.
fn heads() -> Vec<(&'static str, Vec<Polyline<Vertex>>)> {
    let triangle = [(59.0, 48.0), (63.0, 50.0), (59.0, 52.0)];
    vec![
        ("a triangle", vec![contour(&triangle, true)]),
        (
            "a triangle with a wavering base",
            vec![contour(&[(59.0, 48.0), (63.0, 50.0), (59.0, 52.0), (58.9999, 50.5)], true)],
        ),
        ("one that begins at the end of its shaft", vec![contour(&[(60.0, 48.0), (64.0, 50.0), (60.0, 52.0)], true)]),
        (
            "one that its shaft interrupts",
            vec![contour(&[(59.0, 49.7), triangle[0], triangle[1], triangle[2], (59.0, 50.3)], false)],
        ),
        ("with a notch", vec![contour(&[(57.0, 48.0), (63.0, 50.0), (57.0, 52.0), (58.5, 50.0)], true)]),
        ("an angle", vec![contour(&[(58.0, 48.0), (60.4, 50.0), (58.0, 52.0)], false)]),
        (
            "two strokes",
            vec![contour(&[(57.0, 48.0), (60.0, 50.0)], false), contour(&[(60.0, 50.0), (57.0, 52.0)], false)],
        ),
    ]
}

#[test]
fn heads_are_found_however_they_are_drawn() {
    for (name, head) in heads() {
        let (heads, left) = taken(std::iter::once(shaft()).chain(head).collect());
        assert!(matches!(heads[..], [head] if head.toward.x > 0.99), "{name}: {heads:?}");
        assert_eq!(left.len(), 1, "{name}");
        let tip = left[0].vertices.iter().map(|vertex| vertex.at.x).fold(0.0, f32::max);
        assert!((tip - heads[0].at.x).abs() < 0.3 && tip >= 59.9, "{name}: {tip}");
    }
}

#[test]
fn what_is_no_head_stays() {
    let cases: [(&str, Vec<Polyline<Vertex>>); 7] = [
        ("it points back", vec![contour(&[(63.0, 48.0), (59.0, 50.0), (63.0, 52.0)], true)]),
        ("a square", vec![contour(&[(60.0, 48.0), (64.0, 48.0), (64.0, 52.0), (60.0, 52.0)], true)]),
        ("a large triangle", vec![contour(&[(60.0, 40.0), (80.0, 50.0), (60.0, 60.0)], true)]),
        ("across", vec![contour(&[(58.0, 50.0), (62.0, 50.0), (60.0, 54.0)], true)]),
        ("beside", vec![contour(&[(59.0, 58.0), (63.0, 60.0), (59.0, 62.0)], true)]),
        (
            "a sign within a line",
            vec![
                contour(&[(59.0, 48.0), (63.0, 50.0), (59.0, 52.0)], true),
                contour(&[(63.0, 50.0), (99.0, 50.0)], false),
            ],
        ),
        (
            "a roof on its walls",
            vec![
                contour(&[(57.0, 46.0), (60.0, 50.0), (57.0, 54.0)], false),
                contour(&[(57.0, 46.0), (30.0, 46.0)], false),
                contour(&[(57.0, 54.0), (30.0, 54.0)], false),
            ],
        ),
    ];
    for (name, others) in cases {
        let count = 1 + others.len();
        let (heads, left) = taken(std::iter::once(shaft()).chain(others).collect());
        assert!(heads.is_empty() && left.len() == count, "{name}: {heads:?}");
    }
}

#[test]
fn heads_tip_to_tip_between_two_measures_are_heads_and_two_triangles_within_a_line_are_none() {
    let head = |tip: f32, back: f32| contour(&[(tip + back, 48.0), (tip, 50.0), (tip + back, 52.0)], true);
    let measures = |heads: Vec<Polyline<Vertex>>| {
        let shafts = [contour(&[(10.0, 50.0), (60.0, 50.0)], false), contour(&[(60.0, 50.0), (110.0, 50.0)], false)];
        taken(shafts.into_iter().chain(heads).collect()).0
    };
    let all = measures(vec![head(10.0, 3.0), head(60.0, -3.0), head(60.0, 3.0), head(110.0, -3.0)]);
    assert_eq!(all.len(), 4, "{all:?}");
    let mut inner: Vec<f32> = all.iter().map(|head| head.at.x).filter(|x| (30.0..90.0).contains(x)).collect();
    inner.sort_by(f32::total_cmp);
    assert!(inner.len() == 2 && inner[1] - inner[0] >= PARAMS.max_clearance(), "{inner:?}");
    assert!(measures(vec![head(60.0, -3.0), head(60.0, 3.0)]).is_empty(), "a valve in a pipe");
}

#[test]
fn a_shaft_ends_before_what_it_points_at() {
    let wall = contour(&[(61.0, 10.0), (61.0, 90.0)], false);
    let (heads, left) = taken([shaft(), contour(&[(58.0, 48.0), (60.4, 50.0), (58.0, 52.0)], false), wall].to_vec());
    let gap = 61.0 - heads[0].at.x;
    assert!((PARAMS.max_clearance()..PARAMS.max_clearance() + 0.5).contains(&gap), "{gap}");
    assert!(left.iter().any(|line| (line.length() - (heads[0].at.x - 10.0)).abs() < 0.05));
    // a head that ends a little inside of what it points at, and an axis beyond its last tick
    let head = contour(&[(59.0, 48.0), (63.0, 50.0), (59.0, 52.0)], true);
    let inside = |wall: &[(f32, f32)]| taken(vec![shaft(), head.clone(), contour(wall, false)]).0[0].at.x;
    let gap = 62.0 - inside(&[(62.0, 10.0), (62.0, 90.0)]);
    assert!((PARAMS.max_clearance()..PARAMS.max_clearance() + 0.5).contains(&gap), "{gap}");
    assert!(inside(&[(62.0, 48.0), (62.0, 52.0)]) > 62.9);
    assert!(inside(&[(60.0, 10.0), (60.0, 90.0)]) > 62.9, "most of the head is beyond the line");
    // a short one, which is a link, leads up to the line too, and is not cut back before it
    let short = contour(&[(53.0, 50.0), (58.0, 50.0)], false);
    let head = contour(&[(58.0, 49.0), (60.0, 50.0), (58.0, 51.0)], true);
    let at = taken(vec![short, head, contour(&[(59.5, 10.0), (59.5, 90.0)], false)]).0[0].at.x;
    assert!((at - 59.5).abs() < 0.01, "{at}");
}

/// As in a food web. What it points at may lie a little before its tip, or be met by it.
#[test]
fn a_shaft_that_crosses_a_line_shortly_before_what_it_points_at_stays_whole() {
    let head = contour(&[(58.0, 48.0), (60.4, 50.0), (58.0, 52.0)], false);
    let upright = |x: f32| contour(&[(x, 10.0), (x, 90.0)], false);
    let tip = |crossed: f32, wall: f32| taken(vec![shaft(), head.clone(), upright(wall), upright(crossed)]).0[0].at.x;
    for wall in [60.3, 60.4, 60.6, 61.0] {
        let at = tip(40.0, wall);
        assert!(at < wall - PARAMS.max_clearance() + 0.01, "there is room before a line at {wall}: {at}");
        for crossed in [51.5, 52.0, 54.1] {
            let at = tip(crossed, wall);
            assert!((at - wall).abs() < 0.15, "it leads to the line at {wall} over that at {crossed}: {at}");
        }
    }
    // and so does one that ends a hair beyond a short line, as an extension line of a measure
    let short = contour(&[(60.35, 44.0), (60.35, 56.0)], false);
    let at = taken(vec![shaft(), head.clone(), short]).0[0].at.x;
    assert!(at < 60.35 - PARAMS.max_clearance() + 0.01, "{at}");
    // a line that ends beside it is not crossed
    let beside = contour(&[(52.0, 51.0), (52.0, 90.0)], false);
    let at = taken(vec![shaft(), head, upright(60.6), beside]).0[0].at.x;
    assert!(at < 60.6 - PARAMS.max_clearance() + 0.01, "{at}");
}

/// The finished lines of contours with heads at their ends, and which heads are drawn.
fn drawn(contours: Vec<Polyline<Vertex>>) -> (Vec<Line>, Vec<bool>) {
    let (mut heads, left) = taken(contours);
    let lines: Vec<&Polyline<Vertex>> = left.iter().collect();
    let drawn = draw(&mut heads, &lines, &[], area(), &PARAMS);
    let shafts =
        left.iter().enumerate().map(|(number, line)| drawn.shaft(number, line, &vec![false; line.vertices.len()]));
    let finish = |(line, anchored): (Polyline<Vertex>, Vec<bool>)| weight::finish(&line, &anchored, &PARAMS);
    let of_heads = drawn.heads.iter().map(|head| (head.clone(), vec![false; head.vertices.len()]));
    (shafts.chain(of_heads).filter_map(finish).collect(), heads.iter().map(|head| head.is_drawn).collect())
}

#[test]
fn a_head_is_two_strokes_that_meet_at_the_end_of_its_shaft() {
    for (name, head) in heads() {
        let (lines, is_drawn) = drawn(std::iter::once(shaft()).chain(head).collect());
        assert!(lines.len() == 2 && is_drawn == [true], "{name}");
        let found = arrows(&lines);
        assert!(matches!(found[..], [Arrow { line: 0, head: Some(1), .. }]), "{name}: {found:?}");
        assert!((lines[1].length() - 2.0 * LENGTHS[0]).abs() < 0.1, "{name}");
    }
    let both = [
        shaft(),
        contour(&[(58.0, 48.0), (60.0, 50.0), (58.0, 52.0)], false),
        contour(&[(12.0, 48.0), (10.0, 50.0), (12.0, 52.0)], false),
    ];
    assert_eq!(arrows(&drawn(both.to_vec()).0).len(), 2);
    let angle = [shaft(), contour(&[(60.0, 50.0), (60.0, 60.0), (70.0, 60.0)], false)];
    assert!(arrows(&drawn(angle.to_vec()).0).is_empty(), "an angle that is no head");
}

#[test]
fn a_head_without_room_is_smaller_or_left_out() {
    let head = || contour(&[(58.0, 49.0), (60.4, 50.0), (58.0, 51.0)], false);
    let beside = |y: f32| [shaft(), head(), contour(&[(5.0, y), (90.0, y)], false)].to_vec();
    let (lines, is_drawn) = drawn(beside(58.4));
    let length = lines.last().map_or(0.0, Line::length);
    assert!(is_drawn == [true] && length < 2.0 * LENGTHS[0] - 0.5, "{length}");
    let (lines, is_drawn) = drawn(beside(55.5));
    assert!(is_drawn == [false] && lines.len() == 2);
}

#[test]
fn a_head_on_a_short_shaft_between_two_lines_touches_what_it_points_at() {
    let short = |before: f32, wall: [(f32, f32); 2]| {
        let shaft = contour(&[(before, 50.0), (56.0, 50.0)], false);
        let head = contour(&[(56.0, 49.0), (58.0, 50.0), (56.0, 51.0)], true);
        let start = contour(&[(before, 10.0), (before, 90.0)], false);
        drawn(vec![shaft, head, contour(&wall, false), start])
    };
    let upright = [(58.0, 10.0), (58.0, 90.0)];
    let (lines, is_drawn) = short(46.0, upright);
    let found = arrows(&lines);
    let [arrow] = found[..] else { panic!("{found:?}") };
    assert!(is_drawn == [true] && arrow.line == 0 && (58.0..58.2).contains(&arrow.at.x), "{arrow:?}");
    assert!(arrow.toward.x > 0.99 && arrow.wings.iter().all(|wing| wing.x < 54.0), "{arrow:?}");
    assert_eq!(short(50.0, upright).1, [false], "its strokes would be too near to where it comes from");
    assert_eq!(short(46.0, [(18.0, 10.0), (98.0, 90.0)]).1, [false], "one stroke would lie along it");
}

/// As in a flow chart: one line from a box down and across, and down by so much to the next.
#[test]
fn a_head_is_not_moved_round_a_bend_of_its_shaft() {
    let shaft = contour(&[(90.0, 40.0), (60.0, 40.0), (60.0, 45.3)], false);
    let head = contour(&[(58.0, 41.6), (60.0, 45.3), (62.0, 41.6)], true);
    let pointed_at = contour(&[(60.0, 45.3), (87.0, 61.0), (60.0, 77.0), (33.0, 61.0)], true);
    let (lines, is_drawn) = drawn(vec![shaft, head, pointed_at]);
    assert!(is_drawn == [false] && arrows(&lines).is_empty(), "{is_drawn:?}");
    assert!((lines[0].length() - 35.3).abs() < 0.2, "it leads up to what it points at: {}", lines[0].length());
}

#[test]
fn a_head_on_a_short_shaft_touches_the_corner_that_it_points_at() {
    let shaft = contour(&[(60.0, 30.0), (60.0, 40.7)], false);
    let head = contour(&[(58.0, 37.0), (60.0, 40.7), (62.0, 37.0)], true);
    let start = contour(&[(30.0, 30.0), (90.0, 30.0)], false);
    let pointed_at = contour(&[(60.0, 40.7), (87.0, 56.4), (60.0, 72.1), (33.0, 56.4)], true);
    let (lines, is_drawn) = drawn(vec![shaft, head, start, pointed_at]);
    let found = arrows(&lines);
    assert!(is_drawn == [true] && matches!(found[..], [arrow] if (40.7..40.9).contains(&arrow.at.y)), "{found:?}");
}

#[test]
fn a_head_on_a_short_last_piece_touches_what_it_points_at_or_is_left_out() {
    let bent = |below: f32| {
        let y = 40.0 + below;
        let shaft = contour(&[(10.0, 40.0), (60.0, 40.0), (60.0, y)], false);
        let head = contour(&[(58.0, y - 4.0), (60.0, y), (62.0, y - 4.0)], true);
        drawn(vec![shaft, head, contour(&[(40.0, y), (80.0, y), (80.0, y + 20.0), (40.0, y + 20.0)], true)])
    };
    let (lines, is_drawn) = bent(9.8);
    let found = arrows(&lines);
    let [arrow] = found[..] else { panic!("{found:?}") };
    assert!(is_drawn == [true] && (49.8..50.0).contains(&arrow.at.y) && arrow.toward.y > 0.99, "{arrow:?}");
    assert!(arrow.wings.iter().all(|wing| wing.y > 43.0), "clear of its own shaft: {arrow:?}");
    let (lines, is_drawn) = bent(6.0);
    assert!(is_drawn == [false] && lines.len() == 2, "{is_drawn:?}");
    assert!((lines[0].length() - 56.0).abs() < 0.2, "it leads up to the box: {}", lines[0].length());
    // a longer one ends before the box, with room for a head
    let (lines, is_drawn) = bent(16.0);
    let found = arrows(&lines);
    assert!(is_drawn == [true] && matches!(found[..], [arrow] if arrow.at.y < 52.0), "{found:?}");
}

/// As in the bitmap of a flow chart: the outline of the diamond goes on as the arrow that leaves its corner.
#[test]
fn a_shaft_without_room_for_a_head_before_a_box_leads_up_to_the_box_again() {
    let diamond_and_shaft = [(60.0, 50.0), (87.0, 34.0), (60.0, 18.0), (33.0, 34.0), (60.0, 50.0), (60.0, 61.8)];
    let shaft = contour(&diamond_and_shaft, false);
    let head = contour(&[(58.0, 58.1), (60.0, 61.8), (62.0, 58.1)], true);
    let pointed_at = contour(&[(40.0, 61.8), (80.0, 61.8), (80.0, 76.0), (40.0, 76.0)], true);
    let all = vec![shaft, head, pointed_at];
    let length = |lines: &[Line]| lines[0].length() - 4.0 * 27.0_f32.hypot(16.0);
    let (lines, is_drawn) = drawn(all.clone());
    let found = arrows(&lines);
    assert!(is_drawn == [true] && matches!(found[..], [arrow] if (61.8..62.0).contains(&arrow.at.y)), "{found:?}");
    assert!((length(&lines) - 11.8).abs() < 0.3, "{}", length(&lines));
    // another line leaves no room for the head there either
    let beside = contour(&[(66.0, 53.5), (66.0, 61.8)], false);
    let (lines, is_drawn) = drawn(all.iter().cloned().chain([beside]).collect());
    assert!(is_drawn == [false] && (length(&lines) - 11.8).abs() < 0.3, "{}", length(&lines));
    // and one that is drawn in between is not what it points at
    let (mut marks, left) = taken(all);
    let between = contour(&[(40.0, 58.0), (80.0, 58.0)], false);
    let lines: Vec<&Polyline<Vertex>> = left.iter().chain([&between]).collect();
    let drawn = draw(&mut marks, &lines, &[], area(), &PARAMS);
    let (shaft, _) = drawn.shaft(0, &left[0], &vec![false; left[0].vertices.len()]);
    assert!(drawn.heads.is_empty() && (shaft.length() - left[0].length()).abs() < 0.01, "{}", shaft.length());
}

#[test]
fn a_triangle_has_three_corners() {
    let points = |corners: &[(f32, f32)]| -> Vec<MmPoint> {
        let at = |i: usize| MmPoint::from(corners[i % corners.len()]);
        // some points on each side, as edgels are
        (0..corners.len()).flat_map(|i| (0..8).map(move |k| at(i).lerp(at(i + 1), k as f32 / 8.0))).collect()
    };
    let of = |corners: &[(f32, f32)]| is_triangle(&points(corners), 4.0);
    assert!(of(&[(0.0, 0.0), (4.0, 2.0), (0.0, 4.0)]));
    assert!(!of(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]), "a square");
    let circle: Vec<(f32, f32)> =
        (0..24).map(|i| (i as f32 * std::f32::consts::TAU / 24.0).sin_cos()).map(|(y, x)| (2.0 * x, 2.0 * y)).collect();
    assert!(!of(&circle));
    assert!(!is_triangle(&[], 4.0));
}

#[test]
fn an_axis_that_ends_shortly_after_its_grid_goes_on_until_its_head_has_room() {
    let grid = contour(&[(57.0, 20.0), (57.0, 80.0)], false);
    let drawn = |others: &[&Polyline<Vertex>]| {
        let mut marks = taken(vec![shaft(), heads()[0].1[0].clone()]).0;
        let axis = shaft();
        let lines: Vec<&Polyline<Vertex>> = std::iter::once(&axis).chain(others.iter().copied()).collect();
        let drawn = draw(&mut marks, &lines, &[], area(), &PARAMS);
        let (shaft, anchored) = drawn.shaft(0, &axis, &vec![false; axis.vertices.len()]);
        assert_eq!(anchored.len(), shaft.vertices.len());
        (marks[0].is_drawn, shaft.length())
    };
    let (is_drawn, length) = drawn(&[&grid]);
    assert!(is_drawn && (53.0..60.0).contains(&length), "{length}");
    let wall = contour(&[(66.0, 20.0), (66.0, 80.0)], false);
    assert!(!drawn(&[&grid, &wall]).0, "there is something before it");
}

#[test]
fn where_arrows_meet_each_head_is_that_of_its_own_shaft() {
    // a second arrow begins at the tip of the first
    let next = contour(&[(60.0, 50.0), (75.0, 20.0)], false);
    let head = contour(&[(60.0, 50.0), (56.8, 52.9), (56.0, 48.0)], true);
    for contours in [vec![next.clone(), shaft(), head.clone()], vec![shaft(), next, head]] {
        let (heads, _) = taken(contours);
        assert!(matches!(heads[..], [head] if head.toward.x > 0.9), "{heads:?}");
    }
}

/// As where a river leads into the sea, and the triangle hides an end of the shore.
#[test]
fn a_head_is_that_of_a_stroke_and_not_of_a_border_that_it_hides_in_part() {
    let shaft = contour(&[(10.0, 45.0), (60.0, 50.0)], false);
    // a triangle with equal sides, whose middle of one is where the border ends
    let head = contour(&[(62.0, 50.0), (58.5, 48.0), (58.5, 52.0)], true);
    let mut border = contour(&[(60.25, 51.0), (80.4, 85.6)], false);
    border.vertices.iter_mut().for_each(|vertex| vertex.contrast = [40.0, 0.0, 0.0]);
    for contours in [vec![shaft.clone(), border.clone(), head.clone()], vec![border, head, shaft]] {
        let (heads, left) = taken(contours);
        assert!(matches!(heads[..], [head] if head.toward.x > 0.9), "{heads:?}");
        assert_eq!(left.len(), 2);
    }
}

#[test]
fn a_tick_beside_the_end_of_an_axis_is_no_head() {
    let halves = [contour(&[(59.3, 49.0), (59.3, 50.0)], false), contour(&[(59.3, 50.0), (59.3, 51.0)], false)];
    let (heads, _) = taken(std::iter::once(shaft()).chain(halves).collect());
    assert!(heads.is_empty(), "{heads:?}");
}

#[test]
fn a_head_is_drawn_at_its_own_line_and_not_at_one_that_ends_beside_it() {
    let mut marks = taken(vec![shaft(), heads()[0].1[0].clone()]).0;
    let mut curve = contour(&[(20.0, 20.0), (45.0, 47.0), (61.5, 49.0)], false);
    curve.vertices.iter_mut().for_each(|vertex| vertex.strength *= 2.0);
    let drawn = draw(&mut marks, &[&curve], &[], area(), &PARAMS);
    assert!(drawn.heads.is_empty() && !marks[0].is_drawn);
    find_shafts(&mut marks, &[&curve]);
    assert!(!marks[0].has_shaft);
}

#[test]
fn a_shaft_that_was_joined_with_another_line_keeps_its_head() {
    let mut marks = taken(vec![shaft(), heads()[0].1[0].clone()]).0;
    let mut joined = contour(&[(10.0, 80.0), (10.0, 50.0), (62.0, 50.0)], false);
    joined.vertices.iter_mut().filter(|vertex| vertex.at.y > 51.0).for_each(|vertex| vertex.strength *= 4.0);
    let drawn = draw(&mut marks, &[&joined], &[], area(), &PARAMS);
    assert!(drawn.heads.len() == 1 && marks[0].is_drawn);
}

#[test]
fn a_head_a_side_of_which_is_one_with_the_box_that_it_points_at_is_found() {
    let shaft = contour(&[(16.5, 74.6), (60.0, 50.0)], false);
    let head = contour(&[(60.0, 50.0), (58.22, 52.96), (56.55, 50.0)], false);
    let pointed_at = contour(&[(20.0, 20.0), (100.0, 20.0), (100.0, 50.0), (20.0, 50.0)], true);
    let (heads, left) = taken(vec![shaft.clone(), head.clone(), pointed_at]);
    assert!(matches!(heads[..], [head] if head.toward.x > 0.8 && head.toward.y < -0.4), "{heads:?}");
    assert_eq!(left.len(), 2);
    assert!(taken(vec![shaft, head]).0.is_empty(), "an angle at the end of a line");
}

#[test]
fn a_head_an_end_of_which_was_moved_onto_a_box_is_found() {
    let mut head = contour(&[(61.66, 50.42), (63.79, 50.97), (61.5, 53.61), (60.0, 50.0)], false);
    let moved = Vertex { at: MmPoint::new(61.42, 50.0), ..head.vertices[0] };
    head.vertices.insert(0, moved);
    let pointed_at = contour(&[(20.0, 20.0), (100.0, 20.0), (100.0, 50.0), (20.0, 50.0)], true);
    let (heads, left) = taken(vec![contour(&[(90.0, 76.0), (60.0, 50.0)], false), head, pointed_at]);
    assert!(matches!(heads[..], [head] if head.toward.x < -0.7 && head.toward.y < -0.6), "{heads:?}");
    assert_eq!(left.len(), 2);
}

#[test]
fn a_head_that_was_found_in_pixels_has_one_tip() {
    // an even triangle that points to the right, with a line that leads to its lower corner
    let triangle = |source: FoundIn| {
        let corner = |(x, y)| Vertex { at: MmPoint::new(x, y), strength: 60.0, source, ..Vertex::TEST };
        Polyline { vertices: [(63.0, 50.0), (59.0, 52.3), (59.0, 47.7)].map(corner).to_vec(), closed: true }
    };
    let to_lower_corner = contour(&[(76.0, 22.9), (61.0, 48.85)], false);
    assert_eq!(taken(vec![to_lower_corner.clone(), triangle(FoundIn::Vector)]).0.len(), 1);
    assert_eq!(taken(vec![to_lower_corner, triangle(FoundIn::Head)]).0.len(), 0);
    assert_eq!(taken(vec![shaft(), triangle(FoundIn::Head)]).0.len(), 1);
}

#[test]
fn where_two_shafts_end_at_one_head_it_is_that_of_the_one_which_it_points_along() {
    let other = contour(&[(20.0, 70.0), (60.0, 50.0)], false);
    let triangle = vec![contour(&[(60.0, 48.0), (64.0, 50.0), (60.0, 52.0)], true)];
    let strokes = vec![contour(&[(57.0, 48.0), (60.0, 50.0)], false), contour(&[(60.0, 50.0), (57.0, 52.0)], false)];
    for head in [triangle, strokes] {
        for shafts in [[shaft(), other.clone()], [other.clone(), shaft()]] {
            let (heads, _) = taken(shafts.into_iter().chain(head.clone()).collect());
            assert!(matches!(heads[..], [head] if head.toward.x > 0.99), "{heads:?}");
        }
    }
}
