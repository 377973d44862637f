//! Bars side by side that are drawn touching one another, or as standing at an axis: the lines of their outlines, and
//! what divides stacked bars up to the axis. (Between two bars ends are led on to the line there, as all others are.)

use super::bars::{Bar, Chart, SAME};
use crate::edges::Edgel;
use crate::geom::polyline::Polyline;
use crate::units::PxPoint;

/// What is level differs from that by at most 25 degrees (the cosine).
const LEVEL: f32 = 0.9;

/// Bars side by side that have no gaps for fingers, and where their outline begins and ends across: at an axis that is
/// as near, or at their own sides.
pub(super) struct BarRow {
    pub(super) bars: Vec<Bar>,
    pub(super) ends: [RowEnd; 2],
}

#[derive(Clone, Copy)]
pub(super) struct RowEnd {
    pub(super) at: f32,
    /// Whether an axis is there.
    pub(super) is_axis: bool,
}

impl BarRow {
    /// Its bars, each with the two places across where its sides are drawn: those between two bars are left as they
    /// are where `only_axes` count.
    fn sides(&self, only_axes: bool) -> Vec<(Bar, [f32; 2])> {
        let [first, last] = self.ends.map(|end| end.at);
        let between = self.bars.windows(2).map(|pair| [middle(&pair[0], &pair[1]); 2]);
        let own = self.bars.windows(2).map(|pair| [pair[0].to, pair[1].from]);
        let between: Vec<[f32; 2]> = if only_axes { own.collect() } else { between.collect() };
        let from = std::iter::once(first).chain(between.iter().map(|at| at[1]));
        let to = between.iter().map(|at| at[0]).chain([last]);
        self.bars.iter().zip(from.zip(to)).map(|(bar, (from, to))| (*bar, [from, to])).collect()
    }
}

/// The place halfway between two bars.
fn middle(before: &Bar, next: &Bar) -> f32 {
    0.5 * (before.to + next.from)
}

impl Chart {
    /// Where lines are: the outline of each row, and between every two of its bars if they are `touching`.
    pub(super) fn paths(&self, rows: &[BarRow], touching: bool) -> Vec<Vec<PxPoint>> {
        let mut paths = Vec::new();
        for BarRow { bars, ends: [first, last] } in rows {
            let mut outline = vec![(first.at, bars[0].top)];
            if !first.is_axis {
                outline.insert(0, (first.at, self.base));
            }
            for pair in bars.windows(2) {
                let middle = middle(&pair[0], &pair[1]);
                outline.extend([(middle, pair[0].top), (middle, pair[1].top)]);
                if touching {
                    paths.push(vec![(middle, self.base), (middle, pair[0].top.min(pair[1].top))]);
                }
            }
            outline.push((last.at, bars[bars.len() - 1].top));
            if !last.is_axis {
                outline.push((last.at, self.base));
            }
            paths.push(outline);
        }
        paths.into_iter().map(|path| path.into_iter().map(|at| self.direction.point(at)).collect()).collect()
    }

    /// A piece of a contour; if it divides a bar of these rows, it is led on to where the sides of that are drawn.
    pub(super) fn with_divider_led_on(
        &self,
        mut piece: Polyline<Edgel>,
        rows: &[BarRow],
        only_axes: bool,
    ) -> Polyline<Edgel> {
        for _ in 0..2 {
            let mut sides = rows.iter().flat_map(|row| row.sides(only_axes));
            let side = sides.find_map(|(bar, at)| self.side_ahead(&piece, bar, at));
            if let (Some(across), Some(&tip)) = (side, piece.vertices.last()) {
                let to = self.direction.point((across, self.direction.of(tip.at).1));
                let steps = (to - tip.at).length().ceil();
                let path = (1..=steps as u32).map(|k| tip.at.lerp(to, k as f32 / steps));
                piece.vertices.extend(path.map(|at| Edgel { at, ..tip }));
            }
            // the other end, and then as it was
            piece.vertices.reverse();
        }
        piece
    }

    /// Where a side of a bar is drawn, if a level piece in that bar ends at this side and before there, with its last
    /// vertex.
    fn side_ahead(&self, piece: &Polyline<Edgel>, bar: Bar, [first, last]: [f32; 2]) -> Option<f32> {
        let end = piece.vertices.last()?;
        let inner = piece.vertices.iter().rev().find(|edgel| (edgel.at - end.at).length() > 2.0 * SAME)?;
        let ((across, along), (from, _)) = (self.direction.of(end.at), self.direction.of(inner.at));
        let is_level = (across - from).abs() >= LEVEL * (end.at - inner.at).length();
        let is_in = (self.base + SAME..bar.top - SAME).contains(&along) && (bar.from..=bar.to).contains(&from);
        let (own, drawn, outwards) = if from > across { (bar.from, first, -1.0) } else { (bar.to, last, 1.0) };
        let is_at_side = (across - own).abs() <= SAME && (drawn - own) * outwards > SAME;
        (is_level && is_in && is_at_side).then_some(drawn)
    }
}

#[cfg(test)]
mod tests;
