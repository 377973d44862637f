//! Contours become lines that a finger can follow: on the sheet, in millimetres.
//!
//! ```text
//! Edges -> smooth -> join (ends that continue one another)
//!       -> centreline (the two sides of a thin stroke become one line) -> join
//!       -> junction (ends extended to lines before them) -> weight (width by strength)
//!       -> clearance (no two too near) -> detail (the most salient lines) -> simplify -> Lines
//! ```
//!
//! Outlines of regions, where there are any (`outlines`), come in before `junction`, and go before other lines in
//! `clearance`.

mod centreline;
mod clearance;
mod corner;
mod few;
mod join;
mod junction;
mod line;
mod lost;
mod outlines;
mod params;
mod saliency;
mod vertex;
mod weight;

#[cfg(test)]
mod tests;

use clearance::Cleared;
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator};
use vertex::Vertex;

use lost::Tally;
use outlines::Rank;

pub use few::Beyond;
pub use line::{Height, Line, Pen, Run};
pub use lost::Lost;
pub use outlines::Outlines;
pub use params::Params;

use crate::edges::{ChainRange, Edges};
use crate::geom::nearby::{Nearby, Segment};
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, PageTransform};

/// The lines of a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lines {
    /// The weightiest line comes first.
    pub lines: Vec<Line>,
    /// What is not drawn for want of room.
    pub lost: Lost,
    /// What is not drawn as it is beyond the most that were asked for.
    pub beyond: Beyond,
}

/// Draws the contours in `area`, the part of the sheet where `transform` puts the picture.
pub fn draw(edges: &Edges, transform: &PageTransform, area: MmRect, params: &Params) -> Lines {
    draw_with(edges, &Outlines::default(), transform, area, params)
}

/// [`draw`] with outlines of regions.
pub fn draw_with(
    edges: &Edges,
    outlines: &Outlines,
    transform: &PageTransform,
    area: MmRect,
    params: &Params,
) -> Lines {
    let mut wanted = Tally::new(area);
    let mut polylines = whole(edges, transform, area, params, &mut wanted);
    let first_outline = polylines.len();
    polylines.extend(outlines.on_the_sheet(transform, params));
    junction::extend(&mut polylines, area, params.join_gap);
    polylines.par_iter_mut().for_each(|polyline| weight::assign(polyline, params));

    let saliencies: Vec<f32> = polylines.par_iter().map(|polyline| saliency::saliency(polyline, params)).collect();
    let all = polylines.clone();
    let has_outlines = first_outline < all.len();
    let rank = |(number, line): (usize, &Polyline<Vertex>)| match number {
        _ if !has_outlines => Rank::Ordinary,
        _ if number < first_outline => Rank::of(line),
        _ => Rank::Outline,
    };
    let ranks: Vec<Rank> = polylines.iter().enumerate().map(rank).collect();
    let mut cleared = clearance::clear(polylines.into_iter().zip(ranks).collect(), area, params);
    if let Some((most, length)) = outlines.others {
        keep_others(&mut cleared, most, length);
    }
    // Detail comes last and takes whole lines, so that less of it is a subset.
    let least = saliency::least(cleared.first().map_or(0.0, |line| line.saliency), params);
    let salient = all[..first_outline].iter().zip(&saliencies).filter(|(_, of)| **of >= least);
    let contours: Vec<&Polyline<Vertex>> = salient.map(|(polyline, _)| polyline).collect();
    contours.iter().for_each(|polyline| wanted.add(polyline));
    let mut drawn: Vec<&Cleared> = cleared.iter().filter(|line| line.saliency >= least).collect();
    let lost = wanted.lost(&kept(&contours, &drawn, has_outlines, area, params));
    // What follows is left out on purpose, and not lost.
    let beyond = match params.most_shapes {
        Some(most) if edges.of_drawing() => {
            let all = nearby(drawn.iter().map(|line| &line.polyline), area, params);
            few::keep_first_things(&mut drawn, most, &all, params)
        }
        Some(most) => few::keep_first(&mut drawn, most, outlines.shapes),
        None => Beyond::default(),
    };
    let finish = |line: &Cleared| weight::finish(&line.polyline, &line.anchored, params);
    Lines { lines: drawn.into_par_iter().filter_map(finish).collect(), lost, beyond }
}

