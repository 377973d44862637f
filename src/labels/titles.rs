//! Titles of axes. Print is turned upright beside an axis; braille is not, so that the title of an upright axis stands
//! above it, as transcribers set it, and that of a level one below its numbers or at their end.

use super::candidates::Candidate;
use super::context::Context;
use super::groups::{Group, GroupDirection, OF_AN_AXIS};
use super::placed::{Attachment, PlacedAs};
use super::spacing::{LEAST_ABOVE, Spacing};
use crate::units::{MmPoint, MmRect, MmVector};

/// How far from its numbers a title stands in print, mm, at most.
const IN_PRINT: f32 = 30.0;
/// How far a title may be moved, mm: away from the numbers to where it is free, and left and right.
const AWAY: f32 = 15.0;
const ASIDE: f32 = 30.0;
/// How far a title may be moved up, mm: to above an axis that goes on over its last number.
const ABOVE: f32 = 30.0;
/// A text is turned if its box is so many times as high as it is wide.
const TURNED: f32 = 1.5;
/// Ticks that are drawn longer, towards the numbers of their axis, reach so far beyond it at most, mm: a title may
/// stand beside them.
const TICK: f32 = 10.0;
/// Fewest letters of a text that shows by its box that it is turned.
const LETTERS: usize = 3;

/// Finds places for titles of axes whose numbers or words have theirs. Gives those of upright axes, which stand nowhere
/// else.
pub(super) fn place(groups: &[Group], context: &Context<'_>, placed: &mut [Option<Candidate>]) -> Vec<usize> {
    let mut of_upright = Vec::new();
    let is_alone = |label: usize| !groups.iter().any(|group| group.members.contains(&label));
    for label in (0..context.wanted.len()).filter(|&label| is_alone(label) && context.forms[label].is_ok()) {
        let beside = groups.iter().filter_map(|group| Some((gap(label, group, context)?, group)));
        let Some((_, group)) = beside.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        placed[label] = at_axis(label, group, context, placed);
        if matches!(group.lies, GroupDirection::Column(_)) {
            of_upright.push(label);
        }
    }
    of_upright
}

/// How far a text is from the numbers or words of which it is the title, if it can be that.
fn gap(label: usize, group: &Group, context: &Context<'_>) -> Option<f32> {
    let text = context.wanted[label].anchor;
    let all = extent(group.members.iter().map(|&member| context.wanted[member].anchor))?;
    let is_turned =
        text.height() > TURNED * text.width() && context.wanted[label].text.trim().chars().count() >= LETTERS;
    // beside an upright axis short titles stand level too
    let is_beside = !text.is_empty() && (text.max.x <= all.min.x || text.min.x >= all.max.x);
    let (at, is_axis) = (text.center(), group.steps.is_some() || group.members.len() >= OF_AN_AXIS);
    // what stands among lines is the name of one of them, or of a sample in a legend
    let lines = context.room.bounds()?;
    let ticks = if is_turned { TICK } else { 0.0 };
    let gap = match group.lies {
        GroupDirection::Column(_)
            if (is_turned || is_beside && group.steps.is_some())
                && (all.min.y..all.max.y).contains(&at.y)
                && !(lines.min.x + ticks..lines.max.x - ticks).contains(&at.x) =>
        {
            (all.min.x - at.x).max(at.x - all.max.x)
        }
        GroupDirection::Row
            if !is_turned
                && !text.is_empty()
                && (all.min.x..all.max.x).contains(&at.x)
                && at.y > lines.max.y - TICK =>
        {
            at.y - all.max.y
        }
        GroupDirection::Row | GroupDirection::BelowPoints | GroupDirection::Column(_) => return None,
    };
    (is_axis && (0.0..IN_PRINT).contains(&gap)).then_some(gap)
}

fn extent(boxes: impl Iterator<Item = MmRect>) -> Option<MmRect> {
    boxes.reduce(|a, b| MmRect::new(a.min.min(b.min), a.max.max(b.max)))
}

