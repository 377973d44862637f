//! How far BrailleRAP's needle travels over sets of dots: our order beside others and beside a bound that no order is
//! below.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin travel -- [FILE.gcode ...]
//! ```
//!
//! Prints a table in Markdown. Lengths in mm from the needle's zero over all dots until an A4 sheet (A3 for the last
//! set) is out. *Free* may pull the paper back any way, *12 mm* and *2 mm* no farther than that; *nearest* goes to
//! the nearest dot; *rows* is row by row, to and fro, and *rows of 2 mm* the same in bands of that height, which are
//! what DesktopBrailleRAP does by default and as its first choice beyond. *Over* is how far *free* and *12 mm* lie
//! over the bound. Minutes are what the machine takes with the default speeds and the magnet's time, milliseconds
//! what finding the order takes.
#![allow(clippy::print_stdout, reason = "this is a program")]

use std::error::Error;
use std::time::Instant;

use tactograph::internals::output::dots::gcode::{self, Params};
use tactograph::internals::output::dots::path_order::{self, DotPosition};
use tactograph::internals::units::MmPoint;
use tactograph_tools::travel::{bound, machine, orders, sets};

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| set | dots | free | 12 mm | 2 mm | nearest | nearest, 12 mm | rows of 2 mm | rows | bound | over | over, 12 mm | minutes, free | minutes, 12 mm | ms, free | ms, 12 mm |"
    );
    println!("|---|{}", "--:|".repeat(15));
    for (name, dots) in sets::all() {
        row(name, &dots, &Params::a4())?;
    }
    row("random, many", &sets::large(), &machine::xl_a3())?;
    for file in std::env::args().skip(1) {
        let params = machine::xl_a3();
        let dots = machine::run(&std::fs::read_to_string(&file)?, params.limits.map(|mm| (mm * 100.0) as i32), 0)?.dots;
        row(&file, &dots, &params)?;
    }
    Ok(())
}

fn row(name: &str, dots: &[DotPosition], params: &Params) -> Result<(), Box<dyn Error>> {
    let paper = (params.paper_length * 100.0) as i32;
    let ends = [[0, 0], [0, paper + 2_000]];
    let mm = |path: &[DotPosition]| orders::length(path, ends) / 100.0;
    let timed = |most_back: i32| {
        let start = Instant::now();
        let path = path_order::order(dots, ends, most_back);
        (mm(&path), path.len(), start.elapsed().as_secs_f64() * 1e3)
    };
    let (free, count, free_ms) = timed(i32::MAX);
    let (bounded, _, bounded_ms) = timed(1_200);
    let bound = bound::lower_bound(dots, ends) / 100.0;
    let points: Vec<MmPoint> = dots.iter().map(|&[x, y]| MmPoint::new(x as f32 / 100.0, y as f32 / 100.0)).collect();
    let limits = params.limits.map(|mm| (mm * 100.0) as i32);
    let minutes = |most_back: f32| -> Result<f64, Box<dyn Error>> {
        let gcode = gcode::write(&points, &Params { most_back, ..params.clone() })?;
        Ok(machine::run(&gcode, limits, paper)?.seconds / 60.0)
    };
    println!(
        "| {name} | {count} | {free:.0} | {bounded:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {bound:.0} | {:.1} % | {:.1} % | {:.1} | {:.1} | {free_ms:.0} | {bounded_ms:.0} |",
        timed(200).0,
        mm(&orders::nearest_neighbour(dots, ends[0], i32::MAX)),
        mm(&orders::nearest_neighbour(dots, ends[0], 1_200)),
        mm(&orders::row_by_row(dots, 200)),
        mm(&orders::row_by_row(dots, 1)),
        100.0 * (free / bound - 1.0),
        100.0 * (bounded / bound - 1.0),
        minutes(f32::INFINITY)?,
        minutes(12.0)?,
    );
    Ok(())
}
