//! Lines for fingers, on pictures that nobody has looked at: noise, spirals, stars and scenes thrown together. And less
//! detail is a part of more.

use crate::common::{apart, drawn, page, samples};
use proptest::prelude::*;
use tactograph::internals::edges::{self, Edgel, Edges};
use tactograph::internals::lines::{self, Line};
use tactograph::internals::raster::Raster;
use tactograph::internals::units::{MmPoint, MmRect, PageTransform, PxPoint, PxVector, Size};
use tactograph::{Note, Options, Picture, Profile, Tracing};

const SIDE: u32 = 300;
/// Millimetres for a pixel.
const SCALE: f32 = 0.4;

const EDGES: edges::Params = edges::Params {
    sigma: 1.2,
    low: 5.0,
    high: 10.0,
    min_length: 5.0,
    min_length_of_drawing: 5.0,
    strength_window: 3.0,
    suppression: 0.0, // all that noise has to offer
    side_cell: 2.5,
    side_offset: 5.5,
    widest_stroke: 11.75, // two lines of 1.5 mm and a gap of 3.2 mm, at SCALE
    dark_lines: None,
};

const LINES: lines::Params = lines::Params { detail: 1.0, ..drawn::LINES };

fn draw(value: impl Fn(f32, f32) -> f32, params: &lines::Params) -> Vec<Line> {
    let size = Size::new(SIDE, SIDE);
    let values = (0..SIDE * SIDE).map(|i| value((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5).clamp(0.0, 1.0));
    let raster = Raster::grey(size, values.map(|v| v.powf(2.2)).collect());
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(SIDE as f32 * SCALE, SIDE as f32 * SCALE));
    lines::draw(&edges::find(&raster, &EDGES), &PageTransform::new(size, area), area, params).lines
}

/// Checks that a scene with at least `least` mm of lines keeps them apart.
fn assert_apart(scene: &str, least: f32, lines: &[Line], params: &lines::Params) {
    let length: f32 = lines.iter().map(Line::length).sum();
    assert!(length >= least, "{scene} has {length} mm of lines only, which says little");
    let near = apart::too_near(lines, params.min_gap, apart::APPROACH_OF_DRAWINGS);
    assert!(near.is_empty(), "{scene}: {} places are too near, such as {:?}", near.len(), near.first());
    for (number, line) in lines.iter().enumerate() {
        let is_whole = line.length() >= 0.97 * params.min_length
            || apart::is_disc(line)
            || apart::leads_from_line_to_line(lines, number);
        assert!(is_whole, "{scene}: a remnant of {} mm", line.length());
    }
}

/// A number in 0..1 for two whole ones and a seed.
fn hash(x: i32, y: i32, seed: u32) -> f32 {
    let mut h =
        (x as u32).wrapping_mul(0x9E37_79B1) ^ (y as u32).wrapping_mul(0x85EB_CA77) ^ seed.wrapping_mul(0xC2B2_AE3D);
    h = (h ^ (h >> 15)).wrapping_mul(0x2C1B_3C6D);
    h = (h ^ (h >> 12)).wrapping_mul(0x297A_2D39);
    ((h ^ (h >> 15)) >> 8) as f32 / (1 << 24) as f32
}

/// Smooth noise with features of about `cell` pixels, 0..1.
fn noise(x: f32, y: f32, cell: f32, seed: u32) -> f32 {
    let (x, y) = (x / cell, y / cell);
    let (i, j) = (x.floor(), y.floor());
    let ease = |t: f32| t * t * (3.0 - 2.0 * t);
    let (u, v) = (ease(x - i), ease(y - j));
    let at = |di: i32, dj: i32| hash(i as i32 + di, j as i32 + dj, seed);
    (at(0, 0) * (1.0 - u) + at(1, 0) * u) * (1.0 - v) + (at(0, 1) * (1.0 - u) + at(1, 1) * u) * v
}

/// The same in steps of equal brightness, each soft by about a pixel: contours everywhere, whatever size its features have.
fn levels(x: f32, y: f32, cell: f32, seed: u32) -> f32 {
    const LEVELS: f32 = 5.0;
    let value = LEVELS * noise(x, y, cell, seed);
    let soft = 0.5 * LEVELS / cell; // by how much of a level the noise rises in a pixel
    (value.floor() + ((value.fract() - 0.5) / soft + 0.5).clamp(0.0, 1.0)) / LEVELS
}

