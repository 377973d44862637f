//! G-code for BrailleRAP, run on a simulated machine that accepts no fault (`tools/src/travel/machine.rs`), and how
//! far the needle travels.

use std::collections::BTreeSet;

use proptest::prelude::*;
use tactograph::internals::output::dots::gcode::{Params, Refused, is_as_written, write};
use tactograph::internals::output::dots::path_order::{DotPosition, order};
use tactograph::internals::units::MmPoint;
use tactograph_tools::travel::bound::lower_bound;
use tactograph_tools::travel::machine::{self, Sheet};
use tactograph_tools::travel::orders::{length, nearest_neighbour, row_by_row};
use tactograph_tools::travel::sets;

/// How far above the bound a path may lie: the drawing's is 6 % above it, where the bound itself is low.
const OVER_BOUND: f64 = 1.08;

fn points(dots: &[DotPosition]) -> Vec<MmPoint> {
    dots.iter().map(|&[x, y]| MmPoint::new(x as f32 / 100.0, y as f32 / 100.0)).collect()
}

/// The sheet that the machine makes of `dots`, and the G-code.
fn made(dots: &[MmPoint], params: &Params) -> (Sheet, String) {
    let gcode = write(dots, params).expect("dots within the limits");
    let limits = params.limits.map(|mm| (mm * 100.0).round() as i32);
    let sheet = machine::run(&gcode, limits, (params.paper_length * 100.0) as i32);
    (sheet.unwrap_or_else(|why| panic!("{why}\n{gcode}")), gcode)
}

#[track_caller]
fn pressed_once(sheet: &Sheet, dots: &[DotPosition]) {
    let wanted: BTreeSet<DotPosition> = dots.iter().copied().collect();
    let pressed: BTreeSet<DotPosition> = sheet.dots.iter().copied().collect();
    assert_eq!(pressed, wanted);
    assert_eq!(sheet.dots.len(), wanted.len(), "a dot is pressed twice");
}

/// How far back the path goes at most: the largest drop of the second coordinate from any dot to any later one.
fn pulled_back(dots: &[DotPosition]) -> i32 {
    let mut lowest = i32::MIN;
    let back = dots.iter().map(|dot| {
        lowest = lowest.max(dot[1]);
        lowest.saturating_sub(dot[1])
    });
    back.max().unwrap_or(0)
}

fn ends(params: &Params) -> [DotPosition; 2] {
    [[0, 0], [0, (params.paper_length * 100.0) as i32 + 2_000]]
}

/// The same dots in another order.
fn shuffled<T: Clone>(dots: &[T], seed: u64) -> Vec<T> {
    let (mut dots, mut next) = (dots.to_vec(), sets::numbers(seed));
    (1..dots.len()).for_each(|at| dots.swap(at, next(at + 1)));
    dots
}

#[test]
fn a_small_sheet_is_written_as_documented() {
    let dots = [[1_240, 3_105], [0, 5], [1_240, 3_105]];
    let (_, gcode) = made(&points(&dots), &Params { title: "Cup;\r\nM112 ☕".into(), ..Params::a4() });
    let version = env!("CARGO_PKG_VERSION");
    let lines = [
        "G28 X; Cup;  M112 ☕",
        &format!("G28 Y; tactograph {version}"),
        "M204 T1500;",
        "G1 F6000;",
        "G1 X0.00 Y0.00;",
        "G1 X0.00 Y0.05;",
        "M3 S1;",
        "M3 S0;",
        "G1 X12.40 Y31.05;",
        "M3 S1;",
        "M3 S0;",
        "G1 F6000;",
        "G1 X0.00 Y317.00;",
    ];
    let (body, end) = gcode.split_once("M84; as written ").expect("the last line");
    assert_eq!(body, lines.join("\r\n") + "\r\n");
    assert!(end.len() == 18 && end.ends_with("\r\n"), "{end}");
    assert!(is_as_written(gcode.as_bytes()) && !is_as_written(gcode.replace("Y31.05", "Y31.06").as_bytes()));
}

#[test]
fn every_dot_of_every_set_is_pressed_once_and_the_sheet_comes_out() {
    for (name, dots) in sets::all() {
        for params in [Params::a4(), Params { most_back: f32::INFINITY, feed: 10_000, ..machine::xl_a4() }] {
            let (sheet, _) = made(&points(&dots), &params);
            pressed_once(&sheet, &dots);
            let back = f64::from(pulled_back(&sheet.dots)) / 100.0;
            assert!(back <= f64::from(params.most_back), "{name}: paper is pulled back {back} mm");
            // The needle goes as the order says.
            let length = length(&sheet.dots, ends(&params));
            assert!((sheet.travel - length).abs() < 0.01, "{name}: {} and {length}", sheet.travel);
        }
    }
}

