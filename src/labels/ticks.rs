//! Which numbers along an axis have a tick on the page: where only some have one, those are the numbers that stay, as
//! readers count ticks.

use super::groups::{Group, GroupDirection};
use super::placed::Wanted;
use super::room::Room;
use super::scale::EVERY;
use crate::units::{MmPoint, MmRect, MmVector};

/// How far from the middle of a number its tick is looked for, mm: print stands within 4 mm of an axis, and ticks that
/// are on a page end within 10 mm of it.
const REACH: f32 = 14.0;
/// Shortest piece of a line across an axis that is a tick, mm: a piece as short as the line is wide has no direction.
const SHORTEST: f32 = 2.0;
/// Shortest tick of a drawing that will be drawn longer, mm, beyond its axis, where most numbers have none: two squares
/// of the room, as a corner of axes may reach one beyond them. Where most have one, a square is enough (`lines::ticks`
/// takes ticks from 0.5 mm on).
const SHORTEST_ALONE: f32 = 1.0;
/// So many short ticks are a scale, as in `lines::ticks`.
const SCALE: usize = 3;
/// How far beside a tick there is nothing, as a share of the distance to the next number.
const CLEAR_OF_TICK: f32 = 0.25;
/// Step in which a tick is looked for, mm: a square of the room.
const STEP: f32 = 0.5;

/// Numbers of an axis of which every so many-th is written; `count` is that, 1 where all are.
pub(super) struct AxisNumbers {
    pub(super) group: Group,
    pub(super) count: i64,
}

/// All numbers of a group, then fewer of them in the order in which they are tried: first those that are the ones with
/// a tick, where only some have one; then those that all have one.
pub(super) fn selections(group: &Group, wanted: &[Wanted], room: &Room) -> Vec<AxisNumbers> {
    let mut all = vec![AxisNumbers { group: group.clone(), count: 1 }];
    let Some(steps) = &group.steps else { return all };
    let ticks: Vec<bool> = with_tick(group, wanted, room);
    let is_tick_of_all = |every: i64| steps.iter().zip(&ticks).all(|(&step, &has)| (step % every == 0) == has);
    let mut fewer: Vec<(u8, i64)> = EVERY
        .into_iter()
        .chain(between_ticks(steps, &ticks).filter(|every| is_tick_of_all(*every)))
        .map(|every| {
            let written = |step: i64| step % every == 0;
            let have = || steps.iter().zip(&ticks).all(|(&step, &has)| has || !written(step));
            let rank = match is_tick_of_all(every) {
                true => 0,
                false if have() => 1,
                false => 2,
            };
            (rank, every)
        })
        .collect();
    fewer.sort_unstable();
    fewer.dedup();
    all.extend(fewer.into_iter().map(|(_, count)| AxisNumbers { group: group.every(count), count }));
    all.retain(|numbers| numbers.group.members.len() > 1);
    all
}

/// How many steps ticks are apart, if those are even and go through the first of the steps that are counted from.
fn between_ticks(steps: &[i64], ticks: &[bool]) -> Option<i64> {
    let at: Vec<i64> = steps.iter().zip(ticks).filter(|(_, has)| **has).map(|(&step, _)| step).collect();
    let apart = at.get(1)? - at.first()?;
    let is_even = at.windows(2).all(|pair| pair[1] - pair[0] == apart) && at[0] % apart == 0;
    (is_even && apart.abs() > 1).then_some(apart.abs())
}

/// How far numbers of an axis are apart on the page, mm, whether all of them are written or not.
pub(super) fn pitch(group: &Group, wanted: &[Wanted]) -> Option<f32> {
    let steps = group.steps.as_deref()?;
    let at = |i: usize| along(group, wanted[group.members[i]].anchor.center());
    let last = steps.len().checked_sub(1)?;
    let apart = (steps[last] - steps[0]).abs();
    (apart > 0).then(|| (at(last) - at(0)).abs() / apart as f32)
}

fn along(group: &Group, at: MmPoint) -> f32 {
    if matches!(group.lies, GroupDirection::Column(_)) { at.y } else { at.x }
}

/// Where ticks of an axis will lie that are shorter than lines have to be, and are drawn longer towards their numbers
/// or, as below bars, words: the points of those pieces.
pub(super) fn longer(groups: &[Group], wanted: &[Wanted], room: &Room, least: f32) -> Vec<MmPoint> {
    let is_of_words = |group: &Group| group.lies == GroupDirection::Row && group.members.len() >= SCALE;
    let scales = groups.iter().filter(|group| group.steps.is_some() || is_of_words(group));
    let pieces = scales.flat_map(|group| {
        let found = group.members.iter().filter_map(|&label| short_tick(wanted[label].anchor, to_axis(group), room));
        let found: Vec<ShortTick> = found.filter(|tick| tick.length < least).collect();
        // not most numbers of a scale stand at corners
        let are_ticks = found.len() >= SCALE && 2 * found.len() > group.members.len();
        let is_scale = group.steps.is_some();
        found.into_iter().filter(move |tick| are_ticks || is_scale && tick.length >= SHORTEST_ALONE)
    });
    let points = |ShortTick { tip, to_axis, length, .. }: ShortTick| {
        let more = to_axis * (least - length);
        let steps = (more.length() / STEP).ceil() as u32;
        (0..=steps).map(move |step| tip - more * (step as f32 / steps as f32))
    };
    pieces.flat_map(points).collect()
}

