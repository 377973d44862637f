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
    /// Of the cells that have one, row by row: most have none.
    samples: Vec<TraceSample>,
    /// How many of these are of the cells before each, and at last of all.
    before: Vec<u32>,
}

/// The direction of a trace is taken over this many of its points to both sides.
const SPAN: isize = 2;
/// Twice the square of the distance, in cells, over which a trace counts less and less for a place.
const FALL: f32 = 4.5;
/// More than what numbers of 32 bits lose in a few steps, as a factor.
const ROUNDING: f32 = 1.0001;

impl TraceMap {
    /// The traces, whose points are about a pixel apart and in pixels of the picture.
    pub(super) fn of(traces: &[TracedContour], grid: RegionGrid) -> Self {
        let mut found: Vec<TraceSample> = Vec::new();
        // by cell, and behind the last: one more than the place of its sample among those found; 0 without one
        let mut places = vec![0_u32; grid.cells.len() + 1];
        for trace in traces {
            for (i, point) in trace.vertices.iter().enumerate() {
                let at = |steps: isize| grid.to_cells(trace.vertices[trace.view().next(i, steps).unwrap_or(i)].at);
                let Some(along) = (at(SPAN) - at(-SPAN)).try_normalize() else { continue };
                let at = grid.to_cells(point.at);
                let Some(cell) = grid.cell_at(at) else { continue };
                let sample = TraceSample { at, strength: point.strength, along };
                match (places[cell] as usize).checked_sub(1).and_then(|place| found.get_mut(place)) {
                    Some(other) if point.strength > other.strength => *other = sample,
                    Some(_) => (),
                    None => {
                        found.push(sample);
                        places[cell] = found.len() as u32;
                    }
                }
            }
        }
        let mut samples = Vec::with_capacity(found.len());
        let mut before = places;
        for of_cell in &mut before {
            let place = std::mem::replace(of_cell, samples.len() as u32);
            if place > 0 {
                samples.push(found[place as usize - 1]);
            }
        }
        Self { grid, samples, before }
    }

    /// Strengths spread over the cells nearest to each trace, so that what lies between two cells counts for both.
    pub(super) fn strengths(&self) -> Plane {
        let mut plane = Plane::filled(self.grid.cells, 0.0);
        let (width, height) = (self.grid.cells.width as usize, self.grid.cells.height as usize);
        for TraceSample { at, strength, .. } in &self.samples {
            for (row, down) in shares(at.y, height) {
                for (column, across) in shares(at.x, width) {
                    let value = &mut plane.values[row * width + column];
                    *value = value.max(strength * (across * down));
                }
            }
        }
        plane
    }

    /// How strong the trace is that runs along `tangent` at a place; 0 without one.
    pub(super) fn strength(&self, at: PxPoint, tangent: PxVector) -> f32 {
        let mut best = 0.0_f32;
        self.around(at, |sample, square| {
            let along = sample.along.dot(tangent).abs();
            // the first terms of the exponential, and a little for rounding: most need no more of it
            let fall = square / FALL;
            let least_fall = 1.0 + fall * (1.0 + fall * (0.5 + fall / 6.0));
            if sample.strength * along * ROUNDING > best * least_fall {
                best = (sample.strength * (-fall).exp() * along).max(best);
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
        for y in rows {
            let (from, to) = (self.before[y * width + columns.start], self.before[y * width + columns.end]);
            for sample in &self.samples[from as usize..to as usize] {
                let square = (sample.at - at).square_length();
                if square <= REACH * REACH {
                    visit(sample, square);
                }
            }
        }
    }
}

/// The cells along an axis of `count` that a place is nearest to, with its share in each.
fn shares(at: f32, count: usize) -> impl Iterator<Item = (usize, f32)> {
    let own = at as usize;
    let share = move |cell: usize| (cell, 1.0 - (cell as f32 + 0.5 - at).abs());
    (own.saturating_sub(1)..(own + 2).min(count)).map(share).filter(|(_, share)| *share > 0.0)
}

#[cfg(test)]
mod tests;
