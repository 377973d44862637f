//! What of a line lies on the sheet.

use lyon::geom::LineSegment;

use crate::units::{MmPoint, MmRect};

/// The parts of a polyline inside a rectangle.
pub(super) fn inside(points: &[MmPoint], closed: bool, area: MmRect) -> Vec<Vec<MmPoint>> {
    let area = area.to_untyped();
    let last = closed.then(|| points.last().copied().zip(points.first().copied())).flatten();
    let segments = points.windows(2).map(|pair| (pair[0], pair[1])).chain(last);
    let mut parts: Vec<Vec<MmPoint>> = Vec::new();
    for (from, to) in segments {
        let segment = LineSegment { from: from.to_untyped(), to: to.to_untyped() };
        let Some(kept) = segment.clipped(&area) else { continue };
        let [from, to] = [kept.from, kept.to].map(MmPoint::from_untyped);
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    // of a ring the last part goes on in the first
    if closed && parts.len() > 1 && parts.last().and_then(|last| last.last()) == parts[0].first() {
        let first = parts.swap_remove(0);
        parts[0].extend(first.into_iter().skip(1));
    }
    parts.retain(|part| part.iter().any(|at| *at != part[0]));
    parts
}

#[cfg(test)]
mod tests;