#[test]
fn twenty_thousand_dots_on_a3() {
    let (dots, params) = (sets::large(), machine::xl_a3());
    let (sheet, _) = made(&points(&dots), &params);
    pressed_once(&sheet, &dots);
    let nearest = nearest_neighbour(&dots, [0, 0], 1_200);
    // Firmware stops the sheet at 420 mm, of 440.
    assert!(sheet.travel < 0.8 * length(&nearest, ends(&params)));
}

#[test]
fn paths_are_no_longer_than_nearest_neighbours_and_close_to_the_bound() {
    let ends = ends(&Params::a4());
    for (name, dots) in sets::all() {
        let length = |path: &[DotPosition]| length(path, ends);
        for back in [i32::MAX, 1_200, 200, 0] {
            let ours = length(&order(&dots, ends, back));
            let nearest = length(&nearest_neighbour(&dots, ends[0], back));
            assert!(ours <= nearest + 1e-3, "{name}, {back}: {ours:.0}, nearest neighbour {nearest:.0}");
        }
        let ours = length(&order(&dots, ends, i32::MAX));
        let bound = lower_bound(&dots, ends);
        assert!(bound <= ours && ours <= OVER_BOUND * bound, "{name}: {ours:.0}, bound {bound:.0}");
        let within = length(&order(&dots, ends, 1_200));
        let rows = length(&row_by_row(&dots, 200));
        assert!(within < 0.75 * rows, "{name}: {within:.0}, rows of 2 mm {rows:.0}");
    }
}

#[test]
fn the_bound_is_below_the_shortest_path_and_tight_on_a_line() {
    // Every order of seven dots.
    let mut next = sets::numbers(5);
    for _ in 0..20 {
        let dots: Vec<DotPosition> = (0..7).map(|_| [next(1_000) as i32, next(1_000) as i32]).collect();
        let ends = [[0, 0], [0, 1_000]];
        let shortest = permutations(&dots).iter().map(|order| length(order, ends)).fold(f64::INFINITY, f64::min);
        let (ours, bound) = (length(&order(&dots, ends, i32::MAX), ends), lower_bound(&dots, ends));
        assert!(bound <= shortest + 1e-6, "{dots:?}: bound {bound}, shortest {shortest}");
        assert!(ours <= 1.02 * shortest, "{dots:?}: {ours}, shortest {shortest}");
    }
    let line: Vec<DotPosition> = (1..50).map(|y| [0, 240 * y]).collect();
    let bound = lower_bound(&line, [[0, 0], [0, 12_000]]);
    assert!((bound - 12_000.0).abs() < 1e-6, "{bound}");
}

fn permutations(dots: &[DotPosition]) -> Vec<Vec<DotPosition>> {
    let Some((&first, rest)) = dots.split_first() else { return vec![vec![]] };
    let put =
        |order: Vec<DotPosition>| (0..=order.len()).map(move |at| [&order[..at], &[first], &order[at..]].concat());
    permutations(rest).into_iter().flat_map(put).collect()
}

#[test]
fn the_order_of_the_input_plays_no_part() {
    for (name, dots) in sets::all() {
        let dots = points(&dots);
        let gcode = made(&dots, &Params::a4()).1;
        let twice = [&dots[..], &shuffled(&dots, 6)].concat();
        for other in [shuffled(&dots, 7), twice] {
            assert_eq!(made(&other, &Params::a4()).1, gcode, "{name}");
        }
    }
}

#[test]
fn an_empty_sheet_is_drawn_in_and_comes_out() {
    let (sheet, gcode) = made(&[], &Params::a4());
    assert_eq!(sheet.dots, [[0; 2]; 0]);
    assert_eq!(gcode.matches("G1 X").count(), 2);
}

#[test]
fn the_zero_of_the_needle_is_where_it_is_said_to_be() {
    let params = Params { origin: [10.0, 12.5], ..Params::a4() };
    let (sheet, _) = made(&[MmPoint::new(10.0, 12.5), MmPoint::new(200.0, 262.5)], &params);
    assert_eq!(sheet.dots, [[0, 0], [19_000, 25_000]]);
}

#[test]
fn the_corners_are_reached_and_nothing_beyond_them() {
    for params in [Params::a4(), machine::xl_a4(), machine::xl_a3()] {
        let [x, y] = params.limits;
        let corners = [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y], [-0.004, y + 0.004]].map(|[x, y]| MmPoint::new(x, y));
        assert_eq!(made(&corners, &params).0.dots.len(), 4);
        for [off_x, off_y] in [[-0.006, 0.0], [x + 0.01, 0.0], [0.0, -0.01], [0.0, y + 0.01]] {
            let dots = [corners[0], MmPoint::new(off_x, off_y)];
            let refused = write(&dots, &params).expect_err("a dot off the limits");
            assert!(matches!(refused, Refused::OffLimits { count: 1, all: 2, .. }), "{refused}");
        }
    }
}

