//! Labels that stand in one row or column of the picture, as at the axes of a chart: they are placed together, in
//! their order, all in one form, each beside what it names. One alone would take the room of its neighbour, or stand
//! under the next bar.

use super::attached::BEFORE_LEADER;
use super::candidates::Candidate;
use super::columns::each_as_it_fits;
use super::context::{ALONG, Context, REACH, both_ways, is_free};
use super::cost::LIKE_A_CELL;
use super::forms::{Form, FormKind};
use super::groups::{Group, GroupDirection, OF_AN_AXIS};
use super::placed::{Attachment, Params, PlacedAs};
use super::spacing::{LEAST_ABOVE, Spacing};
use super::surroundings::{OFF_LEVEL, OFF_TICK};
use super::ticks;
use crate::units::{MmPoint, MmRect, MmVector};

/// How far a row may lie from its texts with leader lines straight to them, mm: past a row of other things below them,
/// such as a legend.
const FAR: f32 = 30.0;
/// Least blank between points and the labels below them, mm.
const BELOW_POINTS: f32 = 2.0;
/// What a second row of labels costs for each of them, mm.
const SECOND_ROW: f32 = 5.0;

/// In which form the labels of a group are written.
#[derive(Debug, Clone, Copy, PartialEq)]
enum FormLevel {
    Whole,
    TwoLines,
    /// Each as it fits beside its anchor, in a column.
    Fitting,
    Short,
    Letters,
    /// Of numbers along an axis: the unit with the highest or the last one only.
    UnitOnce,
}

impl FormLevel {
    /// The number of a label's form; of those that have no such form, the whole text.
    fn form(self, forms: &[Form], fits: impl Fn(&Form) -> bool) -> usize {
        let is = |form: &Form| match self {
            Self::Whole => false,
            Self::Fitting => fits(form),
            Self::TwoLines => form.is_in_two_lines(),
            Self::Short => form.kind == FormKind::Short,
            Self::Letters => form.kind == FormKind::Letter,
            Self::UnitOnce => form.kind == FormKind::Bare,
        };
        forms.iter().position(is).unwrap_or(0)
    }
}

/// What becomes of labels that stand in rows and columns.
pub(super) struct InRows {
    /// The place of each that stands in one which has room as a whole, and of titles of axes.
    pub(super) placed: Vec<Option<Candidate>>,
    /// Of numbers along an axis that are left out as there is no room for all, every how many-th is written.
    pub(super) thinned: Vec<Option<i64>>,
}

/// The place of each label that stands in a row or column which has room as a whole. Numbers of upright axes come
/// first: they stand at their ticks, and words below bars may stand a little lower; unless more have room otherwise.
pub(super) fn placed(groups: &[Group], context: &Context<'_>) -> InRows {
    let of_upright = |group: &&Group| group.steps.is_some() && matches!(group.lies, GroupDirection::Column(_));
    let (first, others): (Vec<&Group>, Vec<&Group>) = groups.iter().partition(of_upright);
    let in_order: Vec<&Group> = groups.iter().collect();
    let upright_first: Vec<&Group> = first.into_iter().chain(others).collect();
    let best = placed_in_order(&upright_first, context);
    let count = |rows: &InRows| rows.placed.iter().flatten().count();
    if count(&best) == groups.iter().map(|group| group.members.len()).sum::<usize>() {
        return best;
    }
    let other = placed_in_order(&in_order, context);
    if count(&other) > count(&best) { other } else { best }
}

/// The same of groups that are placed one after the other.
fn placed_in_order(groups: &[&Group], context: &Context<'_>) -> InRows {
    let mut placed: Vec<Option<Candidate>> = vec![None; context.wanted.len()];
    let mut thinned = vec![None; context.wanted.len()];
    for &group in groups {
        let mut selections = ticks::selections(group, context.wanted, context.room).into_iter();
        let found = selections
            .find_map(|ticks::AxisNumbers { group, count }| Some((of_group(&group, context, &placed)?, group, count)));
        let Some((found, some, count)) = found else { continue };
        if count > 1 {
            group.members.iter().for_each(|&member| thinned[member] = Some(count));
        }
        for (&member, candidate) in some.members.iter().zip(found) {
            placed[member] = Some(candidate);
            thinned[member] = None;
        }
    }
    InRows { placed, thinned }
}

