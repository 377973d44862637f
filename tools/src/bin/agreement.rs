//! `agreement A.svg B.svg`: how far the marks of two pages of one picture agree that were made on different machines:
//! `N marks, K of them differ, by at most D mm`. Ends with 1 if they are not the same marks within [`MOST`].
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use std::process::ExitCode;

use tactograph_tools::agreement::{Agreement, compare};

/// How far a mark may be from the same mark of the other page, mm: pages have two digits after the point, and the last
/// one may be rounded the other way.
const MOST: f64 = 0.0101;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [a, b] = &words[..] else {
        eprintln!("give two pages");
        return ExitCode::from(2);
    };
    let found = read(a).and_then(|a| read(b).map(|b| (a, b))).and_then(|(a, b)| compare(&a, &b));
    match found {
        Ok(Agreement { marks, different, most }) => {
            println!("{marks} marks, {different} of them differ, by at most {most:.2} mm");
            ExitCode::from(u8::from(most > MOST))
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn read(path: &str) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))
}
