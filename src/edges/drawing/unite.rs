//! Of contours that coincide one is kept: the shared border of two areas, the outline of an area under its stroke.

use std::cmp::Reverse;

use lyon::geom::euclid::Box2D;

use super::confirm::most_hidden;
use super::proposal::{Confirmed, SegmentRun, stretches};
use crate::edges::edgel::{Edgel, Edges};
use crate::edges::faint::{FaintStrokes, ONE_WIDTH, WeighedStroke};
use crate::geom::nearby::Index;
use crate::geom::polyline::Polyline;
use crate::geom::{nearest_on_segment, order};
use crate::units::{Px, PxPoint, PxVector, Size};

/// Two contours this near to one another, px, are one if they are parallel; beside the half width of a stroke.
const SAME: f32 = 0.75;
/// Least cosine between the directions of two contours that are one (18 degrees).
const PARALLEL: f32 = 0.95;
/// What is left of a contour and shorter than this, px, is dropped.
const SHORTEST: f32 = 2.0;
/// Side of the cells of the index, px.
const CELL: f32 = 8.0;

/// A stroke on another one is told from it by its contrast if the two differ by this share of that of the other: a blue
/// window in a black wall has 1.27 times its contrast. Chosen by us.
const OTHER_CONTRAST: f32 = 0.15;

/// So many other lines of a grid are like one that lies on an axis, at least.
const LIKE_IT: usize = 2;

/// A bend of this many degrees between segments is a corner.
const CORNER: f32 = 25.0;

/// The contours without those parts that coincide with one before them. Strokes come before outlines and these before
/// faint strokes, as a line of a grid on the top of a bar; then those with the longest side between two corners: so a
/// side that goes on beyond the other's corners is whole, and the other ends on it. What comes is of one proposal after
/// the other, in the order in which strokes are painted. Also gives the middles of strokes that lie as a whole on
/// others from which the eye tells them.
pub(super) fn merged_coincident(confirmed: Vec<Vec<Confirmed>>, size: Size) -> (Vec<Confirmed>, Vec<PxPoint>) {
    let mut confirmed = with_faint_strokes(confirmed);
    let rank = |contour: &Confirmed| contour.stroke.map_or(1, |_| 2 * u8::from(contour.faint));
    // in whole pixels: rounding decides nothing
    confirmed.sort_by_cached_key(|(_, contour)| (rank(contour), Reverse(longest_side(&contour.line).round() as u32)));
    let mut covered = Covered::new(size);
    let (mut kept, mut overlaid) = (Vec::with_capacity(confirmed.len()), Vec::new());
    for (painted, contour) in confirmed {
        let parts = uncovered(&contour, &covered);
        if parts.is_empty() && is_seen_on_others(&contour, painted, &covered) {
            overlaid.push(contour);
        }
        for part in &parts {
            let reach = SAME + 0.5 * part.stroke.unwrap_or(0.0);
            covered.add(&part.line, reach, painted);
        }
        kept.extend(parts);
    }
    let middle = |of: &Confirmed| of.line.vertices.get(of.line.vertices.len() / 2).map(|vertex| vertex.at);
    let extents: Vec<(f32, PxVector)> = kept.iter().filter_map(extent).collect();
    let overlaid = overlaid.iter().filter(|of| !has_others_like_it(of, &extents)).filter_map(middle).collect();
    (kept, overlaid)
}

/// Whether the eye tells a stroke from those on which it lies, as a window of a plan from its wall. One that is painted
/// before them is hidden, as the line of a grid at 0 below an axis. A short one has the contrast of what crosses it, as
/// a tick on the other axis, or the end of a white stroke below a point; and a closed one, as the border of an area
/// that all its neighbours have too, that of other grounds than they have elsewhere.
fn is_seen_on_others(contour: &Confirmed, painted: usize, covered: &Covered) -> bool {
    let Confirmed { line, stroke, faint, .. } = contour;
    if stroke.is_none() || *faint || line.closed || line.length() < most_hidden(*stroke) {
        return false;
    }
    let cover: Vec<&PathPiece> = line.segments().filter_map(|(a, b)| covered.piece_at(a.at.lerp(b.at, 0.5))).collect();
    let later = cover.iter().filter(|piece| piece.painted > painted).count();
    let of_cover = order::middle(cover.iter().map(|piece| piece.strength).collect());
    2 * later <= cover.len() && of_cover > 0.0 && (strength(line) - of_cover).abs() > OTHER_CONTRAST * of_cover
}

