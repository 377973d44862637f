//! Charts whose bars have no room side by side: they are drawn touching, or as one outline, and never torn.

use std::fmt::Write;

use tactograph::internals::geom::nearest_on_segment;
use tactograph::marks::Line;
use tactograph::{Drawing, MmPoint, MmRect, Options, Profile};

const WIDTH: f32 = 900.0;
const HEIGHT: f32 = 600.0;
const BASE: f32 = 520.0;
/// A line is at a place if it is so near, mm.
const NEAR: f32 = 1.6;

/// A chart, and of each bar the middle of its top.
struct Chart {
    svg: String,
    tops: Vec<(f32, f32)>,
}

/// So many bars from `first` px beside the axis on, which take this share of their distance.
fn chart(count: usize, first: f32, share: f32, has_grid: bool) -> Chart {
    const HEIGHTS: [f32; 6] = [205.0, 400.0, 330.0, 440.0, 150.0, 275.0];
    let step = (750.0 - first) / count as f32;
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}'>\
         <rect width='{WIDTH}' height='{HEIGHT}' fill='#fff'/>"
    );
    for level in (1..6).filter(|_| has_grid) {
        write!(svg, "<path d='M90 {}H860' stroke='#bbb'/>", BASE - 90.0 * level as f32).expect("it is a string");
    }
    let mut tops = Vec::new();
    for k in 0..count {
        let (x, width, height) = (90.0 + first + k as f32 * step, share * step, HEIGHTS[k % 6]);
        write!(svg, "<rect x='{x}' y='{}' width='{width}' height='{height}' fill='#4c72b0'/>", BASE - height)
            .expect("it is a string");
        tops.push((x + 0.5 * width, BASE - height));
    }
    svg += "<path d='M90 40V520H860' fill='none' stroke='#000' stroke-width='3'/></svg>";
    Chart { svg, tops }
}

fn converted(chart: &Chart, profile: &str) -> Drawing {
    let profile = Profile::named(profile).expect("it is built in");
    tactograph::convert(chart.svg.as_bytes(), &Options::new(profile)).expect("a page")
}

fn told(drawing: &Drawing) -> String {
    drawing.notes.iter().map(|note| format!("{note}\n")).collect()
}

/// Distance from a place to the nearest of the lines but one, mm.
fn far(at: MmPoint, lines: &[Line], but: Option<usize>) -> f32 {
    let others = lines.iter().enumerate().filter(|(number, _)| Some(*number) != but);
    let runs = others.flat_map(|(_, line)| &line.runs);
    runs.flat_map(|run| run.points.windows(2))
        .map(|pair| nearest_on_segment(at, pair[0], pair[1]).0)
        .fold(f32::INFINITY, f32::min)
}

/// How many ends of lines lie on no other line.
fn loose_ends(lines: &[Line]) -> usize {
    let ends = lines.iter().enumerate().flat_map(|(number, line)| {
        let is_ring = line.runs.iter().any(|run| run.closed);
        let first = line.runs.first().and_then(|run| run.points.first());
        let last = line.runs.last().and_then(|run| run.points.last());
        [first, last].into_iter().flatten().filter(move |_| !is_ring).map(move |end| (number, *end))
    });
    ends.filter(|&(number, end)| far(end, lines, Some(number)) > NEAR).count()
}

/// How many tops of bars are drawn where they are.
fn tops_drawn(chart: &Chart, place: MmRect, lines: &[Line]) -> usize {
    let on_page = |&(x, y): &(f32, f32)| {
        place.min + MmPoint::new(x / WIDTH * place.width(), y / HEIGHT * place.height()).to_vector()
    };
    chart.tops.iter().filter(|top| far(on_page(top), lines, None) <= NEAR).count()
}

#[test]
fn an_overview_has_all_bars_and_no_scraps() {
    for count in [12, 14, 16] {
        let chart = chart(count, 20.0, 0.7, false);
        let drawing = converted(&chart, "swell-a4");
        let overview = drawing.page.overview.as_ref().expect("it has one");
        assert_eq!(tops_drawn(&chart, overview.place, &overview.lines), count, "{count} bars");
        // the two ends of the axis
        assert!(loose_ends(&overview.lines) <= 2, "{count} bars: {} loose ends", loose_ends(&overview.lines));
        assert!(told(&drawing).contains("the bars of the chart"), "{}", told(&drawing));
    }
}

