//! Ends of open polylines that continue one another are linked, and the polylines concatenated.

use lyon::geom::euclid::{Point2D, Vector2D};

use super::polyline::{Blend, Polyline};

/// An end of an open polyline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End<U> {
    /// Number of its polyline.
    pub polyline: usize,
    /// Whether it is where the polyline begins.
    pub at_start: bool,
    /// Its position.
    pub at: Point2D<f32, U>,
    /// Unit direction out of the polyline; zero where it has none.
    pub direction: Vector2D<f32, U>,
    /// What lies on the right minus what lies on the left, as seen when leaving the polyline through this end.
    pub contrast: [f32; 3],
}

/// A polyline in a thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// Number of the polyline.
    pub polyline: usize,
    /// Whether it is gone along backwards.
    pub reversed: bool,
}

/// Polylines that follow one another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinkedChain {
    /// The polylines in order.
    pub parts: Vec<Part>,
    /// Whether the end of the last is linked to the start of the first.
    pub closed: bool,
}

impl LinkedChain {
    /// Its polylines as one; each is taken from `left`, and `append` adds the vertices of one to those before it. A
    /// ring that was one before stays as it is. None if nothing is left of it.
    pub fn concatenate<V: Blend>(
        &self,
        left: &mut [Option<Polyline<V>>],
        append: impl Fn(&mut Vec<V>, Vec<V>),
    ) -> Option<Polyline<V>> {
        let mut parts = self.parts.iter().filter_map(|part| {
            let polyline = left[part.polyline].take()?;
            Some(if part.reversed { polyline.reversed() } else { polyline })
        });
        let mut whole = parts.next()?;
        if whole.closed {
            return Some(whole);
        }
        parts.for_each(|polyline| append(&mut whole.vertices, polyline.vertices));
        whole.closed = self.closed && whole.vertices.len() > 3;
        Some(whole)
    }
}

/// Strings `count` polylines together by their `ends`, of which each polyline has both, its start first, or none; what
/// has none is a thread by itself. Threads with free ends come first, then the closed ones, each in the order of the
/// polylines.
///
/// Every two ends whose x coordinates differ by at most `reach` are a candidate, at the `cost` that the caller gives if
/// they may be linked. The cheapest link is made first, and an end has one link only. Of links that cost the same, the
/// one between earlier ends is made first, so that the result depends on nothing but the ends.
pub fn link<U>(
    count: usize,
    ends: &[End<U>],
    reach: f32,
    cost: impl Fn(&End<U>, &End<U>) -> Option<f32>,
) -> Vec<LinkedChain> {
    thread(count, ends, &partners(ends, reach, cost))
}

/// For each end the one that it is linked to.
fn partners<U>(ends: &[End<U>], reach: f32, cost: impl Fn(&End<U>, &End<U>) -> Option<f32>) -> Vec<Option<usize>> {
    let mut by_x: Vec<usize> = (0..ends.len()).collect();
    by_x.sort_by(|&a, &b| ends[a].at.x.total_cmp(&ends[b].at.x).then(a.cmp(&b)));
    let mut links = Vec::new();
    for (k, &i) in by_x.iter().enumerate() {
        for &j in by_x[k + 1..].iter().take_while(|&&j| ends[j].at.x - ends[i].at.x <= reach) {
            let (i, j) = (i.min(j), i.max(j));
            links.extend(cost(&ends[i], &ends[j]).map(|cost| (cost, i, j)));
        }
    }
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut partner = vec![None; ends.len()];
    for (_, i, j) in links {
        if partner[i].is_none() && partner[j].is_none() {
            (partner[i], partner[j]) = (Some(j), Some(i));
        }
    }
    partner
}

