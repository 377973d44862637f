//! Two strokes of different breadth that thinning made one line: the wall of a plan, and the leaf of the door that
//! stands at its end. Each is a stroke by itself, of its own width.
//!
//! ```text
//!   ##########               ##########
//!            |      are               '
//!            |                        |
//!            '---                     '---
//! ```

use super::arms::Strand;
use super::centre::width_at;
use crate::geom::order::{median, quantile, sorted};
use crate::geom::polyline::Polyline;
use crate::geom::walk::runs;
use crate::raster::plane::Plane;
use crate::units::PxPoint;

/// Of two strokes one is broad if it is so many times as wide as the other, and at least so wide, px: 1 mm on the page
/// of a bitmap that is not small for it. Walls are three to six times as wide as the leaves of doors.
const BROADER: f32 = 2.0;
const BROAD: f32 = 4.0;
/// The width is taken at every so many vertices, which are a pixel apart.
const EVERY: usize = 4;
/// The narrowest and the widest part of a line are its least and its greatest widths but for this share, which ends and
/// junctions may have.
const RARE: f32 = 0.04;
/// A broad part is at least so many times as long as wide, and one between broad ones so many times as long as these
/// are wide: what is shorter is a blot, where others join or cross, or a notch.
const BLOT: f32 = 2.5;
const NOTCH: f32 = 2.0;
/// The lower quartile of the widths of a part is at least this share of the upper one: a wedge or a river that becomes
/// wider is one stroke.
const EVEN: f32 = 0.7;
/// A broad part ends this share of its width before the change, where thinning leads it into the narrow one. From there
/// it is led straight on, as free ends are.
const LEADS_AWAY: f32 = 0.5;
/// Walls that have thin parts at their ends are level along this share of the picture's width, and upright along as
/// much of its height, within an angle of this tangent (11 degrees) over so many pixels. Chosen by us.
const ALONG: f32 = 0.3;
const OFF: f32 = 0.2;
const AHEAD: usize = 8;
/// A line that is shorter than this, px, has no two parts of which one is broad.
const SHORTEST: f32 = 30.0;

/// Whether two widths, px, are those of two strokes, though one ends at the other.
pub(in crate::edges) fn are_two(width: f32, other: f32) -> bool {
    let broader = width.max(other);
    broader >= BROAD && broader >= BROADER * width.min(other)
}

/// The lines of a connected part of a picture, of which those of two breadths are parted where the broad ones are
/// walls: level and upright along much of the picture, both together. The stem of a plant and its roots stay one.
pub(super) fn parted(strands: Vec<Strand>, residue: &Plane, radius: usize) -> Vec<Strand> {
    let parts: Vec<Part> = strands.iter().flat_map(|strand| parts(strand.clone(), residue, radius)).collect();
    if parts.len() == strands.len() {
        return strands;
    }
    // walls are those too that are as broad and have no door, as most of those around a house
    let least = parts.iter().filter(|part| part.is_broad).map(|part| EVEN * part.width).fold(f32::INFINITY, f32::min);
    let (mut level, mut upright) = (0.0, 0.0);
    for Part { strand, .. } in parts.iter().filter(|part| part.width >= least) {
        let vertices = &strand.line.vertices;
        let along = vertices.iter().zip(vertices.iter().skip(AHEAD)).step_by(AHEAD);
        for way in along.map(|(from, to)| (*to - *from).abs()) {
            level += if way.y <= OFF * way.x { way.x } else { 0.0 };
            upright += if way.x <= OFF * way.y { way.y } else { 0.0 };
        }
    }
    let are_walls = level >= ALONG * residue.size.width as f32 && upright >= ALONG * residue.size.height as f32;
    if are_walls { parts.into_iter().map(|part| part.strand).collect() } else { strands }
}

/// A line of pixels, or a part of one.
struct Part {
    strand: Strand,
    /// Its median width, px; none is known of a short line.
    width: f32,
    /// Whether it is broad beside another part of its line.
    is_broad: bool,
}

