//! Clearance: no two lines nearer than a finger can tell apart. Of two rivals the more salient stays, the other is
//! trimmed where it comes too near. Lines that truly join may meet.
//!
//! Lines wait in a queue, by rank and the most salient first. Each is judged among the lines that are drawn already
//! ([`Decision`]): it is drawn, or what becomes of it goes back into the queue.

mod anchor;
mod apart;
mod bases;
mod branch;
mod displace;
mod drawn;
mod extend;
mod near_map;
mod passage;
mod queue;
mod self_distance;
mod shift;
mod split;

pub(super) use apart::move_apart;
pub(super) use queue::Cleared;
pub(crate) use self_distance::{BEND, BEND_LEAST};

use self::displace::displaced;
use self::drawn::{DrawnLines, LineState};
use self::extend::{Extended, extension};
use self::queue::{Queue, QueuedLine};
use self::self_distance::self_approach;
use self::split::{PartEnds, split, without_stubs};
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
    Draw(Polyline<Vertex>),
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

/// What is left of a line is extended to lines that it joins in so many rounds. Where it comes in at too small an angle
/// the next round takes the extension away again, and it would go on like that until the line is given up.
const EXTENDED_ROUNDS: u8 = 3;

/// Clears lines of these saliencies, the most salient one first; the result is in that order.
pub(super) fn clear(
    polylines: Vec<(Polyline<Vertex>, Rank)>,
    saliencies: &[f32],
    area: MmRect,
    params: &Params,
) -> Vec<Cleared> {
    let mut queue = Queue::new(polylines.len(), params);
    let saliencies = bases::raised(saliencies, &polylines, area, params);
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
            // a part of such a ring is nothing: it is left out
            Decision::Open(_) | Decision::Split(_) if is_whole_or_none => {}
            Decision::Draw(line) => cleared.push(draw(line, rank, &mut drawn)),
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
    cleared.sort_by(|a, b| b.saliency.total_cmp(&a.saliency));
    cleared
}