/// In how many rows the labels of a group stand, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Arrangement {
    rows: usize,
    at: RowPlace,
}

/// Where a row stands.
#[derive(Debug, Clone, Copy, PartialEq)]
enum RowPlace {
    /// Near to what it names.
    Near,
    /// Further away, with leader lines.
    Led,
    /// Of labels along an axis, in the margin beyond all lines, each at the height or breadth of its own: there a
    /// finger finds it along the gridlines, or by its place.
    Margin,
}

/// The arrangements and forms in which the labels of a group are tried, in this order. Words to which ticks lead need
/// no leader lines.
fn attempts(group: &Group, have_ticks: bool) -> Vec<(Arrangement, FormLevel)> {
    let words = [FormLevel::Whole, FormLevel::TwoLines, FormLevel::Fitting, FormLevel::UnitOnce, FormLevel::Short];
    let is_column = matches!(group.lies, GroupDirection::Column(_));
    let at_most_rows = if is_column { 1 } else { 2 };
    let of = |at: RowPlace, levels: &[FormLevel]| -> Vec<(Arrangement, FormLevel)> {
        let arrangements = (1..=at_most_rows).map(|rows| Arrangement { rows, at });
        arrangements.flat_map(|arrangement| levels.iter().map(move |&level| (arrangement, level))).collect()
    };
    let is_axis = group.steps.is_some() || !is_column && group.members.len() >= OF_AN_AXIS;
    let letters: &[FormLevel] = if is_column || group.steps.is_some() { &[] } else { &[FormLevel::Letters] };
    let (known, unknown): (&[FormLevel], &[FormLevel]) =
        if group.is_of_months { (letters, &[]) } else { (&[], letters) };
    let of_margin = if is_axis { of(RowPlace::Margin, &words) } else { Vec::new() };
    let led = if is_column { Vec::new() } else { of(RowPlace::Led, &words) };
    let [beyond, farther] = if have_ticks { [of_margin, led] } else { [led, of_margin] };
    [
        of(RowPlace::Near, &words),
        of(RowPlace::Near, known),
        beyond,
        farther,
        of(RowPlace::Near, unknown),
        of(RowPlace::Led, unknown),
    ]
    .concat()
}

/// All labels of a group in the first form in which they have room together; in a second row where one is too short.
fn of_group(group: &Group, context: &Context<'_>, placed: &[Option<Candidate>]) -> Option<Vec<Candidate>> {
    let fits = |label: usize, form: &Form| match group.lies {
        GroupDirection::Column(edge) => {
            let (anchor, area, width) =
                (context.wanted[label].anchor, context.params.area, form.extent(context.cells).x);
            let left = edge.left_of(anchor, width);
            left >= area.min.x && left + width <= area.max.x
        }
        GroupDirection::Row | GroupDirection::BelowPoints => false,
    };
    // the first number of a column, or the last of a row, that has a unit: zero may have none
    let has_unit = |i: &usize| {
        let forms = context.forms[group.members[*i]].as_ref();
        forms.is_ok_and(|forms| forms.forms.iter().any(|form| form.kind == FormKind::Bare))
    };
    let mut numbers = 0..group.members.len();
    let with_unit = if matches!(group.lies, GroupDirection::Column(_)) {
        numbers.find(has_unit)
    } else {
        numbers.rev().find(has_unit)
    };
    let mut seen: Vec<(Arrangement, Vec<usize>)> = Vec::new();
    let have_ticks = ticks::lead_to_words(group, context.wanted, context.room);
    for (arrangement, level) in attempts(group, have_ticks) {
        let number_of = |(i, &label): (usize, &usize)| {
            // in two lines, if it has them
            let level = if level == FormLevel::UnitOnce && Some(i) == with_unit { FormLevel::TwoLines } else { level };
            context.forms[label].as_ref().map_or(0, |forms| level.form(&forms.forms, |form| fits(label, form)))
        };
        let forms: Vec<usize> = group.members.iter().enumerate().map(number_of).collect();
        // those that fit are all words, or none of them counts
        let is_short = |(&label, &number): (&usize, &usize)| {
            context.forms[label].as_ref().is_ok_and(|forms| forms.forms[number].abbreviation.is_some())
        };
        if level == FormLevel::Fitting && group.members.iter().zip(&forms).any(is_short) {
            continue;
        }
        if level == FormLevel::Short
            && let Some(found) = each_as_it_fits(group, context, placed)
        {
            return Some(found);
        }
        let attempt = (arrangement, forms);
        if seen.contains(&attempt) {
            continue;
        }
        let row = RowOfLabels::new(group, &attempt.1, arrangement, context, placed);
        if let Some(found) = row.and_then(|row| row.placed()) {
            return Some(found);
        }
        seen.push(attempt);
    }
    None
}

