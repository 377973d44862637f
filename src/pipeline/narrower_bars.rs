//! Stacked bars that have a little too little room side by side in an overview. Drawn touching one another, the parts
//! of one would seem to go on in the next; so they are narrower, and moved aside from the axis, by what fingers hardly
//! notice: only their heights say something.

use super::bars::{Bar, BaseSpan, Chart, SAME};
use crate::edges::Edges;
use crate::units::{PxPoint, PxVector};

/// What is level differs from that by at most 25 degrees (the cosine).
const LEVEL: f32 = 0.9;

/// How bars are moved, px.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Narrowing {
    /// Each of their sides, inwards.
    inwards: f32,
    /// All of them, across.
    aside: f32,
}

impl Narrowing {
    /// How bars are moved so that they are `gap` apart, and have that before the axes that are so far `before` the
    /// first and the last of them. None if nothing is too near, and none if it takes more than `most`, or leaves one of
    /// them narrower than `gap`.
    fn of(bars: &[Bar], before: [f32; 2], gap: f32, most: f32) -> Option<Self> {
        let narrowest = bars.iter().map(|bar| bar.to - bar.from).fold(f32::INFINITY, f32::min);
        let between = bars.windows(2).map(|pair| pair[1].from - pair[0].to).fold(f32::INFINITY, f32::min);
        let [first, last] = before;
        // between two bars there is room by both their sides, and before an axis by one and by what all are moved
        let needed = [0.5 * (gap - between), gap - 0.5 * (first + last), gap - first - most, gap - last - most];
        let inwards = needed.into_iter().fold(0.0, f32::max);
        let missing = before.map(|before| (gap - before - inwards).max(0.0));
        let aside = missing[0] - missing[1];
        let fits = inwards <= most && aside.abs() <= most && narrowest - 2.0 * inwards >= gap;
        (fits && inwards + aside.abs() > 0.0).then_some(Self { inwards, aside })
    }

    /// Where a place across a bar is then.
    fn moved(self, across: f32, bar: &Bar) -> f32 {
        let (middle, half) = (0.5 * (bar.from + bar.to), 0.5 * (bar.to - bar.from));
        middle + self.aside + (across - middle) * (half - self.inwards) / half
    }
}

impl Chart {
    /// The contours of a chart of stacked bars that are moved as [`Narrowing::of`] says, and the chart then.
    pub(super) fn with_room(&self, edges: &Edges, before: [f32; 2], gap: f32, most: f32) -> Option<(Edges, Self)> {
        let narrowing = Narrowing::of(&self.bars, before, gap, most).filter(|_| self.is_divided)?;
        let mut moved = edges.clone();
        for chain in &edges.chains {
            let view = edges.chain(chain);
            // the outline of a bar or of a part of it as a whole, and of others what is a bar's
            let is_all_in = |bar: &&Bar| view.vertices.iter().all(|edgel| self.is_in(bar, edgel.at));
            let of_all = self.bars.iter().find(is_all_in);
            for (i, (edgel, own)) in moved.edgels[chain.edgels.clone()].iter_mut().zip(view.vertices).enumerate() {
                let is_of = |bar: &&Bar| self.is_of(bar, own.at, view.tangent(i));
                if let Some(bar) = of_all.or_else(|| self.bars.iter().find(is_of)) {
                    let (across, along) = self.direction.of(own.at);
                    edgel.at = self.direction.point((narrowing.moved(across, bar), along));
                }
            }
        }
        let of_side = |at: f32| self.bars.iter().find(|bar| is_side(bar, at));
        let side = |side: &BaseSpan| {
            let at = of_side(side.at).map_or(side.at, |bar| narrowing.moved(side.at, bar));
            BaseSpan { at, ..*side }
        };
        let bar = |bar: &Bar| Bar { from: narrowing.moved(bar.from, bar), to: narrowing.moved(bar.to, bar), ..*bar };
        let (bars, sides) = (self.bars.iter().map(bar).collect(), self.sides.iter().map(side).collect());
        Some((moved, Self { bars, sides, ..self.clone() }))
    }

    /// Whether a place is in a bar or on its outline.
    fn is_in(&self, bar: &Bar, at: PxPoint) -> bool {
        let (across, along) = self.direction.of(at);
        (bar.from - SAME..=bar.to + SAME).contains(&across) && (self.base - SAME..=bar.top + SAME).contains(&along)
    }

    /// Whether a place of a contour that leads in this direction is on a side of a bar, or divides it. What is level on
    /// the base goes on to the next bar.
    fn is_of(&self, bar: &Bar, at: PxPoint, direction: PxVector) -> bool {
        let (across, along) = self.direction.of(at);
        let is_level = self.direction.of(direction.to_point()).0.abs() >= LEVEL;
        self.is_in(bar, at) && if is_level { along > self.base + SAME } else { is_side(bar, across) }
    }
}

/// Whether a place across is that of a side of a bar.
fn is_side(bar: &Bar, across: f32) -> bool {
    (across - bar.from).abs() <= SAME || (across - bar.to).abs() <= SAME
}

#[cfg(test)]
mod tests;
