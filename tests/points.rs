//! Points and ticks of number lines, clocks and graphs: small marks on lines, which a finger has to find.

use std::fmt::Write;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::Tree;
use tactograph::marks::Line;
use tactograph::{Drawing, MmPoint, Options, Profile};

fn svg(drawn: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 500'>\
         <rect width='1000' height='500' fill='#fff'/>{drawn}</svg>"
    )
}

fn page_of(drawn: &str) -> Drawing {
    let profile = Profile::named("swell-a4").expect("the default profile is there");
    tactograph::convert(svg(drawn).as_bytes(), &Options::new(profile)).expect("a page")
}

/// The page of the same drawing as a PNG twice as large.
fn page_of_bitmap(drawn: &str) -> Drawing {
    let tree = Tree::from_str(&svg(drawn), &resvg::usvg::Options::default()).expect("a drawing");
    let mut pixels = Pixmap::new(2000, 1000).expect("so many pixels");
    resvg::render(&tree, Transform::from_scale(2.0, 2.0), &mut pixels.as_mut());
    let profile = Profile::named("swell-a4").expect("the default profile is there");
    tactograph::convert(&pixels.encode_png().expect("a PNG"), &Options::new(profile)).expect("a page")
}

/// A number line with ticks of two lengths, and two filled points on it.
fn number_line() -> String {
    let mut drawn = "<path d='M40 250H960' stroke='#000' stroke-width='3'/>".to_owned();
    for k in 0..=10 {
        let (x, half) = (80 + 84 * k, if k % 5 == 0 { 24 } else { 14 });
        write!(drawn, "<path d='M{x} {}V{}' stroke='#000' stroke-width='3'/>", 250 - half, 250 + half)
            .expect("it is a string");
    }
    drawn + "<circle cx='332' cy='250' r='10' fill='red'/><circle cx='626' cy='250' r='10' fill='#00f'/>"
}

/// The middles of the beads among lines, in a drawing of 1000 units, from left to right.
fn beads(lines: &[Line], page: &Drawing) -> Vec<(f32, f32)> {
    let place = page.page.figure.place;
    let runs = lines.iter().flat_map(|line| &line.runs).filter(|run| run.width > 4.0);
    let at =
        |at: MmPoint| ((at.x - place.min.x) / place.width() * 1000.0, (at.y - place.min.y) / place.height() * 500.0);
    let mut found: Vec<(f32, f32)> = runs.map(|run| at(run.points[0].lerp(run.points[1], 0.5))).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

#[test]
fn points_of_a_number_line_are_beads_on_a_line_without_gaps() {
    for page in [page_of(&number_line()), page_of_bitmap(&number_line())] {
        let lines = &page.page.figure.lines;
        let found = beads(lines, &page);
        let [first, second] = found[..] else { panic!("{found:?}") };
        let is_at = |(x, y): (f32, f32), wanted: f32| (x - wanted).abs() < 3.0 && (y - 250.0).abs() < 4.0;
        assert!(is_at(first, 332.0) && is_at(second, 626.0), "{found:?}");
        let longest = lines.iter().map(Line::length).fold(0.0, f32::max);
        assert!(longest > 0.9 * page.page.figure.place.width(), "the line is whole: {longest} mm");
        // the shorter ticks are 5 mm long in the drawing, the longer ones 8 mm
        let mut ticks: Vec<f32> =
            lines.iter().map(Line::length).filter(|length| (7.5..14.0).contains(length)).collect();
        ticks.sort_by(f32::total_cmp);
        assert!(ticks.len() >= 10, "only the tick below a point may be hidden by it: {ticks:?}");
        let [.., before_long, long, _, _] = ticks[..] else { panic!("{ticks:?}") };
        assert!(long - before_long > 2.0 && ticks[0] >= 8.0, "longer ones stay longer: {ticks:?}");
        assert!(page.notes.iter().all(|note| !note.to_string().contains("short tick")), "{:?}", page.notes);
        assert!(page.page.overview.as_ref().is_some_and(|overview| {
            overview.lines.iter().flat_map(|line| &line.runs).filter(|run| run.width > 3.0).count() == 2
        }));
    }
}

#[test]
fn ticks_that_dots_have_no_room_for_are_told() {
    let profile = Profile::named("index-basic-d").expect("it is built in");
    let page = tactograph::convert(svg(&number_line()).as_bytes(), &Options::new(profile)).expect("a page");
    let told: Vec<String> = page.notes.iter().map(ToString::to_string).collect();
    let says = |what: &str| told.iter().any(|note| note.contains(what));
    assert!(says(" short ticks ("), "{told:#?}");
}

#[test]
fn corners_of_a_graph_and_stations_of_a_route_are_found() {
    let graph = "<path d='M100 300L250 260L375 410L150 450ZM250 260L150 450' stroke='#000' stroke-width='4' fill='none'/>\
                 <circle cx='100' cy='300' r='11'/><circle cx='250' cy='260' r='11'/>\
                 <circle cx='375' cy='410' r='11'/><circle cx='150' cy='450' r='11'/>";
    for page in [page_of(graph), page_of_bitmap(graph)] {
        assert_eq!(beads(&page.page.figure.lines, &page).len(), 4);
    }
    let route = "<path d='M100 250H900' stroke='#06c' stroke-width='8'/>\
                 <g fill='#fff' stroke='#000' stroke-width='3'><circle cx='300' cy='250' r='12'/>\
                 <circle cx='600' cy='250' r='12'/></g>";
    let lines = &page_of(route).page.figure.lines;
    assert_eq!(lines.iter().filter(|line| line.runs[0].closed).count(), 2, "a ring for each");
    assert_eq!(lines.len(), 5, "and the route ends at them");
}
