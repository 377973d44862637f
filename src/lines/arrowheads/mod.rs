//! Heads of arrows: small triangles and open angles at the ends of lines. Which way a line leads is what an arrow says,
//! and as contours its head is too small for lines, or a clot at the end of its shaft.
//!
//! ```text
//!            \                  drawn in a size that fingers find, as two strokes as broad as the shaft,
//!   -----------\                which end in its tip; the tip keeps the least blank from what it points at,
//!              /
//!            /            or touches it where the shaft is too short for that
//! ```

mod find;
mod finished;
mod place;
mod shapes;
mod shorten;

use self::find::{Contours, FoundHead};
use self::shorten::make_room;
use super::lead_on::extend_to;
use super::marks::HeadMark;
use super::params::Params;
use super::vertex::Vertex;
use crate::geom::polyline::Polyline;
use crate::units::{MmPoint, MmRect, MmVector};

pub use finished::{Arrow, arrows};
pub(super) use place::{DrawnHeads, draw, find_shafts};
pub use shapes::is_triangle;

/// Short contours so near to a head are parts of it, mm.
const CRUMB: f32 = 0.6;
/// A shaft that ends before the tip by less than this is not led on, mm.
const AT_TIP: f32 = 0.05;

/// The head of an arrow with its tip at a place: its two strokes, from one end to the other.
pub fn arrowhead(at: MmPoint, toward: MmVector) -> [MmPoint; 3] {
    place::strokes(at, toward, shapes::LENGTHS[0])
}

/// Which contours of a drawing are shafts of arrows, by the heads at their ends.
pub(super) fn are_shafts(polylines: &[Polyline<Vertex>], area: MmRect) -> Vec<bool> {
    let mut are_shafts = vec![false; polylines.len()];
    Contours::of(polylines, area).heads().iter().for_each(|head| are_shafts[head.shaft.line] = true);
    are_shafts
}

/// Takes the heads of arrows out of the contours of a drawing. Their shafts lead to their tips, or end so far before
/// what these point at that there is room for the heads.
pub(super) fn take(polylines: &mut Vec<Polyline<Vertex>>, area: MmRect, params: &Params) -> Vec<HeadMark> {
    let heads = Contours::of(polylines, area).heads();
    if heads.is_empty() {
        return Vec::new();
    }
    let mut taken = vec![false; polylines.len()];
    let mut marks: Vec<HeadMark> = Vec::new();
    for FoundHead { tip, shaft, lines } in &heads {
        lines.iter().for_each(|line| taken[*line] = true);
        let points = lines.iter().flat_map(|line| polylines[*line].vertices.iter().map(|vertex| vertex.at));
        let extent = MmRect::from_points(points.chain([tip.apex]));
        let toward = tip.axis().try_normalize().unwrap_or(shaft.heading);
        if (tip.apex - shaft.at).dot(toward) > AT_TIP {
            extend_to(&mut polylines[shaft.line], shaft.which, tip.apex);
        }
        let strength = shaft.which.of(&polylines[shaft.line]).map_or(0.0, |end| end.strength);
        marks.push(HeadMark {
            at: tip.apex,
            toward,
            extent,
            strength,
            shortened: 0.0,
            has_shaft: true,
            is_drawn: false,
        });
    }
    let shafts: Vec<usize> = heads.iter().map(|head| head.shaft.line).collect();
    let parts: Vec<MmRect> = marks.iter().map(|mark| mark.extent.inflate(CRUMB, CRUMB)).collect();
    for (line, polyline) in polylines.iter().enumerate().filter(|(line, _)| !shafts.contains(line)) {
        let is_in = |head: &MmRect| polyline.vertices.iter().all(|vertex| head.contains(vertex.at));
        taken[line] |= parts.iter().any(is_in);
    }
    make_room(&heads, &mut marks, polylines, &taken, area, params);
    let mut number = 0;
    polylines.retain(|_| {
        number += 1;
        !taken[number - 1]
    });
    marks
}

#[cfg(test)]
mod tests;
