//! The rows of the picture, from colours to ridge points, in bands that the cores take side by side.
//!
//! A band computes some rows above and below it once more, as many as the filters reach. Every sum is made within one band
//! and in the same order as without bands, so their number changes nothing: a cell in which values are averaged belongs to
//! the band in which it begins, and bands begin where the largest cells do.

use std::ops::Range;

use pulp::Arch;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::gradient::Gradient;
use super::sides;
use super::thin::{Ridge, Thinner};
use super::{Params, lab};
use crate::raster::Raster;

/// Bands for a core: more than one, since there is more to do where there are more edges.
const FOR_A_CORE: usize = 2;
/// Rows of a band, at least: the rows computed twice should be few beside them.
const LEAST_ROWS: usize = 64;

/// The ridge points in reading order, and what lies at their sides. `weights` is what each colour plane counts.
pub(super) fn walk(raster: &Raster, weights: &[f32], params: &Params) -> (Vec<Ridge>, sides::Builder) {
    let bands: Vec<_> = split(raster, params).into_par_iter().map(|rows| band(raster, weights, params, rows)).collect();
    let count: usize = bands.iter().map(|(points, _)| points.len()).sum();
    let mut bands = bands.into_iter();
    // there is always a first
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
    let wanted = if cores > 1 { (FOR_A_CORE * cores).min(height / LEAST_ROWS).max(1) } else { 1 };
    let places = sides::rows_of_cells(raster.size(), params);
    // the first place from each border on
    let mut starts: Vec<usize> =
        (0..wanted).filter_map(|band| places.iter().copied().find(|place| *place >= band * height / wanted)).collect();
    starts.dedup();
    let ends = starts.iter().skip(1).copied().chain([height]);
    starts.iter().copied().zip(ends).map(|(start, end)| start..end).collect()
}

fn band(raster: &Raster, weights: &[f32], params: &Params, own: Range<usize>) -> (Vec<Ridge>, sides::Builder) {
    let arch = Arch::new();
    let (size, planes) = (raster.size(), lab::planes(raster));
    let wider =
        |rows: &Range<usize>, by: usize| rows.start.saturating_sub(by)..(rows.end + by).min(size.height as usize);
    let both = |a: &Range<usize>, b: &Range<usize>| match b.is_empty() {
        true => a.clone(),
        false => a.start.min(b.start)..a.end.max(b.end),
    };

    let mut sides = sides::Builder::new(size, planes, params, own.clone());
    let mut thinner = Thinner::new(size, params, own.clone());
    let tensors = both(&wider(&own, thinner.reach()), &sides.rows_of_tensors());
    let mut gradient = Gradient::new(size, planes, params.sigma, tensors.clone());
    let rows = both(&wider(&tensors, gradient.reach()), &sides.rows_of_colours());
    thinner.start(tensors.start);
    gradient.start(rows.start);
    sides.start(rows.start, tensors.start);

    let mut lab = vec![vec![0.0; size.width as usize]; planes];
    for y in rows {
        lab::row(arch, raster, y, &mut lab);
        // as they are: means over whole cells have little noise left
        sides.push_colours(&lab);
        for (plane, &weight) in lab.iter_mut().zip(weights).filter(|(_, weight)| **weight < 1.0) {
            plane.iter_mut().for_each(|v| *v *= weight);
        }
        gradient.push(&lab, |tensor| {
            sides.push_tensor(tensor);
            thinner.push(tensor);
        });
    }
    gradient.finish(|tensor| {
        sides.push_tensor(tensor);
        thinner.push(tensor);
    });
    (thinner.finish(), sides)
}
