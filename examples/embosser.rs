//! A picture to files for an embosser: `cargo run --example embosser -- samples/coffee.png coffee`. Writes one document
//! of all sheets, or a file for each where the format holds one sheet.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use tactograph::{DotFormat, Embossing, Options, Profile};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [picture, name] = &args[..] else { return Err("give a picture and a name for the files".into()) };
    let options = Options::new(Profile::named("index-basic-d")?).picture_name(picture);
    let drawing = tactograph::convert(&std::fs::read(picture)?, &options)?;
    drawing.notes.iter().for_each(|note| eprintln!("{note}"));
    let title = options.document_title().to_owned();
    let files = tactograph::write_dots(&title, &drawing.into_pages(), DotFormat::Idx, Embossing::default())?;
    for (i, bytes) in files.iter().enumerate() {
        let path = if files.len() == 1 { format!("{name}.idx") } else { format!("{name}-{}.idx", i + 1) };
        std::fs::write(&path, bytes)?;
        println!("{path}");
    }
    Ok(())
}
