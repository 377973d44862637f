//! Ticks and points on a line of dots, which are dots beside its first row, as its second row is: told apart by where
//! they lie.

use super::line::{Line, Pen, Run};
use super::marks::PointMark;
use crate::geom::nearest_on_segment;
use crate::units::{MmPoint, MmRect};

/// The last dot of a tick is farther from its line than this, in steps: a second row is up to 1.42.
const AWAY: f32 = 1.7;
/// In a row of dots the next is no farther than this, in steps.
const BROKEN: f32 = 1.6;
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
        let first = self.runs.first().filter(|run| run.pen != Pen::Stroke)?;
        let steps = first.points.windows(2).map(|pair| (pair[1] - pair[0]).length());
        Some((first, steps.fold(f32::INFINITY, f32::min)))
    }

    /// The ticks on a line of dots: rows that lead away from it, each with the place where it stands.
    #[doc(hidden)]
    pub fn row_ticks(&self) -> impl Iterator<Item = (&Run, MmPoint)> {
        let first = self.first_row();
        let tick = move |run| {
            let (first, step) = first?;
            let Run { points, .. }: &Run = run;
            let is_row = points.windows(2).all(|pair| (pair[1] - pair[0]).length() < BROKEN * step);
            let (distance, _) = nearest(first, *points.last()?)?;
            let (_, at) = nearest(first, *points.first()?)?;
            (is_row && distance > AWAY * step).then_some((run, at))
        };
        self.runs.iter().skip(1).filter_map(tick)
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
            (is_point && (is_filled || is_hollow)).then_some(PointMark { at, radius, is_filled, series: None })
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
mod tests {
    use super::*;
    use crate::lines::Height;

    fn run(dots: &[(f32, f32)]) -> Run {
        Run::dots(1.6, dots.iter().map(|&(x, y)| MmPoint::new(2.0 * x, 2.0 * y)).collect(), Height::High)
    }

    fn row(y: f32, columns: std::ops::Range<u32>) -> Vec<(f32, f32)> {
        columns.map(|x| (x as f32, y)).collect()
    }

    #[test]
    fn ticks_and_points_are_told_from_a_second_row() {
        let around = |x: f32| {
            [(-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0)]
                .map(|(dx, dy)| (x + dx, 10.0 + dy))
        };
        let mut axis = row(10.0, 0..40);
        axis.remove(30);
        let parts = [&axis[..], &row(11.0, 0..8), &[(5.0, 12.0), (5.0, 13.0)], &around(20.0), &around(30.0)];
        let line = Line { strength: 100.0, runs: parts.into_iter().map(run).collect() };
        let ticks: Vec<MmPoint> = line.row_ticks().map(|(_, at)| at).collect();
        assert_eq!(ticks, [MmPoint::new(10.0, 20.0)]);
        let points: Vec<(MmPoint, bool)> = line.row_points().map(|point| (point.at, point.is_filled)).collect();
        assert_eq!(points, [(MmPoint::new(40.0, 20.0), true), (MmPoint::new(60.0, 20.0), false)]);
    }

    #[test]
    fn the_second_row_of_a_ring_is_no_point() {
        let ring = |radius: f32| -> Vec<(f32, f32)> {
            let at = |k: u32| (k as f32 * std::f32::consts::TAU / 24.0).sin_cos();
            (0..24).map(at).map(|(y, x)| (10.0 + radius * x, 10.0 + radius * y)).collect()
        };
        let line = Line { strength: 100.0, runs: vec![run(&ring(5.0)), run(&ring(4.0))] };
        assert_eq!((line.row_points().count(), line.row_ticks().count()), (0, 0));
        let outside = Line { strength: 100.0, runs: vec![run(&ring(4.0)), run(&ring(5.0))] };
        assert_eq!(outside.row_points().count(), 0);
        let stroke =
            Line { strength: 1.0, runs: vec![Run::stroke(1.0, vec![MmPoint::zero(), MmPoint::new(9.0, 0.0)])] };
        assert_eq!((stroke.row_points().count(), stroke.row_ticks().count()), (0, 0));
    }
}
