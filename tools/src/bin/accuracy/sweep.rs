//! Run time against error: the same scenes at several working resolutions and scales.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use tactograph::internals::edges::{self, Params};
use tactograph::internals::raster::Raster;
use tactograph::internals::raster::shrink::shrink;
use tactograph::internals::units::Size;

use crate::condition::{Condition, TIMED, mosaic};
use crate::detector::{Time, raster, timed, traced};
use crate::draw::{Clean, Picture};
use crate::measure::Traced;
use crate::plot::{Dot, plot};
use crate::report::Column;
use crate::scene::{Family, Scene};
use crate::score;
use crate::sums::Sums;

/// How many source pixels to a working pixel, along a side.
const SHRINKS: [f64; 5] = [1.0, 1.5, 2.0, 3.0, 4.0];
/// Scales, working pixels.
const SIGMAS: [f32; 5] = [0.7, 1.0, 1.5, 2.0, 3.0];

/// One way to work.
struct Row {
    name: String,
    /// Source pixels to a working pixel and scale in working pixels, if it is ours.
    work: Option<(f64, f32)>,
    time: Time,
    /// RMS distance from the truth, source px, at noise 0, 5 and 10.
    errors: [f64; 3],
    /// Share of the true length found at noise 5.
    recall: f64,
    /// Whether nothing else is both faster and nearer.
    best: bool,
}

/// Writes `sweep.csv` and `sweep.svg`; other detectors' columns go in as they are.
pub(crate) fn sweep(
    folder: &Path,
    scenes: &[Scene],
    clean: &[Clean],
    params: &Params,
    peers: &[Column],
) -> Result<(), Box<dyn Error>> {
    let conditions = Condition::list(TIMED.psf, false, false);
    let shots: Vec<(Condition, Vec<Picture>)> = conditions
        .iter()
        .map(|&condition| (condition, scenes.iter().zip(clean).map(|(s, c)| condition.shoot(s, c)).collect()))
        .collect();
    let timing: Option<Picture> = shots.iter().find(|(condition, _)| *condition == TIMED).map(|(_, shot)| mosaic(shot));
    let timing = timing.ok_or("the condition for the time is not in the list")?;
    let rasters: Vec<Vec<Raster>> = shots.iter().map(|(_, shot)| shot.iter().map(raster).collect()).collect();
    let timing_raster = raster(&timing);

    let mut rows = Vec::new();
    for factor in SHRINKS {
        for sigma in SIGMAS {
            let params = Params { sigma, ..*params };
            let results = rasters.iter().map(|rasters| {
                let lines = rasters.iter().map(|raster| trace(raster, factor, &params));
                Sums::over(&score(scenes.iter().zip(lines)), &Family::SMOOTH)
            });
            let results: Vec<Sums> = results.collect();
            let time = timed(&timing, || drop(std::hint::black_box(trace(&timing_raster, factor, &params))));
            rows.push(Row {
                name: format!("{factor:.1} : {sigma:.1}"),
                work: Some((factor, sigma)),
                time,
                errors: [0, 1, 2].map(|i| results[i].rms()),
                recall: results[1].recall(),
                best: false,
            });
        }
    }
    rows.extend(peers.iter().filter_map(peer));
    mark_best(&mut rows);
    fs::create_dir_all(folder)?;
    fs::write(folder.join("sweep.csv"), csv(&rows))?;
    let dots: Vec<Dot> = rows
        .iter()
        .filter(|row| row.recall > 0.95)
        .map(|row| Dot {
            name: row.name.clone(),
            at: [row.time.best, row.errors[1]],
            ours: row.work.is_some(),
            best: row.best,
        })
        .collect();
    fs::write(folder.join("sweep.svg"), plot(&dots))?;
    Ok(())
}

/// The edges of a picture worked on at a lower resolution, in pixels of the source.
fn trace(raster: &Raster, factor: f64, params: &Params) -> Vec<Traced> {
    let size = raster.size();
    let shrunk = |n: u32| (f64::from(n) / factor).round() as u32;
    let small = Size::new(shrunk(size.width), shrunk(size.height));
    let mut lines = if small == size {
        return traced(&edges::find(raster, params));
    } else {
        let planes = raster.planes().as_ref().map(|plane| shrink(plane, size, small).values);
        traced(&edges::find(&Raster::new(small, planes), params))
    };
    let scale = [f64::from(size.width) / f64::from(small.width), f64::from(size.height) / f64::from(small.height)];
    for point in lines.iter_mut().flat_map(|line| &mut line.points) {
        *point = [point[0] * scale[0], point[1] * scale[1]];
    }
    lines
}

fn peer(column: &Column) -> Option<Row> {
    let smooth = |noise: f64| {
        let is = |c: &Condition| c.noise.total_cmp(&noise).is_eq() && *c == Condition { noise, ..TIMED };
        column.results.iter().find(|(c, _)| is(c)).map(|(_, sums)| Sums::over(sums, &Family::SMOOTH))
    };
    let sums = [smooth(0.0)?, smooth(5.0)?, smooth(10.0)?];
    Some(Row {
        name: column.name.clone(),
        work: None,
        time: column.time?,
        errors: [0, 1, 2].map(|i| sums[i].rms()),
        recall: sums[1].recall(),
        best: false,
    })
}

/// Marks, among those of ours that find nearly all, the ones that no other beats in both time and error.
fn mark_best(rows: &mut [Row]) {
    let points: Vec<[f64; 2]> = rows
        .iter()
        .map(|row| if row.work.is_some() && row.recall > 0.95 { [row.time.best, row.errors[1]] } else { [f64::MAX; 2] })
        .collect();
    for (row, at) in rows.iter_mut().zip(&points) {
        row.best = at[0] < f64::MAX && !points.iter().any(|other| other[0] < at[0] && other[1] < at[1]);
    }
}

fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "detector,source_px_per_working_px,sigma_working_px,ms_per_source_megapixel_median,ms_best,\
         rms_px_noise_0,rms_px_noise_5,rms_px_noise_10,recall_noise_5,best\n",
    );
    for row in rows {
        let (name, work) = match row.work {
            Some((factor, sigma)) => ("tactograph", format!("{factor},{sigma}")),
            None => (row.name.as_str(), ",".into()),
        };
        let [none, some, much] = row.errors;
        let Time { median, best } = row.time;
        let _ = writeln!(
            text,
            "{name},{work},{median:.2},{best:.2},{none:.4},{some:.4},{much:.4},{:.4},{}",
            row.recall, row.best
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_best_are_those_that_nothing_beats_in_both() {
        let row = |time: f64, error: f64, recall: f64| Row {
            name: String::new(),
            work: Some((1.0, 1.0)),
            time: Time { median: time, best: time },
            errors: [error; 3],
            recall,
            best: false,
        };
        let mut rows = [row(10.0, 0.3, 1.0), row(20.0, 0.2, 1.0), row(30.0, 0.25, 1.0), row(5.0, 0.1, 0.4)];
        mark_best(&mut rows);
        assert_eq!(rows.map(|row| row.best), [true, true, false, false]);
    }
}
