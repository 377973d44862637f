//! Pixels in memory to a page and to what a fingertip feels of it: `cargo run --example pixels`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use tactograph::{Error, Options, PageOptions, Picture, Profile};

fn main() -> Result<(), Error> {
    // A blue disc on white, as a canvas of a browser would have it.
    let (width, height) = (300, 200);
    let colour =
        |x: i32, y: i32| if (x - 150).pow(2) + (y - 100).pow(2) < 80 * 80 { [30, 60, 200, 255] } else { [255; 4] };
    let pixels: Vec<u8> = (0..height).flat_map(|y| (0..width).flat_map(move |x| colour(x, y))).collect();
    let picture = Picture::rgba8(width as u32, height as u32, &pixels)?;
    let options = Options::new(Profile::named("swell-a4")?).title("A blue disc");
    let page = tactograph::convert(picture, &options)?.page;
    println!("{}", page.description);
    print!("{}", tactograph::feel(page.to_svg(), &PageOptions::new())?.report());
    Ok(())
}
