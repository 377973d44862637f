//! A page that somebody changed in an editor, judged, described and rendered for a pin display:
//! `cargo run --example edited -- page.svg page`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use tactograph::{DotFormat, Embossing, PageOptions, Profile, RenderOptions};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [page, name] = &args[..] else { return Err("give a page (SVG) and a name for the files of its dots".into()) };
    let svg = std::fs::read(page)?;
    println!("{}", tactograph::describe(&svg, &PageOptions::new())?);
    for finding in tactograph::check(&svg, &PageOptions::new())?.findings {
        println!("{finding}");
    }
    let drawing = tactograph::render(&svg, &RenderOptions::new().profile(Profile::named("dot-pad")?))?;
    drawing.notes.iter().for_each(|note| eprintln!("{note}"));
    // the overview is a sheet of its own
    let sheets = drawing.into_pages();
    let title = sheets[0].title.clone();
    for (i, dots) in tactograph::write_dots(&title, &sheets, DotFormat::Txt, Embossing::default())?.iter().enumerate() {
        std::fs::write(format!("{name}-{}.txt", i + 1), dots)?;
    }
    Ok(())
}
