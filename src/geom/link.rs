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
mod tests;
