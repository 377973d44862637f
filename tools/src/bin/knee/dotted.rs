//! Pages of dots: which dots stay when the picture is worked on at a lower resolution.

use std::collections::HashSet;
use std::sync::Arc;

use tactograph::internals::output::svg;
use tactograph::internals::page::{Page, Pen};
use tactograph::internals::pipeline::{Event, Request, Stage};
use tactograph::internals::profile::Plan;
use tactograph::internals::touch::{Ink, report};
use tactograph::internals::units::MmPoint;
use tactograph_tools::median::median;

use crate::clock::Clock;
use crate::compare::FINGER;
use crate::pictures::Picture;
use crate::rows::profile;

/// px for a millimetre of the page; the last is what the others are held against.
const RESOLUTIONS: [f32; 10] = [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0];

/// What one page is.
struct Made {
    lines: HashSet<[i32; 2]>,
    textures: HashSet<[i32; 2]>,
    length: f32,
    read: f32,
    ms: Vec<[f64; 2]>,
}

/// Prints, for each picture and resolution, time and the share of dots that are elsewhere.
///
/// # Errors
/// A picture cannot be made into a page.
pub(crate) fn table(name: &str, pictures: &[Picture], rounds: usize) -> Result<(), String> {
    println!("| picture | px/mm | ms | decode | line dots | of them new | lost | texture dots | new | lost | read |");
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for picture in pictures {
        let plans = RESOLUTIONS.map(|resolution| {
            Plan::new(&profile(name, &[("figure.resolution", resolution)])?).map_err(|faults| format!("{faults:?}"))
        });
        let plans: Vec<Plan> = plans.into_iter().collect::<Result<_, String>>()?;
        let mut made = Vec::new();
        for plan in &plans {
            made.push(look(&page_of(picture, plan)?.0)?);
        }
        for _ in 0..rounds {
            for (made, plan) in made.iter_mut().zip(&plans) {
                made.ms.push(page_of(picture, plan)?.1);
            }
        }
        let Some((reference, _)) = made.split_last() else { continue };
        for (made, resolution) in made.iter().zip(RESOLUTIONS) {
            let share = |a: &HashSet<[i32; 2]>, b: &HashSet<[i32; 2]>| a.difference(b).count() as f64 / a.len() as f64;
            let ms = |i: usize| median(made.ms.iter().map(|ms| ms[i])).unwrap_or(f64::NAN);
            println!(
                "| {} | {resolution} | {:.1} | {:.1} | {} | {:.3} | {:.3} | {} | {:.3} | {:.3} | {:.4} |",
                picture.name,
                ms(0),
                ms(1),
                made.length,
                share(&made.lines, &reference.lines),
                share(&reference.lines, &made.lines),
                made.textures.len(),
                share(&made.textures, &reference.textures),
                share(&reference.textures, &made.textures),
                made.read
            );
        }
    }
    Ok(())
}

/// The page, and how long all of it and decoding took.
fn page_of(picture: &Picture, plan: &Plan) -> Result<(Page, [f64; 2]), String> {
    let (limits, fit) = (Default::default(), Default::default());
    let request =
        Request { plan, limits, fonts: &Arc::default, title: "a picture", language: "en", fit, cancelled: &|| false };
    let (mut clock, mut stage, mut decode) = (Clock::start(), Clock::start(), 0.0);
    let drawing = tactograph::internals::pipeline::convert(&picture.bytes, &request, &mut |event| match event {
        Event::Begin(Stage::Decode) => drop(stage.lap()),
        Event::End(Stage::Decode) => decode = stage.lap(),
        _ => {}
    });
    let drawing = drawing.map_err(|fault| format!("{}: {fault}", picture.name))?;
    Ok((drawing.page, [clock.lap(), decode]))
}

fn look(page: &Page) -> Result<Made, String> {
    let at = |p: MmPoint| [p.x, p.y].map(|mm| (10.0 * mm).round() as i32);
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs).filter(|run| run.pen != Pen::Stroke);
    let lines: HashSet<_> = runs.flat_map(|run| run.points.iter().map(|p| at(*p))).collect();
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let ink = Ink::of(&svg::write(page)).map_err(|fault| fault.to_string())?;
    let felt = ink.felt(FINGER).map_err(|fault| fault.to_string())?;
    let read = report(&ink, &felt).total().right_of_judged();
    let length = lines.len() as f32;
    Ok(Made { lines, textures: glyphs.map(|glyph| at(glyph.at)).collect(), length, read, ms: Vec::new() })
}
