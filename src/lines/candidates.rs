//! What is to be drawn as far as there is room for it: contours on the sheet, joined, each stroke as one centreline,
//! and outlines of regions.

use rayon::iter::{IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator};

use super::clearance::Cleared;
use super::loose::loose_ends;
use super::lost::{LossTally, Lost, LostScale, STANDS, gaps, gone};
use super::marks::{HeadMark, TickMark};
use super::outlines::{Outlines, Rank};
use super::params::{PagePart, Params};
use super::points::{self, Point};
use super::standing::StandingEnds;
use super::tears::torn;
use super::ticks::{ThinnedScale, alone, crossbars};
use super::vertex::{Vertex, nearby};
use super::{arrowheads, centreline, extension_lines, faint, few, join, lead_on, links, saliency, ticks, weight};
use crate::edges::{ChainRange, Edges};
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, PageTransform};

/// What is to be drawn as far as there is room for it.
pub(super) struct LineCandidates {
    /// Contours, and after them outlines of regions.
    pub(super) lines: Vec<(Polyline<Vertex>, Rank)>,
    /// The saliency of each.
    pub(super) saliencies: Vec<f32>,
    /// How many of them are contours.
    contours: usize,
    /// How many gridlines an overview leaves out.
    gridlines: usize,
    /// What is too short for a line.
    pub(super) short: LossTally,
    /// Points on lines.
    pub(super) points: Vec<Point>,
    /// The ticks of scales that are handed on, to be drawn as dots.
    pub(super) scales: Vec<Vec<TickMark>>,
    /// The ticks that are left out of scales whose others are lines.
    pub(super) left_out: Vec<TickMark>,
    /// Those scales.
    lost_scales: Vec<LostScale>,
    /// The heads of arrows.
    pub(super) heads: Vec<HeadMark>,
}

impl LineCandidates {
    /// Those of a picture, in `area`, the part of the sheet where `transform` puts it.
    pub(super) fn of(
        edges: &Edges,
        outlines: &Outlines,
        transform: &PageTransform,
        area: MmRect,
        params: &Params,
    ) -> Self {
        let mut polylines = on_the_sheet(edges, transform, params);
        // an overview is felt for its shapes
        let is_overview = params.in_overview_of_drawing();
        let gridlines = if is_overview { faint::take_gridlines(&mut polylines) } else { 0 };
        let heads = if params.of_drawing { arrowheads::take(&mut polylines, area, params) } else { Vec::new() };
        extension_lines::keep_apart(&mut polylines, &heads, area, params);
        let takes_points = params.of_drawing && params.takes_points;
        let points = if takes_points { points::take(&mut polylines, params) } else { Vec::new() };
        // dots of lines give way one by one
        if !params.on_dots() {
            points::make_room(&points, &mut polylines, params);
        }
        let spurs = if is_overview { ticks::spurs::take(&mut polylines, area, params) } else { Vec::new() };
        let standing = StandingEnds::of(&mut polylines, area, params);
        let lengthens = params.of_drawing && !is_overview;
        let are_ticks = if lengthens { ticks::of_scales(&polylines, area, params) } else { Vec::new() };
        let gap = params.bridged_gap();
        let mut polylines = join::join_but_ticks(polylines, &are_ticks, gap, &standing, params.of_drawing);
        let at_points: Vec<MmPoint> = points.iter().map(|point| point.at).collect();
        let (scales, thinned) =
            if lengthens { lengthened(&mut polylines, &at_points, area, params) } else { (Vec::new(), Vec::new()) };
        let lost_scales = thinned.iter().map(|scale| scale.lost).collect();
        let left_out = thinned.into_iter().flat_map(|scale| scale.left_out).collect();
        let (mut polylines, mut short) = long_enough(polylines, &standing, area, params);
        spurs.iter().for_each(|spur| short.add(spur));
        polylines.iter_mut().for_each(Polyline::fill);
        let contours = polylines.len();
        let (of_regions, of_outlines): (Vec<_>, Vec<_>) = outlines.on_the_sheet(transform, params).into_iter().unzip();
        polylines.extend(of_regions);
        if is_overview {
            lead_on::put_corners(&mut polylines, area, params);
        }
        lead_on::extend(&mut polylines, area, params.bridged_gap());
        polylines.par_iter_mut().for_each(|polyline| weight::assign(polyline, params));
        let ranks = ranks(&polylines, &of_outlines, area, params);
        let saliencies = saliency::saliencies(&polylines, params);
        let lines = polylines.into_iter().zip(ranks).collect();
        Self { lines, saliencies, contours, gridlines, short, points, scales, left_out, lost_scales, heads }
    }

