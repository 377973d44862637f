//! Labels that stand in one row or column of the picture, as at the axes of a chart: they are placed together, in
//! their order, all in one form, each beside what it names. One alone would take the room of its neighbour, or stand
//! under the next bar.

use super::candidates::{Around, BEFORE_LEADER, Candidate, JUST, TIGHTEST};
use super::forms::{Form, Forms};
use super::placed::{Params, Unplaced, Wanted};
use super::room::Room;
use crate::page::cells::CellGrid;
use crate::units::{MmPoint, MmRect, MmVector};

/// Fewest labels of a row. Two may stand side by side by chance.
const FEWEST: usize = 3;
/// Texts of one row have their middles at one height, and those of a column one edge below the other, up to so much,
/// mm: more than rounding, less than print lines are apart.
const ALIGNED: f32 = 0.7;
/// Points that a person gives by hand are in a row up to so much, mm.
const BY_HAND: f32 = 2.0;
/// How far a row may lie from its texts, mm: so near a label names something without a leader line.
const REACH: f32 = 12.0;
/// ... and how far with leader lines straight to its texts, mm: past a row of other things below them, such as a
/// legend.
const FAR: f32 = 30.0;
/// How far a label may be moved along its row, as a share of the way to its neighbour's anchor: its middle is then
/// still much nearer to its own.
const ALONG: f32 = 0.3;
/// Least blank between points and the labels below them, mm.
const BELOW_POINTS: f32 = 2.0;
/// What a second row of labels costs for each of them, mm.
const SECOND_ROW: f32 = 5.0;

/// How the labels of a group lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lies {
    /// Side by side, in place of texts.
    Row,
    /// Side by side, below points.
    BelowPoints,
    /// One above the other, with one edge in line: 0 is the left one, 1 the right one.
    Column(f32),
}

/// Labels that are placed together, in their order.
#[derive(Debug)]
pub struct Group {
    /// Which they are.
    pub members: Vec<usize>,
    /// In a row or a column.
    pub lies: Lies,
}

/// In which form the labels of a group are written.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Level {
    Whole,
    TwoLines,
    /// Each as it fits beside its anchor, in a column.
    Fitting,
    Short,
}

impl Level {
    /// The number of a label's form; of those that have no such form, the whole text.
    fn form(self, forms: &[Form], fits: impl Fn(&Form) -> bool) -> usize {
        let is = |form: &Form| match self {
            Self::Whole => false,
            Self::Fitting => fits(form),
            Self::TwoLines => form.is_in_two_lines(),
            Self::Short => form.abbreviation.is_some(),
        };
        forms.iter().position(is).unwrap_or(0)
    }
}

/// The least blank between labels side by side, and one above the other, mm.
pub fn least_blank() -> [f32; 2] {
    [TIGHTEST.aside(), TIGHTEST.above()]
}

/// What groups are placed in.
pub(super) struct Place<'a> {
    pub(super) wanted: &'a [Wanted],
    pub(super) forms: &'a [Result<Forms, Unplaced>],
    pub(super) around: &'a [Around<'a>],
    pub(super) room: &'a Room,
    pub(super) params: &'a Params,
    pub(super) cells: &'a CellGrid<'a>,
}

/// The place of each label that stands in a row or column which has room as a whole.
pub(super) fn placed(of: &Place<'_>) -> Vec<Option<Candidate>> {
    let mut placed: Vec<Option<Candidate>> = vec![None; of.wanted.len()];
    for group in groups(of) {
        if let Some(found) = of_group(&group, of, &placed) {
            for (&member, candidate) in group.members.iter().zip(found) {
                placed[member] = Some(candidate);
            }
        }
    }
    placed
}

/// What is written of what is wanted, in rows and columns.
fn groups(of: &Place<'_>) -> Vec<Group> {
    let is_written = |label: &usize| of.forms[*label].is_ok();
    let anchor = |label: usize| (label, of.wanted[label].anchor);
    let (texts, points): (Vec<usize>, Vec<usize>) =
        (0..of.wanted.len()).filter(is_written).partition(|&label| !of.wanted[label].anchor.is_empty());
    let points: Vec<_> = points.into_iter().filter(|&at| of.around[at].is_at_lower_side).map(anchor).collect();
    let below = in_line(&points, |place| place.center().y, BY_HAND);
    let below = below.into_iter().map(|members| Group { members, lies: Lies::BelowPoints });
    let mut groups: Vec<Group> = below.chain(of_texts(&texts.into_iter().map(anchor).collect::<Vec<_>>())).collect();
    for group in &mut groups {
        let along = |label: &usize| match (group.lies, of.wanted[*label].anchor.center()) {
            (Lies::Column(_), at) => at.y,
            (_, at) => at.x,
        };
        group.members.sort_by(|a, b| along(a).total_cmp(&along(b)));
    }
    groups
}