/// From where the place of a row is counted.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Start {
    /// From the anchor of each label.
    Anchors,
    /// From this edge in the margin beyond all lines: its upper one, for columns its left one, mm.
    Margin(f32),
}

/// Where a row is tried.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Offset {
    /// From its start, mm.
    mm: f32,
    /// Blank beside its labels, beyond their clearance, mm.
    aside: f32,
}

/// Each offset with the blank beside labels with which it is tried, in the order of what both cost: that of numbers
/// keeps the dots of their axis from being read as a digit. The second blank is to be rather than the first.
fn with_blanks(offsets: impl Iterator<Item = f32>, [more, most]: [f32; 2]) -> Vec<Offset> {
    let blanks: &[(f32, f32)] = match more > 0.0 {
        true if most > more => &[(most, 0.0), (more, LIKE_A_CELL), (0.0, 2.0 * LIKE_A_CELL)],
        true => &[(more, 0.0), (0.0, LIKE_A_CELL)],
        false => &[(0.0, 0.0)],
    };
    let with_each = |mm: f32| blanks.iter().map(move |&(aside, cost)| (mm.abs() + cost, Offset { mm, aside }));
    let mut all: Vec<(f32, Offset)> = offsets.flat_map(with_each).collect();
    all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    all.into_iter().map(|(_, offset)| offset).collect()
}

/// The labels of a group, each in one form, of which a common place is looked for.
struct RowOfLabels<'a> {
    group: &'a Group,
    /// Of each label: the number of its form, the form and its size.
    numbers: &'a [usize],
    forms: Vec<&'a Form>,
    sizes: Vec<MmVector>,
    /// Where each begins along the row, and how far it may be moved along it, mm.
    along: Vec<(f32, f32)>,
    arrangement: Arrangement,
    /// The greatest width and height of them.
    largest: MmVector,
    /// From one row to the next, mm.
    pitch: f32,
    context: &'a Context<'a>,
    /// Labels of groups that were placed before.
    others: &'a [Option<Candidate>],
}

impl<'a> RowOfLabels<'a> {
    /// Labels in the forms of these numbers; none if one has no such form, or would have to be moved too far along.
    fn new(
        group: &'a Group,
        numbers: &'a [usize],
        arrangement: Arrangement,
        context: &'a Context<'a>,
        others: &'a [Option<Candidate>],
    ) -> Option<Self> {
        let forms: Vec<&Form> = group
            .members
            .iter()
            .zip(numbers)
            .map(|(&label, &number)| context.forms[label].as_ref().ok().and_then(|forms| forms.forms.get(number)))
            .collect::<Option<_>>()?;
        let sizes: Vec<MmVector> = forms.iter().map(|form| form.extent(context.cells)).collect();
        let along = along(group, &sizes, arrangement.rows, context)?;
        let largest = sizes.iter().fold(MmVector::zero(), |all, size| all.max(*size));
        let pitch = in_steps(largest.y + LEAST_ABOVE, context.cells.steps().map(|steps| steps.y));
        Some(Self { group, numbers, forms, sizes, along, arrangement, largest, pitch, context, others })
    }

