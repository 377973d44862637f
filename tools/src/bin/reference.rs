//! How far the program's f32 is from the same computations in f64 (`tools/src/reference/`), on the samples and on
//! scenes where rounding may turn a decision.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin reference
//! ```
#![allow(clippy::print_stdout, reason = "this is a program")]

use tactograph::internals::profile::{Plan, Profile};
use tactograph_tools::reference::edges::quantile;
use tactograph_tools::reference::samples::{self, PX_PER_MM, codes};
use tactograph_tools::reference::{colours, edges, glyphs, scenes};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let plan = Plan::new(&Profile::named("swell-a4")?)?;
    let mut pictures = samples::all()?;
    pictures.extend(scenes::all());
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
