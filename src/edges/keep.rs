//! Which chains are contours worth a line: strength with its texture taken off, hysteresis along the chain, length.

use super::chain::Chain;
use super::sides::Sides;
use super::thin::Ridge;
use super::{EdgePoint, Edges, Params};
use crate::raster::plane::Plane;
use crate::units::Size;

pub(super) fn keep(
    points: &[Ridge],
    chains: &[Chain],
    lab: &[Vec<f32>],
    sides: &Sides,
    size: Size,
    params: &Params,
) -> Edges {
    let mut edges = Edges { size, points: Vec::new(), chains: Vec::new() };
    let colours = Colours { planes: lab, size, reach: params.sigma.max(1.0) };
    for chain in chains {
        // Texture only takes strength away, so a chain without one step of this height never reaches it.
        let reaches = chain.iter().any(|&number| points[number as usize].step >= params.high);
        if !reaches || length(points, chain) < params.min_length {
            continue;
        }
        let strengths = strengths(points, chain, sides, params);
        for piece in pieces(chain, &strengths, params) {
            let numbers: Vec<u32> = piece.iter().map(|&i| chain[i]).collect();
            if length(points, &numbers) < params.min_length {
                continue;
            }
            let start = edges.points.len();
            for (k, &i) in piece.iter().enumerate() {
                let (before, after) = (numbers[k.saturating_sub(1)], numbers[(k + 1).min(numbers.len() - 1)]);
                let step = colours.step(points, before, numbers[k], after);
                edges.points.push(EdgePoint { at: points[numbers[k] as usize].at, strength: strengths[i], step });
            }
            if numbers.first() == numbers.last()
                && let Some(last) = edges.points.last().copied()
            {
                edges.points[start] = last; // a ring's seam carries one value
            }
            edges.chains.push(start..edges.points.len());
        }
    }
    edges
}

fn length(points: &[Ridge], chain: &[u32]) -> f32 {
    chain.windows(2).map(|pair| (points[pair[1] as usize].at - points[pair[0] as usize].at).length()).sum()
}

/// Step heights with texture suppressed, averaged along the chain.
fn strengths(points: &[Ridge], chain: &Chain, sides: &Sides, params: &Params) -> Vec<f32> {
    let suppression = params.suppression;
    // points of a chain are a pixel apart, give or take the slant
    let window = params.strength_window.round() as usize;
    let raw: Vec<f32> = chain
        .iter()
        .map(|&number| {
            let point = &points[number as usize];
            if suppression > 0.0 {
                // the geometric mean of gradient and side statistic: step * sqrt(contour) at full suppression
                point.step * sides.contour(point.at, point.normal, point.step).powf(0.5 * suppression)
            } else {
                point.step
            }
        })
        .collect();
    let closed = chain.first() == chain.last();
    let n = if closed { raw.len() - 1 } else { raw.len() };
    let mean = |i: usize| {
        let reach = if closed { window.min((n - 1) / 2) } else { window.min(i).min(n - 1 - i) };
        let sum: f32 = raw[i] + (1..=reach).map(|k| raw[(i + k) % n] + raw[(i + n - k) % n]).sum::<f32>();
        sum / (2 * reach + 1) as f32
    };
    let mut means: Vec<f32> = (0..n).map(mean).collect();
    if closed {
        means.push(means[0]);
    }
    means
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
    planes: &'a [Vec<f32>],
    size: Size,
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
        let mut step = [0.0; 3];
        for (step, plane) in step.iter_mut().zip(self.planes) {
            let at = |x, y| Plane::look_up(plane, self.size, x, y);
            *step = at(point.at.x + dx, point.at.y + dy) - at(point.at.x - dx, point.at.y - dy);
        }
        step
    }
}