    /// All labels at the nearest height (for columns: the nearest edge) at which they are free, each at its own anchor
    /// if that can be.
    fn placed(&self) -> Option<Vec<Candidate>> {
        let at = self.arrangement.at;
        let starts = match at {
            RowPlace::Margin => self.starts_in_margin(self.context.room.bounds()?).to_vec(),
            RowPlace::Near | RowPlace::Led => vec![Start::Anchors],
        };
        let step = self.context.params.step;
        let steps = |mm: f32| (mm / step).ceil() as i32;
        let (nearest, furthest) = if at == RowPlace::Led { (steps(REACH), steps(FAR)) } else { (0, steps(REACH)) };
        // offsets below are tried before those above
        let is_wanted = |offset: &i32| *offset >= 0 || self.group.lies != GroupDirection::BelowPoints;
        let offsets = both_ways(nearest, furthest).filter(is_wanted).map(|offset| offset as f32 * step);
        // words stand beside the ends of lines that lead to them
        let Params { more_aside, off_ticks, .. } = *self.context.params;
        let asides = if self.group.steps.is_some() { [more_aside, off_ticks] } else { [0.0; 2] };
        let offsets = with_blanks(offsets, asides);
        starts.into_iter().find_map(|start| {
            let at_anchors = || offsets.iter().find_map(|&offset| self.at(start, offset, |_| 0.0));
            at_anchors()
                .or_else(|| offsets.iter().find_map(|&offset| self.at(start, offset, |number| self.along[number].1)))
        })
    }

    /// All labels with the row this far from its start, each moved along the row by as much as `reach` of its number
    /// allows, mm; none if one of them is not free.
    fn at(
        &self,
        start: Start,
        Offset { mm: offset, aside }: Offset,
        reach: impl Fn(usize) -> f32,
    ) -> Option<Vec<Candidate>> {
        let step = self.context.params.step;
        let mut found: Vec<Candidate> = Vec::with_capacity(self.sizes.len());
        for number in 0..self.sizes.len() {
            let furthest = (reach(number) / step).floor().max(0.0) as i32;
            let free = both_ways(0, furthest).find_map(|moved| {
                let candidate = self.candidate(number, start, offset, moved as f32 * step);
                let mut others = found.iter().chain(self.others.iter().flatten());
                let label = self.group.members[number];
                let is_free = self.context.room.is_free_aside(candidate.place, aside)
                    && is_free(label, &candidate, self.context)
                    && others.all(|other| {
                        let least = Spacing::least_rounded(self.context.cells);
                        !candidate.is_too_near(other, least, self.context.params.leader_off)
                    });
                is_free.then_some(candidate)
            })?;
            found.push(free);
        }
        Some(found)
    }

    fn candidate(&self, number: usize, start: Start, offset: f32, moved: f32) -> Candidate {
        let Arrangement { rows, at } = self.arrangement;
        let (size, row) = (self.sizes[number], (number % rows) as f32);
        let corner = self.corner(number, start, offset, self.along[number].0 + moved);
        let place = self.context.cells.snapped(MmRect::new(corner, corner + size));
        let anchor = self.context.around[self.group.members[number]].anchor;
        let attachment = if at == RowPlace::Led {
            Attachment::Leader(leader(place, anchor, self.context.params.leader_off))
        } else {
            Attachment::Beside
        };
        let cost = self.forms[number].kind.cost() + offset.abs() + moved.abs() + row * SECOND_ROW;
        let stands = if at == RowPlace::Margin { PlacedAs::InMargin } else { PlacedAs::InRow };
        Candidate::of_row(self.numbers[number], place, attachment, cost, stands)
    }

    /// The top left corner of a label that begins here along its row.
    fn corner(&self, number: usize, start: Start, offset: f32, begin: f32) -> MmPoint {
        let (anchor, size) = (self.context.wanted[self.group.members[number]].anchor, self.sizes[number]);
        let below = (number % self.arrangement.rows) as f32 * self.pitch;
        match (self.group.lies, start) {
            (GroupDirection::Column(edge), Start::Margin(start)) => {
                MmPoint::new(start + edge.share() * (self.largest.x - size.x) + offset, begin)
            }
            (GroupDirection::Column(edge), Start::Anchors) => {
                MmPoint::new(edge.left_of(anchor, size.x) + offset, begin)
            }
            (GroupDirection::Row | GroupDirection::BelowPoints, Start::Margin(start)) => {
                MmPoint::new(begin, start + offset + below)
            }
            (GroupDirection::Row, Start::Anchors) => {
                MmPoint::new(begin, anchor.center().y - 0.5 * self.largest.y + offset + below)
            }
            (GroupDirection::BelowPoints, Start::Anchors) => {
                MmPoint::new(begin, anchor.max.y + BELOW_POINTS + offset + below)
            }
        }
    }

