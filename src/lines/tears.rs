//! What is missing of open lines of which pieces are drawn, such as the curves of a chart where they cross others.

use std::collections::BTreeMap;

use super::faint::is_faint;
use super::lost::{GONE, LostLine};
use super::params::Params;
use super::vertex::{Vertex, nearby};
use crate::geom::polyline::{self, Polyline};
use crate::units::{MmPoint, MmRect};

/// Shortest missing piece between two of a line that is told, mm: more than a finger slips over, as on a dashed line,
/// by so much as is missing where lines cross. Chosen by us.
pub(crate) const TORN: f32 = 6.0;
/// At the ends of a line it is so many times as long: these are moved up to others, and cut off where they stand out
/// beyond them. Chosen by us.
const AT_END: f32 = 2.0;

/// How a line is looked at.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TearParams {
    /// So far from a line something else may stand for it, mm.
    pub(crate) reach: f32,
    /// The shortest missing piece that is told, mm.
    pub(crate) least: f32,
}

/// What is missing of an open line along `path`: of which of its pieces each point of the path is, `piece_at` says, and
/// whether any line is within reach, `is_near`. An end that `meets` another line is missed as soon as a piece between
/// two others. Of a line of which no piece is drawn nothing is told.
pub(crate) fn tears(
    path: &[MmPoint],
    piece_at: &[Option<usize>],
    is_near: impl Fn(MmPoint) -> bool,
    meets: [bool; 2],
    params: TearParams,
) -> Vec<LostLine> {
    let drawn: Vec<(usize, usize)> =
        piece_at.iter().enumerate().filter_map(|(at, piece)| piece.map(|piece| (at, piece))).collect();
    let (Some(&(first, _)), Some(&(last, _))) = (drawn.first(), drawn.last()) else { return Vec::new() };
    let missing = |from: usize, to: usize, tips: f32, least: f32| {
        let stretch = path.get(from..=to)?;
        let open: f32 = stretch
            .windows(2)
            .filter(|pair| !is_near(pair[0].lerp(pair[1], 0.5)))
            .map(|pair| (pair[1] - pair[0]).length())
            .sum();
        // a piece of the line itself is near beside each of its tips
        let length = (open + tips * params.reach).min(polyline::length(stretch));
        let extent = MmRect::from_points(stretch);
        let lost = LostLine { extent, length, closed: false, is_faint: false, form: None };
        (open > 0.0 && length > least).then_some(lost)
    };
    let ends = [(0, first), (last, path.len().saturating_sub(1))];
    let at_ends = ends.into_iter().zip(meets).filter_map(|((from, to), meets)| match meets {
        true => missing(from, to, 2.0, params.least),
        false => missing(from, to, 1.0, AT_END * params.least),
    });
    let tips = drawn.windows(2).filter(|pair| pair[0].1 != pair[1].1);
    let between = tips.filter_map(|pair| missing(pair[0].0, pair[1].0, 2.0, params.least));
    between.chain(at_ends).collect()
}

/// What is missing of those of these lines that are open, if more of them is drawn than of one that is gone. Thin, pale
/// ones give way to all others, and nothing is told of them here.
pub(super) fn torn<'a>(
    lines: &[&Polyline<Vertex>],
    drawn: impl Iterator<Item = &'a Polyline<Vertex>> + Clone,
    area: MmRect,
    params: &Params,
) -> Vec<LostLine> {
    let reach = params.farthest_moved();
    let near = nearby(lines.iter().copied(), area, params);
    let mut piece_at: Vec<Vec<Option<usize>>> = lines.iter().map(|line| vec![None; line.vertices.len()]).collect();
    let mut kept = vec![0.0; lines.len()];
    for (piece, polyline) in drawn.clone().enumerate() {
        // it is a piece of the line at which most of it lies
        let mut beside: BTreeMap<usize, (f32, Vec<usize>)> = BTreeMap::new();
        for (a, b) in polyline.segments() {
            if let Some((_, _, segment)) = near.nearest(a.at.lerp(b.at, 0.5), reach, |_| true) {
                let (length, at) = beside.entry(segment.line as usize).or_default();
                *length += (b.at - a.at).length();
                at.push(segment.index as usize);
            }
        }
        if let Some((line, (length, at))) = beside.into_iter().max_by(|a, b| a.1.0.total_cmp(&b.1.0)) {
            kept[line] += length;
            at.into_iter().for_each(|at| piece_at[line][at] = Some(piece));
        }
    }
    let near_drawn = nearby(drawn, area, params);
    let is_near = |at: MmPoint| near_drawn.nearest(at, reach, |_| true).is_some();
    let torn = |((line, pieces), kept): ((&&Polyline<Vertex>, Vec<Option<usize>>), f32)| -> Vec<LostLine> {
        if line.view().goes_round() || is_faint(line) || kept < GONE * line.length() {
            return Vec::new();
        }
        let path: Vec<MmPoint> = line.vertices.iter().map(|vertex| vertex.at).collect();
        tears(&path, &pieces, is_near, [false; 2], TearParams { reach, least: TORN })
    };
    lines.iter().zip(piece_at).zip(kept).flat_map(torn).collect()
}

#[cfg(test)]
mod tests;
