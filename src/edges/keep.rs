//! Which chains are contours worth a line: strength with its texture taken off, hysteresis along the chain, length.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::chain::{self, Chain};
use super::path::{Mark, Path};
use super::sides::Sides;
use super::thin::Ridge;
use super::{Params, lab, strength};
use crate::raster::Raster;
use crate::raster::plane::Plane;

/// `noise` is the standard deviation of a pixel in units of strength.
pub(super) fn keep(
    points: &[Ridge],
    chains: &[Chain],
    raster: &Raster,
    sides: &Sides,
    noise: f32,
    params: &Params,
) -> Vec<Path> {
    let colours = Colours { raster, reach: params.sigma.max(1.0) };
    let of_chain = |chain| of_chain(points, chain, &colours, sides, noise, params);
    chains.par_iter().flat_map_iter(of_chain).collect()
}

/// What is kept of a chain.
fn of_chain(
    points: &[Ridge],
    chain: &Chain,
    colours: &Colours<'_>,
    sides: &Sides,
    noise: f32,
    params: &Params,
) -> Vec<Path> {
    let mut paths = Vec::new();
    // Texture only takes strength away, so a chain without one step of this height never reaches it.
    let reaches = chain.iter().any(|&number| points[number as usize].step >= params.high);
    if !reaches {
        return paths;
    }
    let strengths = strength::along(points, chain, sides, params);
    for piece in pieces(chain, &strengths, params) {
        let mut numbers: Vec<u32> = piece.iter().map(|&i| chain[i]).collect();
        if chain::length(points, &numbers) < params.min_length {
            continue;
        }
        let closed = numbers.len() > 3 && numbers.first() == numbers.last();
        if closed {
            numbers.pop();
        }
        let n = numbers.len();
        let mark = |k: usize| {
            let (before, after) =
                if closed { ((k + n - 1) % n, (k + 1) % n) } else { (k.saturating_sub(1), (k + 1).min(n - 1)) };
            let point = &points[numbers[k] as usize];
            Mark {
                at: point.at,
                strength: strengths[piece[k]],
                step: colours.step(points, numbers[before], numbers[k], numbers[after]),
                blur: point.blur,
                doubt: doubt(noise, point, params.sigma),
            }
        };
        paths.push(Path { marks: (0..n).map(mark).collect(), closed });
    }
    paths
}

/// Standard deviation, px, of the place of the steepest point across an edge of height `D` and blur `t` found with
/// derivatives of scale `sigma` under white noise `n`: noise of the second derivative, `n sqrt(3 / 16 pi) / sigma^3`, over
/// the slope that the second derivative has at the edge, `D / (sqrt(2 pi) t^3)`.
fn doubt(noise: f32, point: &Ridge, sigma: f32) -> f32 {
    0.612 * noise / point.step.max(1e-3) * (point.blur / sigma).powi(3)
}

/// Hysteresis along a chain: it is cut where its strength is below `low`, and a piece stays if it reaches `high` somewhere.
/// Pieces are lists of places in the chain; the piece over a ring's seam is put together again.
fn pieces(chain: &Chain, strengths: &[f32], params: &Params) -> Vec<Vec<usize>> {
    let closed = chain.first() == chain.last();
    if strengths.iter().all(|&s| s >= params.low) {
        let reaches = strengths.iter().any(|&s| s >= params.high);
        return if reaches { vec![(0..chain.len()).collect()] } else { Vec::new() };
    }
    let n = if closed { chain.len() - 1 } else { chain.len() };
    // A ring is walked from a weak point, so that no piece crosses the seam.
    let start = if closed { (0..n).find(|&i| strengths[i] < params.low).unwrap_or(0) } else { 0 };
    let mut pieces = Vec::new();
    let mut piece: Vec<usize> = Vec::new();
    for k in 0..=n {
        let i = (start + k) % n;
        if k < n && strengths[i] >= params.low {
            piece.push(i);
        } else if !piece.is_empty() {
            let done = std::mem::take(&mut piece);
            if done.iter().any(|&i| strengths[i] >= params.high) {
                pieces.push(done);
            }
        }
    }
    pieces
}

/// Reads the colours to the right and left of a chain.
struct Colours<'a> {
    raster: &'a Raster,
    /// How far from the edge, px. The two ridges of a line thinner than the scale stand one sigma beside its middle: farther
    /// on would be the paper on its other side.
    reach: f32,
}

impl Colours<'_> {
    fn step(&self, points: &[Ridge], before: u32, here: u32, after: u32) -> [f32; 3] {
        let along = points[after as usize].at - points[before as usize].at;
        let point = &points[here as usize];
        // right of the walking direction, with y down
        let sign = if -along.y * point.normal[0] + along.x * point.normal[1] >= 0.0 { 1.0 } else { -1.0 };
        let (dx, dy) = (sign * self.reach * point.normal[0], sign * self.reach * point.normal[1]);
        let (right, left) = (self.at(point.at.x + dx, point.at.y + dy), self.at(point.at.x - dx, point.at.y - dy));
        std::array::from_fn(|i| right[i] - left[i])
    }

    fn at(&self, x: f32, y: f32) -> [f32; 3] {
        let at = |plane: &Vec<f32>| Plane::look_up(plane, self.raster.size(), x, y);
        match self.raster.planes() {
            [red, green, blue] => lab::colour([at(red), at(green), at(blue)]),
            planes => lab::colour([planes.first().map_or(0.0, at); 3]),
        }
    }
}
