//! At which level line the numbers of an upright axis stand, a tick or a gridline. Print stands beside its line, or a
//! little above or below it; a finger takes a number for that of the line which it meets beside it.

use super::groups::{Group, GroupDirection};
use super::placed::Wanted;
use super::room::Room;
use super::ticks;
use crate::units::{MmPoint, MmRect, MmVector};

/// How far from the sides of a number its line is looked for, mm: print stands within 4 mm of an axis, and ticks that
/// are on a page end within 10 mm of it.
const REACH: f32 = 14.0;
/// Shortest piece of a level line there, mm: one as short as it is wide has no direction.
const SHORTEST: f32 = 2.0;
/// Shortest piece of one elsewhere at this height, as a share of the drawing's width: a gridline is interrupted at
/// bars, and the top of a bar is shorter.
const SHORTEST_PIECE: f32 = 0.25;
/// So far above and below the ink of a level line there is none, mm: less than lines keep apart.
const FREE: f32 = 1.5;
/// Step in which lines are looked for, mm: a square of the room.
const STEP: f32 = 0.5;
/// Print stands off its line by this share of the distance of two numbers at most, or it stands between two lines; and
/// by so many mm.
const OFF: f32 = 0.35;
const FARTHEST: f32 = 8.0;
/// Numbers of one axis are all as far off their lines, but for this, mm: lines may be moved, and on a grid of dots they
/// lie up to half a step beside their places.
const ALIKE: f32 = 1.3;
/// Print that is no further off its line stands at it, mm: lines are found to the square.
const AT_LINE: f32 = 0.75;

/// What is wanted, with the numbers of upright axes at their lines.
pub(super) fn at_their_lines(wanted: &[Wanted], room: &Room) -> Vec<Wanted> {
    let mut all = wanted.to_vec();
    for group in super::groups::of(wanted, |_| true, |_| false, |label| is_at_line(wanted[label].anchor, room)) {
        for (label, off) in offsets(&group, wanted, room) {
            all[label].anchor = all[label].anchor.translate(MmVector::new(0.0, off));
        }
    }
    all
}

/// Whether a text stands at a level line.
pub(super) fn is_at_line(text: MmRect, room: &Room) -> bool {
    // pale gridlines may not be seen before they are drawn
    !room.is_drawn()
        || lines_near(text, 0.5 * text.height() + FREE, room).iter().any(|off| off.abs() <= 0.5 * text.height() + STEP)
}

/// How far the numbers of a group are to be moved, those that do not stand at their lines.
fn offsets(group: &Group, wanted: &[Wanted], room: &Room) -> Vec<(usize, f32)> {
    let Some(pitch) = ticks::pitch(group, wanted).filter(|_| matches!(group.lies, GroupDirection::Column(_))) else {
        return Vec::new();
    };
    let reach = FARTHEST.min(OFF * pitch);
    let lines: Vec<Vec<f32>> =
        group.members.iter().map(|&label| lines_near(wanted[label].anchor, reach, room)).collect();
    let Some(common) = common_offset(&lines) else { return Vec::new() };
    let own = |of: &Vec<f32>| {
        let near = of.iter().copied().filter(|off| (off - common).abs() <= ALIKE);
        near.min_by(|a, b| (a - common).abs().total_cmp(&(b - common).abs())).unwrap_or(common)
    };
    let moved = group.members.iter().copied().zip(lines.iter().map(own));
    moved.filter(|(_, off)| off.abs() > AT_LINE).collect()
}

/// How far off their lines most of some numbers stand, of which each has these lines near it; none if most have none
/// there, or as many have one on the other side: they stand between two.
fn common_offset(lines: &[Vec<f32>]) -> Option<f32> {
    let count = |at: f32| lines.iter().filter(|of| of.iter().any(|off| (off - at).abs() <= ALIKE)).count();
    let offsets = lines.iter().flatten().copied();
    let common = offsets.max_by(|a, b| count(*a).cmp(&count(*b)).then(b.abs().total_cmp(&a.abs())))?;
    let is_between = common.abs() > ALIKE && count(-common) >= count(common);
    (2 * count(common) >= lines.len() && count(common) > 1 && !is_between).then_some(common)
}

/// How far above (less than 0) or below the middle of a text level lines lie, at most `reach` mm.
fn lines_near(text: MmRect, reach: f32, room: &Room) -> Vec<f32> {
    let Some(bounds) = room.bounds() else { return Vec::new() };
    let (from, to) = (bounds.min.x, bounds.max.x);
    let beside = text.min.x - REACH..=text.max.x + REACH;
    let free = 0.5 * room.widest() + FREE;
    let columns = ((to - from) / STEP).ceil() as u32;
    let is_level = |off: f32| {
        let y = text.center().y + off;
        let mut length = 0.0_f32;
        (0..=columns).any(|column| {
            let at = MmPoint::new(from + STEP * column as f32, y);
            let is_line = room.is_ink(at) && [-free, free].iter().all(|&by| !room.is_ink(at + MmVector::new(0.0, by)));
            length = if is_line { length + STEP } else { 0.0 };
            length > SHORTEST_PIECE * (to - from) || length > SHORTEST && beside.contains(&at.x)
        })
    };
    let steps = (reach / STEP).floor() as i32;
    let found: Vec<i32> = (-steps..=steps).filter(|step| is_level(*step as f32 * STEP)).collect();
    // the squares across one line
    let lines = found.chunk_by(|a, b| b - a == 1);
    lines.map(|line| 0.5 * (line[0] + line[line.len() - 1]) as f32 * STEP).collect()
}

#[cfg(test)]
mod tests;
