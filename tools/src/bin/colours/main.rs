//! How colours are sorted, to look at:
//!
//! ```text
//! cargo run -p tactograph-tools --bin colours -- chart                        writes docs/colours/classes.svg
//! cargo run -p tactograph-tools --bin colours -- map PICTURE OUT.png [KEY=VALUE...]
//! ```
//!
//! `chart` draws the classes over hue, saturation and value. `map` draws a picture in its five classes, as `convert` sorts
//! it for the page, with the settings given: six pixels a cell, darker where the texture would be bolder, white where there is
//! none; fringes are hatched.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod chart;
mod map;

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match &words[..] {
        ["chart"] => {
            let folder = Path::new(tactograph_tools::ROOT).join("docs/colours");
            std::fs::create_dir_all(&folder)?;
            std::fs::write(folder.join("classes.svg"), chart::draw()?)?;
            Ok(())
        }
        ["map", picture, out, settings @ ..] => map::draw(picture, out, settings),
        _ => Err("give chart, or map PICTURE OUT.png".into()),
    }
}
