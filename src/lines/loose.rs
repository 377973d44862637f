//! Ends of lines that met another line in the drawing and end before it on the page, as connectors of a family tree: a
//! finger follows them and finds nothing.

use super::clearance::TOUCH;
use super::faint::is_faint;
use super::lead_on::heading;
use super::lost::{GAP, LostLine, STANDS};
use super::params::{HEADING, Params};
use super::vertex::{Tip, Vertex, nearby};
use crate::geom::nearby::Segment;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// Where more is missing before the other line, mm, the line is in pieces, and told as such. Chosen by us.
const MOST: f32 = 20.0;

/// What is missing between the ends of `drawn` lines and the lines that those of the drawing end on there, if these are
/// drawn; but for what is told as `torn`. Thin, pale lines give way to all others, and nothing is told of them.
pub(super) fn loose_ends<'a>(
    lines: &[&Polyline<Vertex>],
    drawn: impl Iterator<Item = &'a Polyline<Vertex>> + Clone,
    torn: &[LostLine],
    area: MmRect,
    params: &Params,
) -> Vec<LostLine> {
    let (of_drawing, near) = (nearby(lines.iter().copied(), area, params), nearby(drawn.clone(), area, params));
    let missing = |(number, line, which): (usize, &Polyline<Vertex>, Tip)| {
        let tip = which.of(line)?.at;
        let is_other = |segment: &Segment| segment.line as usize != number;
        if near.nearest(tip, GAP, is_other).is_some() {
            return None;
        }
        let is_open = |segment: &Segment| !lines[segment.line as usize].closed;
        let (_, at, segment) = of_drawing.nearest(tip, STANDS, is_open)?;
        let own = lines[segment.line as usize];
        let arc = segment.arc + (at - segment.a).length();
        let goes_on = heading(line, which, HEADING)?.dot(segment.b - segment.a) >= 0.0;
        let (beyond, length) = if goes_on { (Tip::Last, own.length() - arc) } else { (Tip::First, arc) };
        let end = beyond.of(own)?.at;
        let is_another = |other: &Segment| other.line != segment.line && !is_faint(lines[other.line as usize]);
        let met = of_drawing.nearest(end, TOUCH, is_another).is_some() && near.nearest(end, STANDS, is_other).is_some();
        let is_told = torn.iter().any(|torn| torn.extent.inflate(STANDS, STANDS).contains_inclusive(end));
        let extent = MmRect::from_points([tip, end]);
        let lost = LostLine { extent, length, closed: false, is_faint: false, form: None };
        (met && length <= MOST && !is_told && !is_faint(own)).then_some(lost)
    };
    let open = drawn.enumerate().filter(|(_, line)| !line.view().goes_round());
    open.flat_map(|(number, line)| Tip::BOTH.map(|which| (number, line, which))).filter_map(missing).collect()
}

#[cfg(test)]
mod tests;