    /// What of those contours that have at least this saliency is not `drawn`, and what is too short. Of a photograph,
    /// pieces that `had_room` and are less salient are not lost for want of room: a contour may be worth a line as a
    /// whole, and what is left of it beside others may not.
    pub(super) fn lost(
        &self,
        drawn: &[&Cleared],
        had_room: &[Cleared],
        least: f32,
        area: MmRect,
        params: &Params,
    ) -> Lost {
        let salient = self.lines[..self.contours].iter().zip(&self.saliencies).filter(|(_, of)| **of >= least);
        let contours: Vec<_> = salient.map(|((line, _), _)| line).collect();
        let mut wanted = self.short;
        contours.iter().for_each(|polyline| wanted.add(polyline));
        let mut kept = LossTally::new(area);
        if params.of_drawing {
            drawn.iter().for_each(|line| kept.add(&line.polyline));
        } else {
            // an outline stands for the contours along it
            let lines = nearby(had_room.iter().map(|line| &line.polyline), area, params);
            let stands = |at: MmPoint| lines.nearest(at, params.max_offset(), |_| true).is_some();
            contours.iter().for_each(|polyline| kept.add_where(polyline, stands));
            kept.count_rings(drawn.iter().map(|line| &line.polyline));
        }
        let lost = wanted.lost(&kept);
        // an overview is told as a whole, and a line that is too short for one by what it is
        let is_told = params.of_drawing && params.part == PagePart::Figure;
        let polylines = || drawn.iter().map(|line| &line.polyline);
        let gone = if is_told && lost.lost >= params.min_length {
            gone(&contours, polylines(), area, params)
        } else {
            Vec::new()
        };
        // elsewhere lines may be longer than they were
        let may_be_open = is_told && lost.by_place.iter().any(|mm| *mm >= STANDS);
        let gaps = if may_be_open { gaps(&contours, polylines(), area, params) } else { Vec::new() };
        let torn = if may_be_open { torn(&contours, polylines(), area, params) } else { Vec::new() };
        // rows of dots end elsewhere, and are led on to others after this
        let may_be_loose = may_be_open && !params.on_dots();
        let loose = if may_be_loose { loose_ends(&contours, polylines(), &torn, area, params) } else { Vec::new() };
        Lost { gone, gaps, torn, loose, gridlines: self.gridlines, scales: self.lost_scales.clone(), ..lost }
    }
}

/// Those of the joined contours that are long enough for lines, each stroke as one centreline, and short ones that lead
/// from line to line; and what is too short.
fn long_enough(
    mut polylines: Vec<Polyline<Vertex>>,
    standing: &StandingEnds,
    area: MmRect,
    params: &Params,
) -> (Vec<Polyline<Vertex>>, LossTally) {
    let mut short = LossTally::new(area);
    // Of full strength and shorter than a link, or weaker and not longer in proportion, it has joined nothing and will
    // not: it is not looked at further.
    let shortest = links::shortest(params);
    let is_crumb = |polyline: &Polyline<Vertex>| polyline.weighted_length(params.full_strength) < shortest;
    if params.of_drawing {
        polylines.iter().filter(|polyline| is_crumb(polyline)).for_each(|polyline| short.add(polyline));
    }
    polylines.retain(|polyline| !is_crumb(polyline));
    let whole = if params.of_drawing { links::short_ones(&polylines, area, params) } else { None };
    let polylines = centreline::merge(polylines, area, params);
    // Where one side of a stroke ends and the other goes on, the centreline goes on with it.
    let polylines = join::join(polylines, params.bridged_gap(), standing, params.of_drawing);
    let is_long = |polyline: &Polyline<Vertex>| polyline.length() >= params.min_length;
    let (mut long, mut rest): (Vec<_>, Vec<_>) = polylines.into_iter().partition(is_long);
    if params.of_drawing {
        let links = whole.map(|whole| links::take(&mut rest, &long, &whole, area, params));
        rest.iter().for_each(|polyline| short.add(polyline));
        long.extend(links.into_iter().flatten());
    }
    (long, short)
}