    /// Where it begins in the margin beyond all lines: below and above (on the left and on the right), the nearer one
    /// first.
    ///
    /// Where numbers stand in a column too, the first of a row below it keeps off the last of the column, which stands
    /// half of its height below the lines.
    fn starts_in_margin(&self, lines: MmRect) -> [Start; 2] {
        let members = &self.group.members;
        let middle = |label: &usize| self.context.wanted[*label].anchor.center();
        let (width, height) = (self.largest.x, self.largest.y + (self.arrangement.rows - 1) as f32 * self.pitch);
        let reaches_out = members.iter().any(|label| {
            let x = middle(label).x;
            x - 0.5 * width < lines.min.x || x + 0.5 * width > lines.max.x
        });
        let beside_column = self.group.is_beside_column && reaches_out;
        let corner = if beside_column { 0.5 * self.largest.y + LEAST_ABOVE } else { 0.0 };
        let count = members.len() as f32;
        let mean = members.iter().fold(MmVector::zero(), |sum, label| sum + middle(label).to_vector() / count);
        let blank = self.context.params.clearance + self.context.params.step;
        let (starts, is_second_nearer) = match self.group.lies {
            GroupDirection::Column(_) => {
                ([lines.min.x - blank - width, lines.max.x + blank], mean.x > SECOND_SIDE * lines.width() + lines.min.x)
            }
            GroupDirection::Row | GroupDirection::BelowPoints => (
                [lines.max.y + blank.max(corner), lines.min.y - blank.max(corner) - height],
                mean.y < (1.0 - SECOND_SIDE) * lines.height() + lines.min.y,
            ),
        };
        let starts = if is_second_nearer { [starts[1], starts[0]] } else { starts };
        starts.map(Start::Margin)
    }
}

/// From this share of the breadth on, numbers of an upright axis stand on the right side, and from so far up those of a
/// level one above: those of an axis through the middle are looked for on the left and below.
const SECOND_SIDE: f32 = 0.6;

/// A leader line from the middle of a label, above or below it, whose marks lie up to `off` mm off it.
fn leader(place: MmRect, anchor: MmPoint, off: f32) -> [MmPoint; 2] {
    let blank = BEFORE_LEADER + off;
    let y = if anchor.y < place.min.y { place.min.y - blank } else { place.max.y + blank };
    [MmPoint::new(place.center().x, y), anchor]
}

/// Where labels of these sizes begin along a row (for columns: down it), as near to their anchors as they can stand
/// side by side, and how far each may be moved; none if one would have to be moved too far.
fn along(group: &Group, sizes: &[MmVector], rows: usize, context: &Context<'_>) -> Option<Vec<(f32, f32)>> {
    let is_column = matches!(group.lies, GroupDirection::Column(_));
    let of_point = |at: MmPoint| if is_column { at.y } else { at.x };
    let of_size = |size: MmVector| if is_column { size.y } else { size.x };
    let blank = if is_column { LEAST_ABOVE } else { Spacing::least(context.cells).aside };
    let step = context.cells.steps().map(of_size);
    let area = context.params.area;
    let (low, high) = (of_point(area.min), of_point(area.max));
    let anchors: Vec<f32> =
        group.members.iter().map(|&label| of_point(context.wanted[label].anchor.center())).collect();
    let pitch = ticks::pitch(group, context.wanted).unwrap_or(f32::INFINITY);
    // a number stands at its tick
    let farthest = match (group.steps.is_some(), is_column) {
        (false, _) => f32::INFINITY,
        (true, true) => OFF_LEVEL,
        (true, false) => OFF_TICK,
    };
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
        // the next tick may be nearer than the next number that is written
        let next = next.min(pitch);
        // on a grid of dots a label is off by half a step anyhow
        let rest = (ALONG * next).min(farthest).max(0.5 * context.params.step) - moved;
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
mod tests;