/// The contours on the sheet that are long enough for lines, joined, each stroke as one centreline. Of a drawing, in
/// which every line is meant, those that are too short are counted in `wanted`.
fn whole(
    edges: &Edges,
    transform: &PageTransform,
    area: MmRect,
    params: &Params,
    wanted: &mut Tally,
) -> Vec<Polyline<Vertex>> {
    let mut polylines = join::join(on_the_sheet(edges, transform, params), params.join_gap);
    let is_crumb =
        |polyline: &Polyline<Vertex>| polyline.weighted_length(params.full_strength) < CRUMB * params.min_length;
    if edges.of_drawing() {
        polylines.iter().filter(|polyline| is_crumb(polyline)).for_each(|polyline| wanted.add(polyline));
    }
    polylines.retain(|polyline| !is_crumb(polyline));
    let polylines = centreline::merge(polylines, area, params);
    // Where one side of a stroke ends and the other goes on, the centreline goes on with it.
    let mut polylines = join::join(polylines, params.join_gap);
    if edges.of_drawing() {
        let is_short = |polyline: &&Polyline<Vertex>| polyline.length() < params.min_length;
        polylines.iter().filter(is_short).for_each(|polyline| wanted.add(polyline));
    }
    polylines.retain(|polyline| polyline.length() >= params.min_length);
    polylines.iter_mut().for_each(Polyline::fill);
    polylines
}

/// Where there are outlines, keeps beside them the first `most` lines of at least `length` mm.
fn keep_others(cleared: &mut Vec<Cleared>, most: usize, length: f32) {
    if cleared.iter().all(|line| line.rank != Rank::Outline) {
        return;
    }
    let mut count = 0;
    cleared.retain(|line| {
        let is_outline = line.rank == Rank::Outline;
        count += usize::from(!is_outline && line.polyline.length() >= length);
        is_outline || (count <= most && line.polyline.length() >= length)
    });
}

/// How much of the contours is drawn.
fn kept(
    contours: &[&Polyline<Vertex>],
    drawn: &[&Cleared],
    has_outlines: bool,
    area: MmRect,
    params: &Params,
) -> Tally {
    let mut kept = Tally::new(area);
    if has_outlines {
        // an outline stands for the contours along it
        let lines = nearby(drawn.iter().map(|line| &line.polyline), area, params);
        let stands = |at: MmPoint| lines.nearest(at, params.max_offset(), |_| true).is_some();
        contours.iter().for_each(|polyline| kept.add_where(polyline, stands));
        kept.count_rings(drawn.iter().map(|line| &line.polyline));
    } else {
        drawn.iter().for_each(|line| kept.add(&line.polyline));
    }
    kept
}

/// The segments of lines, to be found by their places.
fn nearby<'a>(lines: impl Iterator<Item = &'a Polyline<Vertex>>, area: MmRect, params: &Params) -> Nearby {
    let mut segments = Nearby::new(area, params.max_spacing());
    for (line, polyline) in (0..).zip(lines) {
        for (index, (a, b)) in (0..).zip(polyline.segments()) {
            segments.insert(Segment { a: a.at, b: b.at, half_width: 0.0, line, index, arc: 0.0 });
        }
    }
    segments
}

/// The contours on the sheet, in an order and in directions that do not depend on where in the picture each was found
/// first.
fn on_the_sheet(edges: &Edges, transform: &PageTransform, params: &Params) -> Vec<Polyline<Vertex>> {
    let polyline = |range: &ChainRange| {
        let chain = edges.chain(range);
        let polyline = Polyline::of_chain(chain, range.kind, transform);
        let polyline = match range.kind.exact {
            // its corners are corners
            true => polyline,
            false if range.kind.drawn => polyline.smoothed_between_corners(params.smoothing),
            false => polyline.smoothed(params.smoothing).evened(),
        };
        let polyline = polyline.stronger_half_first();
        (polyline.path().map(|v| f64::from(v.strength)).sum::<f64>(), polyline)
    };
    let mut polylines: Vec<(f64, Polyline<Vertex>)> = edges.chains.par_iter().map(polyline).collect();
    polylines.sort_by(|a, b| b.0.total_cmp(&a.0));
    polylines.into_iter().map(|(_, polyline)| polyline).collect()
}

/// A line of full strength shorter than this share of the least length, or a weaker one that is not longer in
/// proportion, has joined nothing and will not: it is not looked at further.
const CRUMB: f32 = 0.5;