/// The parts of a line of pixels that are strokes of different breadth, or all of it. Its residue is that of a square
/// of this half side, px. Each with whether it is broad beside another part.
fn parts(strand: Strand, residue: &Plane, radius: usize) -> Vec<Part> {
    let Strand { line, free, junctions } = &strand;
    let length = line.length();
    let widths = if length < SHORTEST { Vec::new() } else { widths(line, residue, radius) };
    let step = length / widths.len().max(1) as f32;
    let Some(found) = plateaus(&widths, line.closed, step) else {
        let width = if widths.is_empty() { 0.0 } else { median(widths.iter().copied()) };
        return vec![Part { strand, width, is_broad: false }];
    };
    let count = found.len();
    let part = |(number, part): (usize, &Plateau)| -> Part {
        let is_change = [line.closed || number > 0, line.closed || number + 1 < count];
        let mut vertices: Vec<PxPoint> = part.vertices(line, is_change);
        let own: Vec<PxPoint> = junctions.iter().copied().filter(|at| lies_on(*at, &vertices)).collect();
        vertices.dedup();
        let free = [0, 1].map(|end| if is_change[end] { part.is_broad } else { free[end] });
        let strand = Strand { line: Polyline::open(vertices), free, junctions: own };
        Part { strand, width: part.width, is_broad: part.is_broad }
    };
    found.iter().enumerate().map(part).filter(|part| part.strand.line.vertices.len() > 1).collect()
}

/// The width at every so many vertices of a line.
fn widths(line: &Polyline<PxPoint>, residue: &Plane, radius: usize) -> Vec<f32> {
    (0..line.vertices.len()).step_by(EVERY).map(|i| width_at(line, i, residue, radius)).collect()
}

/// Whether a junction is one of a part of a line.
fn lies_on(junction: PxPoint, vertices: &[PxPoint]) -> bool {
    vertices.iter().any(|at| (*at - junction).length() <= EVERY as f32)
}

/// A part of one width.
struct Plateau {
    /// The numbers of its places, in order.
    places: Vec<usize>,
    width: f32,
    is_broad: bool,
}

impl Plateau {
    /// The vertices of a line in it. `is_change` tells of its start and its end whether a part of another breadth
    /// follows there.
    fn vertices(&self, line: &Polyline<PxPoint>, is_change: [bool; 2]) -> Vec<PxPoint> {
        let n = line.vertices.len();
        let first = self.places[0] * EVERY;
        let last = self.places[self.places.len() - 1] * EVERY;
        let first = if is_change[0] { first } else { 0 };
        let last = if is_change[1] { last } else { n - 1 };
        let count = if first <= last { last - first + 1 } else { last + n - first + 1 };
        let cut = if self.is_broad { (LEADS_AWAY * self.width) as usize } else { 0 };
        let [before, behind] = is_change.map(|is_change| if is_change { cut } else { 0 });
        (before..count.saturating_sub(behind)).map(|k| line.vertices[(first + k) % n]).collect()
    }
}

/// The parts of a line that have one width each, broad and narrow in turn; none if it is of one breadth. `step` is how
/// far its places are apart, px.
fn plateaus(widths: &[f32], closed: bool, step: f32) -> Option<Vec<Plateau>> {
    let in_order = sorted(widths.iter().copied());
    let (narrow, wide) = (quantile(&in_order, RARE), quantile(&in_order, 1.0 - RARE));
    if !are_two(narrow, wide) {
        return None;
    }
    let between = (narrow * wide).sqrt();
    let mut is_broad: Vec<bool> = widths.iter().map(|width| *width >= between).collect();
    let found = loop {
        let runs = runs(widths.len(), closed, |a, b| is_broad[a] == is_broad[b]);
        if runs.len() < 2 {
            return None;
        }
        let width = |run: &[usize]| median(run.iter().map(|&place| widths[place]));
        let least = |run: &[usize]| if is_broad[run[0]] { BLOT * width(run) } else { NOTCH * wide };
        let is_short = |run: &&Vec<usize>| (run.len() as f32 * step) < least(run);
        let Some(short) = runs.iter().filter(is_short).min_by_key(|run| run.len()) else {
            let plateau = |run: Vec<usize>| Plateau { width: width(&run), is_broad: is_broad[run[0]], places: run };
            break runs.into_iter().map(plateau).collect::<Vec<_>>();
        };
        let flipped = !is_broad[short[0]];
        short.clone().into_iter().for_each(|place| is_broad[place] = flipped);
    };
    let is_even = |part: &Plateau| {
        let widths = sorted(part.places.iter().map(|&place| widths[place]));
        quantile(&widths, 0.25) >= EVEN * quantile(&widths, 0.75)
    };
    let over_start = found.last().zip(found.first()).filter(|_| closed);
    let mut pairs = found.windows(2).map(|pair| (&pair[0], &pair[1])).chain(over_start);
    (found.iter().all(is_even) && pairs.all(|(a, b)| are_two(a.width, b.width))).then_some(found)
}

#[cfg(test)]
mod tests;
