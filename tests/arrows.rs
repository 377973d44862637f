//! Arrows: which way a line leads is what its head says, on paper, as dots, in words, and on pages that are laid out
//! anew.

use std::fmt::Write;

use tactograph::{Drawing, Options, Profile, RenderOptions};
use tactograph_tools::bitmap;

fn svg(drawn: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 900 600'>\
         <rect width='900' height='600' fill='#fff'/>\
         <g fill='none' stroke='#000' stroke-width='3'>{drawn}</g></svg>"
    )
}

fn profile(name: &str) -> Profile {
    Profile::named(name).expect("it is built in")
}

fn page_of(drawn: &str, profile_name: &str) -> Drawing {
    tactograph::convert(svg(drawn).as_bytes(), &Options::new(profile(profile_name))).expect("a page")
}

/// A cycle of four boxes with arrows from one to the next, clockwise from the upper left; `head` draws that of a tip
/// and a direction.
fn cycle(head: impl Fn([f32; 2], [f32; 2]) -> String) -> String {
    let mut drawn = String::new();
    for (x, y) in [(150, 150), (600, 150), (600, 420), (150, 420)] {
        write!(drawn, "<rect x='{x}' y='{y}' width='170' height='90'/>").expect("it is a string");
    }
    let arrows = [
        ([322.0, 195.0], [598.0, 195.0]),
        ([685.0, 242.0], [685.0, 418.0]),
        ([598.0, 465.0], [322.0, 465.0]),
        ([235.0, 418.0], [235.0, 242.0]),
    ];
    for (from, to) in arrows {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = f32::hypot(dx, dy);
        let head = head(to, [dx / length, dy / length]);
        write!(drawn, "<path d='M{} {}L{} {}'/>{head}", from[0], from[1], to[0], to[1]).expect("it is a string");
    }
    drawn
}

/// Both ends of the strokes of a head.
fn wings([x, y]: [f32; 2], [dx, dy]: [f32; 2]) -> [[f32; 2]; 2] {
    [1.0, -1.0].map(|side| [x - 16.0 * dx - side * 9.0 * dy, y - 16.0 * dy + side * 9.0 * dx])
}

fn filled(tip: [f32; 2], way: [f32; 2]) -> String {
    let [[a, b], [c, d]] = wings(tip, way);
    format!("<polygon points='{a},{b} {},{} {c},{d}' fill='#000' stroke='none'/>", tip[0], tip[1])
}

fn open(tip: [f32; 2], way: [f32; 2]) -> String {
    let [[a, b], [c, d]] = wings(tip, way);
    format!("<path d='M{a} {b}L{} {}L{c} {d}'/>", tip[0], tip[1])
}

/// Which way the arrows of a page point, as its description tells.
fn ways(svg: &str) -> Vec<String> {
    let told = tactograph::describe(svg, &tactograph::PageOptions::new().language("en")).expect("a page").to_string();
    let arrows = told.lines().filter(|line| line.starts_with("An arrow"));
    let way = |line: &str| line.split("points ").nth(1).unwrap_or_default().trim_end_matches('.').to_owned();
    let mut ways: Vec<String> = arrows.map(way).collect();
    ways.sort();
    ways
}

const ALL_WAYS: [&str; 4] = ["down", "to the left", "to the right", "up"];

#[test]
fn the_arrows_of_a_cycle_point_the_way_they_do_on_paper_and_as_dots() {
    let heads: [(&str, String); 2] = [("filled", cycle(filled)), ("open", cycle(open))];
    for (head, drawn) in heads {
        for name in ["swell-a4", "index-basic-d", "viewplus-columbia", "braillerap"] {
            let drawing = page_of(&drawn, name);
            let page = drawing.page.to_svg();
            assert_eq!(ways(&page), ALL_WAYS, "{head}, {name}");
            let checked = tactograph::check(&page, &tactograph::PageOptions::new()).expect("a page");
            assert_eq!(checked.errors(), 0, "{head}, {name}: {checked}");
            assert!(!drawing.notes.iter().any(|note| note.to_string().contains("arrowhead")), "{head}, {name}");
        }
    }
}

#[test]
fn a_page_that_is_laid_out_anew_keeps_its_arrows() {
    let page = page_of(&cycle(filled), "swell-a4").page.to_svg();
    let anew = |page: &str, name: &str| {
        let options = RenderOptions::new().profile(profile(name));
        tactograph::render(page, &options).expect("a page")
    };
    let dots = anew(&page, "index-basic-d");
    let lost = dots.notes.iter().map(ToString::to_string).find(|note| note.contains("lines, line"));
    assert_eq!(lost, None, "heads are no lost lines");
    let dots = dots.page.to_svg();
    assert_eq!(ways(&dots), ALL_WAYS);
    assert_eq!(ways(&anew(&dots, "viewplus-columbia").page.to_svg()), ALL_WAYS);
    assert_eq!(ways(&anew(&dots, "swell-a4").page.to_svg()), ALL_WAYS);
}

