//! Points and ticks of number lines, clocks and graphs: small marks on lines, which a finger has to find.

use std::fmt::Write;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::Tree;
use tactograph::internals::legibility::check;
use tactograph::internals::profile::Plan;
use tactograph::marks::Line;
use tactograph::{Drawing, MmPoint, Options, Profile, RenderOptions, SheetGrid};

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

/// As in circuits, where all shapes have the stroke of the wires.
#[test]
fn a_disc_with_an_outline_of_its_own_colour_is_a_bead_and_one_of_another_colour_a_ring() {
    let wire = "<g stroke='#000' stroke-width='4'><path d='M100 250H900'/>";
    let of = |fill: &str| page_of(&format!("{wire}<circle cx='500' cy='250' r='8' fill='{fill}'/></g>"));
    let (filled, hollow) = (of("#000"), of("#fff"));
    assert_eq!(beads(&filled.page.figure.lines, &filled).len(), 1);
    assert!(beads(&hollow.page.figure.lines, &hollow).is_empty());
    // as documents paint it
    let circle = |paint: &str| format!("<circle cx='500' cy='250' r='8' {paint}/>");
    let apart = |stroke: &str| {
        let stroke = format!("fill='none' stroke='{stroke}' stroke-width='4'");
        page_of(&format!("{wire}</g>{}{}", circle("fill='#000'"), circle(&stroke)))
    };
    let (filled, ringed) = (apart("#000"), apart("#c00"));
    assert_eq!(beads(&filled.page.figure.lines, &filled).len(), 1);
    assert!(beads(&ringed.page.figure.lines, &ringed).is_empty());
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

/// How many lines of a page are as long as ticks that were made longer, and what is told of ticks.
fn ticks_and_notes(drawn: &str) -> (usize, Vec<String>) {
    let page = page_of(drawn);
    let lengths = page.page.figure.lines.iter().map(Line::length);
    let notes = told(&page).into_iter().filter(|note| note.contains("tick")).collect();
    (lengths.filter(|length| (7.9..13.0).contains(length)).count(), notes)
}

#[test]
fn ticks_of_a_number_line_stay_where_an_arc_ends_above_two_of_its_points() {
    let mut drawn = "<path d='M40 250H960' stroke='#000' stroke-width='3'/>".to_owned();
    for x in (0..=10).map(|k| 80 + 84 * k) {
        write!(drawn, "<path d='M{x} 236V264' stroke='#000' stroke-width='2'/>").expect("it is a string");
    }
    drawn += "<circle cx='248' cy='250' r='10'/>\
              <circle cx='668' cy='250' r='10' fill='#fff' stroke='#000' stroke-width='3'/>\
              <path d='M248 231Q458 90 668 231' fill='none' stroke='#c00' stroke-width='3'/>";
    let (ticks, notes) = ticks_and_notes(&drawn);
    assert!(ticks >= 9 && notes.is_empty(), "{ticks} ticks, {notes:?}");
}

#[test]
fn ticks_of_a_ruler_and_of_a_thermometer_that_are_too_many_for_fingers_are_told_and_the_long_ones_drawn() {
    let mut ruler =
        "<rect x='50' y='150' width='900' height='200' fill='none' stroke='#000' stroke-width='3'/>".to_owned();
    for k in 1..100 {
        let length = match (k % 10, k % 5) {
            (0, _) => 40,
            (_, 0) => 30,
            _ => 20,
        };
        let x = 50 + 9 * k;
        write!(ruler, "<path d='M{x} 150v{length}' stroke='#000' stroke-width='2'/>").expect("it is a string");
    }
    let (ticks, notes) = ticks_and_notes(&ruler);
    let is_told = matches!(&notes[..], [note] if note.contains("80 of the 99 ticks") && note.contains("every 5th"));
    assert!(ticks == 19 && is_told, "{ticks} ticks, {notes:?}");
    let mut tube =
        "<rect x='470' y='40' width='40' height='380' rx='20' fill='#fff' stroke='#000' stroke-width='3'/>".to_owned();
    for k in 0..21 {
        let (y, length) = (70 + 15 * k, if k % 5 == 0 { 30 } else { 18 });
        write!(tube, "<path d='M510 {y}h{length}' stroke='#000' stroke-width='2'/>").expect("it is a string");
    }
    let (ticks, notes) = ticks_and_notes(&tube);
    let is_told = matches!(&notes[..], [note] if note.contains("16 of the 21 ticks") && note.contains("every 5th"));
    assert!(ticks == 5 && is_told, "{ticks} ticks, {notes:?}");
}

#[test]
fn ticks_on_the_outer_sides_of_two_axes_are_all_drawn() {
    let mut axes = "<path d='M60 30V450H960' fill='none' stroke='#000' stroke-width='3'/>".to_owned();
    for (x, y) in (1..9).map(|k| (60 + 100 * k, 450 - 50 * k)) {
        let ticks = format!("<path d='M60 {y}h-16'/><path d='M{x} 450v16'/>");
        write!(axes, "<g stroke='#000' stroke-width='2'>{ticks}</g>").expect("it is a string");
    }
    let (ticks, notes) = ticks_and_notes(&axes);
    assert!(ticks == 16 && notes.is_empty(), "{ticks} ticks, {notes:?}");
}

const DEVICES: [&str; 7] =
    ["index-basic-d", "juliet-120", "viewplus-columbia", "braillerap", "dot-pad", "monarch", "pins-120x60"];

fn dots_of(drawn: &str, profile: &str) -> Drawing {
    let profile = Profile::named(profile).expect("it is built in");
    tactograph::convert(svg(drawn).as_bytes(), &Options::new(profile)).expect("a page")
}

/// The number line with a hollow point at its ninth tick.
fn with_hollow() -> String {
    number_line() + "<circle cx='752' cy='250' r='9' fill='#fff' stroke='#000' stroke-width='3'/>"
}

/// How many ticks and points lines of dots have: the places of ticks, filled points, hollow ones.
fn marks_of(lines: &[Line]) -> [usize; 3] {
    let mut ticks: Vec<i32> =
        lines.iter().flat_map(|line| line.row_ticks()).map(|(_, at)| (10.0 * at.x).round() as i32).collect();
    ticks.sort_unstable();
    ticks.dedup();
    let points = || lines.iter().flat_map(|line| line.row_points());
    let filled = points().filter(|point| point.is_filled).count();
    [ticks.len(), filled, points().count() - filled]
}

fn told(page: &Drawing) -> Vec<String> {
    page.notes.iter().map(ToString::to_string).collect()
}

#[test]
fn a_number_line_of_dots_has_its_ticks_and_points() {
    for device in DEVICES {
        let page = dots_of(&with_hollow(), device);
        let [ticks, filled, hollow] = marks_of(&page.page.figure.lines);
        // where dots are few one of two ticks beside a point has no room
        let (least, lost) = if device == "dot-pad" { (10, 1) } else { (11, 0) };
        assert_eq!((filled, hollow), (2, 1), "{device}");
        assert!(ticks >= least, "{device}: {ticks} ticks");
        let words = &page.page.description;
        let points = "2 filled points lie on lines. 1 hollow point lies on a line.";
        assert!(words.contains(points) && words.contains(&format!("{ticks} ticks stand on lines.")), "{words}");
        let of_scale = told(&page).iter().filter(|note| note.contains(" ticks of a scale")).count();
        assert_eq!(of_scale, lost, "{device}: {:#?}", told(&page));
        let checked = tactograph::check(page.page.to_svg(), &tactograph::PageOptions::new()).expect("a page");
        assert_eq!(checked.errors(), 0, "{device}: {:#?}", checked.findings);
    }
}

/// The arc of a jump ends above a filled point and a hollow one, and gives way to both.
#[test]
fn points_of_a_number_line_stay_below_an_arc_from_one_to_the_other() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 170'>\
        <rect width='800' height='170' fill='#fff'/><path d='M30 100H770' stroke='#000' stroke-width='3'/>\
        <g stroke='#000' stroke-width='2'>"
        .to_owned();
    (0..11).for_each(|k| svg += &format!("<path d='M{} 90v20'/>", 70 + 66 * k));
    svg += "</g><circle cx='202' cy='100' r='8'/><path d='M202 85Q367 10 532 85' fill='none' stroke='#c00' \
        stroke-width='2.5'/><circle cx='532' cy='100' r='8' fill='#fff' stroke='#000' stroke-width='3'/></svg>";
    for device in ["index-basic-d", "juliet-120", "viewplus-columbia"] {
        let profile = Profile::named(device).expect("it is built in");
        let page = tactograph::convert(svg.as_bytes(), &Options::new(profile)).expect("a page");
        let [_, filled, hollow] = marks_of(&page.page.figure.lines);
        assert_eq!((filled, hollow), (1, 1), "{device}: {:#?}", told(&page));
        assert!(!told(&page).iter().any(|note| note.contains("2 small shapes")), "{device}: {:#?}", told(&page));
        let checked = tactograph::check(page.page.to_svg(), &tactograph::PageOptions::new()).expect("a page");
        assert_eq!(checked.errors(), 0, "{device}: {:#?}", checked.findings);
    }
}

