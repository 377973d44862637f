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