#[test]
fn what_cannot_be_done_is_said_in_one_line() {
    let dots = [MmPoint::new(195.5, 10.0), MmPoint::new(3.0, 260.25), MmPoint::new(5.0, 5.0)];
    assert_eq!(
        write(&dots, &Params::a4()).expect_err("off the limits").to_string(),
        "2 of 3 dots lie off the 190 x 250 mm that the machine reaches: they need 3.00 to 195.50 mm across and 5.00 to \
         260.25 mm down"
    );
    let nowhere = [MmPoint::new(f32::NAN, 1.0), MmPoint::new(1.0, f32::INFINITY), MmPoint::new(1.0, 1.0)];
    assert_eq!(write(&nowhere, &Params::a4()), Err(Refused::NoPosition { count: 2, all: 3 }));
    let params = Params {
        limits: [f32::NAN, 250.0],
        origin: [f32::INFINITY, 0.0],
        paper_length: 0.0,
        acceleration: 0,
        feed: 0,
        most_back: f32::NAN,
        title: String::new(),
    };
    let told = write(&[], &params).expect_err("nothing is right").to_string();
    for part in ["limits", "zero", "paper 0", "acceleration", "feed", "back"] {
        assert!(told.contains(part), "{part} is not in {told:?}");
    }
    assert!(!told.contains('\n'));
}

#[test]
fn the_machine_refuses_what_is_wrong() {
    let (limits, length) = ([19_000, 25_000], 29_700);
    let gcode = made(&points(&[[100, 200], [300, 400]]), &Params::a4()).1;
    assert!(machine::run(&gcode, limits, length).is_ok());
    for (from, to) in [
        ("G28 Y", "M117"),                     // not homed, and an unknown command
        ("G28 Y; tactograph", "; tactograph"), // a line without a command
        ("G28 X;\r\n", ""),
        ("M204 T1500;\r\n", ""),
        ("G1 F6000;\r\nG1 X0.00 Y0.00", "G1 X0.00 Y0.00"),
        ("X1.00 Y2.00", "X1.0 Y2.0"),
        ("X1.00 Y2.00", "X1.00"),
        ("X1.00 Y2.00", "X-1.00 Y2.00"),
        ("X1.00 Y2.00", "X190.01 Y2.00"),
        ("X1.00 Y2.00", "X0.00 Y250.01"), // out, and then on
        ("M3 S0;\r\nG1 X3", "G1 X3"),     // moves with the needle down
        ("M3 S1;", "M3 S1;\r\nM3 S1;"),
        ("M3 S1;", "M3 S2;"),
        ("M3 S1;", "G91;\r\nM3 S1;"),
        ("G1 X0.00 Y317.00;\r\n", ""),
        ("Y317.00", "Y296.00"),
        ("M84;", "G1 F6000;"),
        ("M84;", "M84;\r\nM3 S1;"),
        ("F6000;\r\n", "F6000;\n"),
    ] {
        assert!(gcode.contains(from), "{from:?} is not there");
        let wrong = gcode.replacen(from, to, 1);
        assert!(machine::run(&wrong, limits, length).is_err(), "{from:?} as {to:?} passes");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_dots_are_pressed_once_in_an_order_of_their_own(
        dots in prop::collection::vec((0..=190, 0..=250, 1..=100), 0..120),
        back in prop::sample::select(vec![0.0_f32, 0.5, 12.0, 60.0, f32::INFINITY]),
        seed in 0..u64::MAX,
    ) {
        // Coarse numbers, so that dots share rows, columns and places.
        let dots: Vec<DotPosition> = dots.into_iter().map(|(x, y, grain)| [x * 100 / grain, y * 100 / grain]).collect();
        let params = Params { most_back: back, ..Params::a4() };
        let (sheet, gcode) = made(&points(&dots), &params);
        pressed_once(&sheet, &dots);
        prop_assert!(pulled_back(&sheet.dots) as f32 <= back * 100.0);
        prop_assert_eq!(made(&points(&shuffled(&dots, seed)), &params).1, gcode);
        let limit = if back.is_finite() { (back * 100.0) as i32 } else { i32::MAX };
        let nearest = nearest_neighbour(&dots, [0, 0], limit);
        prop_assert!(length(&sheet.dots, ends(&params)) <= length(&nearest, ends(&params)) + 1e-3);
        prop_assert!(lower_bound(&dots, ends(&params)) <= length(&sheet.dots, ends(&params)) + 1e-3);
    }
}
