//! Tests of `kept_lines`.

use super::*;

fn line(y: f32, from: f32, to: f32) -> Line {
    Line { strength: 1.0, runs: vec![Run::stroke(1.0, vec![MmPoint::new(from, y), MmPoint::new(to, y)])] }
}

#[test]
fn a_line_that_is_gone_is_named_though_its_neighbour_is_near() {
    let (from, to) = (MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0)), MmPoint::new(10.0, 20.0));
    let to = MmRect::new(to, to + MmPoint::new(50.0, 50.0).to_vector());
    let before = [line(10.0, 0.0, 80.0), line(13.0, 0.0, 80.0), line(60.0, 0.0, 100.0)];
    // half as large, the first moved a little, the second gone, half of the third
    let after = [line(50.0, 10.0, 35.0), line(25.4, 10.0, 50.0)];
    let (stand_for, shares) = matched(&before, from, &after, to);
    assert_eq!(stand_for, [Some(2), Some(0)]);
    // one that lies near none stands for none of them
    let (stand_for, _) = matched(&before, from, &[line(66.0, 10.0, 50.0)], to);
    assert_eq!(stand_for, [None]);
    assert!(shares[0] > 0.9 && shares[1] < 0.1 && (shares[2] - 0.5).abs() < 0.05, "{shares:?}");
    let name = |name: &str, by_hand: bool| LineName { name: name.to_owned(), by_hand };
    let names = ["line 1", "line 2", "line 3"].map(|line| name(line, false));
    let told = lost(&names, &shares).expect("one is lost").to_string();
    assert!(told.contains("line 2, too short") && !told.contains("line 1"), "{told}");
    assert_eq!(lost(&names, &[1.0, 0.5, 0.3]), None);
    let names = [name("line 1", false), name("line 2", true)];
    let told = lost(&names, &[0.0, 0.0]).expect("two are lost").to_string();
    assert!(told.contains("2 lines, line 2 and line 1: "), "what a person drew comes first: {told}");
    let told = lost(&names, &[0.5, 0.5]).expect("a part of one is lost").to_string();
    assert!(told.contains("line 2 in part, too short"), "{told}");
    let names: Vec<LineName> = (0..30).map(|i| name(&format!("line {i}"), i % 3 == 0)).collect();
    let told = lost(&names, &[0.0; 30]).expect("all are lost").to_string();
    assert!((0..30).step_by(3).all(|i| told.contains(&format!("line {i}"))) && told.contains("and 20 more"), "{told}");
}

#[test]
fn what_is_missing_of_lines_is_measured_and_found() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let drawn = [line(20.5, 10.0, 60.0), line(80.0, 0.0, 100.0)];
    let missing_of = |lines: &[Line]| missing(lines, &drawn, area, 2.0, |_| true);
    assert_eq!(missing_of(&[line(20.0, 10.0, 60.0), line(80.0, 20.0, 30.0)]), None);
    let (mm, at) = missing_of(&[line(20.0, 10.0, 90.0)]).expect("its end is missing");
    assert!((mm - 28.0).abs() < 1.01 && (at - MmPoint::new(76.0, 20.0)).length() < 1.01, "{mm} {at:?}");
    let erased = missing(&[line(20.0, 10.0, 90.0)], &drawn, area, 2.0, |at| at.x < 60.0);
    assert_eq!(erased, None, "what is not asked for is not missing");
}
