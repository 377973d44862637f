//! Tests of `told_lines`.

use super::*;
use crate::lines::{LostLine, Run, lost_form};
use crate::pipeline::request::{Fit, OverviewSize};
use crate::profile::Profile;
use crate::units::{MmRect, Size};

const SHEET: Places<'_> = Places { windows: None, name: "sheet" };

#[test]
fn closed_outlines_that_are_open_on_the_page_are_told() {
    let gap = |x: f32, length: f32| LostLine {
        extent: MmRect::new((x, 40.0).into(), (x + length, 40.0).into()),
        length,
        closed: true,
        is_faint: false,
        form: None,
    };
    let told = |gaps: Vec<LostLine>| told_gaps(&Lost { gaps, ..Lost::default() }, SHEET).map(|note| note.to_string());
    assert_eq!(told(vec![]), None);
    let one = told(vec![gap(20.0, 8.0)]).expect("a chamber");
    let place = "around 24, 40 mm from the left and the top of the sheet";
    assert!(one.contains(&format!("a piece of 1 closed outline (8 mm long, {place}), so that it is open")), "{one}");
    let two = told(vec![gap(20.0, 8.0), gap(50.0, 12.0)]).expect("two");
    assert!(two.contains("pieces of 2 closed outlines (the longest 12 mm long, around 56, 40 mm"), "{two}");
}

#[test]
fn lines_that_end_before_those_that_they_met_are_told_and_not_once_more_by_their_length() {
    let end = |x: f32, length: f32| LostLine {
        extent: MmRect::new((x, 40.0).into(), (x, 40.0 + length).into()),
        length,
        closed: false,
        is_faint: false,
        form: None,
    };
    let lost = |loose: Vec<LostLine>| Lost { wanted: 900.0, lost: 9.0, loose, ..Lost::default() };
    let told = |loose: Vec<LostLine>| told_loose(&lost(loose), &[], SHEET).map(|note| note.to_string());
    assert_eq!(told(vec![]), None);
    let one = told(vec![end(20.0, 6.0)]).expect("a connector");
    let place = "6 mm long, around 20, 43 mm from the left and the top of the sheet";
    assert!(one.contains(&format!("the end of 1 line, which stops before the line that it met ({place})")), "{one}");
    let two = told(vec![end(20.0, 4.0), end(60.0, 6.0)]).expect("two");
    let wanted = "the ends of 2 lines, which stop before the lines that they met (the longest 6 mm long, around 60, 43";
    assert!(two.contains(wanted), "{two}");
    let is_all = |loose: Vec<LostLine>| is_told_by_lines(&lost(loose), 3.0);
    assert!(is_all(vec![end(20.0, 4.0), end(60.0, 6.0)]) && !is_all(vec![]));
}

#[test]
fn pieces_that_are_missing_of_open_lines_are_told_and_not_once_more_by_their_length() {
    let piece = |x: f32, length: f32| LostLine {
        extent: MmRect::new((x, 40.0).into(), (x + length, 60.0).into()),
        length,
        closed: false,
        is_faint: false,
        form: None,
    };
    let told =
        |torn: Vec<LostLine>| told_torn(&Lost { torn, ..Lost::default() }, &[], SHEET).map(|note| note.to_string());
    assert_eq!(told(vec![]), None);
    let one = told(vec![piece(20.0, 16.0)]).expect("a curve");
    let place = "around 28, 50 mm from the left and the top of the sheet";
    assert!(one.contains(&format!("a piece of a line whose other pieces are drawn (16 mm long, {place})")), "{one}");
    let two = told(vec![piece(20.0, 16.0), piece(60.0, 20.0)]).expect("two");
    assert!(
        two.contains("2 pieces of lines whose other pieces are drawn (the longest 20 mm long, around 70, 50"),
        "{two}"
    );
    let is_all =
        |lost: f32, torn: Vec<LostLine>| is_told_by_lines(&Lost { wanted: 900.0, lost, torn, ..Lost::default() }, 10.0);
    assert!(is_all(40.0, vec![piece(20.0, 16.0), piece(60.0, 20.0)]));
    assert!(is_all(70.0, vec![piece(20.0, 16.0), piece(60.0, 20.0)]), "34 mm of 900");
    assert!(!is_all(75.0, vec![piece(20.0, 16.0), piece(60.0, 20.0)]), "39 mm are more than are told");
    assert!(!is_all(116.0, vec![piece(20.0, 30.0), piece(60.0, 40.0)]), "46 mm are more than a small share");
    assert!(is_all(114.0, vec![piece(20.0, 30.0), piece(60.0, 40.0)]), "44 mm of 900");
    assert!(is_all(12.0, vec![piece(20.0, 3.0)]), "9 mm are no loss");
    assert!(!is_all(4.0, vec![]), "no line is torn");
    let whole = Lost { wanted: 900.0, lost: 70.0, gone: vec![piece(20.0, 40.0)], ..Lost::default() };
    assert!(is_told_by_lines(&whole, 10.0), "a line that is gone");
}

