//! How the vertices of a line move when some of them are pushed: the others follow, less the farther they are. Straight
//! stretches of a drawing move as a whole and stay straight, and an end on another line slides along that.

use super::passage::{Junction, Meeting, Passage, TOUCH};
use crate::geom::polyline::Polyline;
use crate::lines::vertex::Vertex;
use crate::units::MmVector;

/// A line swings back to its place within this length, mm, so that no corner is felt.
const FADE: f32 = 6.0;
/// Least cosine between the directions of the segments of a straight stretch: 1 degree.
const STRAIGHT_COSINE: f32 = 0.99985;
/// A straight stretch is at least this long, mm: shorter ones are parts of curves.
const STRETCH: f32 = 2.0;
/// Where two stretches, or a stretch and the line on which it ends, meet at an angle with a smaller sine, their common
/// point is not computed from their offsets, as it may be far away.
const STEEP: f32 = 0.35;

/// A displacement at a place of a line, given by its arc, mm.
type LinePush = (f32, MmVector);

/// A straight stretch of a line.
struct StraightPart {
    /// Its first vertex.
    first: usize,
    /// How many segments it has.
    count: usize,
    /// At right angles to it, of length 1.
    normal: MmVector,
    /// How far it moves along the normal, mm.
    offset: f32,
}

impl StraightPart {
    fn shift(&self) -> MmVector {
        self.normal * self.offset
    }
}

/// The displacement of every vertex of a line, of which some are pushed; the others' push is zero. Straight stretches
/// stay straight.
pub(super) fn shifts_of_drawing(polyline: &Polyline<Vertex>, pushes: &[MmVector], passage: &Passage) -> Vec<MmVector> {
    let mut shifts: Vec<Option<MmVector>> = vec![None; polyline.vertices.len()];
    let stretches = stretches(polyline, pushes, passage);
    move_stretches(polyline, &stretches, passage, &mut shifts);
    with_others(shifts, pushes, passage)
}

/// The same of a line that may bend anywhere.
pub(super) fn shifts_of_curve(pushes: &[MmVector], passage: &Passage) -> Vec<MmVector> {
    with_others(vec![None; pushes.len()], pushes, passage)
}

/// The shifts of all vertices, of which those of some are known: the others follow these and their own pushes.
fn with_others(shifts: Vec<Option<MmVector>>, pushes: &[MmVector], passage: &Passage) -> Vec<MmVector> {
    let given = |i: usize| shifts[i].unwrap_or(pushes[i]);
    let pushed = (0..pushes.len()).map(|i| (passage.arcs[i], given(i))).filter(|(_, push)| *push != MmVector::zero());
    let pushed: Vec<LinePush> = pushed.collect();
    shifts
        .iter()
        .zip(&passage.arcs)
        .map(|(shift, &arc)| shift.unwrap_or_else(|| faded(arc, &pushed, passage)))
        .collect()
}

/// The straight stretches of a line, and how far each must move.
fn stretches(polyline: &Polyline<Vertex>, pushes: &[MmVector], passage: &Passage) -> Vec<StraightPart> {
    let directions: Vec<MmVector> =
        polyline.segments().map(|(a, b)| (b.at - a.at).try_normalize().unwrap_or_default()).collect();
    let (n, count) = (polyline.vertices.len(), directions.len());
    let is_straight = |a: MmVector, b: MmVector| a.dot(b) >= STRAIGHT_COSINE;
    // of a ring from a corner on
    let corner = (0..count).find(|&i| !is_straight(directions[(i + count - 1) % count], directions[i]));
    let start = match (polyline.closed, corner) {
        (false, _) => 0,
        (true, Some(corner)) => corner,
        (true, None) => return Vec::new(),
    };
    let order: Vec<usize> = (0..count).map(|k| (start + k) % count).collect();
    let mut stretches = Vec::new();
    let mut rest = &order[..];
    while let Some(&first) = rest.first() {
        let alike = rest.iter().take_while(|&&i| is_straight(directions[first], directions[i])).count().max(1);
        let (these, others) = rest.split_at(alike);
        rest = others;
        let length: f32 = these.iter().map(|&i| passage.arcs[i + 1] - passage.arcs[i]).sum();
        if length < STRETCH {
            continue;
        }
        let normal = MmVector::new(-directions[first].y, directions[first].x);
        let vertices = || (0..=alike).map(|k| (first + k) % n);
        // pushed to both sides, it goes between
        let across = || vertices().map(|i| pushes[i].dot(normal));
        let (low, high) = (across().fold(0.0, f32::min), across().fold(0.0, f32::max));
        let (from, to) = (passage.arcs[these[0]], passage.arcs[these[alike - 1] + 1]);
        // what ends on it would come off
        let within = |arc: f32| if from < to { (from..=to).contains(&arc) } else { !(to..from).contains(&arc) };
        let carries = |j: &Junction| j.meeting == Meeting::LineEnds && within(j.arc);
        let offset = if passage.junctions.iter().any(carries) { 0.0 } else { low + high };
        stretches.push(StraightPart { first, count: alike, normal, offset });
    }
    stretches
}

