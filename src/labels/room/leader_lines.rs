//! Straight leader lines of labels among the lines of a figure.

use super::Room;
use super::squares::SQUARE;
use crate::units::{MmPoint, MmRect};

impl Room {
    /// How many lines a straight leader line crosses, without the last `end` mm.
    pub(in crate::labels) fn crossed(&self, from: MmPoint, to: MmPoint, end: f32) -> usize {
        let length = (to - from).length();
        let steps = (2.0 * length / SQUARE).ceil().max(1.0);
        let is_met = |step: u32| {
            let along = step as f32 / steps;
            (1.0 - along) * length > end && self.is_ink(from.lerp(to, along))
        };
        let (count, _) = (0..=steps as u32).fold((0, false), |(count, was_met), step| {
            let is_met = is_met(step);
            (count + usize::from(is_met && !was_met), is_met)
        });
        count
    }

    /// How much of a straight leader line lies near to other lines, mm, without the last `end` mm.
    pub(in crate::labels) fn along(&self, from: MmPoint, to: MmPoint, end: f32) -> f32 {
        let length = (to - from).length();
        let steps = (length / SQUARE).ceil().max(1.0);
        let is_near = |step: u32| {
            let along = step as f32 / steps;
            (1.0 - along) * length > end && self.for_leader.holds(from.lerp(to, along), &self.squares)
        };
        (0..=steps as u32).filter(|step| is_near(*step)).count() as f32 * length / (steps + 1.0)
    }

    /// The longest piece of a straight leader line that runs nearer to lines, but for gridlines, than a label may lie,
    /// mm, without the last `end` mm; its marks lie up to `off` mm off it.
    pub(in crate::labels) fn beside_lines(&self, from: MmPoint, to: MmPoint, end: f32, off: f32) -> f32 {
        let length = (to - from).length();
        let steps = (length / SQUARE).ceil().max(1.0);
        // no box without a side, which would touch no square
        let reach = off + 0.25 * SQUARE;
        let is_near = |step: u32| {
            let along = step as f32 / steps;
            let at = from.lerp(to, along);
            (1.0 - along) * length > end
                && self.taken.within(MmRect::new(at, at).inflate(reach, reach), &self.squares) > 0
        };
        let (_, longest) = (0..=steps as u32).fold((0_u32, 0_u32), |(run, longest), step| {
            let run = if is_near(step) { run + 1 } else { 0 };
            (run, longest.max(run))
        });
        longest as f32 * length / (steps + 1.0)
    }
}
