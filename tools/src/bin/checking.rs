//! How long a check takes, and how far its distances lie from those of a search of all pairs in f64: the figures of
//! docs/checking.md.
//!
//! ```text
//! cargo run -p tactograph-tools --bin checking
//! ```

#![allow(clippy::print_stdout, reason = "this is a program")]

use std::time::Instant;

use tactograph::internals::legibility::{check, too_near};
use tactograph::internals::page::{Class, Figure, Glyph, Line, Page, Parts, Run, Shape, Sign, Texture};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::units::{MmPoint, MmRect, MmVector, Size};
use tactograph_tools::rng::Rng;

/// Times of which the least counts.
const ROUNDS: usize = 15;
/// Random pages that are held against the search, and lines on each.
const PAGES: u64 = 200;
const LINES: usize = 30;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let plan = Plan::new(&Profile::named("swell-a4")?)?;
    println!("| contours | their points | glyphs | sheet | findings | time |\n|---|---|---|---|---|---|");
    for (contours, glyphs, sheet) in [
        (75, 1500, [148.0, 210.0]),
        (150, 3000, [148.0, 210.0]),
        (300, 6000, [210.0, 297.0]),
        (600, 12_000, [297.0, 420.0]),
    ] {
        let page = page(contours, glyphs, sheet)?;
        let points: usize = page.figure.lines.iter().flat_map(|line| &line.runs).map(|run| run.points.len()).sum();
        let once = || {
            let start = Instant::now();
            std::hint::black_box(check(&page, &plan.limits(), None));
            start.elapsed().as_secs_f64() * 1e3
        };
        let least = (0..ROUNDS).map(|_| once()).fold(f64::MAX, f64::min);
        let [width, height] = sheet;
        let found = check(&page, &plan.limits(), None).findings.len();
        println!("| {contours} | {points} | {glyphs} | {width} x {height} mm | {found} | {least:.1} ms |");
    }
    let (pairs, worst) = exactness();
    println!("\n{PAGES} random pages, {pairs} pairs of lines that are too near: at most {worst:.5} mm off.");
    Ok(())
}

/// Wavy contours in rows, with glyphs between them.
fn page(contours: usize, glyphs: usize, sheet: [f32; 2]) -> Result<Page, tactograph::Error> {
    let [width, height] = sheet.map(|side| side - 20.0);
    let columns = (contours as f32 * 0.5 * width / height).sqrt().ceil().max(1.0);
    let rows = (contours as f32 / columns).ceil();
    let (across, down) = (width / columns, height / rows);
    let line = |number: usize| {
        let (column, row) = (number % columns as usize, number / columns as usize);
        let at = |k: usize| {
            let share = k as f32 / 60.0;
            let x = 10.0 + column as f32 * across + 3.0 + share * (across - 6.0);
            MmPoint::new(x, 10.0 + (row as f32 + 0.5) * down + 0.2 * down * (12.0 * share + number as f32).sin())
        };
        Line { strength: 20.0, runs: vec![Run::stroke(1.2, (0..=60).map(at).collect())] }
    };
    // as many glyphs as are asked for, in rows
    let step = (width * height / glyphs as f32).sqrt();
    let in_row = (width / step) as usize;
    let glyph = |number: usize| {
        let at = MmPoint::new((number % in_row) as f32, (number / in_row) as f32) * step + MmVector::new(11.5, 11.5);
        Glyph { at, shape: Shape::Rhombus { length: 2.2, thickness: 1.2, degrees: 45.0 } }
    };
    let texture = Texture {
        class: Class::Green,
        sign: Sign::Rhombus { degrees: 45.0 },
        colour: [0, 128, 0],
        area: width * height,
        glyphs: (0..glyphs).map(glyph).collect(),
    };
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(10.0 + width, 10.0 + height));
    let lines = (0..contours).map(line).collect();
    Page::new(Parts::of(sheet, Figure { place, source: Size::new(100, 100), textures: vec![texture], lines }))
}

/// How many pairs of straight lines on random pages are too near, and how far the distance of any of them is off.
fn exactness() -> (usize, f64) {
    const LEAST: f64 = 3.2;
    let (mut pairs, mut worst) = (0, 0.0_f64);
    for seed in 0..PAGES {
        let mut rng = Rng::new(seed);
        let mut point =
            || MmPoint::new(rng.between_f32(0.0, 1.0) * 190.0 + 10.0, rng.between_f32(0.0, 1.0) * 277.0 + 10.0);
        let lines: Vec<Line> =
            (0..LINES).map(|_| Line { strength: 20.0, runs: vec![Run::stroke(1.0, vec![point(), point()])] }).collect();
        let found = too_near(&lines, LEAST as f32);
        for (i, a) in lines.iter().enumerate() {
            for (j, b) in lines[..i].iter().enumerate() {
                let blank = distance(ends(a), ends(b)) - 1.0;
                // lines that touch join, and beside a join other rules count
                if blank > 0.01 && blank < LEAST - 0.02 {
                    let near = found.iter().filter(|near| near.lines == (i, j) || near.lines == (j, i));
                    let least = near.map(|near| f64::from(near.gap)).fold(f64::MAX, f64::min);
                    (pairs, worst) = (pairs + 1, worst.max((least - blank).abs()));
                }
            }
        }
    }
    (pairs, worst)
}

type Point = (f64, f64);

fn ends(line: &Line) -> (Point, Point) {
    let [a, b] = [0, 1].map(|k| line.runs[0].points[k]).map(|at| (f64::from(at.x), f64::from(at.y)));
    (a, b)
}

fn distance((a, b): (Point, Point), (c, d): (Point, Point)) -> f64 {
    let side = |p: Point, q: Point, r: Point| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let to = |p: Point, a: Point, b: Point| {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let share = (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        (a.0 + share * dx - p.0).hypot(a.1 + share * dy - p.1)
    };
    [to(a, c, d), to(b, c, d), to(c, a, b), to(d, a, b)].into_iter().fold(f64::MAX, f64::min)
}
