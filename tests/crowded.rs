//! Worksheet pictures that are dense for their size: charts of bars, of sectors and of curves, and boxes with connectors.

use std::fmt::Write;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::Tree;
use tactograph::internals::geom::nearest_on_segment;
use tactograph::marks::Line;
use tactograph::{Drawing, MmPoint, MmRect, Options, Profile};

const WIDTH: f32 = 900.0;
const HEIGHT: f32 = 600.0;
/// A contour is drawn where a line is this near, mm: by so much the two sides of a narrow gap may give way.
const NEAR: f32 = 1.6;

fn svg(drawn: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}'>\
         <rect width='{WIDTH}' height='{HEIGHT}' fill='#fff'/>{drawn}</svg>"
    )
}

fn converted(bytes: &[u8]) -> Drawing {
    let profile = Profile::named("swell-a4").expect("the default profile is there");
    tactograph::convert(bytes, &Options::new(profile)).expect("a page")
}

fn page_of(drawn: &str) -> Drawing {
    converted(svg(drawn).as_bytes())
}

/// The page of the same drawing as a PNG of 1000 px.
fn page_of_bitmap(drawn: &str) -> Drawing {
    let tree = Tree::from_str(&svg(drawn), &resvg::usvg::Options::default()).expect("a drawing");
    let mut pixels = Pixmap::new(1000, 667).expect("so many pixels");
    resvg::render(&tree, Transform::from_scale(1000.0 / WIDTH, 1000.0 / WIDTH), &mut pixels.as_mut());
    converted(&pixels.encode_png().expect("a PNG"))
}

/// So many bars on an axis, which take this share of their distance, with their height at its place in a list.
fn bars(count: usize, share: f32) -> (String, Vec<(f32, f32)>) {
    const HEIGHTS: [f32; 5] = [210.0, 400.0, 330.0, 440.0, 150.0];
    let step = 750.0 / count as f32;
    let (mut drawn, mut points) = (String::new(), Vec::new());
    for k in 0..count {
        let (x, width, height) = (105.0 + (k as f32 + 0.5 - 0.5 * share) * step, share * step, HEIGHTS[k % 5]);
        write!(drawn, "<rect x='{x}' y='{}' width='{width}' height='{height}' fill='#4c72b0'/>", 520.0 - height)
            .expect("it is a string");
        // both legs and the top
        let legs = (1..20).flat_map(|i| [x, x + width].map(|x| (x, 520.0 - height * i as f32 / 20.0)));
        points.extend(legs.chain((1..5).map(|i| (x + width * i as f32 / 5.0, 520.0 - height))));
    }
    drawn += "<path d='M90 40V520H860' fill='none' stroke='#000' stroke-width='3'/>";
    (drawn, points)
}

/// Share of some points of a drawing that lie on lines drawn in `place`.
fn share_drawn(points: &[(f32, f32)], place: MmRect, lines: &[Line]) -> f32 {
    let is_drawn = |&&(x, y): &&(f32, f32)| {
        let at = place.min + MmPoint::new(x / WIDTH * place.width(), y / HEIGHT * place.height()).to_vector();
        lines.iter().flat_map(|line| &line.runs).any(|run| {
            let next = run.points.iter().cycle().skip(1).take(run.points.len() - usize::from(!run.closed));
            run.points.iter().zip(next).any(|(from, to)| nearest_on_segment(at, *from, *to).0 <= NEAR)
        })
    };
    points.iter().filter(is_drawn).count() as f32 / points.len() as f32
}

#[test]
fn bars_with_gaps_of_three_millimetres_are_all_whole() {
    // 14 bars of 7.2 mm with gaps of 3.1 mm: lines need 4.9
    let (drawn, points) = bars(14, 0.7);
    let page = page_of(&drawn).page;
    let share = share_drawn(&points, page.figure.place, &page.figure.lines);
    assert!(share >= 0.98, "{share} of the bars are drawn");
    assert_eq!(page.figure.lines.len(), 15, "14 bars and an axis");
    let page = page_of_bitmap(&drawn).page;
    let share = share_drawn(&points, page.figure.place, &page.figure.lines);
    assert!(share >= 0.98, "{share} of the bars of the bitmap are drawn");
}

