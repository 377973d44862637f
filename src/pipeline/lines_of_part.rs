//! Where lines are on a page, to know of a curve whether it is drawn.

use crate::geom::nearby::Nearby;
use crate::lines::{Line, index_of_lines};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect};

/// Lines are smoothed, mm, beyond what they give way.
const SMOOTHED: f32 = 1.0;

/// A line is looked at in steps of this, mm.
const STEP: f32 = 2.0;

/// The lines of a figure or of an overview.
pub(super) struct LinesOfPart {
    index: Nearby,
    reach: f32,
}

impl LinesOfPart {
    /// Those of a part of the page that lies at `place`.
    pub(super) fn of(lines: &[Line], place: MmRect, layout: &Layout, plan: &Plan) -> Self {
        Self::within(lines, place, plan.lines().farthest_moved().max(1.5 * layout.medium.pitch()) + SMOOTHED)
    }

    /// The same, to be looked for no farther off than this, mm.
    pub(super) fn within(lines: &[Line], place: MmRect, reach: f32) -> Self {
        Self { index: index_of_lines(lines, place, reach), reach }
    }

    /// The share of a line of the other part of the page, which lies at the first place, at which there is one in this.
    pub(super) fn share_of_line(&self, line: &Line, [from, to]: [MmRect; 2]) -> f32 {
        let scale = to.width() / from.width();
        let segments = line.runs.iter().flat_map(|run| {
            let path: Vec<MmPoint> = run.path().collect();
            path.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
        });
        let places = segments.flat_map(|[a, b]| {
            let steps = ((b - a).length() / STEP).ceil().max(1.0) as u32;
            (0..=steps).map(move |step| to.min + (a.lerp(b, step as f32 / steps as f32) - from.min) * scale)
        });
        self.share(places)
    }

    /// Whether there is a line at a place.
    pub(super) fn has(&self, at: MmPoint) -> bool {
        self.index.nearest(at, self.reach, |_| true).is_some()
    }

    /// Share of some places at which there is a line; 0 of none.
    pub(super) fn share(&self, places: impl Iterator<Item = MmPoint>) -> f32 {
        let (mut all, mut near) = (0_u32, 0_u32);
        for at in places {
            all += 1;
            near += u32::from(self.has(at));
        }
        near as f32 / all.max(1) as f32
    }
}
