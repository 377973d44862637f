//! Open lines that are in pieces as dots: where two cross at a flat angle, or run near one another, dots of the weaker
//! one are left out.

use super::kept_lines;
use crate::geom::nearby::Segment;
use crate::lines::{GONE, Line, LostLine, TORN, TearParams, tears, which_are_weak};
use crate::units::{MmPoint, MmRect};

/// Lines are looked at this often, mm.
const STEP: f32 = 1.0;
/// A dot of a line lies no farther from it than so many steps of the dots: half a diagonal of the grid, and what
/// giving way may add.
const FARTHEST: f32 = 1.5;
/// The shortest missing piece that is told has so many steps: where two dots are missing there are three, or more in a
/// slanting row.
const LEAST_STEPS: f32 = 3.1;

/// A line meets another if it ends so near to it, mm, before both become dots.
const MEETS: f32 = 0.3;

/// How open lines are looked at where dots lie `pitch` mm apart.
pub(super) fn params_of_dots(pitch: f32) -> TearParams {
    TearParams { reach: pitch, least: TORN.max(LEAST_STEPS * pitch) }
}

/// What is missing of open lines, of which these shares become dots, among those that are `pressed`; `stand_for` says
/// of which line each of these is. Dots lie `pitch` mm apart. Weak lines, such as gridlines, give way to all others:
/// nothing is told of them.
pub(super) fn torn(
    (lines, shares): (&[Line], &[f32]),
    (pressed, stand_for): (&[Line], &[Option<usize>]),
    area: MmRect,
    pitch: f32,
    least_strength: f32,
) -> Vec<LostLine> {
    let weak = which_are_weak(lines, least_strength);
    let near = kept_lines::index_of(pressed, area, pitch);
    let is_near = |at: MmPoint| near.nearest(at, pitch, |_| true).is_some();
    let params = params_of_dots(pitch);
    let others = kept_lines::index_of(lines, area, pitch);
    let is_met = |at: Option<&MmPoint>, number: usize| {
        let is_other = |segment: &Segment| segment.line as usize != number && !weak[segment.line as usize];
        at.is_some_and(|at| others.nearest(*at, MEETS, is_other).is_some())
    };
    let of_line = |number: usize| -> Vec<LostLine> {
        let line = &lines[number];
        if weak[number] || shares[number] < GONE || line.ends_meet() {
            return Vec::new();
        }
        let path = places(line);
        let mut piece_at = vec![None; path.len()];
        let pieces = pressed.iter().zip(stand_for).enumerate().filter(|(_, (_, of))| **of == Some(number));
        for (piece, (row, _)) in pieces {
            for dot in row.own_runs().iter().flat_map(|run| &run.points) {
                if let Some(at) = nearest(&path, *dot, FARTHEST * pitch) {
                    piece_at[at] = Some(piece);
                }
            }
        }
        let meets = [path.first(), path.last()].map(|end| is_met(end, number));
        tears(&path, &piece_at, is_near, meets, params)
    };
    (0..lines.len()).flat_map(of_line).collect()
}

/// Places along a line.
fn places(line: &Line) -> Vec<MmPoint> {
    let path = line.own_path();
    let mut places: Vec<MmPoint> = path.first().copied().into_iter().collect();
    for pair in path.windows(2) {
        let steps = ((pair[1] - pair[0]).length() / STEP).ceil().max(1.0) as u32;
        places.extend((1..=steps).map(|step| pair[0].lerp(pair[1], step as f32 / steps as f32)));
    }
    places
}

/// The number of the place that is nearest to a dot, if it is near.
fn nearest(places: &[MmPoint], dot: MmPoint, reach: f32) -> Option<usize> {
    let far = |at: usize| (places[at] - dot).square_length();
    let nearest = (0..places.len()).min_by(|&a, &b| far(a).total_cmp(&far(b)));
    nearest.filter(|&at| far(at) <= reach * reach)
}

#[cfg(test)]
mod tests;
