//! Renders an SVG page with resvg on white, and tells how far another program's rendering of it is away:
//!
//! ```text
//! cargo run -p tactograph-tools --bin render -- PAGE.svg OUT.png [--dpi 100] [--against OTHER.png]
//! ```
//!
//! With `--against` it prints two numbers in percent: the mean difference of all pixels, and the share of pixels that
//! differ by more than a quarter of the way from black to white. The sizes may differ by one pixel, as programs round a
//! fraction of a pixel up or to the nearest.
#![allow(clippy::print_stdout, reason = "this is a program")]

use std::error::Error;

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use tactograph_tools::words::Words;

/// A quarter of the way from black to white: well over what smoothing of edges differs by between renderers, well under
/// a line that is missing.
const FAR: u8 = 64;

fn main() -> Result<(), Box<dyn Error>> {
    let (mut files, mut dpi, mut against) = (Vec::new(), 100.0, None);
    let mut words = Words::of_program("tools/src/bin/render.rs");
    while let Some(word) = words.next() {
        match word.as_str() {
            "--dpi" => dpi = words.number(&word)?,
            "--against" => against = Some(words.value(&word)?),
            _ => files.push(word),
        }
    }
    let [page, out] = &files[..] else { return Err("give PAGE.svg and OUT.png".into()) };

    let options = Options { dpi, ..Options::default() };
    let tree = Tree::from_data(&std::fs::read(page)?, &options)?;
    let size = tree.size().to_int_size();
    let mut pixmap = Pixmap::new(size.width(), size.height()).ok_or("the page has no size")?;
    pixmap.fill(Color::WHITE);
    resvg::render(&tree, Transform::identity(), &mut pixmap.as_mut());
    pixmap.save_png(out)?;

    if let Some(other) = against {
        let other = Pixmap::load_png(&other)?;
        let (width, height) = (pixmap.width().min(other.width()), pixmap.height().min(other.height()));
        if pixmap.width().max(other.width()) > width + 1 || pixmap.height().max(other.height()) > height + 1 {
            let sizes = [&pixmap, &other].map(|p| format!("{} x {}", p.width(), p.height()));
            return Err(format!("sizes differ: here {}, there {}", sizes[0], sizes[1]).into());
        }
        let rows = pixmap.pixels().chunks(pixmap.width() as usize).zip(other.pixels().chunks(other.width() as usize));
        // The page is black on white, so one channel says it all.
        let pairs = rows.take(height as usize).flat_map(|(here, there)| here.iter().zip(there));
        let differences: Vec<u8> = pairs.map(|(a, b)| a.green().abs_diff(b.green())).collect();
        let count = differences.len() as f64;
        let mean = differences.iter().map(|&d| f64::from(d)).sum::<f64>() / 255.0 / count;
        let far = differences.iter().filter(|&&d| d > FAR).count() as f64 / count;
        println!("{:.4} {:.4}", 100.0 * mean, 100.0 * far);
    }
    Ok(())
}
