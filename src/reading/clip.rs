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
mod tests {
    use super::*;

    fn parts(points: &[(f32, f32)], closed: bool) -> Vec<Vec<(f32, f32)>> {
        let points: Vec<MmPoint> = points.iter().map(|&at| at.into()).collect();
        let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 50.0));
        inside(&points, closed, area).iter().map(|part| part.iter().map(|at| (at.x, at.y)).collect()).collect()
    }

    #[test]
    fn a_line_is_cut_where_it_leaves_the_sheet_and_goes_on_where_it_comes_back() {
        let whole = [(10.0, 10.0), (90.0, 40.0)];
        assert_eq!(parts(&whole, false), [whole.to_vec()]);
        let twice = [(-10.0, 20.0), (50.0, 20.0), (50.0, 60.0), (70.0, 60.0), (70.0, 10.0)];
        let left = [vec![(0.0, 20.0), (50.0, 20.0), (50.0, 50.0)], vec![(70.0, 50.0), (70.0, 10.0)]];
        assert_eq!(parts(&twice, false), left);
        assert!(parts(&[(-10.0, -10.0), (110.0, -10.0)], false).is_empty());
    }

    #[test]
    fn a_ring_that_leaves_the_sheet_is_one_line() {
        let ring = [(20.0, 20.0), (20.0, 60.0), (80.0, 60.0), (80.0, 20.0)];
        assert_eq!(parts(&ring, true), [[(80.0, 50.0), (80.0, 20.0), (20.0, 20.0), (20.0, 50.0)].to_vec()]);
    }
}
