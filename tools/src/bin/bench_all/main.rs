//! How fast the whole program is, beside others that do a part of its work, on pictures that are made here.
//!
//! ```text
//! tools/src/bin/bench_all/peers.sh                              once: installs the others and what writes the pictures
//! cargo run --release -p tactograph-tools --bin bench_all                  all tables, as Markdown (some eighteen minutes)
//!   --quick            three rounds, nothing of 50 MP, no vtracer, fewer photographs in one call, and who has worked 2 s in all
//!                      does not run again (two minutes)
//!   --runs N           rounds in which each program runs once; 9 if not said
//!   --only PART        only work with this in its name, such as "12 mp png", "one core: 12 mp png", "kinds", "other work", "throughput", "skipped", "growth"
//!   --write            also writes the tables into docs/speed.md, a short one at its head, and a few rows into README.md; not
//!                      where a program is missing, or djpeg took more than a tenth longer in one table than in the other, as then
//!                      something else kept the machine busy
//!   --program FILE     another program than the one built here, such as one with other settings
//! ```
//!
//! **How it is measured.** Everything is a process of its own, from its start to its end, and the pictures are in the
//! system's cache. All programs for one picture run in turn, round after round, every second round in reverse, after one
//! round to warm up. Figures are medians over the rounds; a ratio is the median of the ratios within each round, so that
//! whatever else the machine does falls on both sides. Working time (CPU) is shown beside the clock: it feels others' load
//! less. Who has worked 15 s in all does not run again, but for calls with many photographs. Memory is the most that was held (peak resident set).
//!
//! The pictures (`photo.rs`) lie under target/bench/inputs and are made once. `measured.rs` runs one program once,
//! `rounds.rs` several in turn, `targets.rs` holds what is promised, `stages.rs` looks into our own stages (`plot.rs` draws
//! them), `work.rs` at drawings, PDF and pages, `browser.rs` at the library as WebAssembly, `throughput.rs` at many photographs in
//! one call (`at_once.rs`: at their memory). `written.rs` puts the tables into the pages unless `refused.rs` has a reason not to,
//! `readme.rs` chooses the rows of README.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

mod args;
mod at_once;
mod browser;
mod floor;
mod inputs;
mod measured;
mod numbers;
mod ours;
mod peers;
mod plot;
mod readme;
mod refused;
mod rounds;
mod stages;
mod table;
mod targets;
mod throughput;
mod usage;
mod work;
mod written;

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use tactograph_tools::marks;
use tactograph_tools::words::Words;

use args::Args;
use inputs::Inputs;
use ours::Ours;
use peers::Peers;
use table::Table;
use targets::Bench;

fn main() -> ExitCode {
    let mut words = std::env::args_os().skip(1);
    match words.next() {
        Some(word) if word == measured::MODE => return measured::report(words),
        Some(word) if word == floor::MODE => return told(decode(words.next().as_deref().map(Path::new))),
        Some(word) if word == at_once::MODE => return told(several(words)),
        _ => {}
    }
    told(measure())
}

fn told(result: Result<(), String>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::FAILURE
        }
    }
}

fn decode(picture: Option<&Path>) -> Result<(), String> {
    let picture = picture.ok_or("no picture was named")?;
    floor::decode(picture).map_err(|fault| format!("{}: {fault}", picture.display()))
}

fn several(mut words: impl Iterator<Item = OsString>) -> Result<(), String> {
    let count = words.next().and_then(|word| word.to_str()?.parse().ok()).ok_or("how many at once?")?;
    at_once::convert(Path::new(&words.next().ok_or("no picture was named")?), count)
}

fn measure() -> Result<(), String> {
    let args = Args::read(Words::of_program("tools/src/bin/bench_all/main.rs"))?;
    std::env::set_current_dir(tactograph_tools::ROOT).map_err(|fault| fault.to_string())?;
    // target/release/bench_all
    let this = std::env::current_exe().map_err(|fault| fault.to_string())?;
    let profile = this.parent().ok_or("this program lies in no build folder")?;
    let target = profile.parent().ok_or("this program lies in no build folder")?;
    // now, as what is changed from here on is not measured
    let made = marks::made();
    let ours = Ours::build(target, profile, args.program.clone())?;
    let inputs = Inputs::make(target, args.quick)?;
    let peers = Peers::find(target);
    for program in &peers.missing {
        eprintln!("{program} is not installed: its rows are left out; run tools/src/bin/bench_all/peers.sh");
    }
    if args.write {
        refused::missing(&peers.missing)?;
    }
    let bench = Bench { args: &args, ours: &ours, peers: &peers, inputs: &inputs, target };

    let beside = targets::measure(&bench, false);
    let one_core = targets::measure(&bench, true);
    let mut tables = Vec::new();
    for (title, about, rows) in [("Beside others", BESIDE, &beside), ("The same with one core", ONE_CORE, &one_core)] {
        if !rows.is_empty() {
            tables.push(told_of(targets::long_table(title, about, rows)));
        }
    }
    if args.write {
        refused::check([&beside, &one_core])?;
    }
    let alone: [(&str, Measure); 5] = [
        ("kinds", stages::kinds),
        ("other work", work::others),
        ("throughput", throughput::throughput),
        ("skipped", stages::skips),
        ("growth", stages::growth),
    ];
    for (name, table) in alone {
        if args.wants(name) {
            eprintln!("{name}");
            tables.push(told_of(table(&bench)));
        }
    }
    if args.write {
        written::write(&targets::short_table(&beside), &tables, &args, &made)?;
    }
    Ok(())
}

/// A table, once it is printed.
fn told_of(table: Table) -> Table {
    print!("{}", table.text());
    table
}

/// What makes a table of our own program alone.
type Measure = fn(&Bench<'_>) -> Table;

const BESIDE: &str = "Whole processes, medians. *Ratio* is ours to theirs by the clock, and of working time (CPU); where \
                      nothing stands beside, *value* is what the row names. *More for PDF* is the median of the \
                      differences within each round, not the difference of the medians.";
const ONE_CORE: &str = "Every process is kept to one core of the machine.";
