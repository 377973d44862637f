//! A page that somebody changed in an editor, judged, described and rendered for a pin display:
//! `cargo run --example edited -- page.svg page.txt`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use tactograph::{DotFormat, Profile, RenderOptions};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [page, text] = &args[..] else { return Err("give a page (SVG) and a name for the text of its dots".into()) };
    let svg = std::fs::read(page)?;
    println!("{}", tactograph::describe(&svg, None, None)?);
    for finding in tactograph::check(&svg, None)?.findings {
        println!("{finding}");
    }
    let drawing = tactograph::render(&svg, &RenderOptions::new().profile(Profile::named("dot-pad")?))?;
    drawing.notes.iter().for_each(|note| eprintln!("{note}"));
    std::fs::write(text, drawing.page.to_dots(DotFormat::Txt)?)?;
    Ok(())
}
