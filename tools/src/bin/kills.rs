//! Is nothing lost when the program is killed? See `tools/src/killing.rs`.
//!
//! ```text
//! cargo build --release && cargo run --release -p tactograph-tools --bin kills       1000 runs killed (15 minutes)
//!   --runs N           so many killed; those that had ended before do not count
//!   --seed N           other moments (default 1)
//!   --program PATH     the program to kill (default target/release/tactograph)
//! ```
#![allow(clippy::print_stdout, reason = "this is a program")]

use std::path::PathBuf;

use tactograph_tools::killing::{Tally, kill};
use tactograph_tools::words::Words;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (mut runs, mut seed, mut program) = (1000, 1, PathBuf::from("target/release/tactograph"));
    let mut words = Words::of_program("tools/src/bin/kills.rs");
    while let Some(word) = words.next() {
        match word.as_str() {
            "--runs" => runs = words.whole_number(&word)?,
            "--seed" => seed = words.number(&word)?,
            "--program" => program = words.value(&word)?.into(),
            _ => return Err(words.unknown(&word).into()),
        }
    }
    let program = std::path::absolute(program)?;
    let Tally { killed, ended, left_over, old, new } = kill(&program, runs, seed)?;
    println!(
        "{killed} runs killed, {ended} had ended before; {left_over} left a temporary file, gone after the next run"
    );
    println!("files that stood: {old} as before, {new} new, none half");
    Ok(())
}