#[test]
fn a_pin_display_is_no_sheet() {
    let name = |profile: &str| {
        let profile = Profile::named(profile).expect("it is built in");
        let plan = Plan::new(&profile).expect("it makes sense");
        let layout = Fit::default().layout(Size::new(400, 300), &plan, OverviewSize::Own).expect("there is room");
        layout.medium.name_of_sheet()
    };
    assert_eq!(["swell-a4", "index-basic-d", "monarch"].map(name), ["sheet", "sheet", "display"]);
    let at = around(MmPoint::new(24.0, 40.0), Places { name: "display", ..SHEET });
    assert_eq!(at, "around 24, 40 mm from the left and the top of the display");
}

#[test]
fn a_line_that_is_gone_is_told_however_short_it_is_beside_all_others() {
    let line = |x: f32, length: f32, closed: bool| LostLine {
        extent: MmRect::new((x, 40.0).into(), (x + length, 40.0).into()),
        length,
        closed,
        is_faint: false,
        form: None,
    };
    let told = |gone: Vec<LostLine>| {
        let lost = Lost { wanted: 10_000.0, lost: 50.0, gone, ..Lost::default() };
        told_gone(&lost, &[], &[], SHEET).map(|note| note.to_string())
    };
    assert_eq!(told(vec![]), None);
    assert_eq!(told(vec![line(20.0, 9.0, true)]), None, "small closed shapes are told by the labels beside them");
    let hand = told(vec![line(20.0, 36.0, false)]).expect("a hand of a clock");
    assert!(hand.contains("1 line as a whole (36 mm long, around 38, 40 mm from the left"), "{hand}");
    let two = told(vec![line(20.0, 12.0, false), line(50.0, 30.0, true)]).expect("two");
    assert!(two.contains("2 lines as a whole (the longest 30 mm long, around 65, 40 mm from the left"), "{two}");
}

#[test]
fn a_line_that_is_gone_is_told_with_its_form() {
    let line = |points: &[(f32, f32)]| {
        let path: Vec<MmPoint> = points.iter().map(|&at| MmPoint::from(at)).collect();
        let (extent, length) = (MmRect::from_points(&path), polyline::length(&path));
        LostLine { extent, length, closed: false, is_faint: false, form: lost_form(&path) }
    };
    let told = |gone: Vec<LostLine>| {
        let lost = Lost { wanted: 1000.0, lost: 100.0, gone, ..Lost::default() };
        told_gone(&lost, &[], &[], SHEET).map_or_else(String::new, |note| note.to_string())
    };
    let curve = line(&[(20.0, 80.0), (50.0, 74.0), (80.0, 40.0)]);
    let one = told(vec![curve]);
    assert!(one.contains("1 line as a whole (a bent line from lower left to upper right, 76 mm long, around"), "{one}");
    let two = told(vec![curve, line(&[(20.0, 30.0), (110.0, 31.0)])]);
    assert!(two.contains("2 lines as a whole (the longest, a straight level line, 90 mm long, around"), "{two}");
    let hook = told(vec![line(&[(20.0, 30.0), (60.0, 30.0), (60.0, 40.0), (25.0, 40.0)])]);
    assert!(hook.contains("1 line as a whole (a bent line, 85 mm long, around"), "{hook}");
    let round = lost_form(&[(20.0, 30.0), (60.0, 30.0), (40.0, 50.0), (20.0, 30.0)].map(MmPoint::from));
    assert_eq!(round, None, "it comes back to where it began");
}