#[test]
fn a_short_arrow_from_box_to_box_has_its_head_at_the_side_of_the_second() {
    let boxes = "<rect x='150' y='200' width='250' height='200'/><rect x='465' y='200' width='250' height='200'/>";
    let drawing = page_of(&format!("{boxes}<path d='M400 300H463'/>{}", open([463.0, 300.0], [1.0, 0.0])), "swell-a4");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    assert!(!told.iter().any(|note| note.contains("arrowhead")), "{told:?}");
    let page = drawing.page.to_svg();
    assert_eq!(ways(&page), ["to the right"]);
    let checked = tactograph::check(&page, &tactograph::PageOptions::new()).expect("a page");
    assert_eq!(checked.errors(), 0, "{checked}");
}

#[test]
fn a_head_without_room_is_told_with_its_place() {
    let beside = "<path d='M100 280H800M100 320H800M150 300H750'/>".to_owned();
    let drawing = page_of(&(beside + &open([750.0, 300.0], [1.0, 0.0])), "swell-a4");
    let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
    let lost = told.iter().any(|note| note.contains("1 arrowhead at the end of a line (at "));
    assert!(lost || ways(&drawing.page.to_svg()) == ["to the right"], "{told:?}");
    assert!(lost, "there is no room: {told:?}");
}

#[test]
fn arrows_that_meet_a_box_at_an_angle_keep_their_heads() {
    // a side of each head lies along the lower side of the box that both point at
    let arrow = |from: [f32; 2], to: [f32; 2]| {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = f32::hypot(dx, dy);
        let head = filled(to, [dx / length, dy / length]);
        format!("<path d='M{} {}L{} {}'/>{head}", from[0], from[1], to[0], to[1])
    };
    let boxes = "<rect x='150' y='300' width='180' height='60'/><rect x='560' y='300' width='180' height='60'/>\
                 <rect x='370' y='140' width='180' height='60'/>";
    let drawn = format!("{}{}{boxes}", arrow([250.0, 300.0], [420.0, 200.0]), arrow([640.0, 300.0], [490.0, 200.0]));
    for name in ["swell-a4", "index-basic-d"] {
        let drawing = page_of(&drawn, name);
        let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
        assert!(!told.iter().any(|note| note.contains("tick") || note.contains("arrowhead")), "{name}: {told:?}");
        assert_eq!(ways(&drawing.page.to_svg()).len(), 2, "{name}");
    }
}

#[test]
fn filled_heads_of_a_bitmap_are_those_of_the_drawing() {
    let picture = bitmap::png(&svg(&cycle(filled)), 1200).expect("a PNG");
    for name in ["swell-a4", "index-basic-d"] {
        let drawing = tactograph::convert(&picture, &Options::new(profile(name))).expect("a page");
        let told: Vec<String> = drawing.notes.iter().map(ToString::to_string).collect();
        assert_eq!(ways(&drawing.page.to_svg()), ALL_WAYS, "{name}: {told:?}");
    }
}

#[test]
fn heads_with_barbs_are_found_in_a_bitmap() {
    let barbed = |[x, y]: [f32; 2], way: [f32; 2]| {
        let [[a, b], [c, d]] = wings([x, y], way);
        let [e, f] = [x - 12.0 * way[0], y - 12.0 * way[1]];
        format!("<polygon points='{a},{b} {x},{y} {c},{d} {e},{f}' fill='#000' stroke='none'/>")
    };
    let picture = bitmap::png(&svg(&cycle(barbed)), 1000).expect("a PNG");
    for name in ["swell-a4", "index-basic-d"] {
        let drawing = tactograph::convert(&picture, &Options::new(profile(name))).expect("a page");
        assert_eq!(ways(&drawing.page.to_svg()), ALL_WAYS, "{name}");
    }
}

#[test]
fn triangles_on_a_curve_in_a_bitmap_are_no_heads() {
    let places = [[100.0, 480.0], [230.0, 380.0], [360.0, 410.0], [490.0, 250.0], [620.0, 270.0], [750.0, 270.0]];
    let mut drawn = "<path d='M60 540H860M60 540V60'/><path d='M".to_owned();
    places.iter().for_each(|[x, y]| write!(drawn, " {x} {y}").expect("it is a string"));
    drawn.push_str("'/>");
    for &[x, y] in &places[1..] {
        drawn.push_str(&filled([x + 8.0, y], [1.0, 0.0]));
    }
    let picture = bitmap::png(&svg(&drawn), 1000).expect("a PNG");
    for name in ["swell-a4", "index-basic-d"] {
        let drawing = tactograph::convert(&picture, &Options::new(profile(name))).expect("a page");
        let none: [String; 0] = [];
        assert_eq!(ways(&drawing.page.to_svg()), none, "{name}");
    }
}
