//! Contours become lines that a finger can follow: on the sheet, in millimetres.
//!
//! ```text
//! Edges -> smooth -> join (ends that continue one another) -> bars (two near sides become one middle line)
//!       -> join -> clear (no two lines too near) -> weight (width by strength) -> simplify -> Lines
//! ```

mod bars;
mod clear;
mod join;
mod weight;

use crate::edges::Edges;
use crate::frame::Frame;
use crate::geom::polyline::{self, arc_lengths};
use crate::units::{MmPoint, MmRect, MmVector};

/// How lines are drawn. Lengths are in millimetres on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Width of the weakest line.
    pub width_min: f32,
    /// Width of every line from `full_strength` on.
    pub width_max: f32,
    /// Strength of an edge (see [`crate::edges`]) that gets `width_min`.
    pub least_strength: f32,
    /// Strength from which a line has `width_max`; low, so that most lines share one width.
    pub full_strength: f32,
    /// A line of full strength shorter than this is left out; a weaker one must be longer in proportion.
    pub min_length: f32,
    /// Least blank between the edges of two lines.
    pub min_gap: f32,
    /// Farthest distance of two ends that are joined when they continue one another.
    pub join_gap: f32,
    /// Sigma of the Gaussian that smooths a line along itself.
    pub smoothing: f32,
    /// Farthest that a simplified line may lie from the smooth one.
    pub tolerance: f32,
}

/// A finished line: one contour in pieces of equal width.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Mean strength of its edge (see [`crate::edges`]).
    pub strength: f32,
    /// Pieces in order; each begins where the one before it ends.
    pub runs: Vec<Run>,
}

/// A piece of a line of one width.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Width, mm.
    pub width: f32,
    /// Polyline; first point = last point for a closed line of one width.
    pub points: Vec<MmPoint>,
}

impl Run {
    /// Whether the run is a ring of its own.
    pub fn is_closed(&self) -> bool {
        self.points.len() > 2 && self.points.first() == self.points.last()
    }
}

impl Line {
    /// Length, mm.
    pub fn length(&self) -> f32 {
        self.runs.iter().map(|run| polyline::length(&run.points)).sum()
    }
}

/// The lines of a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawn {
    /// The weightiest line comes first.
    pub lines: Vec<Line>,
    /// Share of the contours' length, 0..=1, that was worth a line but lies too close to others.
    pub crowded_out: f32,
}

/// Draws the contours in `area`, the part of the sheet where `frame` puts the picture.
pub fn draw(edges: &Edges, frame: &Frame, area: MmRect, params: &Params) -> Drawn {
    let trails = edges.chains().map(|chain| Trail::from_chain(chain, frame).smoothed(params.smoothing).evened());
    let mut trails = join::join(trails.collect(), params.join_gap);
    trails.retain(|trail| trail.weighted_length(params) >= CRUMB * params.min_length);
    let trails = bars::merge(trails, area, params);
    // Where one side of a bar ends and the other goes on, the middle line goes on with it.
    let mut trails = join::join(trails, params.join_gap);
    let length = |trails: &[Trail]| trails.iter().map(Trail::length).sum::<f32>();
    trails.retain(|trail| trail.weighted_length(params) >= params.min_length);
    let found = length(&trails);
    let trails = clear::clear(trails, area, params);
    let crowded_out = if found > 0.0 { (1.0 - length(&trails) / found).max(0.0) } else { 0.0 };
    Drawn { lines: trails.iter().filter_map(|trail| weight::finish(trail, params)).collect(), crowded_out }
}

/// A line shorter than this share of the least length has joined nothing and will not: it is not looked at further.
const CRUMB: f32 = 0.5;

/// Distance of the vertices of a line in the making, mm: a few to the width of the thinnest line.
const SPACING: f32 = 0.4;

