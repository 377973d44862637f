//! How long a check takes, how far its distances lie from those of a search of all pairs in f64, and whether pages of random
//! pictures pass: the figures of docs/checking.md.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin checking
//! ```

#![allow(clippy::print_stdout, reason = "this is a program")]

use std::time::Instant;

use tactograph::internals::legibility::{check, too_near};
use tactograph::internals::page::{Line, Page, Run};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::units::MmPoint;
use tactograph_tools::rng::Rng;
use tactograph_tools::{blanks, full_page, scenes};

/// Times of which the least counts.
const ROUNDS: usize = 15;
/// Random pages that are held against the search, and lines on each.
const PAGES: u64 = 200;
const LINES: usize = 30;
/// Blank between lines that is asked for there, mm.
const LEAST: f32 = 3.2;
/// Random pictures whose pages are checked.
const SCENES: u64 = 200;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let plan = Plan::new(&Profile::named("swell-a4")?)?;
    println!("| contours | their points | glyphs | sheet | findings | time |\n|---|---|---|---|---|---|");
    for (_, contours, glyphs, sheet) in full_page::SIZES {
        let page = full_page::page(contours, glyphs, sheet)?;
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
    let rules: [(&str, Blanks); 2] =
        [("texture-gap", blanks::textures_beside_waves), ("braille-gap", blanks::braille_beside_waves)];
    for (rule, pages) in rules {
        let (told, worst) = exactness_of(rule, pages, &plan)?;
        println!("{PAGES} random pages, {told} places of {rule}: at most {worst:.5} mm off.");
    }
    let (told, worst) = exactness_of_returns();
    println!("{told} lines that come back to themselves: told at most {worst:.3} mm too far apart.");
    for (what, picture) in [("scenes and noise", Picture::Scene), ("crowded drawings", Picture::Drawing)] {
        let (pages, errors) = own_pages(picture)?;
        println!("\n{pages} pages of {SCENES} random {what}: {} errors.", errors.len());
        errors.iter().for_each(|error| println!("{error}"));
    }
    Ok(())
}

/// A kind of random pictures.
#[derive(Clone, Copy)]
enum Picture {
    Scene,
    Drawing,
}

/// The errors of pages of the program itself.
fn own_pages(of: Picture) -> Result<(usize, Vec<String>), Box<dyn std::error::Error>> {
    let (mut count, mut errors) = (0, Vec::new());
    for seed in 0..SCENES {
        let name = scenes::PROFILES[seed as usize % scenes::PROFILES.len()];
        let profile = Profile::named(name)?;
        let limits = Plan::new(&profile)?.limits();
        let options = tactograph::Options::new(profile);
        let drawing = match of {
            Picture::Scene => {
                let pixels = scenes::picture(seed, 240);
                tactograph::convert(tactograph::Picture::rgba8(240, 240, &pixels)?, &options)?
            }
            Picture::Drawing => {
                tactograph::convert(scenes::drawing(seed, 12 + 3 * (seed as usize % 10)).as_bytes(), &options)?
            }
        };
        for page in std::iter::once(&drawing.page).chain(&drawing.overview) {
            count += 1;
            let found = check(page, &limits, None).findings;
            let found = found.iter().filter(|finding| finding.is_error());
            errors.extend(found.map(|error| format!("seed {seed}, {name}: {error}")));
        }
    }
    Ok((count, errors))
}

/// How many pairs of straight lines on random pages are too near, each looked at by itself, and how far the distance of
/// any of them is off.
fn exactness() -> (usize, f64) {
    let (mut pairs, mut worst) = (0, 0.0_f64);
    for seed in 0..PAGES {
        let mut rng = Rng::new(seed);
        let mut point =
            || MmPoint::new(rng.between_f32(0.0, 1.0) * 190.0 + 10.0, rng.between_f32(0.0, 1.0) * 277.0 + 10.0);
        let lines: Vec<Line> =
            (0..LINES).map(|_| Line { strength: 20.0, runs: vec![Run::stroke(1.0, vec![point(), point()])] }).collect();
        for (i, a) in lines.iter().enumerate() {
            for b in &lines[..i] {
                let blank = blanks::least(&blanks::strokes(a), &blanks::strokes(b));
                // lines that touch join, and beside a join other rules count
                if blank > 0.01 && blank < f64::from(LEAST) - 0.02 {
                    // by themselves: where a third line joins both, the three may meet
                    let near = too_near(&[a.clone(), b.clone()], LEAST).into_iter();
                    let least = near.map(|near| f64::from(near.gap)).fold(f64::MAX, f64::min);
                    (pairs, worst) = (pairs + 1, worst.max((least - blank).abs()));
                }
            }
        }
    }
    (pairs, worst)
}

/// Random pages, each with the blanks that are known of it.
type Blanks = fn(u64) -> Result<(Page, Vec<f64>), tactograph::Error>;

/// How many blanks are told by a rule, and how far any of them is off.
fn exactness_of(rule: &str, page: Blanks, plan: &Plan) -> Result<(usize, f64), tactograph::Error> {
    let (mut told, mut worst) = (0, 0.0_f64);
    for seed in 0..PAGES {
        let (page, known) = page(seed)?;
        let (count, off) = blanks::off(&check(&page, &plan.limits(), None), rule, known);
        (told, worst) = (told + count, worst.max(off));
    }
    Ok((told, worst))
}

/// How many lines come back to themselves, and how much too far apart any of them is told.
fn exactness_of_returns() -> (usize, f64) {
    let lines = (0..PAGES).map(blanks::there_and_back);
    // strokes that touch join, and what is just short of the limit may be missed
    let looked_at: Vec<(Line, f64)> =
        lines.filter(|(_, blank)| (0.01..f64::from(LEAST) - 0.15).contains(blank)).collect();
    let off = |(line, blank): &(Line, f64)| {
        let near = too_near(std::slice::from_ref(line), LEAST);
        near.into_iter().map(|near| f64::from(near.gap)).fold(f64::MAX, f64::min) - blank
    };
    (looked_at.len(), looked_at.iter().map(off).fold(0.0, f64::max))
}