/// Distance from the middle and angle round it.
fn polar(x: f32, y: f32) -> (f32, f32) {
    ((x - 150.3).hypot(y - 149.6), (y - 149.6).atan2(x - 150.3))
}

#[test]
fn lines_keep_apart_on_noise() {
    for seed in 0..4 {
        for cell in [3.0, 6.0, 10.0, 18.0, 40.0] {
            let check = |name: &str, value: &dyn Fn(f32, f32) -> f32| {
                assert_apart(&format!("{name} of {cell} px, seed {seed}"), 500.0, &draw(value, &LINES), &LINES);
            };
            if cell <= 10.0 {
                // wider noise is too smooth for an edge
                check("noise", &|x, y| noise(x, y, cell, seed));
            }
            check("levels", &|x, y| levels(x, y, cell, seed));
            check("blots", &|x, y| (0.5 + 8.0 * (noise(x, y, cell, seed) - 0.5)).clamp(0.1, 0.9));
        }
    }
}

#[test]
fn lines_keep_apart_on_spirals_rings_and_stars() {
    let wave = |phase: f32| 0.5 + (2.0 * phase.sin()).clamp(-0.4, 0.4);
    for pitch in [4.0, 6.0, 9.0, 13.0, 20.0_f32] {
        let turn = std::f32::consts::TAU / pitch;
        let scene = |name: &str, value: &dyn Fn(f32, f32) -> f32| {
            assert_apart(&format!("{name}, {pitch} px"), 150.0, &draw(value, &LINES), &LINES);
        };
        scene("rings", &|x, y| wave(polar(x, y).0 * turn));
        scene("a spiral", &|x, y| wave(polar(x, y).0 * turn - polar(x, y).1));
        scene("a star", &|x, y| wave(polar(x, y).1 * pitch.floor()));
        if pitch > 4.0 {
            // narrower ones are a blur, in which there is no edge
            scene("hairpins", &|x, y| wave((x + 12.0 * (y * 0.1).sin()) * turn * (y / 300.0 + 0.5)));
        }
    }
}

#[test]
fn lines_keep_apart_at_other_gaps() {
    for (min_gap, width_max) in [(1.5, 1.0), (3.2, 3.0), (6.0, 2.0)] {
        let params = lines::Params { min_gap, width_max, join_gap: 0.9 * min_gap, ..LINES };
        let check = |value: &dyn Fn(f32, f32) -> f32| {
            assert_apart(&format!("a gap of {min_gap}"), 150.0, &draw(value, &params), &params);
        };
        for seed in 10..14 {
            check(&|x, y| noise(x, y, 8.0, seed));
            check(&|x, y| levels(x, y, 14.0, seed));
            check(&scene(seed));
        }
    }
}

/// Shapes thrown on one another: discs, rings, boxes, strokes and wedges, soft by a pixel.
fn scene(seed: u32) -> impl Fn(f32, f32) -> f32 {
    let number = |shape: i32, which: i32| hash(shape, which, 1000 + seed);
    let shapes: Vec<[f32; 7]> = (0..14).map(|shape| std::array::from_fn(|which| number(shape, which as i32))).collect();
    move |x, y| {
        let mut value = 0.9;
        for [kind, cx, cy, angle, long, wide, shade] in &shapes {
            let (sin, cos) = (std::f32::consts::TAU * angle).sin_cos();
            let (dx, dy) = (x - 300.0 * cx, y - 300.0 * cy);
            let (u, v) = (dx * cos + dy * sin, dy * cos - dx * sin);
            let (long, wide) = (15.0 + 90.0 * long, 1.0 + 14.0 * wide * wide);
            let outside = match (kind * 5.0) as u32 {
                0 => u.hypot(v * (1.0 + wide / 8.0)) - 0.6 * long,
                1 => (u.hypot(v) - 0.5 * long).abs() - 0.3 * wide,
                2 => (u.abs() - 0.7 * long).max(v.abs() - 2.5 * wide),
                3 => (u.abs() - long).max((v - 10.0 * (u / 25.0).sin()).abs() - 0.4 * wide),
                _ => (v.abs() - 0.35 * u).max(u - long),
            };
            let inside = (0.5 - outside).clamp(0.0, 1.0);
            value += (0.05 + 0.85 * shade - value) * inside;
        }
        value
    }
}

