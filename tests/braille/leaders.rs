//! Leader lines of dots differ from outlines: they have every second dot only.

use super::worksheets::{drawn, notes, svg};
use tactograph::marks::Run;
use tactograph::{Drawing, PageOptions, Profile, RenderOptions};

/// Profiles of dots, and how far dots are apart.
const PROFILES: [(&str, f32); 2] = [("index-basic-d", 2.0), ("braillerap", 2.5)];

/// Whether the steps of a row of dots are longer than those of a line, but for one of three, as at its beginning and
/// behind a hole, and none is longer than by the dot that is missing.
fn is_every_second(run: &Run, pitch: f32) -> bool {
    let steps: Vec<f32> = run.points.windows(2).map(|pair| (pair[1] - pair[0]).length()).collect();
    let short = |steps: &[f32]| steps.iter().filter(|step| **step <= 1.5 * pitch).count();
    short(&steps) + 2 <= steps.len()
        && steps.windows(3).all(|three| short(three) <= 1)
        && steps.iter().all(|step| *step < 3.0 * pitch)
}

/// A cell, most of whose own leader lines have no room as a whole: labels have others.
#[test]
fn a_leader_line_of_a_label_has_every_second_dot() {
    let marks = "<rect x='150' y='60' width='420' height='320' rx='40' fill='#c5e1a5' stroke='#2e7d32' \
        stroke-width='8'/>\
        <rect x='164' y='74' width='392' height='292' rx='32' fill='#e6f4d7' stroke='#558b2f' stroke-width='3'/>\
        <ellipse cx='400' cy='230' rx='110' ry='80' fill='#bbdefb' stroke='#1565c0' stroke-width='3'/>\
        <circle cx='235' cy='150' r='45' fill='#ffcc80' stroke='#e65100' stroke-width='3'/>\
        <ellipse cx='220' cy='300' rx='30' ry='15' fill='#43a047' stroke='#1b5e20' stroke-width='2'/>\
        <g stroke='#000' stroke-width='1.5'><path d='M235 165L120 150'/><path d='M220 300L120 320'/>\
        <path d='M430 240L610 230'/><path d='M555 330L610 340'/><path d='M300 280L330 430'/></g>\
        <g font-size='17'><text x='114' y='155' text-anchor='end'>Nucleus</text>\
        <text x='114' y='325' text-anchor='end'>Chloroplast</text><text x='616' y='235'>Vacuole</text>\
        <text x='616' y='345'>Membrane</text><text x='336' y='435'>Cytoplasm</text></g>";
    for (profile, pitch) in PROFILES {
        let drawing = drawn(&svg([720.0, 460.0], marks), profile);
        let leaders: Vec<&Run> = drawing.page.braille.iter().filter_map(|label| label.leader.as_ref()).collect();
        // a short one stays as it is
        let long = leaders.iter().filter(|run| run.length() > 4.5 * pitch);
        let long: Vec<bool> = long.map(|run| run.points.len() >= 3 && is_every_second(run, pitch)).collect();
        assert!(!long.is_empty() && !long.contains(&false), "{profile}: {leaders:?}: {}", notes(&drawing));
    }
}

/// A cell with leader lines of its own that are on the page, one of them across the wall: they are told from it, the
/// page keeps all rules, and has them when it is laid out anew.
#[test]
fn a_leader_line_of_a_drawing_has_every_second_dot() {
    let marks = "<ellipse cx='330' cy='250' rx='170' ry='120' fill='#cde' stroke='#000' stroke-width='3'/>\
        <circle cx='300' cy='260' r='45' fill='#a36' stroke='#000' stroke-width='3'/>\
        <g stroke='#000' stroke-width='2'><path d='M554 114L452 166'/><path d='M554 394L340 280'/></g>\
        <g font-size='20'><text x='560' y='120'>Wall</text><text x='560' y='400'>Nucleus</text></g>";
    let [index, braillerap] = PROFILES;
    for ((profile, pitch), other) in [(index, braillerap), (braillerap, index)] {
        let drawing = drawn(&svg([700.0, 500.0], marks), profile);
        assert_every_second(&drawing, (profile, pitch));
        let found = tactograph::check(drawing.page.to_svg(), &PageOptions::new()).expect("a page").findings;
        assert!(found.is_empty(), "{profile}: {found:?}");
        let options = RenderOptions::new().profile(Profile::named(other.0).expect("it is built in"));
        let anew = tactograph::render(drawing.page.to_svg(), &options).expect("a page");
        assert_every_second(&anew, other);
    }
}

/// The outlines have all dots, and the leader lines, which are the open lines, every second one.
fn assert_every_second(drawing: &Drawing, (profile, pitch): (&str, f32)) {
    let rows = || drawing.page.figure.lines.iter().map(|line| &line.runs[0]);
    let is_open = |run: &&Run| {
        let [first, last] = [run.points[0], run.points[run.points.len() - 1]];
        (last - first).length() > 5.0 * pitch
    };
    let (open, rings): (Vec<&Run>, Vec<&Run>) = rows().partition(is_open);
    let of_leaders: Vec<bool> = open.iter().map(|run| is_every_second(run, pitch)).collect();
    assert!(of_leaders.len() >= 2 && !of_leaders.contains(&false), "{profile}: {open:?}: {}", notes(drawing));
    assert!(rings.len() == 2 && rings.iter().all(|run| !is_every_second(run, pitch)), "{profile}: {rings:?}");
}