#[test]
fn a_figure_with_gridlines_has_bars_of_their_own_height() {
    let chart = chart(12, 6.0, 0.7, true);
    let drawing = converted(&chart, "swell-a4");
    let figure = &drawing.page.figure;
    assert_eq!(tops_drawn(&chart, figure.place, &figure.lines), 12);
    assert!(told(&drawing).contains("the bars of the chart touch one another, without gaps"), "{}", told(&drawing));
    // above the lowest bars there is nothing up to the next gridline
    let above = |&(x, y): &(f32, f32)| (x, y - 25.0);
    let lowest: Vec<(f32, f32)> = chart.tops.iter().filter(|(_, y)| *y == BASE - 205.0).map(above).collect();
    let open = Chart { tops: lowest, svg: String::new() };
    assert_eq!(tops_drawn(&open, figure.place, &figure.lines), 0);
}

#[test]
fn what_has_room_stays_as_it_is() {
    let chart = chart(5, 40.0, 0.6, false);
    let drawing = converted(&chart, "swell-a4");
    assert!(!told(&drawing).contains("the bars of the chart"), "{}", told(&drawing));
    assert_eq!(drawing.page.figure.lines.len(), 6, "five bars and an axis");
}

#[test]
fn on_an_embosser_bars_touch_and_are_told() {
    let chart = chart(14, 20.0, 0.7, false);
    let drawing = converted(&chart, "index-basic-d");
    let figure = &drawing.page.figure;
    assert!(told(&drawing).contains("the bars of the chart touch one another"), "{}", told(&drawing));
    let points = |line: &Line| line.runs.iter().map(|run| run.points.len()).sum::<usize>();
    assert!(figure.lines.iter().all(|line| points(line) > 2), "no scraps");
}

#[test]
fn squared_paper_is_no_chart() {
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 900 600'>\
                   <rect width='900' height='600' fill='#fff'/>"
        .to_owned();
    for i in 0..15 {
        write!(svg, "<path d='M{0} 100V520' stroke='#888'/>", 90 + 50 * i).expect("it is a string");
    }
    for i in 0..8 {
        write!(svg, "<path d='M90 {0}H790' stroke='#888'/>", 100 + 60 * i).expect("it is a string");
    }
    // two shapes whose area is to be found
    svg += "<path d='M140 160V460H390V340H240V160Z' fill='#ddd' stroke='#000' stroke-width='4'/>\
            <path d='M540 460H740V220Z' fill='#ddd' stroke='#000' stroke-width='4'/></svg>";
    for profile in ["swell-a4", "index-basic-d"] {
        let squared = Chart { svg: svg.clone(), tops: Vec::new() };
        let told = told(&converted(&squared, profile));
        assert!(!told.contains("bar"), "{profile}: {told}");
    }
}

#[test]
fn the_top_of_a_bar_on_a_gridline_is_its_own() {
    let mut chart = chart(4, 40.0, 0.5, true);
    // the second bar ends on a gridline, between higher ones
    let [own, grid] = [BASE - 400.0, BASE - 360.0];
    chart.svg =
        chart.svg.replace(&format!("y='{own}'"), &format!("y='{grid}'")).replace("height='400'", "height='360'");
    let drawing = converted(&chart, "swell-a4");
    let place = drawing.page.figure.place;
    let on_page =
        |x: f32, y: f32| place.min + MmPoint::new(x / WIDTH * place.width(), y / HEIGHT * place.height()).to_vector();
    let width_at = |at: MmPoint| {
        let runs = drawing.page.figure.lines.iter().flat_map(|line| &line.runs);
        let far = |run: &tactograph::marks::Run| {
            run.points.windows(2).map(|pair| nearest_on_segment(at, pair[0], pair[1]).0).fold(f32::INFINITY, f32::min)
        };
        runs.filter(|run| far(run) <= NEAR).map(|run| run.width).fold(0.0, f32::max)
    };
    let (x, _) = chart.tops[1];
    let (top, beside) = (width_at(on_page(x, grid)), width_at(on_page(x + 90.0, grid)));
    assert!(top > 1.4, "the top is as broad as the sides of its bar: {top}");
    assert!(beside > 0.0 && beside < 0.8, "the gridline beside it stays thin: {beside}");
    let overview = drawing.page.overview.as_ref().expect("there is room");
    let share = overview.place.width() / place.width();
    let at = |at: MmPoint| overview.place.min + (at - place.min) * share;
    assert!(far(at(on_page(800.0, BASE - 180.0)), &overview.lines, None) > NEAR, "it has no gridlines");
    assert!(told(&drawing).contains("gridlines, are not in the overview"), "{}", told(&drawing));
}