/// Follows the links from polyline to polyline.
fn thread<U>(count: usize, ends: &[End<U>], partner: &[Option<usize>]) -> Vec<LinkedChain> {
    // for each polyline the numbers of its two ends
    let mut ends_of: Vec<Option<[usize; 2]>> = vec![None; count];
    for (number, pair) in ends.chunks_exact(2).enumerate() {
        ends_of[pair[0].polyline] = Some([2 * number, 2 * number + 1]);
    }
    let mut taken = vec![false; count];
    let mut threads = Vec::with_capacity(count);
    for closed in [false, true] {
        for first in 0..count {
            let entry = match ends_of[first] {
                _ if taken[first] => continue,
                None => {
                    taken[first] = true;
                    threads.push(LinkedChain { parts: vec![Part { polyline: first, reversed: false }], closed: false });
                    continue;
                }
                Some(own) => own.into_iter().find(|&end| partner[end].is_none()).or(closed.then_some(own[0])),
            };
            let mut parts = Vec::new();
            let mut next = entry;
            while let Some(end) = next.map(|number| &ends[number])
                && !std::mem::replace(&mut taken[end.polyline], true)
            {
                parts.push(Part { polyline: end.polyline, reversed: !end.at_start });
                next = ends_of[end.polyline].and_then(|own| partner[own[usize::from(end.at_start)]]);
            }
            if !parts.is_empty() {
                threads.push(LinkedChain { parts, closed: next.is_some() });
            }
        }
    }
    threads
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MmPoint;
    use proptest::prelude::*;

    /// The ends of straight polylines from the first point of each pair to the second.
    fn ends(lines: &[(MmPoint, MmPoint)]) -> Vec<End<crate::units::Mm>> {
        let both = |(polyline, &(from, to)): (usize, &(MmPoint, MmPoint))| {
            let direction = (to - from).try_normalize().unwrap_or_default();
            let end = |at_start, at, direction| End { polyline, at_start, at, direction, contrast: [0.0; 3] };
            [end(true, from, -direction), end(false, to, direction)]
        };
        lines.iter().enumerate().flat_map(both).collect()
    }

    fn by_distance(lines: &[(MmPoint, MmPoint)], reach: f32) -> Vec<LinkedChain> {
        link(lines.len(), &ends(lines), reach, |a, b| {
            let distance = (b.at - a.at).length();
            (distance <= reach && a.polyline != b.polyline).then_some(distance)
        })
    }

    fn at(x: f32, y: f32) -> MmPoint {
        MmPoint::new(x, y)
    }

    fn parts(thread: &LinkedChain) -> Vec<(usize, bool)> {
        thread.parts.iter().map(|part| (part.polyline, part.reversed)).collect()
    }

    #[test]
    fn ends_in_reach_make_one_thread_whichever_way_the_pieces_run() {
        let threads =
            by_distance(&[(at(0., 0.), at(4., 0.)), (at(9., 0.), at(5., 0.)), (at(20., 0.), at(30., 0.))], 1.5);
        assert_eq!(threads.len(), 2);
        assert_eq!((parts(&threads[0]), threads[0].closed), (vec![(0, false), (1, true)], false));
        assert_eq!(parts(&threads[1]), [(2, false)]);
    }

    #[test]
    fn the_cheapest_link_is_made_and_an_end_has_one() {
        // the end at x = 4 could go on to either of two
        let threads =
            by_distance(&[(at(0., 0.), at(4., 0.)), (at(5., 0.5), at(9., 0.5)), (at(4.5, 0.), at(9., 0.))], 2.0);
        assert_eq!(parts(&threads[0]), [(0, false), (2, false), (1, true)]);
    }

    #[test]
    fn of_equal_links_that_of_the_earlier_ends_is_made() {
        let threads =
            by_distance(&[(at(0., 0.), at(4., 0.)), (at(5., 1.), at(9., 9.)), (at(5., -1.), at(9., -9.))], 2.0);
        assert_eq!(parts(&threads[0]), [(0, false), (1, false)]);
    }

    #[test]
    fn pieces_of_a_ring_close_and_come_last() {
        let square = [
            (at(0., 0.), at(4., 0.)),
            (at(4.5, 4.5), at(4.5, 0.5)),
            (at(4., 5.), at(0., 5.)),
            (at(-0.5, 4.5), at(-0.5, 0.5)),
        ];
        let mut lines = square.to_vec();
        lines.push((at(20., 0.), at(30., 0.)));
        let threads = by_distance(&lines, 1.0);
        assert_eq!(parts(&threads[0]), [(4, false)]);
        assert!(threads[1].closed);
        assert_eq!(parts(&threads[1]), [(0, false), (1, true), (2, false), (3, false)]);
    }

    #[test]
    fn the_two_ends_of_one_polyline_may_be_linked() {
        let threads = link(1, &ends(&[(at(0., 0.), at(1., 0.))]), 2.0, |_, _| Some(1.0));
        assert_eq!(threads, [LinkedChain { parts: vec![Part { polyline: 0, reversed: false }], closed: true }]);
    }

    #[test]
    fn linked_polylines_become_one_in_the_direction_of_the_first() {
        let lines = [(at(0., 0.), at(4., 0.)), (at(9., 0.), at(5., 0.)), (at(9., 1.), at(0., 1.))];
        let mut left: Vec<_> = lines.iter().map(|&(from, to)| Some(Polyline::open(vec![from, to]))).collect();
        let threads = by_distance(&lines, 1.5);
        assert_eq!(threads.len(), 1);
        let ring = threads[0].concatenate(&mut left, |before, next| before.extend(next)).expect("it is left");
        let expected = [at(0., 0.), at(4., 0.), at(5., 0.), at(9., 0.), at(9., 1.), at(0., 1.)];
        assert_eq!((ring.vertices, ring.closed), (expected.to_vec(), true));
        assert!(threads[0].concatenate(&mut left, |before, next| before.extend(next)).is_none(), "it was taken");
    }

    #[test]
    fn what_has_no_ends_is_a_thread_by_itself() {
        let threads = link::<crate::units::Mm>(2, &[], 1.0, |_, _| None);
        assert_eq!(threads.iter().map(parts).collect::<Vec<_>>(), [[(0, false)], [(1, false)]]);
    }

    proptest! {
        #[test]
        fn every_polyline_is_in_one_thread_and_its_links_are_in_reach(
            raw in prop::collection::vec((0.0_f32..20.0, 0.0_f32..20.0, 0.0_f32..20.0, 0.0_f32..20.0), 0..30),
            reach in 0.0_f32..8.0,
        ) {
            let lines: Vec<_> = raw.iter().map(|&(a, b, c, d)| (at(a, b), at(c, d))).collect();
            let threads = by_distance(&lines, reach);
            let parts = threads.iter().flat_map(|thread| &thread.parts);
            let mut seen: Vec<usize> = parts.map(|part| part.polyline).collect();
            seen.sort_unstable();
            prop_assert_eq!(seen, (0..lines.len()).collect::<Vec<_>>());
            let tip = |part: &Part, end: bool| {
                let (from, to) = lines[part.polyline];
                if part.reversed == end { from } else { to }
            };
            for thread in &threads {
                for pair in thread.parts.windows(2) {
                    prop_assert!((tip(&pair[0], true) - tip(&pair[1], false)).length() <= reach);
                }
            }
        }
    }
}
