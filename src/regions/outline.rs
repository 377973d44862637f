//! Outlines of the most salient regions.

use super::border::{Border, borders, corner_at};
use super::bumps::Places;
use super::choose::{Chosen, Params, choose};
use super::follow::followed;
use super::label_map::label_map;
use super::main_thing::main_thing;
use super::trace::{OutlineAreas, RegionOutline, TracePoint, TracedContour};
use super::tree::Tree;

use crate::geom::polyline::{Polyline, smooth};
use crate::units::{PxPoint, Size};

/// Outlines are smoothed over at least this much, cells: their cracks run in steps.
const LEAST_SMOOTHING: f32 = 1.2;
/// Where no contour is seen along them they are smoothed over so many times as much: their changes of bending, 4.5 in
/// 100 mm, fall by a third, and what they agree with people's stays the same.
const UNSEEN: f32 = 2.0;
/// A step from vertex to vertex counts as no longer than this when outlines are smoothed, cells: from a cell to the
/// next it hardly is. What is longer is a leap from one trace to another, which smoothing would leave as it is, as all
/// that is beyond it would be out of reach.
const LONGEST_STEP: f32 = 1.5;

impl Tree {
    /// The outlines of the chosen regions, the first first, for a sheet with so many millimetres for a pixel of
    /// the picture. Neighbours share one border, which belongs to the first of them; one that is not closed ends on the
    /// edge of the picture or on others. The strength is the mean of what is seen along the line. Also returns the
    /// areas that the outlines surround.
    pub fn outlines(&self, mm_per_px: f32, params: &Params, chosen: &Chosen) -> (Vec<RegionOutline>, OutlineAreas) {
        let mm = self.mm_of_cell(mm_per_px);
        let Chosen { regions, beyond } = chosen;
        let labels = label_map(self, regions, mm, params.narrowest);
        let mut placed = vec![None; (self.grid.cells.width as usize + 1) * (self.grid.cells.height as usize + 1)];
        let sigma = (params.smoothing / mm).max(LEAST_SMOOTHING);
        let all = borders(&labels, regions.len(), self.grid.cells);
        let outline = |border: &Border| RegionOutline {
            contour: self.contour_along(border, [sigma, mm], &mut placed),
            // labels begin with 1
            region: usize::from(border.label) - 1,
        };
        let outlines = all.iter().map(outline).collect();
        (outlines, OutlineAreas { grid: self.grid, labels, count: regions.len(), beyond: *beyond })
    }

    /// The regions that get an outline, for a sheet with so many millimetres for a pixel of the picture: those of
    /// `first`, then those that tell most; of those that tell as much, `preferred` ones.
    pub fn chosen(&self, mm_per_px: f32, params: &Params, first: &[u32], preferred: &[u32]) -> Chosen {
        let mut regions = choose(self, self.mm_of_cell(mm_per_px), params, first, preferred);
        let count = regions.len();
        regions.truncate(params.drawn.map_or(count, |most| most.max(first.len())));
        Chosen { beyond: count - regions.len(), regions }
    }

    /// The region that is the main thing of the picture, for a sheet with so many millimetres for a pixel, if there is
    /// one among those that tell enough for an outline.
    pub fn main_thing(&self, mm_per_px: f32, params: &Params) -> Option<u32> {
        main_thing(self, self.mm_of_cell(mm_per_px), params.least_gain)
    }

    /// A border without bumps that nobody sees, smoothed along itself with `sigma` cells of `mm` on the sheet. `placed`
    /// has where the corners of those before it are.
    fn contour_along(&self, border: &Border, [sigma, mm]: [f32; 2], placed: &mut [Option<PxPoint>]) -> TracedContour {
        let size = self.grid.cells;
        let middles = middles(border, size);
        let followed = followed(&self.traces, &middles, border.closed);
        let (found, strengths): (Vec<PxPoint>, Vec<f32>) = followed.iter().map(|seen| (seen.at, seen.strength)).unzip();
        let strength = strengths.iter().sum::<f32>() / middles.len().max(1) as f32;
        let mut is_seen: Vec<[f32; 1]> = strengths.iter().map(|strength| [f32::from(*strength > 0.0)]).collect();
        let places = Places { points: &found, strengths: &strengths, closed: border.closed, mm };
        let mut points = places.without_bumps();
        if let (false, Some(&first), Some(&last)) = (border.closed, border.corners.first(), border.corners.last()) {
            let at = |corner: usize| placed[corner].unwrap_or_else(|| corner_at(corner, size));
            let (first, last) = (at(first), at(last));
            points.insert(0, first);
            points.push(last);
            is_seen.insert(0, [1.0]);
            is_seen.push([1.0]);
        }
        let line = Polyline { vertices: points, closed: border.closed };
        let points = smoothed(&line, &is_seen, sigma);
        let n = points.len();
        for (i, &corner) in border.corners.iter().enumerate() {
            // of a ring the corner lies before the middle of the same number, of an open border behind it
            let (before, after) = if border.closed { ((i + n - 1) % n, i) } else { (i, (i + 1).min(n - 1)) };
            placed[corner].get_or_insert(points[before].lerp(points[after], 0.5));
        }
        let point = |at: PxPoint| TracePoint { at: self.grid.to_picture(at), strength };
        Polyline { vertices: points.into_iter().map(point).collect(), closed: border.closed }
    }
}

/// The vertices of an outline, smoothed along it with `sigma` where a contour is seen, and more where none is: there it
/// runs along basins, whose borders are ragged.
fn smoothed(line: &Polyline<PxPoint>, is_seen: &[[f32; 1]], sigma: f32) -> Vec<PxPoint> {
    let arcs = arcs_without_leaps(line);
    let place = |i: usize| [line.vertices[i].x, line.vertices[i].y];
    let fine = smooth(&arcs, line.closed, sigma, place);
    let point = |[x, y]: [f32; 2]| PxPoint::new(x, y);
    if is_seen.iter().all(|[seen]| *seen > 0.0) {
        return fine.into_iter().map(point).collect();
    }
    let coarse = smooth(&arcs, line.closed, UNSEEN * sigma, place);
    let seen = smooth(&arcs, line.closed, sigma, |i| is_seen[i]);
    let mix = |((fine, coarse), [seen]): (([f32; 2], [f32; 2]), [f32; 1])| point(coarse).lerp(point(fine), seen);
    fine.into_iter().zip(coarse).zip(seen).map(mix).collect()
}

/// The lengths along an outline up to its vertices, and that of a ring, with no step longer than [`LONGEST_STEP`].
fn arcs_without_leaps(line: &Polyline<PxPoint>) -> Vec<f32> {
    let mut arcs = line.arc_lengths();
    let (mut last, mut beyond) = (0.0, 0.0);
    for arc in &mut arcs {
        beyond += (*arc - last - LONGEST_STEP).max(0.0);
        last = *arc;
        *arc -= beyond;
    }
    arcs
}

/// The middles of the sides along a border.
fn middles(border: &Border, size: Size) -> Vec<PxPoint> {
    let corners = &border.corners;
    let count = if border.closed { corners.len() } else { corners.len().saturating_sub(1) };
    let middle = |i: usize| corner_at(corners[i], size).lerp(corner_at(corners[(i + 1) % corners.len()], size), 0.5);
    (0..count).map(middle).collect()
}

#[cfg(test)]
mod tests;