/// The nearest free place of a title in the first form that has one.
fn at_axis(label: usize, group: &Group, context: &Context<'_>, placed: &[Option<Candidate>]) -> Option<Candidate> {
    let forms = &context.forms[label].as_ref().ok()?.forms;
    let row = extent(group.members.iter().filter_map(|&member| Some(placed[member].as_ref()?.place)))?;
    let in_print = extent(group.members.iter().map(|&member| context.wanted[member].anchor))?;
    let text = context.wanted[label].anchor;
    let is_left = text.center().x < in_print.min.x;
    let least = Spacing::least_rounded(context.cells);
    let furthest = if group.lies == GroupDirection::Row { AWAY } else { ABOVE };
    let in_form = |(number, form): (usize, &super::forms::Form)| {
        let size = form.extent(context.cells);
        // where it stands if it is free, and in which direction it goes where it is not
        let (at, away) = match group.lies {
            GroupDirection::Column(_) => {
                let x = if is_left { row.min.x } else { row.max.x - size.x };
                (MmPoint::new(x, row.min.y - LEAST_ABOVE - size.y), -1.0)
            }
            GroupDirection::Row | GroupDirection::BelowPoints => {
                (MmPoint::new(text.center().x - 0.5 * size.x, row.max.y + LEAST_ABOVE), 1.0)
            }
        };
        // beside an axis it would stand above what the axis is that of, such as the first bar of a chart
        let is_above = |corner: MmPoint| match group.lies {
            GroupDirection::Column(_) if is_left => corner.x <= row.max.x,
            GroupDirection::Column(_) => corner.x + size.x >= row.min.x,
            GroupDirection::Row | GroupDirection::BelowPoints => true,
        };
        let at_end = MmPoint::new(row.max.x + least.in_line + 0.5 * context.params.step, row.max.y - size.y);
        let free = |corner: MmPoint, cost: f32| {
            let place = context.cells.snapped(MmRect::new(corner, corner + size));
            let candidate =
                Candidate::of_row(number, place, Attachment::Beside, form.kind.cost() + cost, PlacedAs::AsTitle);
            let mut others = placed.iter().flatten();
            let is_free = context.params.holds(&place)
                && context.room.is_free(place)
                && others.all(|other| {
                    !candidate.is_too_near(other, least, context.params.leader_off)
                        && !candidate.is_read_on(other, least, context.room)
                });
            is_free.then_some(candidate)
        };
        let step = context.params.step.max(1.0);
        let steps = |reach: f32| (reach / step).floor() as i32;
        let across = (0..=steps(ASIDE)).flat_map(|by| [by, -by].into_iter().take(if by == 0 { 1 } else { 2 }));
        let offsets = (0..=steps(furthest)).flat_map(|by| across.clone().map(move |aside| (aside, by)));
        let moved = offsets.filter_map(|(aside, by)| {
            let by = MmVector::new(aside as f32, away * by as f32) * step;
            is_above(at + by).then(|| free(at + by, by.x.abs() + by.y.abs())).flatten()
        });
        let nearest = moved.min_by(|a, b| a.cost.total_cmp(&b.cost));
        nearest.or_else(|| free(at_end, AWAY).filter(|_| group.lies == GroupDirection::Row))
    };
    forms.iter().enumerate().filter(|(_, form)| form.kind.is_of_one()).find_map(in_form)
}

/// How high above a title the highest of other texts reach that stand above all lines, as the heading of a chart does:
/// the top of the box that they would need; none where there is no title above lines, or no such text.
pub(super) fn top_of_headings(context: &Context<'_>, placed: &[Option<Candidate>]) -> Option<f32> {
    let lines = context.room.bounds()?;
    let titles = placed.iter().flatten().filter(|candidate| candidate.stands == PlacedAs::AsTitle);
    let above = titles.map(|title| title.place.min.y).filter(|top| *top < lines.min.y);
    let title = above.min_by(f32::total_cmp)?;
    let is_heading = |label: &usize| placed[*label].is_none() && context.wanted[*label].anchor.center().y < lines.min.y;
    let heights = (0..context.wanted.len()).filter(is_heading).filter_map(|label| {
        let form = context.forms[label].as_ref().ok()?.forms.first()?;
        Some(form.extent(context.cells).y)
    });
    heights.max_by(f32::total_cmp).map(|height| title - LEAST_ABOVE - height)
}