#[test]
fn ticks_reach_two_free_dots_beyond_their_axis_and_long_ones_farther() {
    for device in ["index-basic-d", "braillerap", "pins-120x60"] {
        let page = dots_of(&number_line(), device);
        let lines = &page.page.figure.lines;
        // behind a point there may be less
        let points: Vec<MmPoint> = lines.iter().flat_map(|line| line.row_points()).map(|point| point.at).collect();
        let is_bare = |at: MmPoint| points.iter().all(|point| (*point - at).length() > 6.0);
        let counts: Vec<usize> = lines
            .iter()
            .flat_map(|line| line.row_ticks())
            .filter(|(_, at)| is_bare(*at))
            .map(|(run, _)| run.points.len())
            .collect();
        let (least, most) = (counts.iter().min(), counts.iter().max());
        assert!(least >= Some(&2) && most > least, "{device}: {counts:?}");
    }
}

/// The face of a clock with a tick at each minute and a longer one at each hour.
fn clock_face() -> String {
    let mut clock = "<circle cx='500' cy='250' r='220' fill='none' stroke='#000' stroke-width='4'/>".to_owned();
    for k in 0..60 {
        let (sin, cos) = (k as f32 / 60.0 * std::f32::consts::TAU).sin_cos();
        let inner = if k % 5 == 0 { 190.0 } else { 205.0 };
        let at = |radius: f32| format!("{:.2} {:.2}", 500.0 + radius * sin, 250.0 - radius * cos);
        write!(clock, "<path d='M{}L{}' stroke='#000' stroke-width='3'/>", at(220.0), at(inner)).expect("a string");
    }
    clock
}