#[test]
fn a_dashed_line_is_drawn_without_gaps_and_told() {
    let (triangle, altitude) = ("M150 500L750 500L520 120Z", "M520 120V500");
    let drawn = format!(
        "<path d='{triangle}' fill='none' stroke='#000' stroke-width='4'/>\
         <path d='{altitude}' stroke='#000' stroke-width='3' stroke-dasharray='14 8'/>"
    );
    let points: Vec<(f32, f32)> = (0..=36).map(|k| (520.0, 130.0 + 10.0 * k as f32)).collect();
    for drawing in [page_of(&drawn), page_of_bitmap(&drawn)] {
        let share = share_drawn(&points, drawing.page.figure.place, &drawing.page.figure.lines);
        assert!(share >= 0.999, "{share} of the altitude is drawn");
        let told = drawing.notes.iter().map(ToString::to_string).find(|note| note.contains("dash"));
        assert!(told.is_some_and(|told| told.starts_with("1 dashed line: it is drawn without gaps")));
    }
    let solid = page_of_bitmap(&drawn.replace("stroke-dasharray", "class"));
    assert!(solid.notes.iter().all(|note| !note.to_string().contains("dash")));
}

#[test]
fn an_overview_is_larger_only_where_bars_have_no_room_in_it() {
    for (count, scale) in [(3, 0.4..0.401), (7, 0.45..0.701)] {
        let (drawn, points) = bars(count, 0.6);
        let page = page_of(&drawn).page;
        let overview = page.overview.as_ref().expect("it has one");
        let size = overview.place.width() / page.figure.place.width();
        assert!(scale.contains(&(size + 1e-4)), "{count} bars: an overview of {size}");
        let share = share_drawn(&points, overview.place, &overview.lines);
        assert!(share >= 0.98, "{share} of {count} bars are drawn");
        let below = page.figure.place.max.y;
        assert!(overview.place.min.y > below && overview.place.max.y < 297.0 - 10.0);
    }
}

#[test]
fn a_white_stroke_round_sectors_does_not_tear_their_outline() {
    let at = |degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (450.0 + 240.0 * cos, 300.0 + 240.0 * sin)
    };
    let mut drawn = String::new();
    for (from, to, fill) in [(0.0, 126.0, "#4c72b0"), (126.0, 216.0, "#55a868"), (216.0, 360.0, "#c44e52")] {
        let ((x, y), (u, v)) = (at(from), at(to));
        let path = format!("M450 300L{x} {y}A240 240 0 0 1 {u} {v}Z");
        write!(drawn, "<path d='{path}' fill='{fill}' stroke='#fff' stroke-width='2'/>").expect("it is a string");
    }
    let page = page_of(&drawn).page;
    let circle: Vec<(f32, f32)> = (0..360).map(|degrees| at(degrees as f32)).collect();
    let share = share_drawn(&circle, page.figure.place, &page.figure.lines);
    assert!(share >= 0.995, "{share} of the circle is drawn");
}

#[test]
fn curves_that_cross_and_connectors_that_end_at_24_degrees_are_whole() {
    let along = |(a, b): ((f32, f32), (f32, f32))| {
        (0..=50).map(move |i| (a.0 + (b.0 - a.0) * i as f32 / 50.0, a.1 + (b.1 - a.1) * i as f32 / 50.0))
    };
    let lines = [((100.0, 100.0), (500.0, 278.0)), ((100.0, 278.0), (500.0, 100.0)), ((400.0, 400.0), (200.0, 490.0))];
    let mut drawn = String::from("<path d='M300 400H700M100 490H300' stroke='#036' stroke-width='4'/>");
    for ((x, y), (u, v)) in lines {
        write!(drawn, "<path d='M{x} {y}L{u} {v}' stroke='#036' stroke-width='4'/>").expect("it is a string");
    }
    let page = page_of(&drawn).page;
    let points: Vec<(f32, f32)> = lines.into_iter().flat_map(along).collect();
    let share = share_drawn(&points, page.figure.place, &page.figure.lines);
    assert!(share >= 0.995, "{share} of the lines is drawn");
}