/// A line in the making.
#[derive(Debug, Clone, PartialEq)]
struct Trail {
    vertices: Vec<Vertex>,
    /// A closed trail repeats its first vertex at its end.
    closed: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Vertex {
    at: MmPoint,
    strength: f32,
    /// Colour on the right less colour on the left.
    step: [f32; 3],
}

impl Vertex {
    /// The vertex a share of the way from this one to `other`.
    fn between(&self, other: &Self, share: f32) -> Self {
        let mix = |a: f32, b: f32| a + (b - a) * share;
        Self {
            at: self.at.lerp(other.at, share),
            strength: mix(self.strength, other.strength),
            step: std::array::from_fn(|i| mix(self.step[i], other.step[i])),
        }
    }
}

impl Trail {
    fn from_chain(chain: &[crate::edges::EdgePoint], frame: &Frame) -> Self {
        let vertices: Vec<Vertex> =
            chain.iter().map(|p| Vertex { at: frame.to_mm(p.at), strength: p.strength, step: p.step }).collect();
        let closed = vertices.len() > 3 && chain.first().map(|p| p.at) == chain.last().map(|p| p.at);
        Self { vertices, closed }
    }

    fn points(&self) -> Vec<MmPoint> {
        self.vertices.iter().map(|v| v.at).collect()
    }

    fn length(&self) -> f32 {
        self.vertices.windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum()
    }

    /// What decides between rivals: the longer and stronger of two lines says more.
    fn saliency(&self) -> f32 {
        self.vertices
            .windows(2)
            .map(|pair| (pair[1].at - pair[0].at).length() * pair[0].strength.min(pair[1].strength))
            .sum()
    }

    /// Length, mm, of a line of full strength that is worth as much: a weak line counts in proportion.
    fn weighted_length(&self, params: &Params) -> f32 {
        self.length() * (self.mean_strength() / params.full_strength).min(1.0)
    }

    fn mean_strength(&self) -> f32 {
        self.vertices.iter().map(|v| v.strength).sum::<f32>() / self.vertices.len().max(1) as f32
    }

    fn reversed(mut self) -> Self {
        self.vertices.reverse();
        for vertex in &mut self.vertices {
            vertex.step = vertex.step.map(|v| -v);
        }
        self
    }

    /// Unit direction of travel at a vertex, over its neighbours.
    fn tangent(&self, i: usize) -> MmVector {
        let n = self.vertices.len();
        let (before, after) = if self.closed {
            ((i + n - 2) % (n - 1), (i + 1) % (n - 1))
        } else {
            (i.saturating_sub(1), (i + 1).min(n - 1))
        };
        (self.vertices[after].at - self.vertices[before].at).try_normalize().unwrap_or(MmVector::zero())
    }

    /// Puts vertices at even distances of about [`SPACING`], the ends where they are. A ring begins at its strongest place,
    /// so that the result does not hang on where the search for it began.
    fn evened(mut self) -> Self {
        if self.closed {
            self.vertices.pop();
            let strength = |i: &usize| self.vertices[*i].strength;
            let strongest = (0..self.vertices.len()).max_by(|a, b| strength(a).total_cmp(&strength(b)));
            self.vertices.rotate_left(strongest.unwrap_or(0));
            self.vertices.extend(self.vertices.first().copied());
        }
        let arcs = arc_lengths(&self.points());
        let total = arcs.last().copied().unwrap_or(0.0);
        let steps = (total / SPACING).round().max(1.0) as usize;
        let mut even = Vec::with_capacity(steps + 1);
        let mut k = 0;
        for step in 0..=steps {
            let arc = total * step as f32 / steps as f32;
            while k + 2 < arcs.len() && arcs[k + 1] < arc {
                k += 1;
            }
            let (a, b) = (&self.vertices[k], &self.vertices[(k + 1).min(self.vertices.len() - 1)]);
            let length = arcs.get(k + 1).map_or(0.0, |next| next - arcs[k]);
            even.push(a.between(b, if length > 0.0 { (arc - arcs[k]) / length } else { 0.0 }));
        }
        if self.closed {
            even[steps] = even[0];
        }
        self.closed &= steps >= 3;
        self.vertices = even;
        self
    }

    fn smoothed(mut self, sigma: f32) -> Self {
        let arcs = arc_lengths(&self.points());
        let old = std::mem::take(&mut self.vertices);
        let smooth = polyline::smooth(&arcs, self.closed, sigma, |i| {
            let v = &old[i];
            [v.at.x, v.at.y, v.strength, v.step[0], v.step[1], v.step[2]]
        });
        self.vertices = smooth
            .into_iter()
            .map(|[x, y, strength, l, a, b]| Vertex { at: MmPoint::new(x, y), strength, step: [l, a, b] })
            .collect();
        self
    }
}

/// Products of two colour steps, as vectors.
fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