/// Moves the vertices of straight stretches.
fn move_stretches(
    polyline: &Polyline<Vertex>,
    stretches: &[StraightPart],
    passage: &Passage,
    shifts: &mut [Option<MmVector>],
) {
    let n = polyline.vertices.len();
    let (mut after, mut before) = (vec![None; n], vec![None; n]);
    for stretch in stretches {
        after[stretch.first] = Some(stretch);
        before[(stretch.first + stretch.count) % n] = Some(stretch);
    }
    for vertex in 0..n {
        shifts[vertex] = match (before[vertex], after[vertex]) {
            (Some(a), Some(b)) => Some(common(a, b)),
            (Some(one), None) | (None, Some(one)) => {
                let end =
                    passage.junctions.iter().find(|j| j.is_own_end() && (j.arc - passage.arcs[vertex]).abs() < TOUCH);
                Some(end.map_or(one.shift(), |end| slid(one, end.along)))
            }
            (None, None) => None,
        };
    }
    for stretch in stretches {
        let at = |k: usize| (stretch.first + k) % n;
        let (Some(from), Some(to)) = (shifts[at(0)], shifts[at(stretch.count)]) else { continue };
        for k in 1..stretch.count {
            shifts[at(k)] = Some(from.lerp(to, k as f32 / stretch.count as f32));
        }
    }
}

/// How the common vertex of two stretches moves: to where they cross when both have moved.
fn common(a: &StraightPart, b: &StraightPart) -> MmVector {
    let sine = a.normal.cross(b.normal);
    if sine.abs() < STEEP {
        return (a.shift() + b.shift()) * 0.5;
    }
    // the point d with d . a = offset of a and d . b = offset of b
    MmVector::new(
        (a.offset * b.normal.y - b.offset * a.normal.y) / sine,
        (b.offset * a.normal.x - a.offset * b.normal.x) / sine,
    )
}

/// How the end of a stretch moves that lies on a line with this direction: it stays on it.
fn slid(stretch: &StraightPart, along: MmVector) -> MmVector {
    let sine = along.dot(stretch.normal);
    if sine.abs() < STEEP { MmVector::zero() } else { along * (stretch.offset / sine) }
}

