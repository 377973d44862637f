//! What of a shape is seen from a point in it.

use std::cmp::Ordering;
use std::f32::consts::TAU;

use super::{FINE_RAYS, Room};
use crate::units::{MmPoint, MmRect, MmVector};

/// A part of a shape is hidden behind a line that is so far from what is seen beside it, mm, with no line so near to
/// the middle between, mm, as there is along a wall: on a grid lines have steps.
const HIDDEN: f32 = 10.0;
const BESIDE_SIGHT: f32 = 2.0;
/// What is seen farther off in fewer directions side by side, a sixth of all, lies behind a gap of an outline, such as
/// the one in the middle of a pie of dots.
const THROUGH_A_GAP: usize = FINE_RAYS as usize / 6;

impl Room {
    /// Whether a part of the shape around a point is hidden from it within `reach` mm, as behind the furniture and
    /// doors of a room: two lines that are seen side by side lie far from one another, with a blank between. Nothing is
    /// hidden in a box or in the sector of a pie, though a gap leads out of it.
    pub(in crate::labels) fn hides_a_part(&self, at: MmPoint, reach: f32) -> bool {
        let ink = self.strong.as_ref().unwrap_or(&self.ink);
        let look = |ray: u32| {
            let (sin, cos) = (TAU * ray as f32 / FINE_RAYS as f32).sin_cos();
            let direction = MmVector::new(cos, sin);
            self.first_in(ink, at, direction, reach).map(|far| (far, at + direction * far))
        };
        let seen: Vec<Option<(f32, MmPoint)>> = (0..FINE_RAYS).map(look).collect();
        let is_blank = |at: MmPoint| self.nearest(MmRect::new(at, at), BESIDE_SIGHT, ink).is_none();
        // whether the next that is seen lies behind this one, or before it
        let step = |ray: usize| match (seen[ray], seen[(ray + 1) % seen.len()]) {
            (Some((far, a)), Some((next, b))) if (b - a).length() >= HIDDEN && is_blank(a.lerp(b, 0.5)) => {
                next.total_cmp(&far)
            }
            _ => Ordering::Equal,
        };
        let steps: Vec<Ordering> = (0..seen.len()).map(step).collect();
        let all = steps.len();
        // in how many directions something is seen behind, up to the step back
        let behind = |ray: usize| match steps[ray] {
            Ordering::Equal => 0,
            Ordering::Greater => (1..=all).find(|by| steps[(ray + by) % all] == Ordering::Less).unwrap_or(all),
            Ordering::Less => (1..=all).find(|by| steps[(ray + all - by) % all] == Ordering::Greater).unwrap_or(all),
        };
        (0..all).any(|ray| behind(ray) > THROUGH_A_GAP)
    }
}