/// The ticks of a number line are hardly longer than the least length, half of them on either side of it.
#[test]
fn ticks_across_an_axis_are_drawn() {
    let mut drawn = String::from("<path d='M30 300H870' stroke='#000' stroke-width='4'/>");
    let mut points = Vec::new();
    for x in (60..=840_u16).step_by(78).map(f32::from) {
        write!(drawn, "<path d='M{x} 276V324' stroke='#000' stroke-width='3'/>").expect("it is a string");
        points.extend((0..=10).map(|i| (x, 276.0 + 4.8 * i as f32)));
    }
    for drawing in [page_of(&drawn), page_of_bitmap(&drawn)] {
        let share = share_drawn(&points, drawing.page.figure.place, &drawing.page.figure.lines);
        assert!(share >= 0.95, "{share} of the ticks is drawn");
        assert_eq!(drawing.page.figure.lines.len(), 12, "the axis and eleven ticks");
        assert!(!drawing.notes.iter().any(|note| note.id() == "too-dense"), "{:?}", drawing.notes);
    }
}

#[test]
fn two_circles_that_cross_have_an_overview_also_as_a_bitmap() {
    let circle = |x: f32, fill: &str| {
        format!("<circle cx='{x}' cy='300' r='190' fill='{fill}' fill-opacity='0.5' stroke='#000' stroke-width='3'/>")
    };
    let drawn = circle(350.0, "#e07b39") + &circle(550.0, "#4c72b0");
    let points = |x: f32| {
        let at = move |k: u16| f32::from(k).to_radians().sin_cos();
        (0..360).step_by(5).map(at).map(move |(sine, cosine)| (x + 190.0 * cosine, 300.0 + 190.0 * sine))
    };
    let points: Vec<(f32, f32)> = points(350.0).chain(points(550.0)).collect();
    for page in [page_of(&drawn).page, page_of_bitmap(&drawn).page] {
        let overview = page.overview.as_ref().expect("an overview");
        let share = share_drawn(&points, overview.place, &overview.lines);
        assert!(share > 0.8, "{share}");
    }
}

#[test]
fn a_window_in_a_wall_is_told() {
    let plan = |colour: &str| {
        format!(
            "<g stroke-width='10'><path d='M50 50H850V550H50Z' fill='none' stroke='#000'/>\
             <path d='M120 50H260' stroke='{colour}'/></g>"
        )
    };
    let is_told = |colour: &str| {
        let notes = page_of(&plan(colour)).notes;
        notes.iter().any(|note| note.to_string().starts_with("1 stroke lies on a line of another colour (around "))
    };
    assert!(is_told("#39f"));
    assert!(!is_told("#000"), "drawn twice");
}

