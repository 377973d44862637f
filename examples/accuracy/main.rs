//! How accurate the edges are, on drawn scenes whose truth is known.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod args;
mod condition;
mod detector;
mod draw;
mod measure;
mod near;
mod peers;
mod plot;
mod report;
mod rng;
mod scene;
mod scenes;
mod shapes;
mod sums;
mod sweep;

use std::collections::BTreeMap;
use std::error::Error;

use args::Args;
use condition::{Condition, PSFS, TIMED, mosaic};
use draw::{Clean, Picture};
use measure::{Traced, measure};
use report::Column;
use scene::{Family, Scene};
use sums::Sums;

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::read(std::env::args().skip(1))?;
    let scenes = scenes::all(args.quick);
    let mut columns = vec![Column { name: "tactograph".into(), time: None, results: Vec::new() }];
    if let Some(folder) = &args.peers {
        for name in peers::names(folder)? {
            columns.push(Column { time: peers::time(folder, &name), name, results: Vec::new() });
        }
    }
    let psfs = if args.all { &PSFS[..] } else { &PSFS[..1] };
    for &psf in psfs {
        let clean: Vec<Clean> = scenes.iter().map(|scene| draw::render(scene, psf)).collect();
        for condition in Condition::list(psf, args.all, args.colour_noise) {
            let pictures: Vec<Picture> =
                scenes.iter().zip(&clean).map(|(scene, clean)| condition.shoot(scene, clean)).collect();
            let timed = condition == TIMED;
            if let Some(folder) = &args.export {
                peers::export(folder, condition, &scenes, &pictures)?;
                if timed {
                    peers::export_mosaic(folder, &mosaic(&pictures))?;
                }
                continue;
            }
            if timed {
                columns[0].time = Some(detector::time(&mosaic(&pictures), &args.params));
            }
            let lines = pictures.iter().map(|picture| detector::trace(picture, &args.params));
            columns[0].results.push((condition, score(scenes.iter().zip(lines))));
            if let Some(folder) = &args.peers {
                for column in &mut columns[1..] {
                    let mut traced = Vec::new();
                    for scene in &scenes {
                        traced
                            .extend(peers::lines(folder, &column.name, condition, scene)?.map(|lines| (scene, lines)));
                    }
                    column.results.push((condition, score(traced.into_iter())));
                }
            }
        }
        if let Some(folder) = &args.sweep {
            sweep::sweep(folder, &scenes, &clean, &args.params, &columns[1..])?;
            return Ok(());
        }
        if args.export.is_none() {
            print!("{}", report::table(psf, &columns));
        }
    }
    if args.families {
        for column in &columns {
            for (condition, by_family) in &column.results {
                print!("{}", report::families(&column.name, *condition, by_family));
            }
        }
    }
    if let Some(file) = args.csv {
        std::fs::write(file, report::csv(&columns))?;
    }
    Ok(())
}

/// Compares what was traced with the truth, scene by scene.
fn score<'a>(traced: impl Iterator<Item = (&'a Scene, Vec<Traced>)>) -> BTreeMap<Family, Sums> {
    let mut by_family: BTreeMap<Family, Sums> = BTreeMap::new();
    for (scene, lines) in traced {
        by_family.entry(scene.family).or_default().add(&measure(scene, &lines));
    }
    by_family
}
