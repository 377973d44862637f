//! Lines of a drawing that are all a little too near to their neighbours, as the bars of a chart, give way to one
//! another before any of them is drawn: each by half of what is missing (mutual displacement, as in the generalisation
//! of maps). Alone, the second of two would have to give way by all of it.

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::displace::{MORE, OUTSIDE, farthest, is_held};
use super::drawn::DrawnLines;
use super::passage::Passage;
use super::self_distance::is_rival;
use super::shift::shifts_of_drawing;
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::Vertex;
use crate::units::{MmPoint, MmRect, MmVector};

/// A line between two that are too near on both sides takes some rounds to find its place.
const ROUNDS: usize = 12;
/// The rounds end where one moves the lines, all together, by more than this share of what the round before did: there
/// is no place for all then. Where there is, each round leaves about half of what is missing.
const LESS: f32 = 0.9;

/// The lines, moved apart. None if no two are so little too near that this helps.
pub(in crate::lines) fn move_apart(
    polylines: &[Polyline<Vertex>],
    area: MmRect,
    params: &Params,
) -> Option<Vec<Polyline<Vertex>>> {
    let mut lines = polylines.to_vec();
    let places = |lines: &[Polyline<Vertex>]| -> Vec<Vec<MmPoint>> {
        lines.iter().map(|line| line.vertices.iter().map(|vertex| vertex.at).collect()).collect()
    };
    let own = places(&lines);
    // which lines join does not change, so junctions are found once, on the lines before they move
    let at_first = drawn(&lines, area, params, Joins::Found);
    let passages: Vec<Passage> = lines
        .par_iter()
        .enumerate()
        .map(|(number, line)| at_first.passage_among(line.view(), |other| other as usize != number))
        .collect();
    let reach: Vec<f32> = lines.iter().zip(&passages).map(|(line, passage)| farthest(line, passage, params)).collect();
    let mut last = f32::MAX;
    let mut has_moved = false;
    for _ in 0..ROUNDS {
        let drawn = drawn(&lines, area, params, Joins::Unknown);
        let all = MovingLines { lines: &lines, own: &own, passages: &passages, reach: &reach, drawn: &drawn };
        let moved: Vec<Vec<MmVector>> = (0..lines.len()).into_par_iter().map(|number| all.moves(number)).collect();
        let total_move: f32 = moved.iter().flatten().map(|push| push.length()).sum();
        if total_move > LESS * last || total_move == 0.0 {
            break;
        }
        last = total_move;
        has_moved = true;
        for ((line, moves), (own, reach)) in lines.iter_mut().zip(moved).zip(own.iter().zip(&reach)) {
            for ((vertex, push), own) in line.vertices.iter_mut().zip(moves).zip(own) {
                let to = *own + (vertex.at + push - *own).clamp_length(0.0, *reach);
                if area.inflate(OUTSIDE, OUTSIDE).contains_inclusive(to) {
                    vertex.at = to;
                }
            }
        }
    }
    has_moved.then_some(lines)
}

/// Whether it is known of lines which others they join.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Joins {
    Found,
    /// It does not matter: only how near they are to one another is looked at.
    Unknown,
}

/// All lines as if they were drawn.
fn drawn<'a>(lines: &[Polyline<Vertex>], area: MmRect, params: &'a Params, joins: Joins) -> DrawnLines<'a> {
    let mut drawn = DrawnLines::new(area, params);
    for line in lines {
        let number = drawn.begin(line);
        if joins == Joins::Found {
            let junctions = drawn.junctions_with_others(line, number);
            drawn.finish(line, number, &junctions);
        }
    }
    drawn
}

/// Every so many vertices, at most 2 mm apart, are looked at, and the ends; those between follow them.
const EVERY: usize = 4;

/// A line that its other side pushes on this share of its length is a narrow bar, which becomes wider; one that is
/// pushed on less has a pointed corner.
const NARROW: f32 = 0.25;

/// What is missing between a vertex and a rival, mm, and how the vertex gives way.
type VertexPush = (f32, MmVector);

/// Lines that move apart.
struct MovingLines<'a> {
    lines: &'a [Polyline<Vertex>],
    /// Where their vertices were at first.
    own: &'a [Vec<MmPoint>],
    /// The junctions of each with the others, before any moved: their arcs change by no more than lines move.
    passages: &'a [Passage],
    /// How far each may move, mm.
    reach: &'a [f32],
    drawn: &'a DrawnLines<'a>,
}

impl MovingLines<'_> {
    /// How the vertices of a line move away from the lines around: by half of what is missing.
    fn moves(&self, number: usize) -> Vec<MmVector> {
        let (line, passage, params) = (&self.lines[number], &self.passages[number], self.drawn.params);
        // of a bar or another ring the two sides may be too near to one another
        let may_meet_itself = is_held(line, passage, params);
        let arcs = line.arc_lengths();
        let mut rivals: Vec<(usize, [[VertexPush; 2]; 2])> = Vec::new();
        let last = line.vertices.len().saturating_sub(1);
        for (i, vertex) in line.vertices.iter().enumerate().filter(|(i, _)| i % EVERY == 0 || *i == last) {
            let arc = arcs[i];
            let tangent = line.tangent(i);
            // the worst rival on either side: of other lines, and of its own
            let mut worst: [[VertexPush; 2]; 2] = [[(0.0, MmVector::zero()); 2]; 2];
            let is_rival_line = |other: u32| may_meet_itself || other as usize != number;
            self.drawn.each_near_among(vertex, arc, passage, is_rival_line, |near| {
                let other = near.segment.line as usize;
                let is_rival = || match other == number {
                    true => is_rival(line, &arcs, [(arc, vertex.at), (near.line_arc, near.at)], near.distance),
                    // where the other one comes to a junction it may be near
                    false => !near.joins() && !self.passages[other].joins(number as u32, near.line_arc, near.approach),
                };
                let side = usize::from(tangent.cross(near.away) > 0.0);
                let (most, push) = &mut worst[usize::from(other == number)][side];
                if near.missing > *most && is_rival() {
                    *most = near.missing;
                    // where both together cannot give way by as much, one will be cut, and the other had better stay
                    let there = near.segment.index as usize;
                    let fits = near.missing <= self.left(number, i) + self.left(other, there) + MORE;
                    let share = if fits { 0.5 * (near.missing + MORE) / near.distance.max(MORE) } else { 0.0 };
                    *push = near.away * share;
                }
                true
            });
            rivals.push((i, worst));
        }
        let is_pushed = |of_own: &[VertexPush; 2]| of_own.iter().any(|(_, push)| *push != MmVector::zero());
        let by_own = rivals.iter().filter(|(_, [_, own])| is_pushed(own)).count();
        let is_narrow = by_own as f32 >= NARROW * rivals.len() as f32;
        let mut pushes = vec![MmVector::zero(); line.vertices.len()];
        for (i, [others, own]) in rivals {
            let sides = others.into_iter().zip(own);
            let worst = sides.map(|(other, own)| if is_narrow && own.0 > other.0 { own.1 } else { other.1 });
            pushes[i] = worst.fold(MmVector::zero(), |sum, push| sum + push);
        }
        if pushes.iter().all(|push| *push == MmVector::zero()) {
            return pushes;
        }
        shifts_of_drawing(line, &pushes, passage)
    }

    /// How far a vertex may still move, mm.
    fn left(&self, line: usize, vertex: usize) -> f32 {
        self.reach[line] - (self.lines[line].vertices[vertex].at - self.own[line][vertex]).length()
    }
}

#[cfg(test)]
mod tests;
