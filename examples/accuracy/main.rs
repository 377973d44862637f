//! How accurate the edges are, on drawn scenes whose truth is known.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod draw;
mod measure;
mod near;
mod rng;
mod scene;
mod scenes;
mod shapes;

use std::collections::BTreeMap;
use std::error::Error;
use std::time::Instant;

use draw::Picture;
use measure::{Sums, Traced, measure};
use scene::{Family, Scene};
use tactograph::edges::{self, Params};
use tactograph::raster::Raster;
use tactograph::units::Size;

fn main() -> Result<(), Box<dyn Error>> {
    let mut params = Params::default();
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number =
            || -> Result<f32, Box<dyn Error>> { Ok(words.next().ok_or(format!("{word} needs a number"))?.parse()?) };
        match word.as_str() {
            "--sigma" => params.sigma = number()?,
            "--low" => params.low = number()?,
            "--high" => params.high = number()?,
            "--suppression" => params.suppression = number()?,
            _ => return Err(format!("{word} is not known").into()),
        }
    }
    let scenes = scenes::all();
    let clean: Vec<_> = scenes.iter().map(|scene| draw::render(scene, 0.7)).collect();
    for noise in [0.0, 5.0, 10.0] {
        let mut by_family: BTreeMap<Family, Sums> = BTreeMap::new();
        let mut time = 0.0;
        for (i, (scene, clean)) in scenes.iter().zip(&clean).enumerate() {
            let picture = clean.shot(noise, false, i as u64);
            let start = Instant::now();
            let lines = trace(&picture, &params);
            time += start.elapsed().as_secs_f64();
            by_family.entry(scene.family).or_default().add(&measure(scene, &lines));
        }
        let mut total = Sums::default();
        println!("\nnoise {noise}: {time:.2} s in the detector");
        println!("| family | RMS | p95 | recall | precision | pieces | closure | px/MP |");
        println!("|---|---|---|---|---|---|---|---|");
        for (family, sums) in &by_family {
            row(family.name(), sums);
            if Family::SMOOTH.contains(family) {
                total.add(sums);
            }
        }
        row("all smooth", &total);
    }
    Ok(())
}

fn row(name: &str, sums: &Sums) {
    println!(
        "| {name} | {:.3} | {:.2} | {:.3} | {:.3} | {:.2} | {:.2} | {:.0} |",
        sums.rms(),
        sums.p95(),
        sums.found_length / sums.true_length,
        sums.right_length / sums.traced_length,
        sums.pieces / sums.contours,
        sums.closed_rings / sums.rings,
        1e6 * sums.all_length / sums.area
    );
}

fn trace(picture: &Picture, params: &Params) -> Vec<Traced> {
    let edges = edges::find(&raster(picture), params);
    edges
        .chains()
        .map(|chain| Traced {
            closed: chain.len() > 1 && chain.first().map(|p| p.at) == chain.last().map(|p| p.at),
            points: chain.iter().map(|p| [f64::from(p.at.x), f64::from(p.at.y)]).collect(),
            strength: chain.iter().map(|p| f64::from(p.strength)).collect(),
        })
        .collect()
}

/// Linear light from sRGB bytes, as the decoder makes it.
fn raster(picture: &Picture) -> Raster {
    let linear: Vec<f32> = (0..=255)
        .map(|code| {
            let encoded = f64::from(code) / 255.0;
            if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
        })
        .map(|light| light as f32)
        .collect();
    let plane = |channel: usize| picture.rgb.iter().skip(channel).step_by(3).map(|&v| linear[v as usize]).collect();
    Raster::colour(Size::new(picture.size[0] as u32, picture.size[1] as u32), [plane(0), plane(1), plane(2)])
}
