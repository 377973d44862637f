//! How thin a stroke may be in a scan, and still be found: draws lines at many angles on a picture of 12 megapixels, makes the
//! page, and looks from which width on 0.95 of them are drawn.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin thin_strokes     the table (some minutes)
//!   --width-mm MM      width of the figure (default 170)
//! ```
//!
//! **Picture**: 4000 x 3000 px in grey, seven straight lines that cross nothing, each at another angle, and a ring; pixels at
//! their borders are as dark as they are covered. **Noise** is white and normal, the same in all channels, in code values.
#![allow(clippy::print_stdout, reason = "this is a program")]

use std::error::Error;

use tactograph::{Options, Picture, Profile};
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::drawn::{Point, lines_of, share_near};
use tactograph_tools::rng::Rng;
use tactograph_tools::words::Words;

type Fault = Box<dyn Error + Send + Sync>;

/// Size of the picture, px.
const SIZE: [usize; 2] = [4000, 3000];
/// Contrasts of the stroke with the white paper, code values.
const CONTRASTS: [u8; 4] = [255, 128, 64, 32];
/// Standard deviations of the noise, code values.
const NOISES: [f64; 4] = [0.0, 2.0, 5.0, 10.0];
/// Widths of the stroke that are tried, px.
const WIDTHS: [f64; 14] = [0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 16.0];
/// A stroke is found when this share of it is drawn.
const FOUND: f64 = 0.95;
const PAPER: f64 = 255.0;

fn main() -> Result<(), Fault> {
    let mut width_mm = 170.0;
    let mut words = Words::of_program("tools/src/bin/thin_strokes.rs");
    while let Some(word) = words.next() {
        match word.as_str() {
            "--width-mm" => width_mm = words.number(&word)?,
            _ => return Err(words.unknown(&word).into()),
        }
    }
    let tasks: Vec<(u8, f64)> =
        CONTRASTS.into_iter().flat_map(|contrast| NOISES.map(|noise| (contrast, noise))).collect();
    let thinnest: Result<Vec<Option<f64>>, Fault> =
        on_all_cores(&tasks, |&(contrast, noise)| thinnest(contrast, noise, width_mm)).into_iter().collect();
    let thinnest = thinnest?;
    let mm = |px: f64| px * f64::from(width_mm) / SIZE[0] as f64;
    println!("| contrast, of 255 | {} |", NOISES.map(|noise| format!("noise {noise}")).join(" | "));
    println!("|---|{}", "---|".repeat(NOISES.len()));
    for (contrast, row) in CONTRASTS.iter().zip(thinnest.chunks(NOISES.len())) {
        let cell = |px: &Option<f64>| px.map_or("-".to_owned(), |px| format!("{px} px, {:.2} mm", mm(px)));
        println!("| {contrast} | {} |", row.iter().map(cell).collect::<Vec<_>>().join(" | "));
    }
    Ok(())
}

/// The least of the widths at which strokes are found, px; those above it are found, too: half of what is left is passed
/// over with each try.
fn thinnest(contrast: u8, noise: f64, width_mm: f32) -> Result<Option<f64>, Fault> {
    let (mut low, mut high) = (0, WIDTHS.len());
    while low < high {
        let middle = (low + high) / 2;
        if found(WIDTHS[middle], contrast, noise, width_mm)? >= FOUND {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    Ok(WIDTHS.get(high).copied())
}

/// The middles of the strokes, px.
fn strokes() -> Vec<Vec<Point>> {
    let [width, height] = SIZE.map(|side| side as f64);
    let mut strokes: Vec<Vec<Point>> = (0..7)
        .map(|i| {
            let (x, half) = (width * (0.08 + 0.1 * f64::from(i)), 0.35 * height);
            // from upright to 17 degrees aslant
            let off = half * (f64::from(i) * 2.9_f64).to_radians().tan();
            vec![[x - 0.3 * off, 0.5 * height - half], [x + 0.7 * off, 0.5 * height + half]]
        })
        .collect();
    let at = |step: u32| {
        let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 180.0).sin_cos();
        [0.87 * width + 0.07 * width * cos, 0.25 * height + 0.07 * width * sin]
    };
    strokes.push((0..=180).map(at).collect());
    // one that lies nearly level
    strokes.push(vec![[0.05 * width, 0.93 * height], [0.95 * width, 0.96 * height]]);
    strokes
}

/// Share of the strokes that the page draws.
fn found(width: f64, contrast: u8, noise: f64, width_mm: f32) -> Result<f64, Fault> {
    let strokes = strokes();
    let mut covered = vec![0.0_f32; SIZE[0] * SIZE[1]];
    for pair in strokes.iter().flat_map(|stroke| stroke.windows(2)) {
        cover(&mut covered, pair[0], pair[1], width);
    }
    let mut rng = Rng::new(7);
    let mut pixels = Vec::with_capacity(4 * covered.len());
    for covered in covered {
        let noise = if noise > 0.0 { noise * rng.normal() } else { 0.0 };
        let value = (PAPER - f64::from(contrast) * f64::from(covered) + noise).round().clamp(0.0, 255.0) as u8;
        pixels.extend([value, value, value, 255]);
    }
    let mut profile = Profile::named("swell-a4")?;
    for key in ["overview.on", "figure.textures"] {
        profile.set(key, "false")?;
    }
    let picture = Picture::rgba8(SIZE[0] as u32, SIZE[1] as u32, &pixels)?;
    let drawing = tactograph::convert(picture, &Options::new(profile).width_mm(width_mm))?;
    let place = drawing.page.figure.place;
    let scale = f64::from(place.width()) / SIZE[0] as f64;
    let on_sheet = |at: &Point| [f64::from(place.min.x) + scale * at[0], f64::from(place.min.y) + scale * at[1]];
    let truth: Vec<Vec<Point>> = strokes.iter().map(|stroke| stroke.iter().map(on_sheet).collect()).collect();
    Ok(share_near(&truth, &lines_of(&drawing.page)).unwrap_or(0.0))
}

/// Covers the pixels of a straight stroke; of those at its border as much as it covers of them.
fn cover(covered: &mut [f32], a: Point, b: Point, width: f64) {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    let reach = 0.5 * width + 1.0;
    let range = |axis: usize| {
        let (low, high) = (a[axis].min(b[axis]) - reach, a[axis].max(b[axis]) + reach);
        low.floor().max(0.0) as usize..(high.ceil().max(0.0) as usize).min(SIZE[axis])
    };
    for y in range(1) {
        // where the stroke is in this row
        let columns = if dy.abs() > 1e-9 && dy.abs() > 0.01 * length {
            let at = |y: f64| a[0] + (y - a[1]) / dy * dx;
            let (first, last) = (at(y as f64), at(y as f64 + 1.0));
            let wider = reach * length / dy.abs();
            let columns = range(0);
            let low = ((first.min(last) - wider).max(0.0) as usize).max(columns.start);
            low..((first.max(last) + wider).max(0.0).ceil() as usize).min(columns.end)
        } else {
            range(0)
        };
        for x in columns {
            let at = [x as f64 + 0.5 - a[0], y as f64 + 0.5 - a[1]];
            let along = (at[0] * dx + at[1] * dy) / length;
            let across = ((at[0] * dy - at[1] * dx) / length).abs();
            // a pixel as a disc of a pixel's width
            let share = |inside: f64| inside.clamp(-0.5, 0.5) + 0.5;
            let breadth = share(0.5 * width - across) - share(-0.5 * width - across);
            let value = breadth * share(along).min(share(length - along));
            let cell = &mut covered[y * SIZE[0] + x];
            *cell = cell.max(value as f32);
        }
    }
}
