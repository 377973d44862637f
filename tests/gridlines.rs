//! Shapes on squared paper: the grid gives way to them, however much longer its lines are together.

use std::fmt::Write;

use tactograph::internals::geom::nearest_on_segment;
use tactograph::marks::{Line, Run};
use tactograph::{MmPoint, Options, Profile};

const SIDE: f32 = 600.0;
/// A line is at a place if it is so near, mm.
const NEAR: f32 = 1.6;

/// Squared paper of so many squares a side, in pixels, and the corners of the triangle on it.
fn triangle(squares: usize) -> (String, [(f32, f32); 3]) {
    let step = SIDE / squares as f32;
    let mut svg = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {SIDE} {SIDE}'>");
    svg += "<rect width='100%' height='100%' fill='#fff'/><g stroke='#b8c4d0'>";
    for i in 0..=squares {
        let at = i as f32 * step;
        write!(svg, "<path d='M{at} 0V{SIDE}'/><path d='M0 {at}H{SIDE}'/>").expect("it is a string");
    }
    let at = |column: usize, row: usize| (column as f32 * step, row as f32 * step);
    let corners = [at(4, squares - 4), at(squares - 4, squares - 4), at(5, 4)];
    let path: String = corners.iter().map(|(x, y)| format!("{x} {y} ")).collect();
    svg += &format!("</g><polygon points='{path}' fill='none' stroke='#111' stroke-width='3'/></svg>");
    (svg, corners)
}

/// The greatest width of the lines at a place; 0 if none is there.
fn width_at(at: MmPoint, lines: &[Line]) -> f32 {
    let is_near = |run: &&Run| {
        let back = run.points.last().zip(run.points.first()).filter(|_| run.closed);
        let sides = run.points.windows(2).map(|pair| (pair[0], pair[1])).chain(back.map(|(a, b)| (*a, *b)));
        sides.map(|(a, b)| nearest_on_segment(at, a, b).0).fold(f32::INFINITY, f32::min) <= NEAR
    };
    lines.iter().flat_map(|line| &line.runs).filter(is_near).map(|run| run.width).fold(0.0, f32::max)
}

#[test]
fn a_triangle_on_squared_paper_is_whole_and_stands_out() {
    for squares in [12, 16, 24] {
        let (svg, corners) = triangle(squares);
        let profile = Profile::named("swell-a4").expect("it is built in");
        let drawing = tactograph::convert(svg.as_bytes(), &Options::new(profile)).expect("a page");
        let figure = &drawing.page.figure;
        let on_page =
            |(x, y): (f32, f32)| figure.place.min + MmPoint::new(x, y).to_vector() * figure.place.width() / SIDE;
        let grid = width_at(on_page((0.5 * SIDE, SIDE / squares as f32)), &figure.lines);
        for k in 0..3 {
            let [a, b] = [corners[k], corners[(k + 1) % 3]].map(on_page);
            for share in 1..20 {
                let width = width_at(a.lerp(b, share as f32 / 20.0), &figure.lines);
                assert!(
                    width > 1.3 * grid,
                    "{squares} squares, side {k} at {share}/20: {width} mm, the grid {grid} mm"
                );
            }
        }
        let (_, base) = corners[0];
        let beside = width_at(on_page((SIDE - 1.5 * SIDE / squares as f32, base)), &figure.lines);
        assert!(beside <= 1.01 * grid, "{squares} squares: the gridline beside the base is {beside} mm broad");
        let overview = drawing.page.overview.as_ref().expect("there is room");
        let rings = overview.lines.iter().filter(|line| line.runs.iter().all(|run| run.closed));
        assert_eq!((overview.lines.len(), rings.count()), (1, 1), "{squares} squares: the triangle and nothing else");
    }
}

