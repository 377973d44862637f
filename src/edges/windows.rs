//! Windows in the walls of plans: thin strokes beside one another between the ends of two walls that lie in one line.
//! Their gap is none on the page, and at the walls they end beside the middle of these: the wall would be open, or have
//! a bulge. They become one thin stroke, along the middle, from wall to wall.
//!
//! ```text
//!   #######-----------#######            #######           #######
//!   #######           #######     ->     #######-----------#######
//!   #######-----------#######            #######           #######
//! ```

use super::contour::{Contour, ContourPoint};
use super::stroke::are_two_breadths;
use super::tips::FoundContour;
use crate::units::{PxPoint, PxVector};

/// The ends of two walls lie in one line if the cosine between the direction of each and the way to the other is at
/// least this (8 degrees), and the broader wall is at most so many times as broad as the other.
const IN_LINE: f32 = 0.99;
const ALIKE: f32 = 1.5;
/// The direction of an end is taken over so many widths of the wall, but for the last one, where others join it.
const HEADING: f32 = 3.0;
/// A pane lies no farther from the middle than half of the wall's width and this much more, px, and no farther beyond
/// the ends of the walls than these are broad; along the window it is this share of it, at least.
const BESIDE: f32 = 1.5;
const ALONG: f32 = 0.8;

/// A drawing with more ends of broad strokes is no plan: it has none looked for.
const MOST_ENDS: usize = 400;

/// The end of a wall.
struct WallEnd {
    at: PxPoint,
    /// Away from the wall.
    direction: PxVector,
    width: f32,
}

/// Contours whose windows are one stroke each.
pub(super) fn merged(mut found: Vec<FoundContour>) -> Vec<FoundContour> {
    let ends = wall_ends(&found);
    if ends.len() > MOST_ENDS {
        return found;
    }
    let pairs = (0..ends.len()).flat_map(|a| (a + 1..ends.len()).map(move |b| (a, b)));
    let pairs = pairs.map(|(a, b)| [&ends[a], &ends[b]]).filter(are_in_line);
    for pair in pairs.collect::<Vec<_>>() {
        let is_pane: Vec<bool> = found.iter().map(|contour| is_pane(contour, pair)).collect();
        let Some(first) = is_pane.iter().position(|is_pane| *is_pane) else { continue };
        let window = between(pair, &found[first]);
        let mut number = 0;
        found.retain(|_| {
            number += 1;
            !is_pane[number - 1]
        });
        found.push(window);
    }
    found
}

/// The ends of the strokes that are broad beside some other one.
fn wall_ends(found: &[FoundContour]) -> Vec<WallEnd> {
    let thinnest = found.iter().filter_map(|found| found.stroke).fold(f32::INFINITY, f32::min);
    let is_wall = |(found, width): &(&FoundContour, f32)| {
        !found.contour.closed && found.contour.vertices.len() > 1 && are_two_breadths(thinnest, *width)
    };
    let walls = found.iter().filter_map(|found| Some((found, found.stroke?))).filter(is_wall);
    let both = walls.flat_map(|(found, width)| [true, false].map(|at_start| end(found, width, at_start)));
    both.flatten().collect()
}

fn end(found: &FoundContour, width: f32, at_start: bool) -> Option<WallEnd> {
    let tip = if at_start { 0 } else { found.contour.vertices.len() - 1 };
    let inwards = found.contour.heading(tip, at_start, [width, HEADING * width])?;
    Some(WallEnd { at: found.contour.vertices[tip].at, direction: -inwards, width })
}

/// Whether two walls lie in one line, with a gap between them.
fn are_in_line([a, b]: &[&WallEnd; 2]) -> bool {
    let Some(way) = (b.at - a.at).try_normalize() else { return false };
    let is_wide = (b.at - a.at).length() >= a.width.max(b.width);
    let are_alike = a.width.max(b.width) <= ALIKE * a.width.min(b.width);
    is_wide && are_alike && a.direction.dot(way) >= IN_LINE && -b.direction.dot(way) >= IN_LINE
}

/// Whether a contour is a thin stroke along a window, and nowhere else.
fn is_pane(found: &FoundContour, [a, b]: [&WallEnd; 2]) -> bool {
    let width = a.width.max(b.width);
    let Some(stroke) = found.stroke.filter(|stroke| are_two_breadths(*stroke, width)) else { return false };
    let length = (b.at - a.at).length();
    let along = (b.at - a.at) / length;
    let beside = 0.5 * (width - stroke).max(0.0) + BESIDE;
    let places = || found.contour.vertices.iter().map(|vertex| vertex.at - a.at);
    let is_in = |way: PxVector| way.cross(along).abs() <= beside && (-width..=length + width).contains(&way.dot(along));
    if !places().all(is_in) {
        return false;
    }
    let arcs = || places().map(|way| way.dot(along).clamp(0.0, length));
    arcs().fold(0.0, f32::max) - arcs().fold(length, f32::min) >= ALONG * length
}

/// The stroke from wall to wall that is like a pane.
fn between([a, b]: [&WallEnd; 2], pane: &FoundContour) -> FoundContour {
    let middle = pane.contour.vertices[pane.contour.vertices.len() / 2];
    let mut contour = Contour::open(vec![ContourPoint { at: a.at, strength: pane.height(), ..middle }]);
    contour.lead_to(b.at);
    FoundContour { whole: contour.length(), contour, stroke: pane.stroke, tint: pane.tint }
}

#[cfg(test)]
mod tests;