#[test]
fn a_coast_is_whole_in_the_overview_though_a_lake_beside_it_is_clearer() {
    let (columns, rows) = ([60, 255, 450, 645, 840], [90, 300, 510]);
    let fills = ["#b7dba5", "#f4e29b", "#e8b4a0", "#c7b6dd"];
    let mut drawn = "<g stroke='#444' stroke-width='2'>".to_owned();
    for (row, y) in rows.windows(2).enumerate() {
        for (column, x) in columns.windows(2).enumerate() {
            let fill = fills[(column + 2 * row) % 4];
            write!(drawn, "<path d='M{} {}H{}V{}H{}Z' fill='{fill}'/>", x[0], y[0], x[1], y[1], x[0]).expect("text");
        }
    }
    // 12 units, less than 2 mm, before the coast of the last country
    drawn += "</g><path d='M700 440H770V498H700Z' fill='#9bc'/>";
    let level = (12..=168).map(|k| 5.0 * k as f32).flat_map(|x| [(x, 90.0), (x, 510.0)]);
    let upright = (18..=102).map(|k| 5.0 * k as f32).flat_map(|y| [(60.0, y), (840.0, y)]);
    let coast: Vec<(f32, f32)> = level.chain(upright).collect();
    let drawing = page_of(&drawn);
    let overview = drawing.page.overview.as_ref().expect("it has one");
    let share = share_drawn(&coast, overview.place, &overview.lines);
    assert!(share >= 0.999, "{share} of the coast is drawn");
    let told = drawing.notes.iter().map(ToString::to_string).find(|note| note.contains("the overview leaves out"));
    assert!(told.is_some_and(|told| told.starts_with("the overview leaves out 1 closed shape")));
}

/// Boxes of 130 by 48, and lines, as paths.
fn tree(boxes: &[(f32, f32)], lines: &str) -> String {
    let rect = |(x, y): &(f32, f32)| format!("M{x} {y}h130v48h-130Z");
    let boxes: String = boxes.iter().map(rect).collect();
    format!("<g fill='none' stroke='#000' stroke-width='2'><path d='{boxes}'/><path d='{lines}'/></g>")
}

/// Two of three strokes from one place of a box were one bent line, which took the room of the box; and a line that
/// lacked 0.05 mm on either side ended 5 mm before the line that it met.
#[test]
fn connectors_of_trees_reach_the_boxes_and_lines_that_they_meet() {
    let along = |[(x, y), (u, v)]: [(f32, f32); 2]| {
        (0..=50).map(move |k| k as f32 / 50.0).map(move |share| (x + share * (u - x), y + share * (v - y)))
    };
    let fan = tree(
        &[(385.0, 60.0), (135.0, 238.0), (385.0, 238.0), (635.0, 238.0)],
        "M450 108L200 238M450 108V238M450 108L700 238",
    );
    let of_fan = [
        [(385.0, 60.0), (515.0, 60.0)],
        [(385.0, 108.0), (515.0, 108.0)],
        [(450.0, 108.0), (200.0, 238.0)],
        [(450.0, 108.0), (450.0, 238.0)],
        [(450.0, 108.0), (700.0, 238.0)],
    ];
    let family = tree(
        &[(150.0, 100.0), (330.0, 100.0), (110.0, 284.0), (350.0, 284.0)],
        "M280 124H330M305 124V224M175 284V224H415V284",
    );
    let of_family = [[(280.0, 124.0), (330.0, 124.0)], [(305.0, 124.0), (305.0, 224.0)]];
    for (drawn, lines) in [(fan, &of_fan[..]), (family, &of_family[..])] {
        let page = page_of(&drawn).page;
        let points: Vec<(f32, f32)> = lines.iter().copied().flat_map(along).collect();
        let share = share_drawn(&points, page.figure.place, &page.figure.lines);
        assert!(share >= 0.995, "{share} of the lines is drawn");
    }
}

#[test]
fn a_connector_that_ends_before_the_line_that_it_met_is_told_as_such() {
    let notes = |gap: f32| {
        let (boxes, middle) = ([(150.0, 100.0), (280.0 + gap, 100.0)], 280.0 + 0.5 * gap);
        let drawing = page_of(&tree(&boxes, &format!("M280 124H{}M{middle} 124V264H600", 280.0 + gap)));
        drawing.notes.iter().map(|note| format!("{note}\n")).collect::<String>()
    };
    let wanted = "the end of 1 line, which stops before the line that it met (";
    assert!(notes(30.0).contains(wanted), "{}", notes(30.0));
    assert!(!notes(30.0).contains("mm of contours"), "told once: {}", notes(30.0));
    assert!(!notes(80.0).contains(wanted), "{}", notes(80.0));
}
