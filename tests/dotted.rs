//! Pages of dots keep what their profiles promise, on every sample and every device: dots lie where the device presses them,
//! lines are one dot wide and hold together, and empty dots lie between what fingers must tell apart.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use crate::common::{page, samples};
use tactograph::Page;
use tactograph::internals::devices::{DotArea, Grid};
use tactograph::internals::output::dots::{DotMatrix, dots};
use tactograph::internals::page::{Height, Line, Medium, Pen, Run};
use tactograph::internals::profile::{Profile, built_in};
use tactograph::internals::units::MmPoint;

type Cell = [i32; 2];

/// All pages of all samples with all profiles of dots: the figures and the overviews.
fn pages() -> &'static [(String, Profile, &'static Page)] {
    static PAGES: OnceLock<Vec<(String, Profile, &'static Page)>> = OnceLock::new();
    PAGES.get_or_init(made)
}

fn made() -> Vec<(String, Profile, &'static Page)> {
    let mut pages = Vec::new();
    for file in built_in() {
        let profile = Profile::named(file.name).expect("it is built in");
        if profile.dots.device.is_none() {
            continue;
        }
        for sample in samples::names() {
            let drawing = page::of_sample(&sample, file.name);
            let name = format!("{sample} with {}", file.name);
            pages.push((format!("{name}, overview"), profile.clone(), drawing.overview.as_ref()));
            pages.push((name, profile.clone(), Some(&drawing.page)));
        }
    }
    pages.into_iter().filter_map(|(name, profile, page)| Some((name, profile, page?))).collect()
}

fn area(page: &Page) -> &DotArea {
    match &page.medium {
        Medium::Dots(dots) => &dots.area,
        other => panic!("{other:?} is not of dots"),
    }
}

fn grid(page: &Page) -> Option<&Grid> {
    match area(page) {
        DotArea::Grid(grid) => Some(grid),
        DotArea::Free(_) => None,
    }
}

/// The column and row of a dot, which must lie on one.
fn cell(at: MmPoint, grid: &Grid, name: &str) -> Cell {
    [(at.x, &grid.columns), (at.y, &grid.rows)].map(|(mm, centres)| {
        let index = centres.iter().position(|centre| (centre - mm).abs() < 1e-3);
        index.unwrap_or_else(|| panic!("{name}: {at:?} is off the grid")) as i32
    })
}

fn apart(a: Cell, b: Cell) -> i32 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

fn cells(run: &Run, grid: &Grid, name: &str) -> Vec<Cell> {
    run.points.iter().map(|&at| cell(at, grid, name)).collect()
}

/// All dots of a line.
fn cells_of(line: &Line, grid: &Grid, name: &str) -> Vec<Cell> {
    line.runs.iter().flat_map(|run| cells(run, grid, name)).collect()
}

#[test]
fn every_dot_is_one_that_the_device_presses_and_none_is_pressed_twice() {
    for (name, _, page) in pages() {
        let all = dots(page);
        match area(page) {
            DotArea::Grid(grid) => {
                let mut places = BTreeSet::new();
                for (at, height) in &all {
                    assert!(places.insert(cell(*at, grid, name)), "{name}: a dot is pressed twice, {at:?} {height:?}");
                }
                assert_eq!(DotMatrix::of(page).map(|matrix| matrix.count()), Some(all.len()), "{name}");
            }
            DotArea::Free(reach) => {
                let reach = reach.inflate(1e-3, 1e-3);
                assert!(all.iter().all(|(at, _)| reach.contains_inclusive(*at)), "{name}: a dot is out of reach");
            }
        }
    }
}

/// The sides of a sharp corner are taken over so many dots.
const SIDE: isize = 3;

/// Each dot is a neighbour of the next and, but for rings, of no other: no doubled corners, no clots, no gaps.
#[test]
fn lines_are_one_dot_wide_and_hold_together() {
    let mut lines = 0;
    for (name, _, page) in pages() {
        let Some(grid) = grid(page) else { continue };
        for line in &page.figure.lines {
            let way = cells(&line.runs[0], grid, name);
            assert!(way.windows(2).all(|pair| apart(pair[0], pair[1]) == 1), "{name}: a gap in {way:?}");
            let n = way.len();
            let clots = (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|&(i, j)| {
                let steps = if apart(way[0], way[n - 1]) <= 1 { (i - j).min(n - (i - j)) } else { i - j };
                steps == 2 && apart(way[i], way[j]) <= 1
            });
            // a right angle of the line has one
            let corners = |i: usize, j: usize| {
                let middle = (0..n).find(|&k| (k + 1 == i && j + 1 == k) || (i + 1) % n == k && (k + 1) % n == j);
                middle.is_some_and(|k| {
                    let [a, b, c] = [way[j], way[k], way[i]];
                    (a[0] == b[0] || a[1] == b[1]) && (b[0] == c[0] || b[1] == c[1])
                })
            };
            // so has the tip of a sharp one, from which its sides part
            let tips = |i: usize, j: usize| {
                let ring = apart(way[0], way[n - 1]) <= 1;
                let middle = if i - j == 2 { j + 1 } else { (i + 1) % n };
                let at = |step: isize| {
                    let index = middle as isize + step;
                    let index = if ring { index.rem_euclid(n as isize) } else { index };
                    usize::try_from(index).ok().and_then(|index| way.get(index).copied())
                };
                at(-SIDE).zip(at(SIDE)).is_some_and(|(back, on)| {
                    let to = |at: Cell| [at[0] - way[middle][0], at[1] - way[middle][1]];
                    let (back_step, on_step) = (to(back), to(on));
                    back_step[0] * on_step[0] + back_step[1] * on_step[1] > 0 && apart(back, on) >= 2
                })
            };
            for (i, j) in clots {
                assert!(corners(i, j) || tips(i, j), "{name}: a clot at {:?} and {:?} in {way:?}", way[i], way[j]);
            }
            lines += 1;
        }
    }
    assert!(lines > 1000, "only {lines} lines");
}

/// Between two lines there are empty dots, but beside an end of one of them that meets the other; and so there are
/// between two parts of a line that comes back to itself.
#[test]
fn empty_dots_lie_between_lines() {
    let mut ends_met = 0;
    for (name, profile, page) in pages() {
        let Some(grid) = grid(page) else { continue };
        let gap = profile.dots.line_gap as i32;
        let lines: Vec<Vec<Cell>> = page.figure.lines.iter().map(|line| cells(&line.runs[0], grid, name)).collect();
        let all: Vec<Vec<Cell>> = page.figure.lines.iter().map(|line| cells_of(line, grid, name)).collect();
        let (way_out, bend) = (2 * gap + 4, (4 * gap + 4) as usize);
        for (i, line) in lines.iter().enumerate() {
            for (number, other) in all[..i].iter().enumerate() {
                let nearest = |at: Cell| other.iter().map(|&dot| apart(at, dot)).min().unwrap_or(i32::MAX);
                for &cell in line.iter().filter(|cell| nearest(**cell) <= gap) {
                    let meets = |row: &[Cell], other: &[Cell]| {
                        let tips = [row.first(), row.last()].into_iter().flatten();
                        let met = |tip: Cell| other.iter().any(|&dot| apart(tip, dot) <= gap);
                        tips.copied().any(|tip| apart(tip, cell) <= way_out && met(tip))
                    };
                    let is_junction = meets(line, other) || meets(&lines[number], &all[i]);
                    assert!(is_junction, "{name}: {} empty dots between two lines at {cell:?}", nearest(cell) - 1);
                    ends_met += 1;
                }
            }
            let n = line.len();
            let is_ring = apart(line[0], line[n - 1]) <= 2;
            let arc = |i: usize, j: usize| if is_ring { (i - j).min(n - (i - j)) } else { i - j };
            let ends_near = |at: Cell| {
                let met = |tip: usize, at: usize| tip.abs_diff(at) > bend && apart(line[tip], line[at]) <= gap;
                [0, n - 1].into_iter().any(|tip| apart(line[tip], at) <= way_out && (0..n).any(|at| met(tip, at)))
            };
            for (i, &cell) in line.iter().enumerate() {
                let back = (0..i).find(|&j| arc(i, j) > bend && apart(cell, line[j]) <= gap);
                assert!(back.is_none() || ends_near(cell), "{name}: a line comes back to itself at {cell:?}: {line:?}");
            }
        }
    }
    assert!(ends_met > 1000, "only {ends_met} dots beside junctions");
}

#[test]
fn empty_dots_lie_between_lines_and_textures() {
    let mut glyphs = 0;
    for (name, profile, page) in pages() {
        let Some(grid) = grid(page) else { continue };
        // areas without room for the profile's gap keep one
        let gap = (profile.dots.texture_gap as i32).min(1);
        let lines: BTreeSet<Cell> = page.figure.lines.iter().flat_map(|line| cells_of(line, grid, name)).collect();
        for glyph in page.figure.textures.iter().flat_map(|texture| &texture.glyphs) {
            let [x, y] = cell(glyph.at, grid, name);
            let near = (-gap..=gap).flat_map(|dy| (-gap..=gap).map(move |dx| [x + dx, y + dy]));
            assert!(
                !near.clone().any(|near| lines.contains(&near)),
                "{name}: the texture's dot {x} {y} is too near to a line"
            );
            glyphs += 1;
        }
    }
    assert!(glyphs > 10_000, "only {glyphs} dots of textures");
}

/// Where dots can be anywhere they lie in even steps; where a line meets another a dot may be missing.
#[test]
fn dots_anywhere_lie_in_even_steps() {
    let mut steps = (0, 0);
    for (name, profile, page) in pages() {
        if grid(page).is_some() {
            continue;
        }
        for run in page.figure.lines.iter().filter(|line| line.runs.len() == 1).flat_map(|line| &line.runs) {
            for pair in run.points.windows(2) {
                let step = (pair[1] - pair[0]).length() / profile.dots.pitch;
                assert!(step > 0.74, "{name}: dots {step} pitches apart");
                steps = (steps.0 + 1, steps.1 + i32::from((0.8..1.15).contains(&step)));
            }
        }
    }
    assert!(steps.0 > 500 && steps.1 as f32 >= 0.97 * steps.0 as f32, "{steps:?}");
}

#[test]
fn heights_are_those_that_the_device_has() {
    for (name, profile, page) in pages() {
        let heights: BTreeSet<Height> = dots(page).into_iter().map(|(_, height)| height).collect();
        match profile.dots.device.map(|device| device.has_heights()) {
            Some(false) => assert!(heights.iter().all(|&height| height == Height::High), "{name}: {heights:?}"),
            _ => assert!(heights.len() <= 3, "{name}"),
        }
        let strokes = page.figure.lines.iter().flat_map(|line| &line.runs).filter(|run| run.pen == Pen::Stroke);
        assert_eq!(strokes.count(), 0, "{name}: a stroke on a page of dots");
    }
}

/// The frame lies around the picture, with empty dots between.
#[test]
fn frames_keep_off_the_picture() {
    for (name, profile, page) in pages() {
        assert_eq!(profile.frame.on, !page.frame.at.is_empty(), "{name}: a frame");
        let inner = page.figure.place.inflate(profile.dots.pitch, profile.dots.pitch);
        assert!(!page.frame.at.iter().any(|&at| inner.contains(at)), "{name}: the frame is too near to the picture");
        let picture = page.figure.place.inflate(1e-3, 1e-3);
        let marks = page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
        let marks =
            marks.copied().chain(page.figure.textures.iter().flat_map(|texture| &texture.glyphs).map(|glyph| glyph.at));
        for at in marks {
            assert!(picture.contains_inclusive(at), "{name}: {at:?} is off the picture");
        }
    }
}

/// The back of a page is on the same grid, with columns exchanged.
#[test]
fn a_mirrored_page_is_on_the_same_grid() {
    let page = &page::of_sample("coffee.png", "index-basic-d").page;
    let (front, back) =
        (DotMatrix::of(page).expect("a grid"), DotMatrix::of(&page.clone().mirrored()).expect("a grid"));
    for y in 0..front.rows() {
        let row = |matrix: &DotMatrix| matrix.row(y).to_vec();
        let reversed: Vec<u8> = row(&front).into_iter().rev().collect();
        assert_eq!(row(&back), reversed, "row {y}");
    }
}

/// The figure of a drawing of these elements, 400 by 300, in black.
fn drawn(elements: &str, name: &str) -> Page {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 300'><rect width='400' height='300' fill='#fff'/>\
         <g stroke='#000' stroke-width='2' fill='none'>{elements}</g></svg>"
    );
    let options = tactograph::Options::new(Profile::named(name).expect("it is built in"));
    let page = tactograph::convert(svg.as_bytes(), &options).expect("a page").page;
    let found = tactograph::check(page.to_svg(), &tactograph::PageOptions::new()).expect("a page").findings;
    assert!(found.is_empty(), "{name}: {found:?}");
    page
}

