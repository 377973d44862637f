//! Contours of a picture as data: `cargo run --example trace -- samples/coffee.png`. Writes a row for each polyline:
//! whether it is closed, how many points it has, its length and its mean strength.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this is a program")]

use tactograph::{Options, Profile, Tracing};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let picture = std::env::args().nth(1).ok_or("give a picture")?;
    let options = Options::new(Profile::named("swell-a4")?);
    let traced = tactograph::trace(&std::fs::read(picture)?, &Tracing::contours(), &options)?;
    traced.notes.iter().for_each(|note| eprintln!("{note}"));
    println!("closed,points,length in px,mean strength");
    for polyline in &traced.trace.polylines {
        // the first point is not repeated at the end of a closed one
        let closing = polyline.points.first().filter(|_| polyline.closed);
        let next = polyline.points.iter().skip(1).chain(closing);
        let length: f32 = polyline.points.iter().zip(next).map(|(a, b)| (*b - *a).length()).sum();
        let mean = polyline.strength.iter().sum::<f32>() / polyline.strength.len() as f32;
        println!("{},{},{length:.1},{mean:.2}", polyline.closed, polyline.points.len());
    }
    Ok(())
}
