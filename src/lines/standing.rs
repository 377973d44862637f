//! Ends of lines that stand on other lines, and two such lines with a gap between them: the plates of a capacitor at
//! the ends of its wires. The gap is what the symbol says, so that it is never closed, and made wide enough for
//! fingers.

use super::arrowheads::shortened;
use super::junction::heading;
use super::params::Params;
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::Segment;
use crate::geom::nearest_on_segment;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect};

/// An end this near to another line stands on it, mm.
const TOUCHES: f32 = 0.05;
/// It does if that goes on for this much on both sides, mm: else the two meet at a corner.
const GOES_ON: f32 = 2.0;
/// Plates are no longer than so many least lengths of lines: longer ones are lines by themselves.
const LONGEST: f32 = 3.0;
/// Wires lead straight towards one another (the cosine); their direction is taken over this length, mm.
const TOWARDS: f32 = 0.9;
const HEADING: f32 = 1.5;
/// A plate is moved by at most this, mm: that there are two says more than where exactly they lie. Chosen by us: on a
/// grid of 2 mm a gap of one is made wide enough.
const FARTHEST: f32 = 3.0;
/// More than two lines have to be apart, mm, so that they need not be moved again.
const MORE: f32 = 0.05;

/// An end of a line that stands on another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Standing {
    line: usize,
    which: Tip,
    pub(super) at: MmPoint,
    /// The number of the line on which it stands.
    pub(super) base: u32,
}

/// The ends of lines that stand on others.
pub(super) fn standing(polylines: &[Polyline<Vertex>], area: MmRect, params: &Params) -> Vec<Standing> {
    let lines = nearby(polylines.iter(), area, params);
    let lengths: Vec<f32> = polylines.iter().map(Polyline::length).collect();
    let ends = polylines.iter().enumerate().filter(|(_, line)| !line.closed);
    let ends = ends.flat_map(|(line, polyline)| Tip::BOTH.map(|which| (line, which, which.of(polyline))));
    let stands = |(line, which, end): (usize, Tip, Option<&Vertex>)| {
        let at = end?.at;
        let goes_on = |segment: &Segment| {
            let base = segment.line as usize;
            let arc = segment.arc + (nearest_on_segment(at, segment.a, segment.b).1 - segment.a).length();
            base != line && (polylines[base].closed || (GOES_ON..lengths[base] - GOES_ON).contains(&arc))
        };
        let (_, _, segment) = lines.nearest(at, TOUCHES, goes_on)?;
        Some(Standing { line, which, at, base: segment.line })
    };
    ends.filter_map(stands).collect()
}

/// Moves two short lines on which the ends of others stand that lead towards one another apart, with these ends, so
/// that there is room for both.
pub(super) fn part_plates(polylines: &mut [Polyline<Vertex>], standing: &mut [Standing], params: &Params) {
    let spacing = params.max_clearance() + MORE;
    let is_plate = |polylines: &[Polyline<Vertex>], of: &Standing| {
        let plate = &polylines[of.base as usize];
        let alone = standing.iter().filter(|other| other.base == of.base).count() == 1;
        alone && !plate.closed && plate.length() <= LONGEST * params.min_length
    };
    let plates: Vec<usize> = (0..standing.len()).filter(|&of| is_plate(polylines, &standing[of])).collect();
    for (k, &first) in plates.iter().enumerate() {
        for &second in &plates[k + 1..] {
            let [a, b] = [standing[first], standing[second]];
            let (gap, shift) = (b.at - a.at, 0.5 * (spacing - (b.at - a.at).length()));
            let Some(ahead) = gap.try_normalize() else { continue };
            let leads = |of: &Standing, sign: f32| {
                let wire = &polylines[of.line];
                heading(wire, of.which, HEADING).is_some_and(|way| sign * way.dot(ahead) >= TOWARDS)
                    && wire.length() - shift >= params.min_length
            };
            if a.line == b.line || !(0.0..=FARTHEST).contains(&shift) || !leads(&a, 1.0) || !leads(&b, -1.0) {
                continue;
            }
            for (of, step) in [(first, ahead * -shift), (second, ahead * shift)] {
                let Standing { line, which, base, .. } = standing[of];
                polylines[line] = shortened(&polylines[line], which, shift);
                polylines[base as usize].vertices.iter_mut().for_each(|vertex| vertex.at += step);
                // the wire may lead there at a small angle
                if let Some(end) = which.of_mut(&mut polylines[line]) {
                    end.at = standing[of].at + step;
                    standing[of].at = end.at;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
