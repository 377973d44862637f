//! Do the tests notice a fault? Small faults are drawn at random from the sources of the stages, all of them are
//! compiled into one copy of the project, and the tests are run with one on at a time.
//!
//! ```text
//! cargo run --release --manifest-path tools/mutants/Cargo.toml -- FOLDER      in a copy of the project in FOLDER
//!   --count N          so many faults (default 300); the compiler refuses some
//!   --seed N           others (default 1)
//! ```
//!
//! What noticed each fault is in `FOLDER/results.tsv`, a table at the end of the output. A run that was stopped goes on
//! where it was; for other sources or another seed take another folder.

mod places;
#[expect(dead_code, reason = "the same random numbers as all measuring programs have")]
#[path = "../../src/rng.rs"]
mod rng;
mod runs;
mod scratch;

use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (mut folder, mut count, mut seed) = (None, 300, 1);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value"));
        match word.as_str() {
            "--count" => count = value()?.parse()?,
            "--seed" => seed = value()?.parse()?,
            _ if folder.is_none() && !word.starts_with('-') => folder = Some(PathBuf::from(word)),
            _ => return Err(format!("{word}: see the head of tools/mutants/src/main.rs").into()),
        }
    }
    let folder = std::path::absolute(folder.ok_or("which folder? see the head of tools/mutants/src/main.rs")?)?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize()?;
    let mutants = scratch::make(&root, &folder, count, seed)?;
    println!("{} faults", mutants.len());
    let list: String = mutants.iter().map(|mutant| format!("{}\t{}\n", mutant.number, mutant.told())).collect();
    std::fs::write(folder.join("mutants.tsv"), list)?;
    runs::run(&folder, &mutants)?;
    print!("{}", runs::table(&folder)?);
    Ok(())
}
