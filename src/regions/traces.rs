//! Traced contours on the grid of cells: where the nearest one runs, how strong, in which direction.

use super::grid::{REACH, RegionGrid};
use super::trace::TracedContour;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector};

/// The strongest point of a trace within a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TraceSample {
    /// Where it is, in cells.
    pub(super) at: PxPoint,
    pub(super) strength: f32,
    /// Unit vector along the trace.
    pub(super) along: PxVector,
}

/// What is seen of a trace from a place beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seen {
    /// Where the trace is, in cells.
    pub(super) at: PxPoint,
    /// How strong it is for that place: less if it is farther away, or runs in another direction.
    pub(super) strength: f32,
}

/// What passes each cell.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TraceMap {
    grid: RegionGrid,
    samples: Vec<Option<TraceSample>>,
    /// Which cells have a sample, 64 to a number, each row from a number of its own: most have none.
    is_there: Vec<u64>,
}

/// The direction of a trace is taken over this many of its points to both sides.
const SPAN: isize = 2;
/// Twice the square of the distance, in cells, over which a trace counts less and less for a place.
const FALL: f32 = 4.5;

impl TraceMap {
    /// The traces, whose points are about a pixel apart and in pixels of the picture.
    pub(super) fn of(traces: &[TracedContour], grid: RegionGrid) -> Self {
        let mut samples: Vec<Option<TraceSample>> = vec![None; grid.cells.len()];
        for trace in traces {
            for (i, point) in trace.vertices.iter().enumerate() {
                let at = |steps: isize| grid.to_cells(trace.vertices[trace.view().next(i, steps).unwrap_or(i)].at);
                let Some(along) = (at(SPAN) - at(-SPAN)).try_normalize() else { continue };
                let at = grid.to_cells(point.at);
                let Some(cell) = grid.cell_at(at) else { continue };
                if samples[cell].is_none_or(|other| point.strength > other.strength) {
                    samples[cell] = Some(TraceSample { at, strength: point.strength, along });
                }
            }
        }
        let width = grid.cells.width as usize;
        let bits = |cells: &[Option<TraceSample>]| {
            cells.iter().enumerate().fold(0, |bits, (i, sample)| bits | u64::from(sample.is_some()) << i)
        };
        let is_there = samples.chunks_exact(width).flat_map(|row| row.chunks(64).map(bits)).collect();
        Self { grid, samples, is_there }
    }

    /// Strengths spread over the cells nearest to each trace, so that what lies between two cells counts for both.
    pub(super) fn strengths(&self) -> Plane {
        let mut plane = Plane::filled(self.grid.cells, 0.0);
        for TraceSample { at, strength, .. } in self.samples.iter().flatten() {
            let centres = |at: f32| [-1.0, 0.0, 1.0].map(|step| at.floor() + step + 0.5);
            let share = |centre: f32, at: f32| (1.0 - (centre - at).abs()).max(0.0);
            for y in centres(at.y) {
                let down = share(y, at.y);
                for x in centres(at.x) {
                    let share = share(x, at.x) * down;
                    // most of the nine cells are too far away
                    if let Some(cell) = (share > 0.0).then(|| self.grid.cell_at(PxPoint::new(x, y))).flatten() {
                        plane.values[cell] = plane.values[cell].max(strength * share);
                    }
                }
            }
        }
        plane
    }

    /// How strong the trace is that runs along `tangent` at a place; 0 without one.
    pub(super) fn strength(&self, at: PxPoint, tangent: PxVector) -> f32 {
        let mut best = 0.0_f32;
        self.around(at, |sample, square| {
            // near or not it is no stronger than this: most need no exponential
            let along = sample.along.dot(tangent).abs();
            if sample.strength * along > best {
                best = (sample.strength * (-square / FALL).exp() * along).max(best);
            }
        });
        best
    }

    /// All that is seen near a place of traces that run along `tangent`; without any, the place with no strength.
    pub(super) fn all_seen(&self, at: PxPoint, tangent: PxVector) -> Vec<Seen> {
        let mut all = Vec::new();
        self.around(at, |sample, square| {
            let strength = sample.strength * (-square / FALL).exp() * sample.along.dot(tangent).abs();
            if strength > 0.0 {
                all.push(Seen { at: sample.at, strength });
            }
        });
        if all.is_empty() {
            all.push(Seen { at, strength: 0.0 });
        }
        all
    }

    /// Calls `visit` with all that passes within [`REACH`] of a place and the square of its distance.
    pub(super) fn around(&self, at: PxPoint, mut visit: impl FnMut(&TraceSample, f32)) {
        let width = self.grid.cells.width as usize;
        let [columns, rows] = self.grid.around(at, REACH);
        let words = width.div_ceil(64);
        if columns.is_empty() {
            return;
        }
        for y in rows {
            let row = &self.is_there[y * words..][..words];
            let first = columns.start / 64;
            let bits = row[first] >> (columns.start % 64);
            // the next 64 columns from the first on
            let bits = match row.get(first + 1) {
                Some(next) if columns.start % 64 > 0 => bits | next << (64 - columns.start % 64),
                _ => bits,
            };
            let mut bits = bits & ((1 << columns.len()) - 1);
            while bits != 0 {
                let cell = y * width + columns.start + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let Some(sample) = &self.samples[cell] else { continue };
                let square = (sample.at - at).square_length();
                if square <= REACH * REACH {
                    visit(sample, square);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
