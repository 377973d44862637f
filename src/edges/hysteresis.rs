//! Selects the parts of chains that are contours: hysteresis along the chain (Canny 1986) with the strength of
//! [`super::strength`], and a least length.

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::chain::{self, Chain};
use super::contour::{Contour, ContourPoint};
use super::params::Params;
use super::ridge::RidgePoint;
use super::strength::{self, Evidence};
use crate::geom::polyline::Polyline;
use crate::geom::walk::runs;
use crate::raster::Raster;
use crate::raster::lab;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector};

/// What the selection reads beside the chains.
pub(super) struct Selection<'a> {
    pub(super) points: &'a [RidgePoint],
    pub(super) raster: &'a Raster,
    pub(super) evidence: Evidence<'a>,
    /// Standard deviation of the noise of a pixel, in units of strength.
    pub(super) noise: f32,
    pub(super) params: &'a Params,
}

impl Selection<'_> {
    /// The contours in all chains.
    pub(super) fn contours(&self, chains: &[Chain]) -> Vec<Contour> {
        chains.par_iter().enumerate().flat_map_iter(|chain| self.contours_of(chain)).collect()
    }

    /// The contours in the chain of this number.
    fn contours_of(&self, (number, chain): (usize, &Chain)) -> Vec<Contour> {
        let Self { points, params, .. } = self;
        // Strength never exceeds the height of the step, so a chain without one step of this height cannot reach it.
        if !chain.vertices.iter().any(|&number| points[number as usize].height >= params.high) {
            return Vec::new();
        }
        let strengths = strength::weighted(points, (number, chain), &self.evidence, params);
        let mut contours = Vec::new();
        for piece in pieces(&strengths, chain.closed, params.low, params.high) {
            let numbers = piece.vertices.iter().map(|&i| chain.vertices[i]).collect();
            let part = Chain { vertices: numbers, closed: piece.closed };
            if chain::length(points, &part) >= params.min_length {
                contours.push(self.contour(&part, piece.vertices.iter().map(|&i| strengths[i])));
            }
        }
        contours
    }

    /// A part of a chain as a contour.
    fn contour(&self, part: &Chain, strengths: impl Iterator<Item = f32>) -> Contour {
        let at = |k: usize| &self.points[part.vertices[k] as usize];
        let n = part.vertices.len();
        let point = |(k, strength): (usize, f32)| {
            let [before, after] = chain::neighbours(n, part.closed, k).map(|k| at(k).at);
            let point = at(k);
            ContourPoint {
                at: point.at,
                strength,
                contrast: self.contrast(point, after - before),
                blur: point.blur,
                position_sigma: position_sigma(self.noise, point, self.params.sigma),
            }
        };
        Contour { vertices: strengths.enumerate().map(point).collect(), closed: part.closed }
    }

    /// Colour on the right minus colour on the left of a chain that runs in the direction `along` at `point`.
    fn contrast(&self, point: &RidgePoint, along: PxVector) -> [f32; 3] {
        // The two ridges of a line thinner than the scale stand one sigma from its middle: farther away would be the
        // paper on its other side.
        let distance = self.params.sigma.max(1.0);
        // right of the direction, with y down
        let sign = if -along.y * point.normal.x + along.x * point.normal.y >= 0.0 { 1.0 } else { -1.0 };
        let across = point.normal * (sign * distance);
        let [right, left] = [point.at + across, point.at - across].map(|at| colour_at(self.raster, at));
        std::array::from_fn(|i| right[i] - left[i])
    }
}

/// The colour of a picture between its pixels (L, 2a, 2b).
fn colour_at(raster: &Raster, PxPoint { x, y, .. }: PxPoint) -> [f32; 3] {
    let at = |plane: &Vec<f32>| Plane::look_up(plane, raster.size(), x, y);
    lab::colour(raster.planes().as_ref().map(at).as_colour())
}

/// Position error, px: the standard deviation of the steepest point across an edge of height `D` and blur `t`, found
/// with derivatives of scale `sigma` under white noise `n`. It is the noise of the second derivative, `n sqrt(3 / 16
/// pi) / sigma^3`, divided by the slope of the second derivative at the edge, `D / (sqrt(2 pi) t^3)`.
fn position_sigma(noise: f32, point: &RidgePoint, sigma: f32) -> f32 {
    0.612 * noise / point.height.max(1e-3) * (point.blur / sigma).powi(3)
}

/// Hysteresis along a chain: the runs of indices whose strength is at least `low`, if it reaches `high` somewhere in
/// them. A run over the seam of a closed chain is one run. The run is closed if it is the whole of a closed chain.
fn pieces(strengths: &[f32], closed: bool, low: f32, high: f32) -> Vec<Polyline<usize>> {
    let is_weak = |i: usize| strengths[i] < low;
    let runs = runs(strengths.len(), closed, |a, b| is_weak(a) == is_weak(b));
    let closed = closed && runs.len() == 1;
    let kept = runs.into_iter().filter(|run| !is_weak(run[0]) && run.iter().any(|&i| strengths[i] >= high));
    kept.map(|vertices| Polyline { vertices, closed }).collect()
}

#[cfg(test)]
mod tests;
