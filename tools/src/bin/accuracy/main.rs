//! How accurate the edges are, on drawn scenes whose truth is known, and how long they take.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin accuracy                    one table: noise 0, 5 and 10, blur 0.7 px (some seconds)
//!   --quick                  every third scene
//!   --all                    noise 0, 2, 5, 10, 20 and blur 0.7, 1, 2 px
//!   --colour-noise           also with noise of its own in each channel of grey scenes (5c and 10c)
//!   --family                 also a table for each kind of scene
//!   --scenes                 also a table of single scenes
//!   --csv FILE               also every figure on a line of its own
//!   --sigma, --low, --high, --suppression NUMBER              other parameters than `edges::Params::default()`
//!   --export DIR             write the pictures instead, for other detectors (peers.py names one command for all of it)
//!   --peers DIR              other detectors' figures beside ours
//!   --sweep                  write docs/accuracy/sweep.csv and .svg instead: run time against error at several working
//!                            resolutions and scales, of contours alone; with --peers the others are in the drawing
//! ```
//!
//! The first column is of contours as `trace --full-resolution` finds them, in photographs weighted by the regions
//! between them; the second of contours alone. What the weight changes on drawn scenes is the difference: below the
//! table stands which figures are worse with it, or that none is.
//!
//! **Scenes** (`scenes/`): straight edges at 36 angles, discs of radius 5 to 200 px, ellipses, sines, polygons with
//! corners of 30 to 150 degrees, T and X junctions, bars 1 to 6 px wide, pairs of edges 2 to 20 px apart, stairs, edges
//! whose step grows from nothing, colours of equal luma, flat sheets, smooth shading and lawns; each with its own random
//! place below the pixel. They are painted by exact area coverage, blurred by an exact Gaussian lens, given noise and
//! rounded to 8 bits. Blur, steps and noise are in code values 0..=255, as other detectors count them; ours gets the
//! linear light of these codes, as from the decoder.
//!
//! **Measures** (`measure.rs`), all weighted by length, in pixels of the picture:
//!
//! * *localisation*: distance of traced places to the true contour, of those within 2 px of it. Compare it only between
//!   detectors of like recall and precision: who misses faint edges errs less on the rest.
//! * *recall*, *precision*: the share of the true length within 1 px of a traced line, and of the traced length within
//!   1 px of a true contour, over smooth contours, polygons and junctions. Of edges 2 px apart a line must be within 0.8 px.
//! * *traced length / true length*: more than 1 is a staircase, a doubled line or a spur.
//! * *pieces*: chains on a contour that was found. *Rings closed*: closed contours with one closed chain on 90 % of them.
//! * *corner error*, *junction gap*: from the true corner or junction to the nearest traced line. *Branch missing*: how
//!   much of the 8 px of each branch next to the junction is not found.
//! * *strength rank correlation*: Spearman's, of strength with the true step on edges that grow, in stretches of 10 px;
//!   *smallest step found*: from which on more than half of such an edge is found.
//! * *false px/MP*: traced length for a million pixels where nothing is true.
//! * *ms/MP*: from linear light to linked chains on a mosaic of the scenes with noise 5: one thread, its working time.
//!
//! The steps of the scenes were chosen so that a plain detector of Devernay's kind reaches the figures from which this
//! project's targets were taken (sigma 1.5: 0.040 / 0.118 / 0.245 px at noise 0 / 5 / 10; here 0.050 / 0.119 / 0.243).
#![allow(clippy::print_stdout, reason = "this is a program")]

mod args;
mod condition;
mod detector;
mod draw;
mod measure;
mod peers;
mod plot;
mod report;
mod scene;
mod scenes;
mod shapes;
mod sums;
mod sweep;

use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;

use rayon::ThreadPoolBuilder;
use tactograph_tools::words::Words;

use args::Args;
use condition::{Condition, PSFS, TIMED, mosaic};
use draw::{Clean, Picture};
use measure::{Traced, measure};
use report::Column;
use scene::{Family, Scene};
use sums::Sums;

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::read(Words::of_program("tools/src/bin/accuracy/main.rs"))?;
    // what other threads do would not be counted
    ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global()?;
    let scenes = scenes::all(args.quick);
    let own = detector::OWN.map(|(name, _)| Column { name: name.into(), time: None, results: Vec::new() });
    let mut columns = Vec::from(own);
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
            if let Some(folder) = &args.export {
                peers::export(folder, condition, &scenes, &pictures)?;
                if condition == TIMED {
                    peers::export_mosaic(folder, &mosaic(&pictures))?;
                }
                continue;
            }
            add_own(&mut columns, condition, &scenes, &pictures, &args);
            if let Some(folder) = &args.peers {
                for column in &mut columns[detector::OWN.len()..] {
                    column.results.push((condition, score_of_peer(folder, &column.name, condition, &scenes)?));
                }
            }
        }
        if let Some(folder) = &args.sweep {
            sweep::sweep(folder, &scenes, &clean, &args.params, &columns[detector::OWN.len()..])?;
            return Ok(());
        }
        if args.export.is_none() {
            print!("{}{}", report::table(psf, &columns), report::worse(psf, &columns[0], &columns[1]));
        }
    }
    if args.families {
        for column in &columns {
            for (condition, by_family) in &column.results {
                let rows = by_family.iter().map(|(family, sums)| (family.name(), sums));
                print!("{}", report::rows(&column.name, *condition, rows));
            }
        }
    }
    if let Some(file) = args.csv {
        std::fs::write(file, report::csv(&columns))?;
    }
    Ok(())
}

/// Adds to the columns of this project what it traces in pictures of the scenes, in one condition.
fn add_own(columns: &mut [Column], condition: Condition, scenes: &[Scene], pictures: &[Picture], args: &Args) {
    for (column, (_, regions)) in columns.iter_mut().zip(detector::OWN) {
        if condition == TIMED {
            column.time = Some(detector::time(&mosaic(pictures), &args.params, regions));
        }
        let traced = |picture: &Picture| detector::trace(picture, &args.params, regions);
        let lines: Vec<Vec<Traced>> = pictures.iter().map(traced).collect();
        if args.scenes {
            let sums: Vec<Sums> = scenes.iter().zip(&lines).map(|(scene, lines)| measure(scene, lines)).collect();
            let rows = scenes.iter().map(|scene| scene.name.as_str()).zip(&sums);
            print!("{}", report::rows(&column.name, condition, rows));
        }
        column.results.push((condition, score(scenes.iter().zip(lines))));
    }
}

/// Compares what was traced with the truth, scene by scene.
fn score<'a>(traced: impl Iterator<Item = (&'a Scene, Vec<Traced>)>) -> BTreeMap<Family, Sums> {
    let mut by_family: BTreeMap<Family, Sums> = BTreeMap::new();
    for (scene, lines) in traced {
        by_family.entry(scene.family).or_default().add(&measure(scene, &lines));
    }
    by_family
}

/// Compares what another detector traced, as its files in a folder have it.
fn score_of_peer(
    folder: &Path,
    name: &str,
    condition: Condition,
    scenes: &[Scene],
) -> Result<BTreeMap<Family, Sums>, Box<dyn Error>> {
    let mut traced = Vec::new();
    for scene in scenes {
        traced.extend(peers::lines(folder, name, condition, scene)?.map(|lines| (scene, lines)));
    }
    Ok(score(traced.into_iter()))
}