/// What is to be done with a line among those that are drawn. `own` is an empty index, and empty again afterwards.
fn judge(line: QueuedLine, drawn: &DrawnLines<'_>, own: &mut Nearby) -> Decision {
    let keeps_its_place = keeps_its_place(&line, drawn.params);
    let QueuedLine { mut polyline, round, .. } = line;
    // it is judged as it will be drawn: with both ends on one place of another line it is a ring
    drawn.snap(&mut polyline);
    if let Some(shorter) = without_stubs(&polyline, drawn) {
        return Decision::Shorten(shorter);
    }
    let states = drawn.states(&polyline);
    if states.contains(&LineState::TooNear) {
        let displaced = if keeps_its_place { None } else { displaced(&polyline, drawn) };
        return match displaced {
            Some(displaced) => Decision::Displace(displaced),
            None => {
                let ends = if round < EXTENDED_ROUNDS { PartEnds::Extended } else { PartEnds::AsCut };
                Decision::Split(split(&polyline, &states, ends, drawn))
            }
        };
    }
    match self_approach(&polyline, drawn.params, own) {
        None => Decision::Draw(polyline),
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
const LEVEL: f32 = 0.009;
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

/// Draws a line.
fn draw(mut line: Polyline<Vertex>, rank: Rank, drawn: &mut DrawnLines<'_>) -> Cleared {
    drawn.snap(&mut line);
    let number = drawn.begin(&line);
    finish(line, rank, number, drawn)
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
    finish(line, rank, number, drawn)
}

/// Lets others join the ends of a line; what was cut off it no longer counts for its saliency.
fn finish(line: Polyline<Vertex>, rank: Rank, number: u32, drawn: &mut DrawnLines<'_>) -> Cleared {
    drawn.finish(&line, number);
    let saliency = saliency(&line, drawn.params);
    Cleared { saliency, rank, anchored: vec![false; line.vertices.len()], polyline: line }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::lines::vertex::FoundIn;
    use crate::units::{MmPoint, MmVector};

    /// Clears lines by their own saliencies.
    pub(in crate::lines) fn clear_all(
        lines: Vec<(Polyline<Vertex>, Rank)>,
        area: MmRect,
        params: &Params,
    ) -> Vec<Cleared> {
        let saliencies: Vec<f32> = lines.iter().map(|(line, _)| saliency(line, params)).collect();
        clear(lines, &saliencies, area, params)
    }

    /// A line of the greatest width with vertices as close as those of lines in the making.
    pub(super) fn polyline(points: &[(f32, f32)], closed: bool) -> Polyline<Vertex> {
        let vertex = |&(x, y): &(f32, f32)| Vertex {
            at: MmPoint::new(x, y),
            strength: 60.0,
            contrast: [60.0, 0.0, 0.0],
            width: Params::TEST.width_max,
            source: FoundIn::Pixels,
            displaced: MmVector::zero(),
        };
        let mut polyline = Polyline { vertices: points.iter().map(vertex).collect(), closed };
        polyline.subdivide(0.4);
        polyline
    }

    /// Lines that are drawn on a square of 100 mm.
    pub(super) fn drawn(lines: &[&[(f32, f32)]]) -> DrawnLines<'static> {
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
        let mut drawn = DrawnLines::new(area, &Params::TEST);
        lines.iter().for_each(|points| {
            draw(polyline(points, false), Rank::Ordinary, &mut drawn);
        });
        drawn
    }

    /// The decision on a line where another runs along y = 50.
    fn decision(points: &[(f32, f32)], closed: bool) -> Decision {
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
        let mut own = Nearby::new(area, Params::TEST.max_spacing());
        let (polyline, rank) = (polyline(points, closed), Rank::Ordinary);
        let line = QueuedLine { polyline, rank, round: 0, is_part: false };
        judge(line, &drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]), &mut own)
    }

    #[test]
    fn a_ring_without_room_is_opened_or_left_out_as_a_whole() {
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
        let square = |low: f32, high: f32| polyline(&[(low, low), (high, low), (high, high), (low, high)], true);
        // on one side the inner one comes too near to the outer one
        let inner = polyline(&[(12.0, 30.0), (60.0, 30.0), (60.0, 60.0), (12.0, 60.0)], true);
        let cleared = |whole_rings: bool| {
            let params = Params { whole_rings, ..Params::TEST };
            let all = clear_all(
                [square(10.0, 90.0), inner.clone()].map(|ring| (ring, Rank::Ordinary)).to_vec(),
                area,
                &params,
            );
            all.iter().map(|line| line.polyline.closed).collect::<Vec<_>>()
        };
        assert_eq!(cleared(false), [true, false]);
        assert_eq!(cleared(true), [true]);
    }

    #[test]
    fn a_line_that_is_apart_or_crosses_steeply_is_drawn() {
        assert!(matches!(decision(&[(10.0, 60.0), (90.0, 60.0)], false), Decision::Draw(_)));
        assert!(matches!(decision(&[(50.1, 20.1), (50.1, 80.0)], false), Decision::Draw(_)));
        assert!(matches!(decision(&[(20.0, 60.0), (60.0, 60.0), (60.0, 90.0), (20.0, 90.0)], true), Decision::Draw(_)));
    }

    /// The states of the vertices of a line where another runs along y = 50.
    fn states(points: &[(f32, f32)], closed: bool) -> Vec<LineState> {
        drawn(&[&[(10.0, 50.0), (90.0, 50.0)]]).states(&polyline(points, closed))
    }

    #[test]
    fn a_spike_that_only_just_crosses_a_line_does_not_join_it() {
        let spike = [(46.0, 52.5), (49.8, 52.5), (50.01, 49.96), (50.2, 52.5), (54.0, 52.5)];
        assert!(states(&spike, false).iter().all(|state| *state == LineState::TooNear));
        // the same over the start of a ring
        let ring = [(50.01, 49.96), (50.2, 52.5), (54.0, 52.5), (54.0, 70.0), (46.0, 70.0), (46.0, 52.5), (49.8, 52.5)];
        assert_eq!(states(&ring, true)[0], LineState::TooNear);
        // a line that ends up on the other side joins
        let through = [(49.8, 80.1), (49.8, 52.5), (50.01, 49.96), (50.2, 20.1)];
        assert!(!states(&through, false).contains(&LineState::TooNear));
    }

    #[test]
    fn a_line_that_only_touches_the_corner_of_another_does_not_join_it() {
        let roof = drawn(&[&[(30.0, 70.0), (50.0, 50.0), (70.0, 70.0)]]);
        let states = |points: &[(f32, f32)]| roof.states(&polyline(points, false));
        assert!(states(&[(30.0, 30.0), (50.0, 50.0), (70.0, 30.0)]).contains(&LineState::TooNear));
        assert!(!states(&[(50.0, 20.0), (50.0, 50.0), (50.0, 80.0)]).contains(&LineState::TooNear));
    }

    #[test]
    fn a_line_whose_two_ends_meet_on_another_will_be_a_ring_and_does_not_join_it() {
        let drop = [(50.0, 50.0), (58.0, 60.0), (42.0, 60.0), (50.0, 50.0)];
        assert_eq!(states(&drop, false)[0], LineState::TooNear);
        assert_eq!(states(&drop[..2], false)[0], LineState::Joined);
        let almost = [drop[0], drop[1], drop[2], (50.0, 50.05)];
        assert!(!matches!(decision(&almost, false), Decision::Draw(_)), "its ends are drawn in one place");
    }

    #[test]
    fn each_way_of_being_too_near_has_its_decision() {
        assert!(matches!(decision(&[(50.1, 20.1), (50.1, 52.0)], false), Decision::Shorten(_)));
        assert!(matches!(decision(&[(10.0, 54.5), (90.0, 54.5)], false), Decision::Displace(_)));
        assert!(matches!(decision(&[(10.0, 60.0), (40.0, 52.0), (90.0, 52.0)], false), Decision::Split(_)));
        assert_eq!(decision(&[(15.0, 52.0), (85.0, 52.0)], false), Decision::Split(Vec::new()), "nothing is left");
    }

    #[test]
    fn a_gridline_and_the_parts_of_a_line_stay_at_their_height() {
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
        let params = Params { of_drawing: true, ..Params::TEST };
        let heights = |rank: Rank, is_crossed: bool| {
            // one along most of it is a little too near, and one crosses it
            let near = polyline(&[(30.0, 54.5), (60.0, 54.5)], false);
            let wall = polyline(&[(70.0, 49.0), (95.0, 49.0), (95.0, 52.0)], false);
            let line = polyline(&[(5.0, 50.0), (99.0, 50.0)], false);
            let walls = if is_crossed { vec![(wall, Rank::Subject)] } else { Vec::new() };
            let lines = walls.into_iter().chain([(near, Rank::Stroke), (line, rank)]).collect();
            let cleared = clear_all(lines, area, &params);
            let own = cleared.iter().filter(|line| line.rank == rank).flat_map(|line| &line.polyline.vertices);
            own.map(|vertex| (vertex.at.y - 50.0).abs()).fold(0.0, f32::max)
        };
        assert!(heights(Rank::Faint, false) < 0.01);
        assert!(heights(Rank::Ordinary, false) > 0.1, "a whole line may move");
        assert!(heights(Rank::Ordinary, true) < 0.01, "the parts of one are at one height");
    }

    #[test]
    fn what_comes_back_to_itself_is_opened_or_cut() {
        let flat_ring = [(20.0, 60.0), (80.0, 60.0), (80.0, 62.0), (20.0, 62.0)];
        assert!(matches!(decision(&flat_ring, true), Decision::Open(line) if !line.closed));
        let hairpin = [(20.0, 60.0), (80.0, 60.0), (80.0, 63.0), (20.0, 63.0)];
        let Decision::DrawBody { body, rest } = decision(&hairpin, false) else { panic!("it comes back") };
        assert!((60.0..70.0).contains(&body.length()) && rest.length() > 50.0);
    }

    #[test]
    fn a_body_that_is_too_short_without_the_rest_is_judged_anew() {
        // it comes back 7 mm from its start, and the least length is 8
        let coil = [(20.0, 60.0), (24.0, 60.0), (24.0, 61.0), (20.0, 61.0), (20.0, 90.0)];
        assert!(matches!(decision(&coil, false), Decision::Split(_)), "{:?}", decision(&coil, false));
    }

    #[test]
    fn an_outline_goes_before_a_more_salient_line_and_a_long_stroke_before_both() {
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
        let line = |y: f32, x: f32| polyline(&[(10.0, y), (x, y)], false);
        let clear = |ranks: [Rank; 3]| {
            let lines = [line(50.0, 90.0), line(52.0, 60.0), line(54.0, 40.0)];
            let cleared = clear_all(lines.into_iter().zip(ranks).collect(), area, &Params::TEST);
            let mut lengths: Vec<(Rank, u32)> =
                cleared.iter().map(|line| (line.rank, line.polyline.length().round() as u32)).collect();
            lengths.sort_unstable();
            lengths
        };
        assert_eq!(clear([Rank::Ordinary; 3]), [(Rank::Ordinary, 80)]);
        let drawn = clear([Rank::Ordinary, Rank::Outline, Rank::Ordinary]);
        assert_eq!(drawn.last(), Some(&(Rank::Outline, 50)), "the outline is whole");
        assert!(drawn.iter().all(|line| line.1 < 80), "{drawn:?}");
        let drawn = clear([Rank::Ordinary, Rank::Outline, Rank::Stroke]);
        assert_eq!(drawn.last(), Some(&(Rank::Stroke, 30)), "the stroke is whole");
    }
}