#[test]
fn lines_keep_apart_on_fifty_scenes() {
    for seed in 0..50 {
        assert_apart(&format!("scene {seed}"), 100.0, &draw(scene(seed), &LINES), &LINES);
    }
}

#[test]
fn less_detail_is_a_part_of_more() {
    for path in samples::samples() {
        let bytes = std::fs::read(&path).expect("a sample can be read");
        let pages = ["0", "0.25", "0.5", "0.75", "1"]
            .map(|detail| page::page_of(&bytes, "sample", &[("lines.detail", detail)], &mut |_| ()).page);
        for pair in pages.windows(2) {
            let parts = |page: &tactograph::Page| {
                let overview = page.overview.iter().flat_map(|overview| overview.lines.clone()).collect();
                [page.figure.lines.clone(), overview]
            };
            let (less, more): ([Vec<Line>; 2], [Vec<Line>; 2]) = (parts(&pair[0]), parts(&pair[1]));
            // the lines that say most come first
            assert!(less[0].len() <= more[0].len());
            assert_eq!(less[0][..], more[0][..less[0].len()], "{}", path.display());
            // the overview has none that the figure lacks
            let mut of_more = more[1].iter();
            assert!(less[1].iter().all(|line| of_more.any(|other| other == line)), "{}: overview", path.display());
        }
        let [first, .., last] = &pages;
        assert_eq!(first.figure.lines.is_empty(), last.figure.lines.is_empty(), "{}: nothing is left", path.display());
    }
}

#[test]
fn long_strong_closed_and_smooth_lines_come_first() {
    let params = lines::Params { detail: 0.0, ..LINES };
    // a large dark disc, a small one, a long faint edge
    let picture = |x: f32, y: f32| {
        let disc = |cx: f32, cy: f32, r: f32| (0.5 + r - (x - cx).hypot(y - cy)).clamp(0.0, 1.0);
        let ring = disc(100.0, 100.0, 70.0);
        let small = disc(230.0, 60.0, 9.0);
        let faint = (0.5 + x - 200.0 - 0.2 * y).clamp(0.0, 1.0) * 0.15 * f32::from(y > 150.0);
        0.85 - 0.7 * ring.max(small) - faint
    };
    let least = draw(picture, &params);
    assert_eq!(least.len(), 1, "{least:?}");
    assert!(least[0].runs[0].closed && least[0].length() > 150.0, "not the large ring: {:?}", least[0]);
    assert_eq!(draw(picture, &LINES).len(), 3);
}

#[test]
fn an_end_that_points_at_a_line_meets_it() {
    // a dark upper half, and below it two greys side by side: their border stops short of the upper half's
    for blur in [0.7, 1.5] {
        let step = |d: f32| 1.0 / (1.0 + (-1.7 * d / blur).exp());
        let lines = draw(|x, y| 0.08 + step(y - 120.0) * (0.45 + 0.4 * step(x - 150.0)), &LINES);
        assert_eq!(lines.len(), 2, "{lines:?}");
        let points = |line: &Line| line.runs.iter().flat_map(|run| run.points.clone()).collect::<Vec<_>>();
        let (through, stem) = (points(&lines[0]), points(&lines[1]));
        let tips = [stem[0], stem[stem.len() - 1]];
        let meets = |tip: &MmPoint| through.iter().any(|p| (*p - *tip).length() < 1e-3);
        assert!(tips.iter().any(meets), "blur {blur}: the stem ends at {tips:?}");
    }
}

#[test]
fn a_pupil_in_an_eye_stays_a_ring() {
    // an outline of an eye, and the pupil off its middle: 2.7 mm from it on one side, edge to edge
    let lines = draw(
        |x, y| {
            let ellipse = |cx: f32, cy: f32, a: f32, b: f32| ((x - cx) / a).hypot((y - cy) / b);
            let white = ((1.0 - ellipse(150.0, 150.0, 40.0, 30.0)) * 30.0 + 0.5).clamp(0.0, 1.0);
            let pupil = ((1.0 - ellipse(164.0, 150.0, 14.0, 16.0)) * 14.0 + 0.5).clamp(0.0, 1.0);
            (0.5 + 0.4 * white) * (1.0 - pupil) + 0.05 * pupil
        },
        &LINES,
    );
    assert_eq!(lines.len(), 2, "{lines:?}");
    let closed = |line: &Line| {
        line.runs[0].closed || line.runs[0].points.first() == line.runs[line.runs.len() - 1].points.last()
    };
    assert!(lines.iter().all(closed), "an eye or its pupil is open");
}

