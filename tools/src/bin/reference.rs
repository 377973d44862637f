//! How far the program's f32 is from the same computations in f64 (`tools/src/reference/`), on the samples and on
//! scenes where rounding may turn a decision.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin reference
//! ```
#![allow(clippy::print_stdout, reason = "this is a program")]

use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::Raster;
use tactograph::internals::raster::decode::{DecodeOptions, Header, decode};
use tactograph::internals::units::Size;
use tactograph_tools::reference::edges::quantile;
use tactograph_tools::reference::{colours, edges, glyphs, scenes};

/// Working pixels along the longer side, as of a figure 174 mm wide.
const LONGEST: f32 = 696.0;
/// Working pixels for a millimetre.
const PX_PER_MM: f32 = 4.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let plan = Plan::new(&Profile::named("swell-a4")?)?;
    let mut pictures: Vec<(String, Raster)> = Vec::new();
    for name in ["bars.svg", "cell.svg", "chart.svg", "landscape.svg", "map.svg", "portrait.svg"] {
        pictures.push((name.to_owned(), sample(name)?));
    }
    for name in ["astronaut.png", "chelsea.png", "coffee.png", "rocket.jpg"] {
        pictures.push((name.to_owned(), sample(name)?));
    }
    pictures.extend(scenes::all().into_iter().map(|(name, raster)| (name.to_owned(), raster)));
    println!(
        "| | points | along the other axis | of one only | position, px: 99.9 % | all | strength: 99.9 % | all | as a \
         share: 99.9 % | all | line width, mm: 99.9 % | other class |"
    );
    println!("|---|{}", "---|".repeat(11));
    let lines = plan.lines();
    let mm_per_unit = f64::from((lines.width_max - lines.width_min) / (lines.full_strength - lines.least_strength));
    for (name, raster) in &pictures {
        let found = edges::compare(raster, &plan.edges(PX_PER_MM));
        let classes = colours::compare(codes(raster), &plan.classes(PX_PER_MM));
        let [px, height, share] =
            [&found.px, &found.height, &found.share].map(|values| [0.999, 1.0].map(|share| quantile(values, share)));
        println!(
            "| {name} | {} | {} | {} | {:.4} | {:.4} | {:.4} | {:.3} | {:.4} | {:.3} | {:.4} | {} |",
            found.both,
            found.other_axis,
            found.single,
            px[0],
            px[1],
            height[0],
            height[1],
            share[0],
            share[1],
            height[0] * mm_per_unit,
            classes.other
        );
    }
    let all = (0..1 << 24).step_by(7).map(|code: u32| [16, 8, 0].map(|shift| (code >> shift & 0xff) as f32 / 255.0));
    let found = colours::compare(all, &plan.classes(PX_PER_MM));
    println!("every seventh colour of 8 bits: {found:?}");
    let (off, marks) = glyphs::compare(&plan.textures());
    println!("marks of textures: {off:.8} mm ({marks} marks)");
    Ok(())
}

/// The colours of a picture as sRGB values 0..=1.
fn codes(raster: &Raster) -> impl Iterator<Item = [f32; 3]> {
    let planes = raster.planes().as_slice();
    let encoded =
        |linear: f32| if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    let plane = move |channel: usize| &planes[channel.min(planes.len() - 1)];
    (0..planes[0].len()).map(move |i| [0, 1, 2].map(|channel| encoded(plane(channel)[i]).clamp(0.0, 1.0)))
}

fn sample(name: &str) -> Result<Raster, Box<dyn std::error::Error>> {
    let bytes = std::fs::read(format!("{}/samples/{name}", tactograph_tools::ROOT))?;
    let working_size = |source: Header| -> Result<Size, tactograph::Error> {
        let longer = source.size.width.max(source.size.height) as f32;
        let scale = if source.is_drawing { LONGEST / longer } else { (LONGEST / longer).min(1.0) };
        let side = |pixels: u32| (pixels as f32 * scale).round() as u32;
        Ok(Size::new(side(source.size.width), side(source.size.height)))
    };
    Ok(decode(&bytes, &DecodeOptions { keep_text: false, ..DecodeOptions::whole(&working_size) })?.raster)
}
