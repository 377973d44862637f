//! Lines that wait to be drawn, by rank and the most salient first, and those that are.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::geom::polyline::Polyline;
use crate::lines::outlines::Rank;
use crate::lines::params::Params;
use crate::lines::saliency::saliency;
use crate::lines::vertex::Vertex;
use crate::ranked::{Ranked, TotalOrder};

/// A piece that is still too near after this many rounds is given up. None of the samples needs more than three.
const MOST_ROUNDS: u8 = 8;

/// A line that waits.
#[derive(Debug)]
pub(super) struct QueuedLine {
    pub(super) polyline: Polyline<Vertex>,
    pub(super) rank: Rank,
    /// In how many rounds it was judged.
    pub(super) round: u8,
    /// Whether it is what is left of a line that was cut.
    pub(super) is_part: bool,
}

/// A line that is apart from all others, as it will be drawn.
pub(in crate::lines) struct Cleared {
    pub(in crate::lines) polyline: Polyline<Vertex>,
    pub(in crate::lines) saliency: f32,
    pub(in crate::lines) rank: Rank,
    /// For each vertex whether another line ends there.
    pub(in crate::lines) anchored: Vec<bool>,
}

/// By rank, then by saliency; of two that are equally salient, the one that came earlier goes first.
type DrawingOrder = (Rank, TotalOrder, Reverse<usize>);

/// Lines that wait for their turn.
pub(super) struct Queue<'a> {
    heap: BinaryHeap<Ranked<DrawingOrder, QueuedLine>>,
    count: usize,
    /// No shorter lines wait, mm.
    least: f32,
    params: &'a Params,
}

impl<'a> Queue<'a> {
    pub(super) fn new(capacity: usize, least: f32, params: &'a Params) -> Self {
        Self { heap: BinaryHeap::with_capacity(capacity), count: 0, least, params }
    }

    /// Adds a line, unless it is too short or was judged too often.
    pub(super) fn push(&mut self, line: QueuedLine) {
        let saliency = saliency(&line.polyline, self.params);
        self.push_as(line, saliency);
    }

    /// [`Queue::push`] of a line that is as salient as this.
    pub(super) fn push_as(&mut self, line: QueuedLine, saliency: f32) {
        let QueuedLine { polyline, rank, round, .. } = &line;
        if polyline.vertices.len() < 2 || polyline.length() < self.least || *round > MOST_ROUNDS {
            return;
        }
        let rank = (*rank, TotalOrder(f64::from(saliency)), Reverse(self.count));
        self.heap.push(Ranked { rank, item: line });
        self.count += 1;
    }

    /// The next line.
    pub(super) fn pop(&mut self) -> Option<QueuedLine> {
        self.heap.pop().map(|next| next.item)
    }
}

#[cfg(test)]
mod tests;