/// On a page of few shapes the ticks of a scale are lines, and those that are left out of it are told as on paper.
#[test]
fn ticks_without_room_on_a_page_of_few_shapes_of_dots_are_told() {
    for name in ["index-basic-d", "swell-a4"] {
        let mut profile = Profile::named(name).expect("it is built in");
        profile.set("lines.shapes", 3).expect("the key is there");
        let page = tactograph::convert(svg(&clock_face()).as_bytes(), &Options::new(profile)).expect("a page");
        let notes = told(&page);
        assert!(notes.iter().any(|note| note.contains("48 of the 60 ticks of a scale")), "{name}: {notes:#?}");
    }
}

#[test]
fn ticks_that_dots_have_no_room_for_are_told_and_every_so_many_th_is_drawn() {
    let page = dots_of(&clock_face(), "index-basic-d");
    let notes = told(&page);
    let is_told = notes.iter().any(|note| note.contains("of the 60 ticks of a scale") && note.contains("every 5th"));
    assert!(is_told, "{notes:#?}");
    let ticks = page.page.figure.lines.iter().flat_map(|line| line.row_ticks()).count();
    assert!((10..=12).contains(&ticks), "{ticks} of the hours");
}

/// The hands of a clock cut the ring of their hub in two arcs, of which one was told as a mark of a right angle.
#[test]
fn the_hub_of_a_clock_is_no_mark_of_an_angle() {
    let clock = "<circle cx='500' cy='250' r='240' fill='none' stroke='#000' stroke-width='6'/>\
                 <path d='M500 250L617.8 304.9' stroke='#000' stroke-width='20'/>\
                 <path d='M500 250L326.8 150' stroke='#000' stroke-width='12'/><circle cx='500' cy='250' r='20'/>";
    let notes = told(&dots_of(clock, "index-basic-d"));
    assert!(!notes.iter().any(|note| note.contains("angle")), "{notes:#?}");
    assert!(notes.iter().any(|note| note.contains("1 piece of a small ring")), "{notes:#?}");
}