/// The rank of each line: the last are outlines of regions, of these ranks.
fn ranks(polylines: &[Polyline<Vertex>], of_outlines: &[Rank], area: MmRect, params: &Params) -> Vec<Rank> {
    let contours = polylines.len() - of_outlines.len();
    let closed_outlines = nearby(polylines[contours..].iter().filter(|line| line.closed), area, params);
    let is_ring =
        |line: &Polyline<Vertex>| Rank::may_be_ring(line, params) && !Rank::is_along(line, &closed_outlines, params);
    let all_outlines = nearby(polylines[contours..].iter(), area, params);
    let is_curve =
        |line: &Polyline<Vertex>| Rank::may_be_curve(line, params) && !Rank::is_along(line, &all_outlines, params);
    // in the figure others have made room for them already
    let is_first = |line: &Polyline<Vertex>| params.part == PagePart::Overview && few::is_of_person(line);
    let rank = |(number, line): (usize, &Polyline<Vertex>)| match number {
        _ if is_first(line) => Rank::Person,
        _ if faint::is_faint(line) => Rank::Faint,
        _ if of_outlines.is_empty() => Rank::Ordinary,
        _ if number < contours && (is_ring(line) || is_curve(line)) => Rank::Untorn,
        _ if number < contours => Rank::of(line),
        _ => of_outlines[number - contours],
    };
    polylines.iter().enumerate().map(rank).collect()
}

/// Makes the marks on the lines of a drawing as long as fingers need them; gives the scales whose ticks are handed on,
/// to be drawn as dots, and those of which ticks are left out. `points` are those on lines.
fn lengthened(
    polylines: &mut Vec<Polyline<Vertex>>,
    points: &[MmPoint],
    area: MmRect,
    params: &Params,
) -> (Vec<Vec<TickMark>>, Vec<ThinnedScale>) {
    // a page of few shapes has no marks: its ticks are lines
    let (scales, thinned) = if params.on_dots() && params.most_shapes.is_none() {
        (ticks::take(polylines, area, params), Vec::new())
    } else {
        (Vec::new(), ticks::lengthen(polylines, points, area, params))
    };
    crossbars::lengthen(polylines, area, params);
    alone::lengthen(polylines, area, params);
    (scales, thinned)
}

/// The contours on the sheet, in an order and in directions that do not depend on where in the picture each was found
/// first.
fn on_the_sheet(edges: &Edges, transform: &PageTransform, params: &Params) -> Vec<Polyline<Vertex>> {
    let polyline = |range: &ChainRange| {
        let chain = edges.chain(range);
        let polyline = Polyline::of_chain(chain, range.kind, transform);
        let polyline = if range.kind.faint { faint::weaken(polyline, params) } else { polyline };
        let polyline = match range.kind.exact {
            // exact paths are not smoothed: their corners are meant
            true => polyline,
            false if range.kind.of_drawing => polyline.smoothed_between_corners(params.smoothing),
            false => polyline.smoothed(params.smoothing).evened(),
        };
        let polyline = polyline.stronger_half_first();
        (polyline.path().map(|v| f64::from(v.strength)).sum::<f64>(), polyline)
    };
    let mut polylines: Vec<(f64, Polyline<Vertex>)> = edges.chains.par_iter().map(polyline).collect();
    polylines.sort_by(|a, b| b.0.total_cmp(&a.0));
    polylines.into_iter().map(|(_, polyline)| polyline).collect()
}

#[cfg(test)]
mod tests;