/// The width of a stroke, and the way from one of its ends to the other.
fn extent(of: &Confirmed) -> Option<(f32, PxVector)> {
    Some((of.stroke?, of.line.vertices.last()?.at - of.line.vertices.first()?.at))
}

/// Whether a stroke is one of many that are alike, as the gridline at 0 on an axis: so many others of its width, of
/// those that are kept with these extents, lead as far in the same direction, from whichever end they are drawn. At
/// which distances they lie is not asked, as of gridlines (see `geom::gridlines`): of those, others may be cut here.
fn has_others_like_it(contour: &Confirmed, extents: &[(f32, PxVector)]) -> bool {
    let Some((own_width, own)) = extent(contour) else { return false };
    let is_alike = |(width, way): &&(f32, PxVector)| {
        (width - own_width).abs() < ONE_WIDTH && (*way - own).length().min((*way + own).length()) <= SAME
    };
    extents.iter().filter(is_alike).count() >= LIKE_IT
}

/// The strength of most of a contour.
fn strength(line: &Polyline<Edgel>) -> f32 {
    order::middle(line.vertices.iter().map(|vertex| vertex.strength).collect())
}

/// All contours, those of faint strokes marked, each with the number of its proposal. How a stroke is painted is told
/// from all of it that is seen: a line of a grid that is the top of a bar and goes on to the next bar is no border of
/// an area.
fn with_faint_strokes(confirmed: Vec<Vec<Confirmed>>) -> Vec<(usize, Confirmed)> {
    let whole = |of: &Vec<Confirmed>| {
        let first = of.first()?;
        let vertices = of.iter().flat_map(|contour| contour.line.vertices.iter().copied()).collect();
        let line = Polyline { vertices, closed: of.len() == 1 && first.line.closed };
        let segments: usize = of.iter().map(|contour| contour.line.segments().count()).sum();
        let on_borders: usize = of.iter().map(|contour| contour.on_borders).sum();
        Some(WeighedStroke::of(first.stroke?, on_borders as f32 / segments.max(1) as f32, line.view()))
    };
    let mut strokes: Vec<Option<WeighedStroke>> = confirmed.iter().map(whole).collect();
    let faint = FaintStrokes::among(strokes.iter_mut().flatten().collect());
    let marked = |(number, (of, stroke)): (usize, (Vec<Confirmed>, Option<WeighedStroke>))| {
        let is_faint = stroke.is_some_and(|stroke| faint.holds(&stroke));
        of.into_iter().map(move |contour| (number, Confirmed { faint: is_faint, ..contour }))
    };
    confirmed.into_iter().zip(strokes).enumerate().flat_map(marked).collect()
}

/// The longest part of a contour between two corners, px.
fn longest_side(line: &Polyline<Edgel>) -> f32 {
    let directions: Vec<PxVector> = line.segments().map(|(a, b)| b.at - a.at).collect();
    let least = CORNER.to_radians().cos();
    let is_corner = |a: &PxVector, b: &PxVector| a.dot(*b) < least * a.length() * b.length();
    let sides = directions.chunk_by(|a, b| !is_corner(a, b));
    sides.map(|side| side.iter().map(|step| step.length()).sum::<f32>()).fold(0.0, f32::max)
}

/// The parts of a contour that coincide with none of those before it. They end on what covers the rest.
fn uncovered(contour: &Confirmed, covered: &Covered) -> Vec<Confirmed> {
    let Confirmed { line, stroke, faint, .. } = contour;
    let cover: Vec<Option<PxPoint>> =
        line.segments().map(|(a, b)| covered.under(a.at, b.at, stroke.is_some())).collect();
    if cover.iter().all(Option::is_none) {
        return vec![contour.clone()];
    }
    let n = cover.len();
    let free: Vec<bool> = cover.iter().map(Option::is_none).collect();
    let part = |stretch: SegmentRun| {
        let vertex = |i: usize| line.vertices[i % line.vertices.len()];
        let mut vertices: Vec<Edgel> = (stretch.first..=stretch.first + stretch.count).map(vertex).collect();
        for (end, beyond) in
            [(0, (stretch.first + n - 1) % n), (vertices.len() - 1, (stretch.first + stretch.count) % n)]
        {
            let at_end_of_open =
                !line.closed && (if end == 0 { stretch.first == 0 } else { stretch.first + stretch.count == n });
            if !at_end_of_open && cover[beyond].is_some() {
                vertices[end].at = covered.nearest(vertices[end].at).unwrap_or(vertices[end].at);
            }
        }
        Confirmed { line: Polyline::open(vertices), stroke: *stroke, on_borders: 0, faint: *faint }
    };
    let parts = stretches(&free, line.closed).into_iter().map(part);
    parts.filter(|part| part.line.length() >= SHORTEST).collect()
}