#[test]
fn stations_of_a_route_of_dots_are_rings_at_which_it_ends() {
    let route = "<path d='M80 380H400L560 160H920' fill='none' stroke='#06c' stroke-width='8'/>\
                 <g fill='#fff' stroke='#000' stroke-width='3'><circle cx='240' cy='380' r='12'/>\
                 <circle cx='400' cy='380' r='12'/><circle cx='740' cy='160' r='12'/></g>";
    for device in DEVICES {
        let page = dots_of(route, device);
        assert_eq!(marks_of(&page.page.figure.lines)[1..], [0, 3], "{device}");
    }
}

/// A page of paper with ticks and points, laid out for devices of dots and for other paper, and from dots to dots.
#[test]
fn marks_are_kept_where_a_page_is_laid_out_anew() {
    let render = |page: &Drawing, profile: &str| {
        let profile = Profile::named(profile).expect("it is built in");
        tactograph::render(page.page.to_svg(), &RenderOptions::new().profile(profile)).expect("a page")
    };
    let paper = page_of(&with_hollow());
    for device in ["index-basic-d", "braillerap", "pins-120x60"] {
        let [ticks, filled, hollow] = marks_of(&render(&paper, device).page.figure.lines);
        assert!(ticks >= 10 && (filled, hollow) == (2, 1), "{device}: {ticks} ticks, {filled} and {hollow} points");
    }
    let beads = |page: &Drawing| page.page.figure.lines.iter().flat_map(Line::beads).count();
    assert_eq!((beads(&paper), beads(&render(&paper, "swell-letter"))), (2, 2));
    let dots = dots_of(&with_hollow(), "index-basic-d");
    let [ticks, filled, hollow] = marks_of(&render(&dots, "braillerap").page.figure.lines);
    assert!(ticks >= 10 && (filled, hollow) == (2, 1), "{ticks} ticks, {filled} and {hollow} points");
    assert_eq!(beads(&render(&dots, "swell-a4")), 2);
}

