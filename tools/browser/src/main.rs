//! `tactograph-browser PICTURE PAGE.svg`: makes a page some times over and tells the median time as `alone N ms`. Built
//! for WebAssembly and run by `run.mjs` in Node.js, whose engine is that of Chromium.
#![allow(clippy::print_stderr, reason = "this is a program")]

use std::time::Instant;

use tactograph::{Options, Profile};

/// Pages that are made: engines translate code a second time, and better, once it has run for a while.
const ROUNDS: usize = 9;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1);
    let (Some(picture), Some(page)) = (words.next(), words.next()) else {
        return Err("name a picture and a page".into());
    };
    let picture = std::fs::read(picture)?;
    let options = Options::new(Profile::named("swell-a4")?);
    let mut times = Vec::new();
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let svg = tactograph::convert(&picture, &options)?.page.to_svg();
        times.push(start.elapsed());
        std::fs::write(&page, svg)?;
    }
    times.sort();
    eprintln!("alone {:.1} ms", times[ROUNDS / 2].as_secs_f64() * 1e3);
    Ok(())
}
