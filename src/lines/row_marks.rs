//! Ticks and points on a line of dots, which are dots beside its first row, as its second row is: told apart by where
//! they lie.

use super::line::{Line, Run};
use super::marks::PointMark;
use crate::geom::nearest_on_segment;
use crate::units::{MmPoint, MmRect};

/// The last dot of a tick is farther from its line than this, in steps: a second row is up to 1.42.
const AWAY: f32 = 1.7;
/// In a row of dots the next is no farther than this, in steps, also diagonally.
pub(super) const NEXT_DOT: f32 = 1.6;
/// Around the middle of a point there is no wider angle without a dot, in turns: a second row has half a turn.
const OPEN: f32 = 0.4;
/// A point is as wide as high, within this.
const AS_WIDE: f32 = 0.7;
/// The row passes the middle of a point within the point's radius and this, in steps; a second row has its middle
/// farther away.
const NEARER: f32 = 0.3;
/// Within a hollow point there are no dots of its line, but for this, in steps.
const INSIDE: f32 = 0.5;
/// A disc has a dot so near to its middle, in steps.
const MIDDLE: f32 = 0.4;

impl Line {
    /// The first row of a line of dots, and the step from dot to dot, mm.
    fn first_row(&self) -> Option<(&Run, f32)> {
        let first = self.row()?;
        let steps = first.points.windows(2).map(|pair| (pair[1] - pair[0]).length());
        Some((first, steps.fold(f32::INFINITY, f32::min)))
    }

    /// The ticks on a line of dots: rows that lead away from it, each with the place where it stands.
    #[doc(hidden)]
    pub fn row_ticks(&self) -> impl Iterator<Item = (&Run, MmPoint)> {
        let first = self.first_row();
        let heads: Vec<[MmPoint; 2]> = self.row_heads().map(|(_, _, wings)| wings).collect();
        let is_head = move |run: &&Run| {
            let ends = run.points.first().zip(run.points.last());
            ends.is_some_and(|(first, last)| heads.contains(&[*first, *last]))
        };
        let tick = move |run| {
            let (first, step) = first?;
            let Run { points, .. }: &Run = run;
            let is_row = points.windows(2).all(|pair| (pair[1] - pair[0]).length() < NEXT_DOT * step);
            let (distance, _) = nearest(first, *points.last()?)?;
            let (_, at) = nearest(first, *points.first()?)?;
            (is_row && distance > AWAY * step).then_some((run, at))
        };
        self.runs.iter().skip(1).filter(move |run| !is_head(run)).filter_map(tick)
    }

    /// The points on a line of dots.
    #[doc(hidden)]
    pub fn row_points(&self) -> impl Iterator<Item = PointMark> {
        let first = self.first_row();
        self.runs.iter().skip(1).filter_map(move |run| {
            let (first, step) = first?;
            let extent = MmRect::from_points(&run.points);
            let (at, [width, height]) = (extent.center(), [extent.width(), extent.height()]);
            let (radius, distance) = (0.25 * (width + height), nearest(first, at)?.0);
            let is_point = width.min(height) >= AS_WIDE * width.max(height)
                && radius > 0.5 * step
                && distance <= radius + NEARER * step
                && widest_angle(at, &run.points) <= OPEN;
            let mut dots = run.points.iter().chain(&first.points);
            let is_filled = dots.any(|dot| (*dot - at).length() < MIDDLE * step);
            // the second row around a ring has that inside
            let is_hollow = first.points.iter().all(|dot| (*dot - at).length() > radius - INSIDE * step);
            // and that inside of one has it around
            let is_in_row = || widest_angle(at, &first.points) <= OPEN;
            let is_mark = is_point && (is_filled || is_hollow) && !is_in_row();
            is_mark.then_some(PointMark {
                at,
                radius,
                is_filled,
                series: None,
                is_alone: false,
                strength: self.strength,
            })
        })
    }
}

/// The place of a row nearest to a point, and the distance.
fn nearest(row: &Run, at: MmPoint) -> Option<(f32, MmPoint)> {
    let places = row.points.windows(2).map(|pair| nearest_on_segment(at, pair[0], pair[1]));
    places.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The widest angle around a place without a dot, in turns.
fn widest_angle(middle: MmPoint, dots: &[MmPoint]) -> f32 {
    let around = dots.iter().map(|dot| *dot - middle).filter(|offset| offset.length() > 1e-3);
    let mut turns: Vec<f32> = around.map(|offset| offset.angle_from_x_axis().radians / std::f32::consts::TAU).collect();
    turns.sort_by(f32::total_cmp);
    let (Some(first), Some(last)) = (turns.first(), turns.last()) else { return 1.0 };
    let over = first + 1.0 - last;
    turns.windows(2).map(|pair| pair[1] - pair[0]).fold(over, f32::max)
}

#[cfg(test)]
mod tests;
