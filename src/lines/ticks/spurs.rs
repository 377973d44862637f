//! Ticks that would be spurs in an overview, which has no room for ticks: where the line of a drawing begins at an axis
//! just across from one, as the top of a bar that is drawn as standing at it, the two would be joined to one line over
//! the axis, and of all its ticks this one would stay.

use super::found::{Tick, ticks};
use super::{scale, without};
use crate::geom::nearby::Index;
use crate::geom::polyline::Polyline;
use crate::lines::params::Params;
use crate::lines::vertex::{Tip, Vertex};
use crate::units::MmRect;

/// Takes the ticks of scales that are too short for lines out of the contours of an overview, if another line ends
/// where they stand. Gives them.
pub(in crate::lines) fn take(
    polylines: &mut Vec<Polyline<Vertex>>,
    area: MmRect,
    params: &Params,
) -> Vec<Polyline<Vertex>> {
    let lines: &[Polyline<Vertex>] = polylines;
    let mut ticks = ticks(lines, area, params);
    ticks.sort_by_key(|tick| tick.base);
    let mut is_of_scale = vec![false; lines.len()];
    let scales = ticks.chunk_by(|a, b| a.base == b.base).filter_map(|on_line| scale(on_line, lines, params));
    let of_scales: Vec<&Tick> = scales.flatten().collect();
    of_scales.iter().for_each(|tick| is_of_scale[tick.number] = true);
    if of_scales.is_empty() {
        return Vec::new();
    }
    let reach = params.bridged_gap();
    let mut ends = Index::new(area, params.max_spacing());
    for (number, line) in lines.iter().enumerate().filter(|(number, line)| !line.closed && !is_of_scale[*number]) {
        Tip::BOTH.iter().filter_map(|which| which.of(line)).for_each(|end| ends.put_at(end.at, (number, end.at)));
    }
    let is_spur = |tick: &&Tick| {
        let foot = tick.foot().and_then(|(which, _)| which.of(&lines[tick.number]));
        let Some(foot) = foot.map(|end| end.at) else { return false };
        let mut meets_end = false;
        ends.around(foot, foot, reach, |&(number, at)| {
            meets_end |= number != tick.base && (at - foot).length() <= reach;
        });
        lines[tick.number].length() < params.min_length && meets_end
    };
    let mut taken = vec![false; lines.len()];
    of_scales.iter().copied().filter(is_spur).for_each(|tick| taken[tick.number] = true);
    let spurs = lines.iter().zip(&taken).filter(|(_, taken)| **taken).map(|(line, _)| line.clone()).collect();
    without(polylines, &taken);
    spurs
}

#[cfg(test)]
mod tests;
