//! Contours become lines that a finger can follow: on the sheet, in millimetres.
//!
//! ```text
//! Edges -> smooth -> join (ends that continue one another) -> bars (two near sides become one middle line)
//!       -> join -> meet (ends led on to lines before them) -> weight (width by strength) -> clear (no two too near)
//!       -> detail (the lines that say most) -> simplify -> Lines
//! ```

mod bars;
mod clear;
mod join;
mod meet;
mod saliency;
mod vertex;
mod weight;

#[cfg(test)]
mod tests;

use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator};
use vertex::Vertex;

use crate::edges::{ChainRange, Edges};
use crate::frame::Frame;
use crate::geom::polyline::{Polyline, PolylineRef};
use crate::units::{MmPoint, MmRect};

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
    /// A line shorter than this is left out.
    pub min_length: f32,
    /// Least blank between the edges of two lines.
    pub min_gap: f32,
    /// Farthest distance of two ends that are joined when they continue one another.
    pub join_gap: f32,
    /// Sigma of the Gaussian that smooths a line along itself.
    pub smoothing: f32,
    /// Farthest that a simplified line may lie from the smooth one.
    pub tolerance: f32,
    /// How many of the lines are drawn, 0..=1: from the longest, strongest, closed and smooth ones only to all. Those drawn at
    /// one detail are drawn, the same, at every higher one.
    pub detail: f32,
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
    /// The vertices of its polyline; of a row of dots, their centres. A ring does not repeat its first point.
    pub points: Vec<MmPoint>,
    /// Whether it is a stroke that goes on from its last point to its first.
    pub closed: bool,
    /// How it is drawn.
    pub pen: Pen,
}

/// How a piece of a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pen {
    /// A stroke through its points.
    #[default]
    Stroke,
    /// A dot on each of its points, pressed this high.
    Dots(Height),
}

/// How high a dot is pressed. Readers tell three of the eight heights of an embosser apart best (Kouroupetroglou et al. 2016), so
/// there are no more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Height {
    /// Textures.
    Low,
    /// Frames and weak lines.
    Middle,
    /// Lines, and everything where a device has one height only.
    #[default]
    High,
}

impl Height {
    /// All of them, the lowest first.
    pub const ALL: [Self; 3] = [Self::Low, Self::Middle, Self::High];

    /// Its name in plain words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Low => "low",
            Self::Middle => "middle",
            Self::High => "high",
        }
    }
}

impl std::fmt::Display for Height {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl Run {
    /// A stroke along a path, a ring if the path comes back to where it began.
    pub fn stroke(width: f32, path: Vec<MmPoint>) -> Self {
        let Polyline { vertices, closed } = Polyline::from_path(path);
        Self { width, points: vertices, closed, pen: Pen::Stroke }
    }

    /// Dots on these points.
    pub fn dots(diameter: f32, points: Vec<MmPoint>, height: Height) -> Self {
        Self { width: diameter, points, closed: false, pen: Pen::Dots(height) }
    }

    /// Its points as a polyline.
    pub fn polyline(&self) -> PolylineRef<'_, MmPoint> {
        PolylineRef { vertices: &self.points, closed: self.closed }
    }
}

impl Line {
    /// Length, mm.
    pub fn length(&self) -> f32 {
        self.runs.iter().map(|run| run.polyline().length()).sum()
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
    let mut polylines = join::join(polylines(edges, frame, params), params.join_gap);
    polylines.retain(|polyline| polyline.weighted_length(params.full_strength) >= CRUMB * params.min_length);
    let polylines = bars::merge(polylines, area, params);
    // Where one side of a bar ends and the other goes on, the middle line goes on with it.
    let mut polylines = join::join(polylines, params.join_gap);
    polylines.retain(|polyline| polyline.length() >= params.min_length);
    polylines.iter_mut().for_each(Polyline::fill);
    meet::meet(&mut polylines, area, params.join_gap);
    polylines.par_iter_mut().for_each(|polyline| weight::assign(polyline, params));

    let says: Vec<f32> = polylines.par_iter().map(|polyline| saliency::saliency(polyline, params)).collect();
    let lengths: Vec<f32> = polylines.iter().map(Polyline::length).collect();
    let cleared = clear::clear(polylines, area, params);
    // Detail comes last and takes whole lines, so that less of it is a subset.
    let least = saliency::least(cleared.first().map_or(0.0, |line| line.saliency), params);
    let wanted: f32 = says.iter().zip(&lengths).filter(|(says, _)| **says >= least).map(|(_, length)| length).sum();
    let drawn: Vec<_> = cleared.iter().filter(|line| line.saliency >= least).collect();
    let kept: f32 = drawn.iter().map(|line| line.polyline.length()).sum();
    Drawn {
        lines: drawn.into_par_iter().filter_map(|line| weight::finish(&line.polyline, &line.pinned, params)).collect(),
        crowded_out: if wanted > 0.0 { (1.0 - kept / wanted).max(0.0) } else { 0.0 },
    }
}

/// The contours on the sheet, in an order and in directions that do not hang on where in the picture they were found first.
fn polylines(edges: &Edges, frame: &Frame, params: &Params) -> Vec<Polyline<Vertex>> {
    let polyline = |range: &ChainRange| {
        let chain = edges.chain(range);
        let polyline = Polyline::of_chain(chain, frame).smoothed(params.smoothing).evened().stronger_half_first();
        (polyline.path().map(|v| f64::from(v.strength)).sum::<f64>(), polyline)
    };
    let mut polylines: Vec<(f64, Polyline<Vertex>)> = edges.chains.par_iter().map(polyline).collect();
    polylines.sort_by(|a, b| b.0.total_cmp(&a.0));
    polylines.into_iter().map(|(_, polyline)| polyline).collect()
}

/// A line of full strength shorter than this share of the least length, or a weaker one that is not longer in proportion, has
/// joined nothing and will not: it is not looked at further.
const CRUMB: f32 = 0.5;