/// Pairs of bars whose second ends on a gridline, with a narrow gap to the next pair: a gridline is no bar between them.
#[test]
fn a_gridline_does_not_close_the_gap_beside_a_bar_that_ends_on_it() {
    let pair = |x: f32, high: f32, low: f32| {
        let bar = |x: f32, y: f32, fill: &str| {
            format!("<rect x='{x}' y='{y}' width='45' height='{}' fill='{fill}'/>", 420.0 - y)
        };
        bar(x, high, "#2b6cb0") + &bar(x + 45.0, low, "#dd8833")
    };
    let pairs = [(105.0, 240.0, 310.0), (220.0, 200.0, 280.0), (335.0, 150.0, 260.0), (450.0, 110.0, 230.0)];
    let drawn: String = pairs.into_iter().map(|(x, high, low)| pair(x, high, low)).collect();
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 700 500'><rect width='700' height='500' fill='#fff'/>\
         <path stroke='#ccc' d='M80 100H560M80 180H560M80 260H560M80 340H560'/>\
         <path d='M80 60V420H560' fill='none' stroke='#000' stroke-width='2'/>{drawn}</svg>"
    );
    let chart = Chart { svg, tops: Vec::new() };
    let drawing = converted(&chart, "swell-a4");
    let figure = &drawing.page.figure;
    let at = |x: f32, place: MmRect| {
        place.min + MmPoint::new(x / 700.0 * place.width(), 260.0 / 500.0 * place.height()).to_vector()
    };
    let broad = |line: &&Line| line.runs.iter().all(|run| run.width > 1.2);
    let strong: Vec<Line> = figure.lines.iter().filter(broad).cloned().collect();
    assert!(!told(&drawing).contains("touch one another"), "{}", told(&drawing));
    assert!(far(at(402.0, figure.place), &strong, None) < NEAR, "the top of the third low bar");
    assert!(far(at(437.0, figure.place), &strong, None) > NEAR, "the gap beside it");
    let overview = drawing.page.overview.as_ref().expect("there is room");
    // its middle is 1.5 mm from the sides of the bars
    assert!(far(at(437.0, overview.place), &overview.lines, None) > 1.0, "the gap in the overview");
}

/// Of two bars with a gap of half a millimetre both have all their sides.
#[test]
fn bars_of_a_pair_with_a_narrow_gap_touch() {
    let heights = [(180, 120), (240, 180), (300, 210), (120, 150), (390, 330)];
    let pair = |(k, (first, second)): (usize, (usize, usize))| {
        let bar = |x: usize, height: usize, fill: &str| {
            format!("<rect x='{x}' y='{}' width='40' height='{height}' fill='{fill}'/>", 500 - height)
        };
        bar(115 + 130 * k, first, "#3a76c4") + &bar(157 + 130 * k, second, "#e08a2a")
    };
    let drawn: String = heights.into_iter().enumerate().map(pair).collect();
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 560'><rect width='800' height='560' fill='#fff'/>\
         <path stroke='#ccc' d='M90 440H760M90 380H760M90 320H760M90 260H760M90 200H760M90 140H760M90 80H760'/>{drawn}\
         <path d='M90 60V500H760' fill='none' stroke='#000' stroke-width='3'/></svg>"
    );
    for profile in ["swell-a4", "index-basic-d"] {
        let drawing = converted(&Chart { svg: svg.clone(), tops: Vec::new() }, profile);
        let told = told(&drawing);
        assert!(told.contains("the bars of the chart touch one another"), "{profile}: {told}");
        assert!(!told.contains("tick"), "pieces of gridlines are no ticks: {told}");
        let figure = &drawing.page.figure;
        for (k, (first, second)) in heights.into_iter().enumerate() {
            // the quarters of each top, the side between the two, and the outer side of the second
            let x = (115 + 130 * k) as f32;
            let [first, second] = [first, second].map(|height| height as f32);
            let tops =
                [10.0, 30.0].map(|at| (x + at, first)).into_iter().chain([52.0, 72.0].map(|at| (x + at, second)));
            let sides = [(x + 41.0, 0.7 * first.min(second)), (x + 82.0, 0.7 * second)];
            for (x, up) in tops.chain(sides) {
                let (x, y) = (x / 800.0 * figure.place.width(), (500.0 - up) / 560.0 * figure.place.height());
                let far = far(figure.place.min + MmPoint::new(x, y).to_vector(), &figure.lines, None);
                assert!(far < 2.2, "{profile}: {far} mm at {x}, {y}");
            }
        }
    }
}