/// How far the nearest dot of a line is from a place of the drawing, in pitches.
fn to_dot(page: &Page, (x, y): (f32, f32), name: &str) -> f32 {
    let place = page.figure.place;
    let at = place.min + MmPoint::new(x, y).to_vector() * (place.width() / 400.0);
    let dots = page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points);
    let nearest = dots.map(|dot| (*dot - at).length()).fold(f32::MAX, f32::min);
    nearest / Profile::named(name).expect("it is built in").dots.pitch
}

/// Each place of a path has a dot near to it.
fn is_dotted_along(page: &Page, from: (f32, f32), to: (f32, f32), name: &str) {
    for step in 0..=80 {
        let share = step as f32 / 80.0;
        let at = (from.0 + (to.0 - from.0) * share, from.1 + (to.1 - from.1) * share);
        let off = to_dot(page, at, name);
        assert!(off < 1.2, "{name}: no dot within {off} steps of {at:?}");
    }
}

const GRIDS: [&str; 4] = ["index-basic-d", "viewplus-columbia", "dot-pad", "monarch"];

/// Two lines that cross steeply keep all their dots.
#[test]
fn a_crossing_has_no_gap() {
    for name in GRIDS {
        for [from, to] in [[(200.0, 60.0), (200.0, 250.0)], [(120.0, 60.0), (300.0, 250.0)]] {
            let path = format!("M60 150H340M{} {}L{} {}", from.0, from.1, to.0, to.1);
            let page = drawn(&format!("<path d='{path}'/>"), name);
            is_dotted_along(&page, (70.0, 150.0), (330.0, 150.0), name);
            is_dotted_along(&page, from, to, name);
        }
    }
}

