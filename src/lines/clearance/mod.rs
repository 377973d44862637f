//! Clearance: no two lines nearer than a finger can tell apart. Of two rivals the more salient stays, the other is
//! trimmed where it comes too near. Lines that truly join may meet.
//!
//! Lines wait in a queue, by rank and the most salient first. Each is judged among the lines that are drawn already
//! ([`Decision`]): it is drawn, or what becomes of it goes back into the queue.

mod anchor;
mod apart;
mod bases;
mod branch;
mod cluster;
mod displace;
mod drawn;
mod extend;
mod junctions;
mod near_line;
mod near_map;
mod passage;
mod queue;
mod self_distance;
mod shift;
mod split;
mod thinner;
mod walls;

pub(super) use apart::move_apart;
pub(crate) use bases::HIGHEST_STACK;
pub(crate) use cluster::APART;
pub(crate) use passage::TOUCH;
pub(super) use queue::Cleared;
pub(crate) use self_distance::{BEND, BEND_LEAST};

use self::displace::displaced;
use self::drawn::{DrawnLines, LineState};
use self::extend::{Extended, extension};
use self::passage::Junction;
use self::queue::{Queue, QueuedLine};
use self::self_distance::self_approach;
use self::split::{PartEnds, split, without_stubs};
use self::thinner::thinner;
use super::links;
use super::outlines::Rank;
use super::params::Params;
use super::saliency::saliency;
use super::vertex::Vertex;
use crate::geom::nearby::Nearby;
use crate::geom::polyline::Polyline;
use crate::units::MmRect;

/// What is to be done with a line.
#[derive(Debug, PartialEq)]
enum Decision {
    /// It is drawn.
    Draw {
        /// What is drawn.
        line: Polyline<Vertex>,
        /// Its junctions with the lines that are drawn.
        junctions: Vec<Junction>,
    },
    /// Its body is drawn; the rest comes back too near to the body, and is judged by itself.
    DrawBody {
        /// What is drawn.
        body: Polyline<Vertex>,
        /// What follows on it.
        rest: Polyline<Vertex>,
    },
    /// It ends on a line that it crosses shortly before its end.
    Shorten(Polyline<Vertex>),
    /// It moves away from lines that it is a little too near to.
    Displace(Polyline<Vertex>),
    /// A ring that comes too near to itself is an open line.
    Open(Polyline<Vertex>),
    /// It is too near to others, and this is left of it. If there is nothing left, it is dropped.
    Split(Vec<Polyline<Vertex>>),
}

/// Only in its first rounds, so many, is what is left of a line extended to lines that it joins. Where it comes in at
/// too small an angle the next round takes the extension away again, and it would go on like that until the line is
/// given up.
const EXTENDED_ROUNDS: u8 = 3;

/// Clears lines of these saliencies, the most salient one first; the result is in that order, after axes.
pub(super) fn clear(
    mut polylines: Vec<(Polyline<Vertex>, Rank)>,
    saliencies: &[f32],
    area: MmRect,
    params: &Params,
) -> Vec<Cleared> {
    let least = if params.of_drawing { links::shortest(params) } else { params.min_length };
    let mut queue = Queue::new(polylines.len(), least, params);
    let saliencies = bases::raised(saliencies, &mut polylines, area, params);
    for ((polyline, rank), saliency) in polylines.into_iter().zip(saliencies) {
        // Where a line comes near itself its earlier part stays.
        let polyline = polyline.stronger_half_first();
        queue.push_as(QueuedLine { polyline, rank, round: 0, is_part: false }, saliency);
    }
    let mut drawn = DrawnLines::new(area, params);
    let mut own = Nearby::new(area, params.max_spacing());
    let mut cleared: Vec<Cleared> = Vec::new();
    while let Some(line) = queue.pop() {
        let (rank, round, is_part) = (line.rank, line.round + 1, line.is_part);
        let is_whole_or_none = line.polyline.closed && params.whole_rings;
        match judge(line, &drawn, &mut own) {
            // a part of such a ring says nothing, so it is left out; only a ring of a person that is too near to itself
            // is drawn all the same, open
            Decision::Open(_) if is_whole_or_none && rank != Rank::Person => {}
            Decision::Split(_) if is_whole_or_none => {}
            Decision::Draw { line, junctions } => cleared.push(draw(line, &junctions, rank, &mut drawn)),
            Decision::DrawBody { body, rest } => {
                cleared.push(draw_body(body, &rest.vertices, rank, &mut drawn, &mut own));
                queue.push(QueuedLine { polyline: rest, rank, round, is_part: true });
            }
            Decision::Shorten(polyline) | Decision::Displace(polyline) | Decision::Open(polyline) => {
                queue.push(QueuedLine { polyline, rank, round, is_part })
            }
            Decision::Split(parts) => {
                let part = |polyline| QueuedLine { polyline, rank, round, is_part: true };
                parts.into_iter().for_each(|polyline| queue.push(part(polyline)))
            }
        }
    }
    anchor::anchor(&mut cleared, &drawn);
    // what was displaced or shortened may be more salient than before
    let is_axis = |line: &Cleared| line.rank == Rank::Axis;
    cleared.sort_by(|a, b| is_axis(b).cmp(&is_axis(a)).then(b.saliency.total_cmp(&a.saliency)));
    cleared
}