/// Where no shape is large enough for the overview, gridlines are none either.
#[test]
fn an_overview_without_shapes_does_not_become_one_of_gridlines() {
    let squares: String =
        (0..8).map(|i| format!("M{} {}h8v8h-8z", 430 + 100 * (i % 2), 60 + 90 * (i / 2))).collect::<String>();
    let drawing = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 400'><path stroke='#e0e0e0' d='M60 30H360M60 90H360M60 \
         150H360M60 210H360M60 270H360'/><path stroke='#000' stroke-width='3' fill='none' d='{squares}'/></svg>"
    );
    let options = Options::new(Profile::named("swell-a4").expect("it is built in"));
    let drawing = tactograph::convert(drawing.as_bytes(), &options).expect("it can be converted");
    let long = |lines: &[tactograph::marks::Line]| lines.iter().filter(|line| line.length() > 30.0).count();
    assert_eq!(long(&drawing.page.figure.lines), 5, "the gridlines");
    assert_eq!(drawing.page.overview.as_ref().map_or(0, |overview| long(&overview.lines)), 0);
}

/// As of a histogram: the ticks were parts of the sides of bars, or these were in their way.
#[test]
fn ticks_in_line_with_the_sides_of_bars_are_as_long_as_others() {
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}'>\
         <rect width='{WIDTH}' height='{HEIGHT}' fill='#fff'/><g fill='none' stroke='#000' stroke-width='3'>"
    );
    for (k, height) in [60, 150, 320, 430, 280, 120, 70].into_iter().enumerate() {
        let x = 130 + 90 * k;
        write!(svg, "<path d='M{x} {BASE}V{}h90V{BASE}Z' fill='#8bf'/>", BASE - height as f32).expect("it is a string");
    }
    write!(svg, "<path d='M90 {BASE}H860'/>").expect("it is a string");
    let ticks = (0..8).map(|k| 130.0 + 90.0 * k as f32);
    for x in ticks.clone() {
        write!(svg, "<path d='M{x} {BASE}v10'/>").expect("it is a string");
    }
    let drawing = converted(&Chart { svg: svg + "</g></svg>", tops: Vec::new() }, "swell-a4");
    let (place, lines) = (drawing.page.figure.place, &drawing.page.figure.lines);
    for x in ticks {
        let foot = MmPoint::new(x / WIDTH * place.width(), BASE / HEIGHT * place.height());
        let below = place.min + foot.to_vector() + MmPoint::new(0.0, 7.0).to_vector();
        assert!(far(below, lines, None) < NEAR, "{x}: {}", told(&drawing));
    }
}

/// Bars of an overview that touched were a wall of bricks if they are stacks: which part is of which bar?
#[test]
fn stacked_bars_stay_apart_in_the_overview() {
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} 640'>\
         <rect width='{WIDTH}' height='640' fill='#fff'/>\
         <path d='M90 40V540H860' fill='none' stroke='#000' stroke-width='3'/>"
    );
    let parts = [[190.0, 170.0, 120.0], [96.0, 240.0, 144.0], [260.0, 110.0, 110.0], [120.0, 150.0, 210.0]];
    for (k, parts) in parts.iter().enumerate() {
        let mut y = 540.0;
        for (height, fill) in parts.iter().zip(["#3b6fb6", "#e8c23a", "#c0392b"]) {
            y -= height;
            let x = 140 + 160 * k;
            write!(svg, "<rect x='{x}' y='{y}' width='110' height='{height}' fill='{fill}'/>").expect("it is a string");
        }
    }
    svg += "</svg>";
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("page.orientation", "landscape").expect("it lies so");
    let drawing = tactograph::convert(svg.as_bytes(), &Options::new(profile)).expect("a page");
    let told = told(&drawing);
    assert!(!told.contains("in the overview the bars of the chart"), "{told}");
    let overview = drawing.page.overview.as_ref().expect("it has one");
    assert!(loose_ends(&overview.lines) <= 3, "the ends of the axes: {}", loose_ends(&overview.lines));
    let place = overview.place;
    let at =
        |x: f32, y: f32| place.min + MmPoint::new(x / WIDTH * place.width(), y / 640.0 * place.height()).to_vector();
    for (k, parts) in parts.iter().enumerate() {
        let (middle, top) = (195.0 + 160.0 * k as f32, 540.0 - parts.iter().sum::<f32>());
        assert!(far(at(middle, top), &overview.lines, None) < NEAR, "the top of bar {k}");
        assert!(k == 3 || far(at(middle + 80.0, 500.0), &overview.lines, None) > 1.0, "the gap behind bar {k}");
    }
}
