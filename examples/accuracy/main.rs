//! How accurate the edges are, on drawn scenes whose truth is known.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod args;
mod condition;
mod detector;
mod draw;
mod measure;
mod near;
mod report;
mod rng;
mod scene;
mod scenes;
mod shapes;
mod sums;

use std::collections::BTreeMap;
use std::error::Error;

use args::Args;
use condition::{Condition, PSFS, mosaic};
use draw::{Clean, Picture};
use measure::{Traced, measure};
use report::Column;
use scene::{Family, Scene};
use sums::Sums;

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::read(std::env::args().skip(1))?;
    let scenes = scenes::all(args.quick);
    let mut columns = vec![Column { name: "tactograph".into(), time: None, results: Vec::new() }];
    let psfs = if args.all { &PSFS[..] } else { &PSFS[..1] };
    for &psf in psfs {
        let clean: Vec<Clean> = scenes.iter().map(|scene| draw::render(scene, psf)).collect();
        for condition in Condition::list(psf, args.all, args.colour_noise) {
            let pictures: Vec<Picture> =
                scenes.iter().zip(&clean).map(|(scene, clean)| condition.shoot(scene, clean)).collect();
            if columns[0].time.is_none() && condition.noise > 2.0 {
                columns[0].time = Some(detector::time(&mosaic(&pictures), &args.params));
            }
            let lines = pictures.iter().map(|picture| detector::trace(picture, &args.params));
            columns[0].results.push((condition, score(&scenes, lines)));
        }
        print!("{}", report::table(psf, &columns));
    }
    if args.families {
        for (condition, by_family) in &columns[0].results {
            print!("{}", report::families(*condition, by_family));
        }
    }
    if let Some(file) = args.csv {
        std::fs::write(file, report::csv(&columns))?;
    }
    Ok(())
}

/// Compares what was traced with the truth, scene by scene.
fn score(scenes: &[Scene], lines: impl Iterator<Item = Vec<Traced>>) -> BTreeMap<Family, Sums> {
    let mut by_family: BTreeMap<Family, Sums> = BTreeMap::new();
    for (scene, lines) in scenes.iter().zip(lines) {
        by_family.entry(scene.family).or_default().add(&measure(scene, &lines));
    }
    by_family
}