/// A stem runs through between two leaves whose tips touch it.
#[test]
fn a_stem_runs_through_between_its_leaves() {
    let plant = "<path d='M200 20V280'/><path d='M200 200C170 140 110 140 80 150C100 190 150 220 200 200Z'/>\
                 <path d='M200 130C240 70 290 70 320 80C300 120 250 150 200 130Z'/>";
    for name in GRIDS {
        let page = drawn(plant, name);
        is_dotted_along(&page, (200.0, 25.0), (200.0, 275.0), name);
        let stem = page.figure.lines.iter().any(|line| line.runs[0].length() > 0.55 * page.figure.place.height());
        assert!(stem, "{name}: the stem is cut");
    }
}

/// Radii meet in the centre of their circle.
#[test]
fn radii_meet_in_the_centre() {
    for (count, from) in [(3, 0.4), (5, 0.6)] {
        let tips = (0..count).map(|k| (k as f32 * std::f32::consts::TAU / count as f32).sin_cos());
        let tips: Vec<(f32, f32)> = tips.map(|(sin, cos)| (200.0 + 120.0 * sin, 150.0 - 120.0 * cos)).collect();
        let radii: String = tips.iter().map(|(x, y)| format!("M200 150L{x:.2} {y:.2}")).collect();
        let page = drawn(&format!("<circle cx='200' cy='150' r='120'/><path d='{radii}'/>"), "index-basic-d");
        for (x, y) in tips {
            let inner = (200.0 + 0.06 * from * (x - 200.0), 150.0 + 0.06 * from * (y - 150.0));
            is_dotted_along(&page, inner, (0.5 * (200.0 + x), 0.5 * (150.0 + y)), "index-basic-d");
        }
    }
}

