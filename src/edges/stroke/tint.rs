//! The tint of a stroke: in which direction its colour lies from that of the ground beside it. Where two strokes cross
//! or run near one another, thinning makes one line of pieces of both; their tints tell them apart.
//!
//! A stroke that is thinner than a pixel is mixed with its ground, more here and less there: that changes its contrast,
//! and hardly its tint. Black and all greys are one tint on white.

use std::cmp::Ordering;

use crate::geom::polyline::Polyline;
use crate::geom::walk::runs;
use crate::raster::contrast;
use crate::units::PxPoint;

/// Two tints are one if the cosine between them is at least this. Between a colour of the palettes of Matplotlib and
/// Excel and the same mixed with three quarters of white it is at least 0.95; between orange and red 0.91, between
/// other two of the first four of Matplotlib at most 0.55.
const ONE: f32 = 0.93;
/// So many tints of a line are tried, one after the other, for the one that most of it has.
const TRIED: usize = 64;
/// An end has another tint if it has it for this much, px: it is a hook, along what the line ends on.
const HOOKED: f32 = 3.0;

/// The direction, as a unit vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::edges) struct Tint([f32; 3]);

impl Tint {
    /// That of a colour, given by what it has more than its ground; none of the ground itself.
    pub(in crate::edges) fn of(excess: [f32; 3]) -> Option<Self> {
        let length = contrast::length(excess);
        (length > 0.0).then(|| Self(excess.map(|value| value / length)))
    }

    /// The one that most of some tints are alike to. Of several to which as many are, it is the same in whichever
    /// direction a line is followed.
    pub(super) fn most_common(tints: &[Self]) -> Option<Self> {
        let sum = tints.iter().fold([0.0_f32; 3], |sum, tint| [0, 1, 2].map(|axis| sum[axis] + tint.0[axis]));
        let mean = Self::of(sum)?;
        if !tints.iter().any(|tint| tint.differs_from(mean)) {
            return Some(mean);
        }
        let alike = |tint: Self| tints.iter().filter(|other| !other.differs_from(tint)).count();
        let tried = tints.iter().copied().step_by(tints.len().div_ceil(TRIED)).map(|tint| (alike(tint), tint));
        tried.max_by(|a, b| a.0.cmp(&b.0).then_with(|| a.1.by_value(b.1))).map(|(_, tint)| tint)
    }

    /// An order that hangs on nothing but the two.
    fn by_value(self, other: Self) -> Ordering {
        let axes = self.0.iter().zip(&other.0).map(|(a, b)| a.total_cmp(b));
        axes.fold(Ordering::Equal, Ordering::then)
    }

    /// Whether the two are not one.
    pub(in crate::edges) fn differs_from(self, other: Self) -> bool {
        contrast::dot(self.0, other.0) < ONE
    }

    /// Whether two are known not to be one.
    pub(in crate::edges) fn are_two(one: Option<Self>, other: Option<Self>) -> bool {
        one.zip(other).is_some_and(|(one, other)| one.differs_from(other))
    }
}

/// The parts of a line that have one tint each, as the numbers of their vertices, if it has several. `tints` are those
/// of its vertices, where they are known. What has another tint over less than `apart` px is no part: a line that
/// crosses.
pub(super) fn parts(line: &Polyline<PxPoint>, tints: &[Option<Tint>], apart: f32) -> Option<Vec<Vec<usize>>> {
    let known = |vertices: &[usize]| vertices.iter().filter_map(|&i| tints[i]).collect::<Vec<Tint>>();
    let mut order: Vec<usize> = (0..tints.len()).collect();
    let main = Tint::most_common(&known(&order))?;
    if line.closed {
        // from a vertex of the main tint once round
        let start = tints.iter().position(|tint| tint.is_some_and(|tint| !tint.differs_from(main)))?;
        order.rotate_left(start);
        order.push(start);
    }
    let (mut parts, mut waiting) = divided(&order, main, line, tints, apart);
    if waiting.is_empty() {
        return None;
    }
    if line.closed && parts.len() > 1 {
        let first = parts.remove(0);
        if let Some(last) = parts.last_mut() {
            last.extend(first.into_iter().skip(1));
        }
    }
    while let Some(order) = waiting.pop() {
        let Some(main) = Tint::most_common(&known(&order)) else { continue };
        let (own, others) = divided(&order, main, line, tints, apart);
        parts.extend(own);
        waiting.extend(others);
    }
    Some(parts)
}

/// The parts of a line, given by its vertices in order, that have the main tint; and those that have others. What lies
/// between the two is in none of them: there is something of both strokes.
fn divided(
    order: &[usize],
    main: Tint,
    line: &Polyline<PxPoint>,
    tints: &[Option<Tint>],
    apart: f32,
) -> (Vec<Vec<usize>>, Vec<Vec<usize>>) {
    let mut arc = 0.0;
    let mut arcs = vec![arc];
    arcs.extend(order.windows(2).map(|pair| {
        arc += (line.vertices[pair[1]] - line.vertices[pair[0]]).length();
        arc
    }));
    let length = |from: usize, to: usize| arcs[to] - arcs[from];
    let end = order.len() - 1;
    // the places in the order whose tints are known, and runs of such as are of the main tint or of others
    let places: Vec<usize> = (0..order.len()).filter(|&place| tints[order[place]].is_some()).collect();
    let is_main = |k: usize| tints[order[places[k]]].is_some_and(|tint| !tint.differs_from(main));
    let runs = runs(places.len(), false, |a, b| is_main(a) == is_main(b));
    let first_of = |run: &Vec<usize>| places[run[0]];
    let last_of = |run: &Vec<usize>| places[run[run.len() - 1]];
    let (mut own, mut others) = (Vec::new(), Vec::new());
    // where the part begins that is not finished; none after an end of another tint
    let mut from = Some(0);
    for (number, run) in runs.iter().enumerate().filter(|(_, run)| !is_main(run[0])) {
        let (first, last) = (first_of(run), last_of(run));
        let before = number.checked_sub(1).map(|before| last_of(&runs[before]));
        let after = runs.get(number + 1).map(first_of);
        let (is_change, [first, last]) = match (before, after) {
            (Some(_), Some(_)) => (length(first, last) >= apart, [first, last]),
            (Some(before), None) => (length(before, end) >= HOOKED && length(before, first) <= apart, [first, end]),
            (None, Some(after)) => (length(0, after) >= HOOKED && length(last, after) <= apart, [0, last]),
            // the main tint is that of some
            (None, None) => continue,
        };
        if is_change {
            own.extend(from.zip(before).map(|(from, to)| order[from..=to].to_vec()));
            others.push(order[first..=last].to_vec());
            from = after;
        }
    }
    own.extend(from.map(|from| order[from..].to_vec()));
    (own, others)
}

#[cfg(test)]
mod tests;