/// A coordinate of a box in which those of a row or column agree.
type Key = fn(MmRect) -> f32;

/// Texts in these boxes that stand in rows, the largest first, then columns of those that are in no row. Numbers at an
/// axis end in line, names in a list begin so.
pub fn of_texts(texts: &[(usize, MmRect)]) -> Vec<Group> {
    let rows = in_line(texts, |place| place.center().y, ALIGNED);
    let mut groups: Vec<Group> = rows.into_iter().map(|members| Group { members, lies: Lies::Row }).collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.members.len()));
    let mut alone = texts.to_vec();
    loop {
        alone.retain(|(label, _)| !groups.iter().any(|group| group.members.contains(label)));
        let edges: [(Key, f32); 3] =
            [(|place| place.max.x, 1.0), (|place| place.min.x, 0.0), (|place| place.center().x, 0.5)];
        let columns = edges.into_iter().flat_map(|(edge, side)| {
            in_line(&alone, edge, ALIGNED).into_iter().map(move |members| Group { members, lies: Lies::Column(side) })
        });
        match columns.reduce(|a, b| if b.members.len() > a.members.len() { b } else { a }) {
            Some(column) => groups.push(column),
            None => return groups,
        }
    }
}

/// Those that agree in a coordinate up to `off` mm, all with the first of them.
fn in_line(labels: &[(usize, MmRect)], key: Key, off: f32) -> Vec<Vec<usize>> {
    let mut sorted: Vec<(usize, f32)> = labels.iter().map(|&(label, place)| (label, key(place))).collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut lines: Vec<Vec<(usize, f32)>> = Vec::new();
    for label in sorted {
        match lines.last_mut() {
            Some(line) if label.1 - line[0].1 <= off => line.push(label),
            _ => lines.push(vec![label]),
        }
    }
    lines.retain(|line| line.len() >= FEWEST);
    lines.into_iter().map(|line| line.into_iter().map(|(label, _)| label).collect()).collect()
}

/// In how many rows the labels of a group stand, and whether leader lines lead to what they name.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Way {
    rows: usize,
    leads: bool,
}

/// All labels of a group in the first form in which they have room together; in a second row where one is too short.
fn of_group(group: &Group, of: &Place<'_>, placed: &[Option<Candidate>]) -> Option<Vec<Candidate>> {
    let levels = [Level::Whole, Level::TwoLines, Level::Fitting, Level::Short];
    let fits = |label: usize, form: &Form| match group.lies {
        Lies::Column(side) => {
            let (anchor, area) = (of.wanted[label].anchor, of.params.area);
            let free = (1.0 - side) * (area.max.x - anchor.min.x) + side * (anchor.max.x - area.min.x);
            form.extent(of.cells).x <= free
        }
        _ => false,
    };
    let ways = [(1, false), (2, false), (1, true), (2, true)].map(|(rows, leads)| Way { rows, leads });
    let ways = if matches!(group.lies, Lies::Column(_)) { &ways[..1] } else { &ways };
    let tried = ways.iter().flat_map(|&way| levels.map(|level| (way, level)));
    let mut seen: Vec<(Way, Vec<usize>)> = Vec::new();
    for (way, level) in tried {
        let forms: Vec<usize> = group
            .members
            .iter()
            .map(|&label| {
                of.forms[label].as_ref().map_or(0, |forms| level.form(&forms.forms, |form| fits(label, form)))
            })
            .collect();
        // those that fit are all words, or none of them counts
        let is_short = |(&label, &number): (&usize, &usize)| {
            of.forms[label].as_ref().is_ok_and(|forms| forms.forms[number].abbreviation.is_some())
        };
        if level == Level::Fitting && group.members.iter().zip(&forms).any(is_short) {
            continue;
        }
        let tried = (way, forms);
        if seen.contains(&tried) {
            continue;
        }
        let found = in_rows(group, &tried.1, way, of, placed);
        if found.is_some() {
            return found;
        }
        seen.push(tried);
    }
    None
}

