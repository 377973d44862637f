//! A line that was cut is led on to what it would have met soon.

use super::field::Field;
use super::own::is_bend;
use super::{Params, meet};
use crate::geom::nearby::Segment;
use crate::geom::{crossing, nearest_on_segment};
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmVector};

/// A line whose path comes this near to another, in join gaps, may be led over to it.
const MEETS: f32 = 0.5;
/// ... if it does not turn aside for it: least cosine between its heading and the way over.
const AHEAD: f32 = 0.5;
/// ... where the way over is longer than this, mm; shorter ones have no direction worth asking for.
const TURN: f32 = 0.75;
/// The heading is taken over this much of the line, mm.
const HEADING: f32 = 2.0;
/// A line that would meet another this near to where a third one does is led to the same place, mm.
const SNAP: f32 = 1.5;

/// The vertices that lead a line on along its old `path`, to a line that it meets soon and not too flat. `own` is the line
/// itself if it is drawn already, which it may meet as well.
pub(super) fn lead_on(
    body: &[Vertex],
    path: &[Vertex],
    ends: bool,
    field: &Field<'_>,
    own: Option<u32>,
    params: &Params,
) -> Option<Vec<Vertex>> {
    let start = body.last()?;
    let length: f32 = body.windows(2).map(|pair| (pair[1].at - pair[0].at).length()).sum();
    let own_bend = |segment: &Segment, way: f32, distance: f32| {
        own == Some(segment.line) && is_bend(length + way - segment.arc, distance)
    };
    // a line that is led back to itself makes a loop that a finger finds
    let own_knot = |segment: &Segment, way: f32, distance: f32| {
        own == Some(segment.line) && is_bend(length + way - segment.arc - field.longest_stub(), distance)
    };
    let longest = field.longest_approach();
    let mut led: Vec<Vertex> = Vec::new();
    let mut way = 0.0;
    // the place to be led to, how many vertices come before it, and how far it is from the last of them
    let mut target: Option<(MmPoint, usize, f32)> = None;
    for vertex in path {
        let last = led.last().unwrap_or(start).at;
        let mut hit: Option<(f32, MmPoint)> = None;
        field.segments().around(last.min(vertex.at), last.max(vertex.at), 0.0, |segment| {
            if let Some(at) = crossing((last, vertex.at), (segment.a, segment.b)) {
                let distance = (at - last).length();
                if hit.is_none_or(|(least, _)| distance < least) && !own_knot(segment, way + distance, 0.0) {
                    hit = Some((distance, at));
                }
            }
        });
        if let Some((_, at)) = hit {
            target = Some((at, led.len(), 0.0));
            break;
        }
        way += (vertex.at - last).length();
        if way > longest {
            break;
        }
        led.push(*vertex);
        let reach = target.map_or(MEETS * params.join_gap, |(.., distance)| distance);
        let near = field.segments().nearest(vertex.at, reach, |segment| {
            !own_knot(segment, way, nearest_on_segment(vertex.at, segment.a, segment.b).0)
        });
        if let Some((distance, at, _)) = near {
            target = Some((at, led.len(), distance));
            if distance < 1e-3 {
                break;
            }
        }
    }
    if target.is_none() && ends && way <= longest {
        // the contour itself ends: what it points at
        let tip = led.last().unwrap_or(start);
        let heading = heading(body, &led)?;
        let at = meet::ahead(tip.at, heading, field.segments(), params.join_gap, |_| true)?;
        target = Some((at, led.len(), (at - tip.at).length()));
    }
    let (mut at, count, _) = target?;
    led.truncate(count);
    if let Some(tip) = field.nearest_tip(at, SNAP) {
        at = tip;
        while led.last().is_some_and(|vertex| (vertex.at - tip).length() < SNAP) {
            led.pop();
        }
    }
    if own.is_some() && body.first().is_some_and(|first| (first.at - at).length() < SNAP) {
        return None; // it would close the ring that was cut open because its sides are too near
    }
    let tip = *led.last().unwrap_or(start);
    let over = at - tip.at;
    let turns = heading(body, &led).is_some_and(|heading| over.dot(heading) < AHEAD * over.length());
    if over.length() > params.join_gap || (over.length() > TURN && turns) {
        return None;
    }
    led.extend(meet::way(&tip, at));
    let mut whole = vec![*start];
    whole.extend(&led);
    let places = field.arriving(&whole);
    let joins = whole.iter().zip(&places.arcs).skip(1).all(|(vertex, &arc)| {
        let mut fits = true;
        field.each_near(vertex, arc, &places, |near, _, joins| {
            fits = joins || own_bend(near.segment, arc, near.distance);
            fits
        });
        fits
    });
    (joins && places.arcs.last().is_some_and(|&arc| arc <= longest)).then_some(led)
}

/// The direction of a line that goes on with `led`.
fn heading(body: &[Vertex], led: &[Vertex]) -> Option<MmVector> {
    let mut back = led.iter().rev().chain(body.iter().rev());
    let tip = back.next()?.at;
    let inner = back.find(|vertex| (vertex.at - tip).length() >= HEADING).or(body.first())?.at;
    (tip - inner).try_normalize()
}