/// A chain of edgels, a pixel apart, that begins somewhere and turns this much a pixel, for so many pixels each.
fn chain() -> impl Strategy<Value = (Vec<Edgel>, bool)> {
    let place = 20.0..280.0_f32;
    let arcs = prop::collection::vec((-0.3..0.3_f32, 2..40_u32), 1..7);
    let values = (place.clone(), place, 0.0..std::f32::consts::TAU, arcs, 8.0..60.0_f32, any::<bool>());
    values.prop_map(|(x, y, mut heading, arcs, strength, closed)| {
        let mut at = PxPoint::new(x, y);
        let mut edgels = Vec::new();
        for (turn, count) in arcs {
            for _ in 0..count {
                heading += turn;
                at += PxVector::new(heading.cos(), heading.sin());
                edgels.push(Edgel { at, strength, contrast: [strength, 0.0, 0.0] });
            }
        }
        (edgels, closed)
    })
}

proptest! {
    /// Contours that no picture would have: of any shape, across one another and themselves, and beyond the page.
    #[test]
    fn whatever_the_contours_lines_keep_apart(chains in prop::collection::vec(chain(), 1..9)) {
        let size = Size::new(SIDE, SIDE);
        let mut edges = Edges::none(size);
        chains.into_iter().for_each(|(edgels, closed)| edges.push(edgels.into_iter(), closed));
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(SIDE as f32 * SCALE, SIDE as f32 * SCALE));
        let lines = lines::draw(&edges, &PageTransform::new(size, area), area, &LINES).lines;
        let near = apart::too_near(&lines, LINES.min_gap, apart::APPROACH);
        prop_assert!(near.is_empty(), "{} places are too near, such as {:?}", near.len(), near.first());
    }
}

#[test]
fn shapes_that_touch_are_not_lost_one_after_another() {
    let ellipses = [(420, 185, 26, 32), (420, 315, 26, 32), (355, 250, 32, 26), (485, 250, 32, 26)];
    let petals: String =
        ellipses.iter().map(|(x, y, rx, ry)| format!("<ellipse cx='{x}' cy='{y}' rx='{rx}' ry='{ry}'/>")).collect();
    let flower = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='840' height='592'><g fill='#d02020' stroke='#000' \
         stroke-width='3'><circle cx='420' cy='250' r='34' fill='#f0d020'/>{petals}</g></svg>"
    );
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("overview", "false").expect("a key");
    for width in (120..=184).step_by(8) {
        let options = Options::new(profile.clone()).width_mm(width as f32);
        let drawing = tactograph::convert(flower.as_bytes(), &options).expect("a page");
        let lost = drawing.notes.iter().find_map(|note| match note {
            Note::LinesLeftOut { percent, .. } | Note::TooDense { percent, .. } => Some(*percent),
            _ => None,
        });
        assert!(lost.unwrap_or(0) <= 30, "{width} mm wide: {lost:?} percent are left out");
    }
}

/// Rules of 0.5 mm, so many side by side on a figure of 120 mm.
#[test]
fn a_drawing_too_dense_for_its_size_is_told_with_what_to_do() {
    let note = |count: u32, profile: &str| {
        let rules: String =
            (0..count).map(|i| format!("<rect x='{}' y='20' width='4' height='552'/>", 20 + i * 800 / count)).collect();
        let ruled = format!("<svg xmlns='http://www.w3.org/2000/svg' width='840' height='592'>{rules}</svg>");
        let options = Options::new(Profile::named(profile).expect("it is built in")).width_mm(120.0);
        let drawing = tactograph::convert(ruled.as_bytes(), &options).expect("a page");
        drawing.notes.iter().find(|note| matches!(note, Note::TooDense { .. })).map(ToString::to_string)
    };
    let told = note(64, "swell-a4").expect("it is too dense");
    assert!(told.starts_with("the drawing is too dense for a figure of 120 mm: "), "{told}");
    let remedies = "spread it over several sheets, or draw only a part of it, so that it is larger";
    assert!(told.contains(remedies), "{told}");
    let told = note(64, "index-basic-d").expect("it is too dense");
    assert!(told.contains(remedies), "{told}");
    assert_eq!(note(16, "swell-a4"), None);
}