#[test]
fn a_line_that_is_gone_is_told_with_the_text_that_is_nearest_to_it() {
    let text = |string: &str, y: f32| Text::of_test(string, MmRect::new((20.0, y).into(), (40.0, y + 4.0).into()));
    let door = LostLine {
        extent: MmRect::new((22.0, 40.0).into(), (46.0, 40.0).into()),
        length: 24.0,
        closed: false,
        is_faint: false,
        form: None,
    };
    let beside_door = |texts: &[Text]| near_text(&door, texts);
    assert_eq!(beside_door(&[text("Garden", 10.0), text("Dining room", 52.0)]), ", near \"Dining room\"");
    assert_eq!(beside_door(&[text("Garden", 10.0)]), "", "it is 26 mm away");
    // a title above all lines names no place, and a text as large as the others does
    let path = vec![MmPoint::new(22.0, 40.0), MmPoint::new(60.0, 90.0)];
    let line = Line { strength: 40.0, runs: vec![Run::stroke(1.5, path)] };
    let near = |size: f32| {
        let plan = [Text { size, ..text("Plan", 30.0) }, text("Cellar", 70.0)];
        beside_door(&of_places(&plan, std::slice::from_ref(&line)))
    };
    assert_eq!((near(6.0).as_str(), near(4.0).as_str()), ("", ", near \"Plan\""));
}

#[test]
fn a_ring_that_is_open_beside_an_added_line_is_told_with_its_gap() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let stroke = |points: Vec<MmPoint>| Line { strength: 40.0, runs: vec![Run::stroke(1.5, points)] };
    // a ring of 30 mm around (50, 50) that lacks so many degrees at its left
    let ring = |lacks: u16| {
        let at = |k: u16| {
            let (sin, cos) = f32::from(180 + k).to_radians().sin_cos();
            MmPoint::new(50.0 + 30.0 * cos, 50.0 + 30.0 * sin)
        };
        stroke((lacks / 2..=360 - lacks / 2).map(at).collect())
    };
    let added = |to: f32| stroke(vec![MmPoint::new(2.0, 50.0), MmPoint::new(to, 50.0)]);
    let gap = |ring: Line, to: f32| opened(&ring, &kept_lines::index_of(&[added(to)], area, 4.7), 4.7);
    let (mm, at) = gap(ring(12), 17.0).expect("it is open");
    assert!((mm - 6.27).abs() < 0.05 && (at - MmPoint::new(20.16, 50.0)).length() < 0.1, "{mm} {at:?}");
    assert_eq!(gap(ring(0), 17.0), None, "it is closed");
    assert_eq!(gap(ring(12), 8.0), None, "no line is beside the gap");
    assert_eq!(gap(ring(90), 17.0), None, "it is no ring with a gap, but an arc");
    // the ring as it was before, and the letter C of which only the tips gave way
    let before = |degrees: std::ops::RangeInclusive<u16>| -> Vec<MmPoint> {
        let at = |k: u16| f32::from(180 + k).to_radians().sin_cos();
        degrees.map(at).map(|(sin, cos)| MmPoint::new(50.0 + 30.0 * cos, 50.0 + 30.0 * sin)).collect()
    };
    assert!(was_closed((mm, at), &before(354..=366)), "a ring that gave way");
    assert!(!was_closed((mm, at), &before(5..=6)), "a line that was open");
    assert!(!was_closed((mm, at), &[]), "nothing gave way");
}