/// The labels of a group in these forms and this way, at the nearest height (for columns: the nearest edge) at which
/// all of them are free.
fn in_rows(
    group: &Group,
    numbers: &[usize],
    Way { rows, leads }: Way,
    of: &Place<'_>,
    placed: &[Option<Candidate>],
) -> Option<Vec<Candidate>> {
    let forms: Vec<&Form> = group
        .members
        .iter()
        .zip(numbers)
        .map(|(&label, &number)| of.forms[label].as_ref().ok().and_then(|forms| forms.forms.get(number)))
        .collect::<Option<_>>()?;
    let sizes: Vec<MmVector> = forms.iter().map(|form| form.extent(of.cells)).collect();
    let along = along(group, &sizes, rows, of)?;
    let highest = sizes.iter().map(|size| size.y).fold(0.0, f32::max);
    let pitch = in_steps(highest + TIGHTEST.above(), of.cells.steps().map(|steps| steps.y));
    let steps = |mm: f32| (mm / of.params.step).ceil() as i32;
    let (nearest, furthest) = if leads { (steps(REACH), steps(FAR)) } else { (0, steps(REACH)) };
    // below before above
    let offsets = both_ways(nearest, furthest);
    let at = |offset: f32, moves: bool| -> Option<Vec<Candidate>> {
        let mut found: Vec<Candidate> = Vec::with_capacity(sizes.len());
        for (number, &label) in group.members.iter().enumerate() {
            let (anchor, size, row) = (of.wanted[label].anchor, sizes[number], (number % rows) as f32);
            let (begin, may_move) = along[number];
            let corner = |moved: f32| match group.lies {
                Lies::Row => MmPoint::new(begin + moved, anchor.center().y - 0.5 * highest + offset + row * pitch),
                Lies::BelowPoints => MmPoint::new(begin + moved, anchor.max.y + BELOW_POINTS + offset + row * pitch),
                Lies::Column(side) => {
                    let edge = anchor.min.x + side * (anchor.width() - size.x);
                    MmPoint::new(edge + offset, begin + moved)
                }
            };
            let candidate = |moved: f32| {
                let corner = corner(moved);
                let place = of.cells.snapped(MmRect::new(corner, corner + size));
                let cost = forms[number].cost + offset.abs() + moved.abs() + row * SECOND_ROW;
                let leader = leads.then(|| leader(place, anchor.center()));
                let candidate = Candidate::in_row(numbers[number], place, leader, cost);
                let mut others = found.iter().chain(placed.iter().flatten());
                let is_free = is_free(label, &candidate, of)
                    && others.all(|other| !candidate.is_too_near(other, JUST, of.params.leader_off));
                is_free.then_some(candidate)
            };
            let steps = if moves { (may_move / of.params.step).floor().max(0.0) as i32 } else { 0 };
            let free = both_ways(0, steps).find_map(|step| candidate(step as f32 * of.params.step))?;
            found.push(free);
        }
        Some(found)
    };
    let is_wanted = |offset: &i32| *offset >= 0 || group.lies != Lies::BelowPoints;
    let offsets: Vec<f32> = offsets.filter(is_wanted).map(|offset| offset as f32 * of.params.step).collect();
    // each at its own anchor, if that can be
    let tried = [false, true].into_iter().flat_map(|moves| offsets.iter().map(move |offset| (*offset, moves)));
    tried.into_iter().find_map(|(offset, moves)| at(offset, moves))
}

/// Whether a label of a row can lie in its place: free, and with a free way for its leader line; without one on its
/// own side of all lines, and nearer to its own anchor than to that of another label.
fn is_free(label: usize, candidate: &Candidate, of: &Place<'_>) -> bool {
    let (around, place) = (&of.around[label], candidate.place);
    let anchor = of.wanted[label].anchor.center();
    let nearest = anchor.clamp(place.min, place.max);
    let is_told = || match candidate.leader {
        Some([from, to]) => of.room.is_free_way(from, to, around.end) && around.leads_to_own(place, [from, to]),
        None => !of.room.is_parted(nearest, anchor, around.end) && around.is_own(place),
    };
    of.params.holds(&place) && of.room.is_free(place) && is_told()
}

/// Steps in both directions, the nearest first.
fn both_ways(nearest: i32, furthest: i32) -> impl Iterator<Item = i32> {
    (nearest..=furthest).flat_map(|step| [step, -step].into_iter().take(if step == 0 { 1 } else { 2 }))
}

/// A leader line from the middle of a label, above or below it.
fn leader(place: MmRect, anchor: MmPoint) -> [MmPoint; 2] {
    let y = if anchor.y < place.min.y { place.min.y - BEFORE_LEADER } else { place.max.y + BEFORE_LEADER };
    [MmPoint::new(place.center().x, y), anchor]
}

