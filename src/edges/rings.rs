//! A line that comes back to itself is a ring, and what leads to the ring: where a leader meets a circle, the two may
//! have been found as one line.

use super::params::HEADING;
use super::tips::FoundContour;
use crate::geom::polyline::Polyline;

/// An end meets its own line where it is no farther from the middle of the stroke than half its width and this, px.
const NEAR: f32 = 2.0;
/// An end meets its own line also where that is so far ahead, px: an edge that meets a stroke ends before it.
const AHEAD_LENGTH: f32 = 8.0;
/// An end that meets its own line goes on in it: least cosine between their directions (37 degrees).
const SMOOTH: f32 = 0.8;
const BENT: f32 = 3.0;

/// A ring is at least this many least lengths of a contour long: what is shorter is felt as a dot at an end.
const RING: f32 = 3.0;

/// Contours of which those that come back to themselves are parted. `least` is the length of the shortest contour, px.
pub(super) fn split_at_contact(found: Vec<FoundContour>, least: f32) -> Vec<FoundContour> {
    let mut all = Vec::with_capacity(found.len());
    for found in found {
        let mut left = Some(found);
        // what leads to a ring may come from another one
        while let Some(found) = left {
            let (first, lead) = part(found, RING * least);
            all.push(first);
            left = lead;
        }
    }
    all
}

/// The ring, and what leads to it; or the contour itself.
fn part(mut found: FoundContour, least: f32) -> (FoundContour, Option<FoundContour>) {
    for turned in [false, true] {
        if turned {
            found.contour.reverse();
        }
        if let Some(at) = comes_back_to(&found, least) {
            let vertices = &found.contour.vertices;
            let ring = Polyline { vertices: vertices[at..].to_vec(), closed: true };
            let lead = Polyline::open(vertices[..=at].to_vec());
            let part = |contour| FoundContour { contour, ..found };
            let lead = (lead.length() >= HEADING).then(|| part(lead));
            return (part(ring), lead);
        }
    }
    found.contour.reverse();
    (found, None)
}

/// The vertex of an open contour to which its end comes back.
fn comes_back_to(found: &FoundContour, least: f32) -> Option<usize> {
    let contour = &found.contour;
    if contour.closed {
        return None;
    }
    let last = contour.vertices.len().checked_sub(1)?;
    let tip = contour.vertices[last].at;
    let along = |from: usize, forwards: bool| contour.heading(from, forwards, [BENT, BENT + HEADING]);
    let end = -along(last, false)?;
    let early = contour.walk(last, false).find(|(_, arc)| *arc >= least)?.0;
    let near = 0.5 * found.stroke.unwrap_or(0.0) + NEAR;
    let goes_on = |at: &usize| {
        let gap = contour.vertices[*at].at - tip;
        let is_ahead = end.dot(gap) >= SMOOTH * gap.length();
        (gap.length() <= near || gap.length() <= AHEAD_LENGTH && is_ahead)
            && along(*at, true).is_some_and(|on| end.dot(on) >= SMOOTH)
    };
    let distance = |i: &usize| (contour.vertices[*i].at - tip).length();
    (0..=early).filter(goes_on).min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

#[cfg(test)]
mod tests;
