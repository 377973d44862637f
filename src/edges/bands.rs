//! From the rows of the picture to ridge points, in bands of rows that are processed in parallel.
//!
//! A band also computes the rows above and below it that its filters reach. Every sum lies within one band and runs in
//! the same order as without bands, so the number of bands changes nothing. A cell in which values are averaged
//! belongs to the band in which it begins, and bands begin where the largest cells begin.

use std::ops::Range;

use pulp::Arch;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::gradient::Gradient;
use super::maxima::MaximaFinder;
use super::params::Params;
use super::ridge::RidgePoint;
use super::side_statistics::{self, StatisticsBuilder};
use crate::raster::Raster;
use crate::raster::lab;

/// Bands per core: more than one, because bands with more edges take longer.
const BANDS_PER_CORE: usize = 2;
/// Least number of rows in a band: the rows that are computed twice should be few in comparison.
const MIN_ROWS: usize = 64;

/// The ridge points in reading order, and the statistics of the colours beside them. `weights` has the weight of each
/// colour plane.
pub(super) fn scan(raster: &Raster, weights: &[f32], params: &Params) -> (Vec<RidgePoint>, StatisticsBuilder) {
    let bands: Vec<_> = split(raster, params).into_par_iter().map(|rows| band(raster, weights, params, rows)).collect();
    let count: usize = bands.iter().map(|(points, _)| points.len()).sum();
    let mut bands = bands.into_iter();
    // there is always a first band
    let (mut points, mut sides) = bands.next().unwrap_or_else(|| band(raster, weights, params, 0..0));
    points.reserve_exact(count - points.len());
    for (more, of_band) in bands {
        points.extend(more);
        sides.append(of_band);
    }
    (points, sides)
}

/// The rows of each band.
fn split(raster: &Raster, params: &Params) -> Vec<Range<usize>> {
    let height = raster.size().height as usize;
    let cores = rayon::current_num_threads();
    let wanted = if cores > 1 { (BANDS_PER_CORE * cores).min(height / MIN_ROWS).max(1) } else { 1 };
    let cell_starts = side_statistics::cell_starts(raster.size(), params);
    // the first cell at or below each equal division of the height
    let mut starts: Vec<usize> = (0..wanted)
        .filter_map(|band| cell_starts.iter().copied().find(|start| *start >= band * height / wanted))
        .collect();
    starts.dedup();
    let ends = starts.iter().skip(1).copied().chain([height]);
    starts.iter().copied().zip(ends).map(|(start, end)| start..end).collect()
}

/// Processes the rows `own`.
fn band(raster: &Raster, weights: &[f32], params: &Params, own: Range<usize>) -> (Vec<RidgePoint>, StatisticsBuilder) {
    let arch = Arch::new();
    let (size, planes) = (raster.size(), lab::planes(raster));
    let wider =
        |rows: &Range<usize>, by: usize| rows.start.saturating_sub(by)..(rows.end + by).min(size.height as usize);
    let both = |a: &Range<usize>, b: &Range<usize>| match b.is_empty() {
        true => a.clone(),
        false => a.start.min(b.start)..a.end.max(b.end),
    };

    let mut sides = StatisticsBuilder::new(size, planes, params, own.clone());
    let mut maxima = MaximaFinder::new(size, params, own.clone());
    let tensors = both(&wider(&own, maxima.reach()), &sides.tensor_rows());
    let mut gradient = Gradient::new(size, planes, params.sigma, tensors.clone());
    let rows = both(&wider(&tensors, gradient.reach()), &sides.colour_rows());
    maxima.start(tensors.start);
    gradient.start(rows.start);
    sides.start(rows.start, tensors.start);

    let mut lab = vec![vec![0.0; size.width as usize]; planes];
    for y in rows {
        lab::row(arch, raster, y, &mut lab);
        // without the weights: means over whole cells have little noise left
        sides.push_colours(&lab);
        for (plane, &weight) in lab.iter_mut().zip(weights).filter(|(_, weight)| **weight < 1.0) {
            plane.iter_mut().for_each(|v| *v *= weight);
        }
        gradient.push(&lab, |tensor| {
            sides.push_tensor(tensor);
            maxima.push(tensor);
        });
    }
    gradient.finish(|tensor| {
        sides.push_tensor(tensor);
        maxima.push(tensor);
    });
    (maxima.finish(), sides)
}