#[test]
fn on_an_embosser_the_grid_goes_and_the_triangle_stays() {
    for squares in [12, 16, 24] {
        let (svg, corners) = triangle(squares);
        let profile = Profile::named("index-basic-d").expect("it is built in");
        let drawing = tactograph::convert(svg.as_bytes(), &Options::new(profile)).expect("a page");
        let figure = &drawing.page.figure;
        let on_page =
            |(x, y): (f32, f32)| figure.place.min + MmPoint::new(x, y).to_vector() * figure.place.width() / SIDE;
        for k in 0..3 {
            let [a, b] = [corners[k], corners[(k + 1) % 3]].map(on_page);
            let drawn = (1..20).filter(|share| width_at(a.lerp(b, *share as f32 / 20.0), &figure.lines) > 0.0).count();
            assert_eq!(drawn, 19, "{squares} squares, side {k}");
        }
        let told: String = drawing.notes.iter().map(|note| format!("{note}\n")).collect();
        assert!(told.contains("the squared grid"), "{squares} squares: {told}");
    }
}

/// Points of a scatter plot of 800 by 600 pixels with a squared grid, and without texts.
const POINTS: [(f32, f32); 22] = [
    (253.2, 353.5),
    (205.1, 388.4),
    (152.5, 506.2),
    (588.5, 146.0),
    (567.5, 202.4),
    (277.4, 322.6),
    (215.6, 385.0),
    (663.9, 139.8),
    (605.4, 164.4),
    (227.9, 470.4),
    (297.1, 409.1),
    (620.7, 229.8),
    (635.8, 125.0),
    (512.0, 213.1),
    (413.5, 276.7),
    (166.1, 393.1),
    (668.2, 120.7),
    (291.4, 404.4),
    (652.9, 240.7),
    (616.7, 221.5),
    (415.0, 344.4),
    (369.0, 293.2),
];

#[test]
fn a_grid_that_points_would_tear_is_left_out_as_a_whole() {
    let (upright, level) = ([212.0, 344.0, 476.0, 608.0, 740.0], [428.0, 336.0, 244.0, 152.0, 60.0]);
    let mut svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 600'>".to_owned();
    svg += "<rect width='800' height='600' fill='#fff'/>";
    for (x, y) in upright.into_iter().zip(level) {
        write!(svg, "<path stroke='#ddd' d='M{x} 520V40M80 {y}H760'/>").expect("it is a string");
        write!(svg, "<path stroke='#000' stroke-width='2' d='M{x} 520V528M72 {y}H80'/>").expect("it is a string");
    }
    svg += "<path d='M80 520H760M80 520V40' stroke='#000' stroke-width='3'/>";
    for (x, y) in POINTS {
        write!(svg, "<circle cx='{x}' cy='{y}' r='6' fill='#14a'/>").expect("it is a string");
    }
    svg += "</svg>";
    let profile = Profile::named("index-basic-d").expect("it is built in");
    let drawing = tactograph::convert(svg.as_bytes(), &Options::new(profile)).expect("a page");
    let figure = &drawing.page.figure;
    let mm = figure.place.width() / 800.0;
    let on_page = |(x, y): (f32, f32)| figure.place.min + MmPoint::new(x, y).to_vector() * mm;
    // places on gridlines that are off the axes and all points
    let of_grid = upright.iter().flat_map(|&x| (8..48).map(move |k| (x, 10.0 * k as f32)));
    let of_grid = of_grid.chain(level.iter().flat_map(|&y| (12..74).map(move |k| (10.0 * k as f32, y))));
    let is_clear = |at: &(f32, f32)| POINTS.iter().all(|of| (on_page(*of) - on_page(*at)).length() > 3.0 * NEAR + 2.0);
    let places: Vec<MmPoint> = of_grid.filter(is_clear).map(on_page).collect();
    let drawn = places.iter().filter(|at| width_at(**at, &figure.lines) > 0.0).count();
    assert!(places.len() > 300 && drawn == 0, "{drawn} of {} places of the grid", places.len());
    let axis = (12..74).filter(|k| width_at(on_page((10.0 * *k as f32, 520.0)), &figure.lines) > 0.0).count();
    assert_eq!(axis, 62, "the axis is whole");
    let told: String = drawing.notes.iter().map(|note| format!("{note}\n")).collect();
    assert!(told.contains("the squared grid"), "{told}");
}