/// Where labels of these sizes begin along a row (for columns: down it), as near to their anchors as they can stand
/// side by side, and how far each may be moved; none if one would have to be moved too far.
fn along(group: &Group, sizes: &[MmVector], rows: usize, of: &Place<'_>) -> Option<Vec<(f32, f32)>> {
    let is_column = matches!(group.lies, Lies::Column(_));
    let of_point = |at: MmPoint| if is_column { at.y } else { at.x };
    let of_size = |size: MmVector| if is_column { size.y } else { size.x };
    let blank = if is_column { TIGHTEST.above() } else { TIGHTEST.aside() };
    let step = of.cells.steps().map(of_size);
    let area = of.params.area;
    let (low, high) = (of_point(area.min), of_point(area.max));
    let anchors: Vec<f32> = group.members.iter().map(|&label| of_point(of.wanted[label].anchor.center())).collect();
    let mut begins = vec![0.0; sizes.len()];
    for row in 0..rows {
        let members: Vec<usize> = (row..sizes.len()).step_by(rows).collect();
        let ideal = members.iter().map(|&i| anchors[i] - 0.5 * of_size(sizes[i]));
        let lengths: Vec<f32> = members.iter().map(|&i| in_steps(of_size(sizes[i]) + blank, step)).collect();
        let ideal: Vec<f32> = ideal.collect();
        for (&i, begin) in members.iter().zip(side_by_side(&ideal, &lengths)) {
            begins[i] = begin.min(high - of_size(sizes[i])).max(low);
        }
    }
    // how far each may still be moved
    let rest = |i: usize| {
        let moved = (begins[i] + 0.5 * of_size(sizes[i]) - anchors[i]).abs();
        let to = |other: Option<&f32>| other.map_or(f32::INFINITY, |other| (other - anchors[i]).abs());
        let next = to(anchors.get(i + 1)).min(to(i.checked_sub(1).and_then(|i| anchors.get(i))));
        // on a grid of dots a label is off by half a step anyhow
        let rest = (ALONG * next).max(0.5 * of.params.step) - moved;
        (rest >= 0.0).then_some((begins[i], rest))
    };
    (0..sizes.len()).map(rest).collect()
}

/// A length that is no less in whole steps of a grid: places so far apart, or further, stay so when they are brought
/// on to it.
fn in_steps(mm: f32, step: Option<f32>) -> f32 {
    match step {
        // a hair less, for sums of floating point
        Some(step) if step > 0.0 => (mm / step - 1e-3).ceil() * step,
        _ => mm,
    }
}

/// Positions that come nearest to the ideal ones (by least squares) where each takes its length: isotonic regression,
/// by pooling neighbours that would overlap (Ayer et al., 1955).
fn side_by_side(ideal: &[f32], lengths: &[f32]) -> Vec<f32> {
    let before: Vec<f32> = lengths
        .iter()
        .scan(0.0, |sum, length| {
            let before = *sum;
            *sum += length;
            Some(before)
        })
        .collect();
    // pools of neighbours that touch: the mean of what their first one would be, and how many they are
    let mut pools: Vec<(f32, usize)> = Vec::new();
    for (ideal, before) in ideal.iter().zip(&before) {
        let mut pool = (ideal - before, 1);
        while let Some(&(mean, count)) = pools.last()
            && mean > pool.0
        {
            pools.pop();
            let all = count + pool.1;
            pool = ((mean * count as f32 + pool.0 * pool.1 as f32) / all as f32, all);
        }
        pools.push(pool);
    }
    let starts = pools.into_iter().flat_map(|(mean, count)| std::iter::repeat_n(mean, count));
    starts.zip(before).map(|(start, before)| start + before).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_stand_side_by_side_as_near_as_they_can() {
        let cases = [
            ([0.0, 10.0, 20.0], [0.0, 10.0, 20.0]),
            // the first two share what they lack; the third has room
            ([0.0, 4.0, 30.0], [-2.0, 6.0, 30.0]),
            // a pool that grows back over the one before it
            ([0.0, 8.0, 8.0], [-8.0 / 3.0, 16.0 / 3.0, 40.0 / 3.0]),
        ];
        for (wanted, placed) in cases {
            let starts = side_by_side(&wanted, &[8.0, 8.0, 8.0]);
            assert!(starts.iter().zip(&placed).all(|(start, at)| (start - at).abs() < 1e-4), "{starts:?}");
            assert_eq!(starts.len(), 3);
        }
    }
}