#[test]
fn a_stroke_ends_where_the_picture_ends() {
    let (width, height) = (600, 400);
    let is_bar = |i: usize| (196..204).contains(&(i / width));
    let pixels: Vec<u8> =
        (0..width * height).flat_map(|i| if is_bar(i) { [30, 30, 30, 255] } else { [255; 4] }).collect();
    let options = Options::new(Profile::named("swell-a4").expect("it is built in"));
    let picture = Picture::rgba8(width as u32, height as u32, &pixels).expect("a picture");
    let trace = tactograph::trace(picture, &Tracing::contours(), &options).expect("a trace").trace;
    let mut points = trace.polylines.iter().flat_map(|line| &line.points);
    assert!(trace.polylines.len() == 1 && points.all(|at| (-0.5..=600.5).contains(&at.x)), "{trace:?}");
}

/// Two atoms and the bond between them; the dark one has a thin outline, and the bond goes on under both.
#[test]
fn a_bond_of_a_dark_atom_with_a_thin_outline_is_in_figure_and_overview() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='600'>\
        <line x1='220' y1='300' x2='220' y2='170' stroke='#888' stroke-width='12'/>\
        <circle cx='220' cy='300' r='50' fill='#333' stroke='#000'/>\
        <circle cx='220' cy='170' r='32' fill='#fff' stroke='#000' stroke-width='2'/></svg>";
    for profile in ["swell-a4", "index-basic-d"] {
        let options = Options::new(Profile::named(profile).expect("it is built in"));
        let drawing = tactograph::convert(svg.as_bytes(), &options).expect("a page");
        assert_eq!(drawing.page.figure.lines.len(), 3, "{profile}: {:?}", drawing.notes);
        if let Some(overview) = &drawing.page.overview {
            assert_eq!(overview.lines.len(), 3, "{profile}: {:?}", drawing.notes);
        }
    }
}

#[test]
fn every_point_of_a_circle_is_drawn() {
    let points = [(400, 80), (609, 232), (529, 478), (271, 478), (191, 232)];
    let discs: String =
        points.iter().map(|(x, y)| format!("<circle cx='{x}' cy='{y}' r='9' fill='#1e88e5'/>")).collect();
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='600'>\
         <circle cx='400' cy='300' r='220' fill='none' stroke='#000' stroke-width='2'/>{discs}</svg>"
    );
    let options = Options::new(Profile::named("swell-a4").expect("it is built in"));
    let page = tactograph::convert(svg.as_bytes(), &options).expect("a page").page;
    let beads = page.figure.lines.iter().flat_map(|line| &line.runs).filter(|run| run.width > 3.0).count();
    assert_eq!(beads, points.len());
}

/// What is told of closed outlines that are open on the page of a drawing.
fn told_open(svg: &str, profile: &str) -> Vec<String> {
    let options = Options::new(Profile::named(profile).expect("it is built in"));
    let notes = tactograph::convert(svg.as_bytes(), &options).expect("a page").notes;
    notes.iter().map(ToString::to_string).filter(|note| note.contains("closed outline")).collect()
}

/// Its two long sides are nearer than lines may be, and one of them lacks a piece.
#[test]
fn a_narrow_box_that_is_open_on_dots_is_told_with_its_place() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 728 500'><rect width='728' height='500' \
        fill='#fff'/><g stroke='#000' stroke-width='3' fill='none'><rect x='30' y='20' width='300' height='16'/>\
        <rect x='400' y='156' width='80' height='24'/><rect x='550' y='308' width='140' height='32'/></g></svg>";
    let told = told_open(svg, "index-basic-d");
    assert!(told.len() == 1 && told[0].contains("a piece of 1 closed outline"), "{told:?}");
    // in the middle of the box, on a figure of 182 mm
    assert!(told[0].contains(" mm long, around 12"), "{told:?}");
}

/// The tip of the triangle is moved down from the beam; the box that stands on it has lost its base.
#[test]
fn a_triangle_that_is_closed_below_a_beam_is_not_said_to_be_open() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 420'><rect width='800' height='420' \
        fill='#fff'/><g stroke='#222' stroke-width='3'><path d='M80 220H720' stroke-width='6'/>\
        <path d='M500 226L450 330H550Z' fill='#bbb'/><rect x='600' y='130' width='90' height='87' fill='#a97'/></g>\
        </svg>";
    let told = told_open(svg, "swell-a4");
    assert!(told.len() == 1 && told[0].contains("a piece of 1 closed outline"), "{told:?}");
}