/// How many rows a line has is decided by the width of its stroke, for all of it.
#[test]
fn broad_strokes_have_two_rows_and_thin_ones_one() {
    let rows_near = |page: &Page, y: f32| {
        let place = page.figure.place;
        let height = place.min.y + y * place.width() / 400.0;
        let near = |line: &&Line| line.runs[0].points.iter().all(|at| (at.y - height).abs() < 12.0);
        let lines: Vec<&Line> = page.figure.lines.iter().filter(near).collect();
        assert!(!lines.is_empty(), "no line at {y}");
        lines.iter().map(|line| line.runs.len()).collect::<BTreeSet<usize>>()
    };
    let wave = |y: f32, width: f32, colour: &str| {
        format!("<path d='M20 {y}q45 -20 90 0t90 0t90 0t90 0' stroke-width='{width}' stroke='{colour}'/>")
    };
    let waves = [wave(60.0, 2.0, "#000"), wave(150.0, 8.0, "#555"), wave(240.0, 2.0, "#555")].concat();
    let ground = "<rect width='200' height='300' fill='#9cf' stroke='none'/>";
    let page = drawn(&format!("{ground}{waves}"), "index-basic-d");
    assert_eq!([60.0, 150.0, 240.0].map(|y| rows_near(&page, y)), [[1].into(), [2].into(), [1].into()]);
}

#[test]
fn a_cross_keeps_its_four_arms() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 300'><rect width='400' height='300' fill='#fff'/>\
               <path d='M100 150H300M200 120V250' stroke='#000' stroke-width='2' fill='none'/></svg>";
    for name in ["index-basic-d", "viewplus-columbia", "dot-pad", "braillerap"] {
        let options = tactograph::Options::new(Profile::named(name).expect("it is built in"));
        let page = tactograph::convert(svg.as_bytes(), &options).expect("a page").page;
        let place = page.figure.place;
        let dots: Vec<MmPoint> =
            page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.iter().copied()).collect();
        for (x, y) in [(150.0, 150.0), (250.0, 150.0), (200.0, 128.0), (200.0, 200.0)] {
            let at = place.min + MmPoint::new(x, y).to_vector() * (place.width() / 400.0);
            let nearest = dots.iter().map(|dot| (*dot - at).length()).fold(f32::MAX, f32::min);
            assert!(nearest < 5.0, "{name}: the arm at {x}, {y} is {nearest} mm away");
        }
        let found = tactograph::check(page.to_svg(), &tactograph::PageOptions::new()).expect("a page").findings;
        assert!(found.is_empty(), "{name}: {found:?}");
    }
}