#[test]
fn sheets_of_dots_have_the_ticks_and_points_of_their_parts() {
    let profile = Profile::named("index-basic-d").expect("it is built in");
    let options = Options::new(profile);
    let grid = Some(SheetGrid::new(2, 1).expect("a grid"));
    let sheets = tactograph::convert_to_sheets(svg(&with_hollow()).as_bytes(), grid, &options).expect("sheets");
    let all: Vec<[usize; 3]> = sheets.pages.iter().map(|page| marks_of(&page.figure.lines)).collect();
    let sum = |kind: usize| all.iter().map(|of| of[kind]).sum::<usize>();
    // what lies where sheets overlap is on both, and a large point hides the tick behind it
    assert!(sum(0) >= 10 && sum(1) >= 2 && sum(2) >= 1, "{all:?}");
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

/// The points of a curve before gridlines, of which some lie beside them: the gridlines give way.
#[test]
fn points_of_a_curve_are_beads_before_gridlines() {
    let mut drawn: String = (0..5).map(|k| format!("<path d='M90 {}H960' stroke='#ddd'/>", 60 + 90 * k)).collect();
    let points = [(150, 300), (290, 230), (430, 140), (570, 195), (710, 70), (850, 105)];
    let path: Vec<String> = points.iter().map(|(x, y)| format!("{x},{y}")).collect();
    drawn += &format!("<polyline points='{}' fill='none' stroke='#c22' stroke-width='4'/>", path.join(" "));
    drawn.extend(points.iter().map(|(x, y)| format!("<circle cx='{x}' cy='{y}' r='8' fill='#c22'/>")));
    drawn += "<path d='M90 30V420H960' fill='none' stroke='#000' stroke-width='3'/>";
    let page = page_of(&drawn);
    assert_eq!(beads(&page.page.figure.lines, &page).len(), points.len(), "{:?}", page.notes);
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let errors: Vec<_> =
        check(&page.page, &plan.limits(), None).findings.into_iter().filter(|found| found.is_error()).collect();
    assert!(errors.is_empty(), "{errors:?}");
}

/// As in scatter plots: rings of the size of other points had no room, and two thirds of the points were left out.
#[test]
fn a_cloud_of_points_is_discs_each_at_its_place_and_those_that_overlap_are_told() {
    let axes = "<path d='M90 30V460H960' fill='none' stroke='#000' stroke-width='3'/>\
                <path d='M90 420L900 80' stroke='#c00' stroke-width='2'/>";
    let far = [(150, 300), (240, 370), (300, 210), (420, 290), (500, 180), (620, 260), (690, 110), (800, 230)];
    let near = [(360, 307), (560, 240)];
    let circles = |places: &[(i32, i32)]| -> String {
        places.iter().map(|(x, y)| format!("<circle cx='{x}' cy='{y}' r='8' fill='#1f77b4'/>")).collect()
    };
    let page = page_of(&(axes.to_owned() + &circles(&far) + &circles(&near)));
    let place = page.page.figure.place;
    let middles: Vec<(f32, f32)> = page
        .page
        .figure
        .lines
        .iter()
        .filter_map(|line| match &line.runs[..] {
            [run] if run.closed && line.length() < 8.0 => {
                let sum = run.points.iter().fold((0.0, 0.0), |sum, at| (sum.0 + at.x, sum.1 + at.y));
                let middle = MmPoint::new(sum.0 / run.points.len() as f32, sum.1 / run.points.len() as f32);
                let share = (middle - place.min).component_div(place.size().to_vector());
                Some((1000.0 * share.x, 500.0 * share.y))
            }
            _ => None,
        })
        .collect();
    for (x, y) in far.iter().chain(&near) {
        let off = middles.iter().map(|at| (at.0 - *x as f32).hypot(at.1 - *y as f32)).fold(f32::INFINITY, f32::min);
        assert!(off < 6.0, "the point at {x}, {y} is {off} units from its place: {middles:?}");
    }
    let checked = tactograph::check(page.page.to_svg(), &tactograph::PageOptions::new()).expect("a page");
    assert_eq!(checked.errors(), 0, "{:#?}", checked.findings);
    assert!(told(&page).iter().all(|note| !note.contains("point")), "{:#?}", told(&page));
    let page = page_of(&(axes.to_owned() + &circles(&far) + &circles(&[(432, 296)])));
    assert!(told(&page).iter().any(|note| note.contains("1 of 9 points (at ")), "{:#?}", told(&page));
}

/// They were rings, hollow ones beside the discs that an SVG gets.
#[test]
fn a_cloud_of_points_in_a_bitmap_is_discs_too() {
    let places = [(150, 300), (240, 370), (300, 210), (420, 290), (500, 180), (620, 260), (690, 110), (800, 230)];
    let mut drawn = "<path d='M90 30V460H960' fill='none' stroke='#000' stroke-width='3'/>".to_owned();
    for (x, y) in places {
        write!(drawn, "<circle cx='{x}' cy='{y}' r='8' fill='#1f77b4'/>").expect("it is a string");
    }
    let page = page_of_bitmap(&drawn);
    // the middle line of a disc is 4 mm long, that of a ring as large as the points 9 mm
    let is_disc = |line: &&Line| matches!(&line.runs[..], [run] if run.closed && line.length() < 6.0);
    assert_eq!(page.page.figure.lines.iter().filter(is_disc).count(), places.len(), "{:#?}", told(&page));
    let checked = tactograph::check(page.page.to_svg(), &tactograph::PageOptions::new()).expect("a page");
    assert_eq!(checked.errors(), 0, "{:#?}", checked.findings);
}

/// As the wheels of a car, which were open below, or not in the overview.
#[test]
fn a_wheel_on_the_road_is_closed_in_the_figure_and_in_the_overview() {
    let drawn = "<g fill='none' stroke='#000' stroke-width='4'><path d='M40 420H960'/><path d='M100 340V180H900V340Z'/>\
                 <circle cx='280' cy='347' r='70'/><circle cx='700' cy='347' r='70'/></g>";
    let page = page_of(drawn);
    let round = |lines: &[Line], place: tactograph::MmRect| {
        let is_wheel = |line: &&Line| {
            let of_circle = std::f32::consts::TAU * 70.0 / 1000.0 * place.width();
            let first = line.runs.first().and_then(|run| run.path().next());
            let last = line.runs.last().and_then(|run| run.path().last());
            let meets = first.zip(last).is_some_and(|(first, last)| (last - first).length() < 0.05);
            meets && (line.length() / of_circle - 1.0).abs() < 0.1
        };
        lines.iter().filter(is_wheel).count()
    };
    let overview = page.page.overview.as_ref().expect("it has one");
    assert_eq!(round(&page.page.figure.lines, page.page.figure.place), 2, "{:#?}", told(&page));
    assert_eq!(round(&overview.lines, overview.place), 2, "{:#?}", told(&page));
    let checked = tactograph::check(page.page.to_svg(), &tactograph::PageOptions::new()).expect("a page");
    assert_eq!(checked.errors(), 0, "{:#?}", checked.findings);
}

/// As the towns of a map or the pips of a die: each is the smallest ring of dots, with dots inside if it is filled.
#[test]
fn points_beside_all_lines_are_rings_of_dots() {
    let discs: String =
        (1..=5).map(|k| format!("<circle cx='{}' cy='120' r='{}' fill='#a00'/>", 150 * k, 4 + 2 * k)).collect();
    let rings: String = (1..=5)
        .map(|k| format!("<circle cx='{}' cy='230' r='{}' fill='none' stroke='#000'/>", 150 * k, 4 + 2 * k))
        .collect();
    for device in DEVICES {
        let page = dots_of(&format!("<path d='M60 400H940' stroke='#000' stroke-width='3'/>{discs}{rings}"), device);
        let signs: Vec<&Line> = page.page.figure.lines.iter().filter(|line| line.runs[0].points.len() <= 24).collect();
        let filled = signs.iter().filter(|line| line.runs.len() > 1).count();
        assert_eq!((signs.len(), filled), (10, 5), "{device}: {:?}", told(&page));
        assert!(!told(&page).iter().any(|note| note.contains("no room")), "{device}: {:?}", told(&page));
        let checked = tactograph::check(page.page.to_svg(), &tactograph::PageOptions::new()).expect("a page");
        assert_eq!(checked.errors(), 0, "{device}: {:#?}", checked.findings);
    }
}

/// Eight rays around a disc, farther from it than ticks: each has too little room, and a sun without them is a point.
#[test]
fn the_rays_of_a_sun_that_are_too_short_are_told() {
    let rays = "M330 210V195M330 290V305M290 250H275M370 250H385M302 222L292 212M358 278L368 288M302 278L292 288\
                M358 222L368 212";
    let page = page_of(&format!(
        "<path d='M60 40H640V440H60Z' fill='none' stroke='#000' stroke-width='3'/><circle cx='330' cy='250' r='20' \
         fill='#fdd017' stroke='#b80' stroke-width='2'/><path d='{rays}' stroke='#b80' stroke-width='3'/>"
    ));
    let is_told = told(&page).iter().any(|note| note.contains("left out: 8 short lines (the first"));
    assert!(is_told, "{:#?}", told(&page));
}
