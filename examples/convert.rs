//! A picture to a page: `cargo run --example convert -- samples/coffee.png coffee.svg [profile]`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use tactograph::{Event, Options, Profile};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [picture, page, profile @ ..] = &args[..] else { return Err("give a picture and a name for the page".into()) };
    let profile = Profile::named(profile.first().map_or("swell-a4", String::as_str))?;
    let options = Options::new(profile).picture_name(picture).progress(|event| {
        if let Event::End(stage) = event {
            eprintln!("{} is done", stage.name());
        }
    });
    let drawing = tactograph::convert(&std::fs::read(picture)?, &options)?;
    drawing.notes.iter().for_each(|note| eprintln!("{note}"));
    // an overview may be a page of its own, as on a device that raises one sheet of dots after another
    let (stem, extension) = page.rsplit_once('.').unwrap_or((page, "svg"));
    for (number, sheet) in drawing.into_pages().iter().enumerate() {
        let file = if number == 0 { page.clone() } else { format!("{stem}-{}.{extension}", number + 1) };
        std::fs::write(file, sheet.to_svg())?;
    }
    Ok(())
}