/// What is to be done with a line among those that are drawn. `own` is an empty index, and empty again afterwards.
fn judge(line: QueuedLine, drawn: &DrawnLines<'_>, own: &mut Nearby) -> Decision {
    let keeps_its_place = keeps_its_place(&line, drawn.params);
    let QueuedLine { mut polyline, round, .. } = line;
    // it is judged as it will be drawn: with both ends on one place of another line it is a ring
    drawn.snap(&mut polyline);
    let mut passage = drawn.passage(polyline.view());
    if let Some(shorter) = without_stubs(&polyline, &passage, drawn) {
        return Decision::Shorten(shorter);
    }
    if links::must_be(&polyline, drawn.params) {
        let Some(mut link) = extend::as_link(polyline, drawn) else { return Decision::Split(Vec::new()) };
        drawn.snap(&mut link);
        (passage, polyline) = (drawn.passage(link.view()), link);
    }
    let states = drawn.states_on(&polyline, &passage);
    if states.contains(&LineState::TooNear) {
        let thinner = thinner(&polyline, &passage, drawn);
        let displaced = if keeps_its_place { None } else { displaced(&polyline, passage, drawn) };
        if let Some(displaced) = displaced {
            return Decision::Displace(displaced);
        }
        let Some(thinner) = thinner else {
            let ends = if round < EXTENDED_ROUNDS { PartEnds::Extended } else { PartEnds::AsCut };
            return Decision::Split(split(&polyline, &states, ends, drawn));
        };
        (passage, polyline) = (drawn.passage(thinner.view()), thinner);
    }
    match self_approach(&polyline, drawn.params, own) {
        None => Decision::Draw { line: polyline, junctions: passage.junctions },
        Some(back) if polyline.closed => {
            // begun after the stretch that is too near, it comes last
            let mut open = polyline.opened_at(back.end % polyline.vertices.len());
            open.vertices.pop();
            Decision::Open(open)
        }
        Some(back) => until_return(polyline, back.start, drawn, own),
    }
}

/// Whether a line is not moved away from others: its height, or how far right it lies, is the value of a scale. It is a
/// level or upright one of a drawing that gives way to others, as a gridline does, or what is left of one that was cut:
/// its parts, each moved by itself, would be lines at several heights.
fn keeps_its_place(line: &QueuedLine, params: &Params) -> bool {
    let QueuedLine { polyline, rank, is_part, .. } = line;
    let (Some(first), Some(last)) = (polyline.vertices.first(), polyline.vertices.last()) else { return false };
    let along = last.at - first.at;
    let is_level = along.x.abs().min(along.y.abs()) <= LEVEL * along.length();
    let is_straight = !polyline.closed && along.length() >= STRAIGHT * polyline.length();
    params.of_drawing && (*is_part || *rank == Rank::Faint) && is_level && is_straight
}

/// Sine of the angle by which a line is off level or upright, at most: half a degree, as of rounded coordinates.
pub(super) const LEVEL: f32 = 0.009;
/// Least share of a straight line's length that its chord has: one of 100 mm bends by 0.7 mm.
const STRAIGHT: f32 = 0.9999;

/// The decision on an open line that comes back too near to itself from vertex `back` on.
fn until_return(mut body: Polyline<Vertex>, back: usize, drawn: &DrawnLines<'_>, own: &mut Nearby) -> Decision {
    let mut rest = body.vertices.split_off(back);
    // an end that lay on the line itself, and made what is near it a junction, may be gone
    while let Some(back) = self_approach(&body, drawn.params, own) {
        rest.splice(0..0, body.vertices.split_off(back.start));
    }
    let rest = Polyline::open(rest);
    // What was joined to a line by a junction beyond the cut is so no longer.
    if body.length() < drawn.params.min_length || drawn.states(&body).contains(&LineState::TooNear) {
        Decision::Split(vec![body, rest])
    } else {
        Decision::DrawBody { body, rest }
    }
}

/// Draws a line that has these junctions with those that are drawn.
fn draw(line: Polyline<Vertex>, junctions: &[Junction], rank: Rank, drawn: &mut DrawnLines<'_>) -> Cleared {
    let number = drawn.begin(&line);
    finish(line, junctions, rank, number, drawn)
}

/// Draws the body of a line that comes back to itself, extended along the rest to what it joins soon, itself perhaps.
fn draw_body(
    mut line: Polyline<Vertex>,
    rest: &[Vertex],
    rank: Rank,
    drawn: &mut DrawnLines<'_>,
    own: &mut Nearby,
) -> Cleared {
    drawn.snap(&mut line);
    let number = drawn.begin(&line);
    let body = line.vertices.len();
    if let Some(added) = extension(&line.vertices, rest, Extended::Line(number), drawn) {
        line.vertices.extend(added);
        if self_approach(&line, drawn.params, own).is_none() {
            drawn.go_on(&line, body - 1, number);
        } else {
            line.vertices.truncate(body);
        }
    }
    let junctions = drawn.junctions_with_others(&line, number);
    finish(line, &junctions, rank, number, drawn)
}

/// Lets others join the ends of a line; what was cut off it no longer counts for its saliency.
fn finish(
    line: Polyline<Vertex>,
    junctions: &[Junction],
    rank: Rank,
    number: u32,
    drawn: &mut DrawnLines<'_>,
) -> Cleared {
    drawn.finish(&line, number, junctions);
    let saliency = saliency(&line, drawn.params);
    Cleared { saliency, rank, anchored: vec![false; line.vertices.len()], polyline: line }
}

#[cfg(test)]
pub(super) mod tests;