/// Whether most words of a row have a tick of their own, which leads to them.
pub(super) fn lead_to_words(group: &Group, wanted: &[Wanted], room: &Room) -> bool {
    let has_tick = |label: &&usize| short_tick(wanted[**label].anchor, to_axis(group), room).is_some();
    let count = group.members.iter().filter(has_tick).count();
    group.steps.is_none() && group.lies == GroupDirection::Row && count >= SCALE && 2 * count > group.members.len()
}

/// A piece of a line across an axis, between the axis and a number.
struct ShortTick {
    /// Where it ends beside the number.
    tip: MmPoint,
    to_axis: MmVector,
    /// How far the tip lies from the number, in steps.
    off: u32,
    length: f32,
}

/// The first piece of a line beside a number, on one of its sides, if it ends at an axis.
fn short_tick(number: MmRect, across: MmVector, room: &Room) -> Option<ShortTick> {
    // print stands nearer to its tick than the line of it will be broad, so it is looked for from inside of the print
    let inside = STEP * (0.5 * room.widest() / STEP + 2.0).ceil();
    let from = 0.5 * (across.x * number.width() + across.y * number.height()) - inside;
    let steps = ((inside + REACH) / STEP) as u32;
    let side = |sign: f32| {
        let to_axis = across * sign;
        let along = MmVector::new(to_axis.y, to_axis.x);
        let at = |step: u32| number.center() + to_axis * (from + STEP * step as f32);
        let begin = (0..=steps).find(|step| room.is_ink(at(*step)))?;
        let beside = |step: u32| [-1.0, 1.0].iter().any(|by| room.is_ink(at(step) + along * (3.0 * by)));
        let axis = (begin..=begin + steps).find(|step| beside(*step) || !room.is_ink(at(*step)))?;
        let length = STEP * (axis - begin) as f32;
        let is_tick = beside(axis) && length >= STEP;
        is_tick.then(|| ShortTick { tip: at(begin), to_axis, off: begin, length })
    };
    let sides = [-1.0, 1.0].into_iter().filter_map(side);
    sides.min_by_key(|tick| (tick.length < SHORTEST_ALONE, tick.off))
}

/// The way from a number to its axis, or away from it.
fn to_axis(group: &Group) -> MmVector {
    match group.lies {
        GroupDirection::Column(_) => MmVector::new(1.0, 0.0),
        GroupDirection::Row | GroupDirection::BelowPoints => MmVector::new(0.0, 1.0),
    }
}

/// Which numbers have a tick: a piece of a line across the axis at their place, with nothing on either side of it.
fn with_tick(group: &Group, wanted: &[Wanted], room: &Room) -> Vec<bool> {
    let Some(pitch) = pitch(group, wanted) else { return vec![false; group.members.len()] };
    let across = to_axis(group);
    let beside = MmVector::new(across.y, across.x) * (CLEAR_OF_TICK * pitch);
    let has_tick = |&label: &usize| {
        let place = wanted[label].anchor;
        let reach = REACH + 0.5 * across.x * place.width();
        let steps = (reach / STEP).ceil() as i32;
        let is_stroke = |step: i32| {
            let at = place.center() + across * (step as f32 * STEP);
            // a line may be moved by a part of a millimetre
            let is_there = [-1.0, 0.0, 1.0].iter().any(|&off| room.is_ink(at + beside.normalize() * off));
            is_there && !room.is_ink(at - beside) && !room.is_ink(at + beside)
        };
        // a line that goes on, such as that of a grid, is followed and not counted
        let strokes: Vec<bool> = (-steps..=steps).map(is_stroke).collect();
        let mut pieces = strokes.split(|is_stroke| !is_stroke).enumerate();
        let ends = [strokes.first(), strokes.last()].map(|end| end == Some(&true));
        let count = strokes.iter().filter(|is_stroke| !**is_stroke).count();
        pieces.any(|(number, piece)| {
            let goes_on = number == 0 && ends[0] || number == count && ends[1];
            !goes_on && piece.len() as f32 * STEP >= SHORTEST
        })
    };
    group.members.iter().map(has_tick).collect()
}

#[cfg(test)]
mod tests;
