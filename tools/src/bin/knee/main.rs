//! Run time against error on the page: at which working resolution does a finger notice nothing any more?
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin knee    writes docs/speed/knee.csv and knee.svg, and the table of
//!                          --quality in docs/speed.md (nine minutes on two cores)
//!   --rounds N             how often each setting is timed (default 5)
//!   --profile NAME         another profile than swell-a4: then tables are printed and nothing is written
//!   --draw DIR             writes the pictures and the page of each, too
//! ```
//!
//! **Settings**: working resolution (px for a millimetre of the page), edge scale (mm), and at which fraction of its size a
//! JPEG is decoded before it is averaged to the working size ("as needed" is what the program does: the smallest that is not
//! below the working size). Where that is given, the program gets pixels, and so does not know that it was a JPEG: such
//! rows are to be compared with one another.
//!
//! **Pictures** (`pictures.rs`, `tools/src/camera_scene.rs`): drawn scenes of 9 to 12 megapixels whose outlines, steps and colours are known, with
//! the blur and the grain of a camera; the photo-like picture of `bench_all` with 12 megapixels; samples.
//!
//! **Errors** (`compare.rs`): scenes are held against what was drawn, all others against the page of the highest resolution at
//! the same scale, where the page has its figure. Lengths are in mm on the page:
//!
//! * *rms*, *p95*: distance from each line to the nearest true one and back, of places that have one within 1 mm, which is
//!   about what a fingertip tells apart; *missing*, *extra*: the share of the length that has none.
//! * *strength*: Spearman's rank correlation of the strength of lines with the true one, place by place.
//! * *class*: the share of the area that is sorted into another class; of scenes, further than 2 mm from a true border.
//! * *read*: the share of places that a fingertip of 1.0 mm reads as they are; see `tactograph::internals::touch`.
//!
//! The curves are not smooth: a working picture has whole pixels, so its sides are rounded, and which edges fall together
//! with the borders of its pixels differs from one resolution to the next. Each side has a scale of its own
//! (`tactograph::internals::units::PageTransform`), so the rounding moves no line.
//!
//! **Time**: working time (CPU) of one thread, on which everything runs as in the program on one core
//! (`pipeline::convert`), from the file's bytes to the page's SVG; without the start of a process. Settings run in
//! turn, round after round, every second round in reverse; figures are medians.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

mod clock;
mod compare;
mod dotted;
mod pictures;
mod plot;
mod qualities;
mod rows;
mod run;
mod sweep;

use std::path::{Path, PathBuf};

use rayon::ThreadPoolBuilder;
use tactograph_tools::marks;
use tactograph_tools::words::Words;

/// What is measured if no profile is named, and what the pages of the docs are about.
const PROFILE: &str = "swell-a4";

/// What is asked for.
struct Args {
    rounds: usize,
    profile: String,
    draw: Option<PathBuf>,
}

fn main() -> Result<(), String> {
    let mut args = Args { rounds: 5, profile: PROFILE.into(), draw: None };
    let mut words = Words::of_program("tools/src/bin/knee/main.rs");
    while let Some(word) = words.next() {
        match word.as_str() {
            "--rounds" => args.rounds = words.whole_number(&word)?,
            "--profile" => args.profile = words.value(&word)?,
            "--draw" => args.draw = Some(words.value(&word)?.into()),
            _ => return Err(words.unknown(&word)),
        }
    }
    // what other threads do would not be counted
    let alone = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    alone.map_err(|fault| fault.to_string())?;
    std::env::set_current_dir(tactograph_tools::ROOT).map_err(|fault| fault.to_string())?;
    // now, as what is changed from here on is not measured
    let made = marks::made();
    let profile = rows::profile(&args.profile, &[])?;
    let pictures = pictures::all(Path::new("target/knee"))?;
    if profile.dots.device.is_some() {
        return dotted::table(&args.profile, &pictures, args.rounds);
    }
    let rows = sweep::sweep(&args.profile, &pictures, args.rounds, args.draw.as_deref())?;
    print!("{}", rows::table(&rows));
    if args.profile != PROFILE {
        return Ok(());
    }
    let folder = Path::new("docs/speed");
    let told = |fault: std::io::Error| format!("{}: {fault}", folder.display());
    std::fs::create_dir_all(folder).map_err(told)?;
    std::fs::write(folder.join("knee.csv"), rows::csv(&rows)).map_err(told)?;
    std::fs::write(folder.join("knee.svg"), plot::plot(&rows)).map_err(told)?;
    marks::write(qualities::PAGE, qualities::MARK, &qualities::table(&rows, &made))
}