/// A segment of a contour.
#[derive(Debug, Clone, Copy)]
struct PathPiece {
    a: PxPoint,
    b: PxPoint,
    reach: f32,
    /// That of most of its contour.
    strength: f32,
    /// The number of its proposal: of strokes the later ones lie on the earlier ones.
    painted: usize,
}

/// The contours that are kept so far, found by place: each piece lies in all cells that its reach takes in.
pub(super) struct Covered(Index<PathPiece, Px>);

impl Covered {
    fn new(size: Size) -> Self {
        let side = |pixels: u32| ((pixels as f32 / CELL).floor() + 1.0) * CELL;
        Self(Index::new(Box2D::new(PxPoint::zero(), PxPoint::new(side(size.width), side(size.height))), CELL))
    }

    /// All contours, each with the same reach.
    pub(super) fn of(edges: &Edges, reach: f32) -> Self {
        let mut covered = Self::new(edges.size);
        for chain in edges.chains() {
            covered.add(&Polyline { vertices: chain.vertices.to_vec(), closed: chain.closed }, reach, 0);
        }
        covered
    }

    fn add(&mut self, line: &Polyline<Edgel>, reach: f32, painted: usize) {
        let strength = strength(line);
        let beyond = PxVector::splat(reach);
        for (a, b) in line.segments() {
            let piece = PathPiece { a: a.at, b: b.at, reach, strength, painted };
            self.0.put_over(a.at.min(b.at) - beyond, a.at.max(b.at) + beyond, piece);
        }
    }

    /// The pieces whose reach may take in a point.
    fn at(&self, at: PxPoint) -> impl Iterator<Item = &PathPiece> {
        self.0.in_cell_of(at).iter()
    }

    /// The point of a contour on which the middle of a segment lies, if the two are parallel there. A stroke lies on
    /// another only where their centre lines do.
    fn under(&self, a: PxPoint, b: PxPoint, is_stroke: bool) -> Option<PxPoint> {
        let along: PxVector = (b - a).try_normalize()?;
        let middle = a.lerp(b, 0.5);
        self.at(middle).find_map(|piece| {
            let (distance, at) = nearest_on_segment(middle, piece.a, piece.b);
            let reach = if is_stroke { SAME } else { piece.reach };
            let parallel = (piece.b - piece.a).try_normalize().is_some_and(|piece| piece.dot(along).abs() >= PARALLEL);
            (distance <= reach && parallel).then_some(at)
        })
    }

    /// The nearest point of a contour that reaches as far as a point.
    fn nearest(&self, at: PxPoint) -> Option<PxPoint> {
        let pieces = self.at(at).map(|piece| (nearest_on_segment(at, piece.a, piece.b), piece.reach));
        let near = pieces.filter(|((distance, _), reach)| distance <= reach);
        near.min_by(|a, b| a.0.0.total_cmp(&b.0.0)).map(|((_, at), _)| at)
    }

    /// The piece of the contour that lies at a point.
    fn piece_at(&self, at: PxPoint) -> Option<&PathPiece> {
        let pieces = self.at(at).map(|piece| (nearest_on_segment(at, piece.a, piece.b).0, piece));
        let here = pieces.filter(|(distance, _)| *distance <= SAME);
        here.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, piece)| piece)
    }

    /// Whether a contour reaches as far as a point.
    pub(super) fn is_near(&self, at: PxPoint) -> bool {
        self.nearest(at).is_some()
    }
}

#[cfg(test)]
mod tests;
