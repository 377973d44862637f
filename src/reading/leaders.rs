//! Leader lines of labels that were moved: the label takes its line along, and its tip stays at what it names.

use usvg::roxmltree::Node;

use super::document::numbers;
use crate::page::{Pen, Run};
use crate::units::MmPoint;

/// What is no move, mm: rounding.
const SAME: f32 = 0.05;

/// The leader line of a label that was moved as a whole, with its tip where it was: the label says where its line ran
/// when it was written. A line of which an end was moved by itself is as it was drawn. One of dots stays as it is, as
/// its dots stand on those of the device.
pub(super) fn with_own_tip(leader: Run, label: Node<'_, '_>) -> Run {
    let ends = numbers(label, "data-leader").filter(|_| label.has_attribute("transform"));
    let Some(&[x, y, tip_x, tip_y]) = ends.as_deref() else { return leader };
    let (from, tip) = (MmPoint::new(x, y), MmPoint::new(tip_x, tip_y));
    let (Some(&first), Some(&last), Pen::Stroke) = (leader.points.first(), leader.points.last(), leader.pen) else {
        return leader;
    };
    let (moved, of_tip) = (first - from, last - tip);
    if moved.length() <= SAME || (of_tip - moved).length() > SAME {
        return leader;
    }
    Run { points: vec![first, tip], ..leader }
}

#[cfg(test)]
mod tests;
