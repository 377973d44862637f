//! Tests of `hand_lines`.

use super::*;

#[test]
fn what_lies_outside_of_the_figure_is_cut_off() {
    let line = |points: &[[f32; 2]], closed: bool| HandLine {
        of_line: 0,
        vertices: points.iter().map(|&at| (at, 40.0)).collect(),
        closed,
        is_disc: false,
    };
    let parts = |points: &[[f32; 2]], closed: bool| line(points, closed).parts_inside([100.0, 50.0]);
    let whole = [[0.0, 0.0], [1.004, 1.0]];
    assert_eq!(parts(&whole, false), [line(&whole, false)], "half a stroke beyond the border stays");
    assert_eq!(parts(&[[0.2, 1.3], [0.8, 1.3]], false), []);
    let crossing = parts(&[[0.5, 0.5], [0.5, 1.5]], false);
    assert_eq!(crossing.len(), 1);
    assert!((crossing[0].length([100.0, 50.0]) - 25.0).abs() < 1.0, "{}", crossing[0].length([100.0, 50.0]));
    let ring = parts(&[[0.2, 0.5], [0.2, 1.5], [0.8, 1.5], [0.8, 0.5]], true);
    assert_eq!(ring.len(), 1, "a ring that leaves the figure is one open line");
    let length = ring[0].length([100.0, 50.0]);
    assert!(!ring[0].closed && (length - 110.0).abs() < 2.0, "{length}");
}

#[test]
fn lines_beside_one_that_a_person_drew_give_way_and_those_that_meet_it_stay() {
    let name = |by_hand: bool| LineName { name: String::new(), by_hand };
    let line = |of_line: usize, ends: [[f32; 2]; 2]| HandLine {
        of_line,
        vertices: ends.map(|at| (at, 40.0)).to_vec(),
        closed: false,
        is_disc: false,
    };
    // the first by a person; one along it, one across, one up to it and one far away
    let ends = [
        [[0.2, 0.5], [0.8, 0.5]],
        [[0.0, 0.52], [1.0, 0.52]],
        [[0.4, 0.0], [0.4, 1.0]],
        [[0.6, 0.1], [0.6, 0.495]],
        [[0.1, 0.1], [0.9, 0.1]],
    ];
    let lines = ends.iter().zip(0..).map(|(ends, of)| line(of, *ends)).collect();
    let names = (0..5).map(|number| name(number == 0)).collect();
    let (left_outside, areas) = (Vec::new(), Vec::new());
    let lines = HandLines { lines, aspect: 1.0, part: None, left_outside, areas, names, overview: Some((74.0, 9)) };
    let overview = |width: f32, lines_of: usize| {
        let place = MmRect::new(MmPoint::zero(), MmPoint::new(width, 50.0));
        lines.told_overview_anew(place, lines_of).map(|note| note.to_string())
    };
    assert_eq!(overview(74.3, 9), None, "it is the same");
    let told = overview(104.0, 19).expect("it is another one");
    assert!(told.contains("is 104 mm wide with 19 lines; that of their page is 74 mm wide with 9 lines"), "{told}");
    assert!(overview(74.0, 1).is_some_and(|told| told.contains("with 1 line;")));
    let edges = lines.contours_by_hand_first(Size::new(1000, 1000), [50.0, 15.0], 40.0).expect("it has the same shape");
    let row = |y: f32| edges.chains().filter(|chain| chain.vertices.iter().all(|v| (v.at.y - y).abs() < 1.0)).count();
    assert_eq!((row(500.0), row(520.0), row(100.0)), (1, 2, 1), "the one along it is cut in two");
    let column =
        |x: f32| edges.chains().filter(|chain| chain.vertices.iter().all(|v| (v.at.x - x).abs() < 1.0)).count();
    assert_eq!((column(400.0), column(600.0)), (2, 1), "the one across ends on it from both sides");
    let end = |x: f32| {
        let of_column = edges.edgels.iter().filter(|v| (v.at.x - x).abs() < 1.0 && (v.at.y - 500.0).abs() > 1.0);
        of_column.map(|v| (v.at.y - 500.0).abs()).fold(f32::MAX, f32::min)
    };
    assert!((15.0..20.1).contains(&end(400.0)) && (15.0..20.1).contains(&end(600.0)));
    assert_eq!(edges.chains.iter().filter(|range| range.kind.added).count(), 1);
    let lines = lines.called(vec![name(false); 5]);
    let none = lines.contours_by_hand_first(Size::new(1000, 1000), [50.0, 15.0], 40.0).expect("the same shape");
    assert_eq!(none, lines.contours(Size::new(1000, 1000)).expect("the same shape"), "without any nothing changes");
}

#[test]
fn lines_that_are_far_too_long_together_are_refused() {
    let lines = |count: usize| {
        let ends = [[0.0, 0.5], [1.0, 0.5]].map(|at| (at, 40.0)).to_vec();
        let line = |of_line| HandLine { of_line, vertices: ends.clone(), closed: false, is_disc: false };
        let lines = (0..count).map(line).collect();
        let (left_outside, areas, names) = (Vec::new(), Vec::new(), Vec::new());
        HandLines { lines, aspect: 2.0, part: None, left_outside, areas, names, overview: None }
    };
    assert_eq!(lines(1999).check_length(), Ok(()), "each is as long as the longest side");
    let told = lines(2001).check_length().expect_err("they are longer").to_string();
    assert!(told.contains("its lines are 2001 times as long as the longest side of its figure"), "{told}");
}
