//! Contours become lines that a finger can follow: on the sheet, in millimetres.
//!
//! ```text
//! Edges -> smooth -> [overview: gridlines out] -> arrowheads and points (taken out)
//!       -> join (ends that continue one another) -> [figure: ticks, crossbars, strokes alone (lengthened)]
//!       -> centreline (the two sides of a thin stroke become one line) -> join
//!       -> outlines (of regions, which go before other lines)
//!       -> lead_on (ends extended to lines before them) -> weight (width by strength)
//!       -> clearance (no two too near; `crowded` tries it in several ways)
//!       -> detail (the most salient lines) -> few -> points and arrowheads (drawn) -> simplify -> Lines
//! ```

mod arrowheads;
mod candidates;
mod centreline;
mod clearance;
mod corner;
mod crowded;
mod extension_lines;
mod faint;
mod few;
mod join;
mod lead_on;
mod line;
mod links;
mod loose;
mod lost;
mod marks;
mod outlines;
mod params;
mod points;
mod row_marks;
mod saliency;
mod standing;
mod tears;
mod ticks;
mod vertex;
mod weight;
mod whole;

#[cfg(test)]
mod tests;

use arrowheads::DrawnHeads;
use candidates::LineCandidates;
use clearance::Cleared;
use points::{DrawnPoints, Point};
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use vertex::Vertex;
pub(crate) use vertex::{CORNER, CORNER_ARMS};

pub use arrowheads::{Arrow, arrowhead, arrows, is_triangle};
pub(crate) use clearance::{APART, BEND, BEND_LEAST, HIGHEST_STACK, TOUCH};
pub(crate) use corner::{SHARPEST, STRAIGHTNESS};
pub use faint::which_are_weak;
pub use few::Beyond;
pub(crate) use line::index_of_lines;
pub use line::{HeavyStrokes, Height, Line, Pen, Run};
pub(crate) use lost::{GAP, is_cross, lost_form};
pub use lost::{GONE, Lost, LostLine, LostMarks, LostScale, LostSign, SignKind};
pub use marks::{HeadMark, LineMarks, PointMark, TickMark, whole_series};
pub use outlines::Outlines;
use outlines::Rank;
pub(crate) use params::{APPROACH_OF_DRAWINGS, CLUSTER_APPROACH};
pub use params::{LineMedium, PagePart, Params, farthest_moved};
pub(crate) use points::LARGEST_HOLLOW;
pub(crate) use tears::{TORN, TearParams, tears};
pub(crate) use ticks::found::{LONGEST_TICK, SHORTEST_TICK};
pub(crate) use ticks::selections::{MOST_BLOCKED, tick_selections};

use crate::edges::{ChainRange, Edges};
use crate::geom::polyline::Polyline;
use crate::units::{MmRect, PageTransform};

/// The lines of a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lines {
    /// The rings of hollow points on lines, then all others, the weightiest first, and then the heads of arrows.
    pub lines: Vec<Line>,
    /// Points and ticks on them that are handed on, and the heads of arrows.
    pub marks: LineMarks,
    /// What is not drawn for want of room.
    pub lost: Lost,
    /// What is not drawn as it is beyond the most that were asked for.
    pub beyond: Beyond,
}

/// Which contours of a drawing are shafts of arrows.
pub(crate) fn are_shafts(edges: &Edges, transform: &PageTransform, area: MmRect) -> Vec<bool> {
    let polyline = |range: &ChainRange| Polyline::of_chain(edges.chain(range), range.kind, transform);
    arrowheads::are_shafts(&edges.chains.iter().map(polyline).collect::<Vec<_>>(), area)
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
    let params = Params { of_drawing: edges.of_drawing(), ..*params };
    let candidates = |params: &Params| LineCandidates::of(edges, outlines, transform, area, params);
    let (candidates, mut cleared, params) = crowded::cleared(candidates, area, params);
    few::keep_beside_outlines(&mut cleared, outlines);
    faint::drop_short_faint(&mut cleared, &candidates.lines, &params);
    // Detail comes last and takes whole lines, so that less of it is a subset; what the picture is about, and what a
    // person drew, stays.
    let most = cleared.iter().map(|line| line.saliency).fold(0.0, f32::max);
    let least = saliency::least(most, &params);
    let is_meant = |line: &Cleared| line.rank == Rank::Subject || few::is_of_person(&line.polyline);
    let stays = |line: &&Cleared| line.saliency >= least || is_meant(line);
    let mut drawn: Vec<_> = cleared.iter().filter(stays).collect();
    links::drop_loose(&mut drawn, area, &params);
    let mut lost = candidates.lost(&drawn, &cleared, least, area, &params);
    // What follows is left out on purpose, and not lost.
    let mut beyond = few::keep(&mut drawn, outlines.shapes, area, &params);
    links::drop_loose(&mut drawn, area, &params);
    // A page of few shapes has no points; each is a shape that is left out.
    let points = if params.most_shapes.is_none() { &candidates.points[..] } else { &[] };
    beyond.shapes += candidates.points.len() - points.len();
    let LineCandidates { scales, left_out, heads, .. } = &*candidates;
    let (scales, left_out, heads) = (scales.clone(), left_out.clone(), heads.clone());
    let mut marks = LineMarks { points: Vec::new(), scales, left_out, heads };
    let (points, heads) = if params.on_dots() {
        marks.points = points.iter().map(Point::mark).collect();
        let polylines: Vec<_> = drawn.iter().map(|line| &line.polyline).collect();
        arrowheads::find_shafts(&mut marks.heads, &polylines);
        (DrawnPoints::default(), DrawnHeads::default())
    } else {
        let polylines: Vec<_> = drawn.iter().map(|line| &line.polyline).collect();
        let points = points::draw(points, &polylines, area, &params);
        lost.add(&points.stubs(&polylines, &params), area);
        lost.add_crosses(&points.hidden(&polylines, &params), area, &params);
        let heads = arrowheads::draw(&mut marks.heads, &polylines, &points.discs, area, &params);
        (points, heads)
    };
    lost.rings += points.lost;
    lost.signs.extend(points.lost_discs.iter().map(|&at| LostSign { at, kind: SignKind::Point }));
    Lines { lines: finished(&drawn, &points, &heads, &params), marks, lost, beyond }
}

/// The lines as they are drawn: the rings of hollow points, then lines with their beads, then the heads of arrows.
fn finished(drawn: &[&Cleared], points: &DrawnPoints, heads: &DrawnHeads, params: &Params) -> Vec<Line> {
    let finish = |(number, line): (usize, &&Cleared)| -> Vec<Line> {
        let (shaft, anchored) = heads.shaft(number, &line.polyline, &line.anchored);
        let parts = points.parts(number, &shaft, &anchored, params);
        parts.iter().filter_map(|part| weight::finish(&part.polyline, &part.anchored, params)).collect()
    };
    let finish_mark = |mark: &Polyline<Vertex>| weight::finish(mark, &vec![false; mark.vertices.len()], params);
    // on a grid of dots the first lines get the dots that they need
    let mut lines: Vec<Line> = points.rings.iter().filter_map(finish_mark).collect();
    let others: Vec<Line> = drawn.par_iter().enumerate().flat_map_iter(finish).collect();
    lines.extend(others);
    lines.extend(heads.heads.iter().filter_map(finish_mark));
    lines
}