/// The longest of the displacements at `arc`, each of which fades along the line; near junctions the line stays where
/// it is.
fn faded(arc: f32, pushes: &[LinePush], passage: &Passage) -> MmVector {
    let mut longest = MmVector::zero();
    // those farther away have faded: of an open line the others are a run, of a ring there may be two more
    let at = |arc: f32| pushes.partition_point(|(there, _)| *there < arc);
    let first = at(arc - FADE - TOUCH);
    let last = at(arc + FADE + TOUCH).max(first);
    let over_start = passage.round.map(|round| {
        let before = at(arc + FADE + TOUCH - round).min(first);
        let after = at(arc - FADE - TOUCH + round).max(last);
        (&pushes[..before], &pushes[after..])
    });
    let (before, after) = over_start.unwrap_or_default();
    for &(there, push) in before.iter().chain(&pushes[first..last]).chain(after) {
        let push = push * (1.0 - passage.between(arc, there) / FADE).max(0.0);
        if push.square_length() > longest.square_length() {
            longest = push;
        }
    }
    let junction = passage.junctions.iter().map(|j| passage.between(j.arc, arc)).fold(f32::MAX, f32::min);
    longest * (junction / FADE).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::super::passage::Meeting;
    use super::*;
    use crate::lines::vertex::FoundIn;
    use crate::units::MmPoint;

    fn polyline(points: &[[f32; 2]], closed: bool) -> Polyline<Vertex> {
        let vertex = |&[x, y]: &[f32; 2]| Vertex {
            at: MmPoint::new(x, y),
            strength: 10.0,
            contrast: [0.0; 3],
            width: 1.0,
            source: FoundIn::Vector,
        };
        Polyline { closed, vertices: points.iter().map(vertex).collect() }
    }

    fn passage(polyline: &Polyline<Vertex>, junctions: Vec<Junction>) -> Passage {
        let mut arcs = vec![0.0];
        for (a, b) in polyline.segments() {
            arcs.push(arcs[arcs.len() - 1] + (b.at - a.at).length());
        }
        let round = polyline.closed.then(|| arcs[arcs.len() - 1]);
        Passage { arcs, round, junctions }
    }

    /// A junction at an arc, with a line of this direction.
    fn junction(arc: f32, along: [f32; 2], meeting: Meeting) -> Junction {
        Junction { arc, at: MmPoint::zero(), line: 0, line_arc: 0.0, along: along.into(), meeting }
    }

    /// A straight line along x with a vertex each millimetre, from 0 to 20.
    fn straight() -> Polyline<Vertex> {
        polyline(&std::array::from_fn::<_, 21, _>(|i| [i as f32, 0.0]), false)
    }

    /// No push but one.
    fn pushed(count: usize, at: usize, push: [f32; 2]) -> Vec<MmVector> {
        (0..count).map(|i| if i == at { push.into() } else { MmVector::zero() }).collect()
    }

    fn is_near(a: MmVector, [x, y]: [f32; 2]) -> bool {
        (a - MmVector::new(x, y)).length() < 1e-3
    }

    #[test]
    fn a_push_fades_along_a_curve() {
        let line = straight();
        let shifts = shifts_of_curve(&pushed(21, 10, [0.0, 1.0]), &passage(&line, Vec::new()));
        for (i, shift) in shifts.iter().enumerate() {
            let expected = (1.0 - (i as f32 - 10.0).abs() / FADE).max(0.0);
            assert!(is_near(*shift, [0.0, expected]), "{i}: {shift:?}");
        }
    }

    #[test]
    fn a_push_fades_over_the_start_of_a_ring() {
        let ring: Vec<[f32; 2]> =
            (0..40).map(|i| (i as f32 * 0.157).sin_cos()).map(|(y, x)| [6.4 * x, 6.4 * y]).collect();
        let ring = polyline(&ring, true);
        let shifts = shifts_of_curve(&pushed(40, 0, [1.0, 0.0]), &passage(&ring, Vec::new()));
        for i in 1..8 {
            assert!((shifts[i] - shifts[40 - i]).length() < 0.02, "{i}: {:?} and {:?}", shifts[i], shifts[40 - i]);
        }
        assert!(shifts[1].x > 0.8 && shifts[20] == MmVector::zero());
    }

    #[test]
    fn near_a_junction_a_line_stays() {
        let line = straight();
        let junctions = vec![junction(10.0, [0.0, 1.0], Meeting::Cross(1))];
        let shifts = shifts_of_curve(&pushed(21, 8, [0.0, 1.0]), &passage(&line, junctions));
        assert_eq!(shifts[10], MmVector::zero());
        assert!(shifts[7].y > shifts[9].y, "{:?} and {:?}", shifts[7], shifts[9]);
    }

    #[test]
    fn a_straight_stretch_moves_as_a_whole_and_its_corner_with_it() {
        let angle = polyline(&[[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, 5.0], [10.0, 10.0]], false);
        let shifts = shifts_of_drawing(&angle, &pushed(5, 1, [0.3, 1.0]), &passage(&angle, Vec::new()));
        // across the stretch only, the corner along the other side, whose far end stays
        for (i, expected) in [[0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 0.5], [0.0, 0.0]].into_iter().enumerate() {
            assert!(is_near(shifts[i], expected), "{i}: {:?}", shifts[i]);
        }
    }

    #[test]
    fn pushed_to_both_sides_it_goes_between() {
        let line = straight();
        let mut pushes = pushed(21, 4, [0.0, 1.0]);
        pushes[16] = MmVector::new(0.0, -0.4);
        let shifts = shifts_of_drawing(&line, &pushes, &passage(&line, Vec::new()));
        assert!(shifts.iter().all(|shift| is_near(*shift, [0.0, 0.6])), "{shifts:?}");
    }

    #[test]
    fn an_end_slides_along_the_line_that_it_lies_on() {
        let line = straight();
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let ends = |along| vec![junction(20.0, along, Meeting::PolylineEnds)];
        let last = |along| shifts_of_drawing(&line, &pushed(21, 10, [0.0, 1.0]), &passage(&line, ends(along)))[20];
        assert!(is_near(last([half, half]), [1.0, 1.0]));
        // on a line of nearly its own direction it would slide far away
        assert_eq!(last([0.98, 0.2]), MmVector::zero());
    }

    #[test]
    fn what_carries_the_end_of_another_line_stays() {
        let line = straight();
        let junctions = vec![junction(10.0, [0.0, 0.0], Meeting::LineEnds)];
        let shifts = shifts_of_drawing(&line, &pushed(21, 4, [0.0, 1.0]), &passage(&line, junctions));
        assert!(shifts.iter().all(|shift| *shift == MmVector::zero()), "{shifts:?}");
    }
}
