//! Corners of dashed lines: where a curve turns at a point, its dash there is bent or cut, and two rows of dashes end
//! before it. Both lead to the corner.

use super::alike::{ROUNDING, are_alike};
use crate::edges::contour::crossing;
use crate::edges::tips::FoundContour;
use crate::units::{PxPoint, PxVector};

/// Greatest cosine between the directions of two ends that make a corner: at least 10 degrees between its sides. Rows
/// that go on in one another are one row.
const NARROWEST: f32 = 0.985;

/// The end of a dashed line.
pub(super) struct RowEnd {
    /// The number of its line.
    pub(super) row: usize,
    pub(super) at_start: bool,
    pub(super) at: PxPoint,
    /// Away from the row.
    pub(super) direction: PxVector,
    /// How far it may be to the corner, px.
    pub(super) reach: f32,
    pub(super) width: f32,
}

/// Leads ends of two dashed lines to the corner that they make, the nearest first, where nothing is met on the way but
/// what may be a dash. Returns these corners.
pub(super) fn join(ends: &[RowEnd], lines: &mut [FoundContour], is_met: &dyn Fn([PxPoint; 2]) -> bool) -> Vec<PxPoint> {
    let pairs = (0..ends.len()).flat_map(|a| (a + 1..ends.len()).map(move |b| (a, b)));
    let corner = |(a, b): (usize, usize)| {
        let tip = tip(&ends[a], &ends[b]).filter(|tip| ![a, b].iter().any(|&end| is_met([ends[end].at, *tip])))?;
        let far = [a, b].iter().map(|&end| (tip - ends[end].at).length()).sum::<f32>();
        Some((far, a, b, tip))
    };
    let mut corners: Vec<(f32, usize, usize, PxPoint)> = pairs.filter_map(corner).collect();
    corners.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut is_led = vec![false; ends.len()];
    let mut tips = Vec::new();
    for (_, a, b, tip) in corners {
        if is_led[a] || is_led[b] {
            continue;
        }
        tips.push(tip);
        for number in [a, b] {
            is_led[number] = true;
            lines[ends[number].row].lead_to(tip, ends[number].at_start, ROUNDING);
        }
    }
    tips
}

/// The corner of two ends, if they make one.
fn tip(a: &RowEnd, b: &RowEnd) -> Option<PxPoint> {
    if a.row == b.row || !are_alike(a.width, b.width) || a.direction.dot(b.direction).abs() > NARROWEST {
        return None;
    }
    let (from_a, from_b) = crossing((a.at, a.direction), (b.at, b.direction))?;
    let is_near = |ahead: f32, end: &RowEnd| (-ROUNDING..=end.reach).contains(&ahead);
    (is_near(from_a, a) && is_near(from_b, b)).then_some(a.at + a.direction * from_a)
}
