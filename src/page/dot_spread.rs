//! Where a picture lies on several sheets of a device of dots: windows of whole dots, and one grid for all of them.
//!
//! The space of all sheets is that of the first, with its grid going on to the right and down. Every window begins
//! whole dots after the one before (of text cells: whole cells), so a dot of the large grid is one of its sheet too.

use std::ops::Range;

use super::cells::CellGrid;
use super::dot_layout::{band, mark_on_grid, on_grid};
use super::heading::Heading;
use super::medium::{DotMedium, Medium};
use super::parts::Run;
use super::sheet::{self, MarkParams, Params, beside};
use super::spread_layout::{GAP, Spread, SpreadPicture, TICK, above};
use crate::braille::CellSize;
use crate::devices::{Device, DotArea, Grid};
use crate::units::{MmPoint, MmRect, MmVector};

/// Least dots of a tick: two are felt as a direction.
const LEAST_TICK: f32 = 2.0;

/// The spread of a picture over sheets of this size; none where they are too small, or the device does not take them.
pub(super) fn fit(
    sheet: [f32; 2],
    picture: SpreadPicture,
    params: &Params,
    (device, pitch): (&'static Device, f32),
) -> Option<Spread> {
    let medium = DotMedium::on(device, pitch, sheet).ok()?;
    let (usable, pitch, margin) = (medium.usable(), medium.pitch, params.margin);
    let origin = usable.min.to_vector();
    let params = Params { mark: params.mark.map(|mark| MarkParams { width: pitch, ..mark }), ..*params };
    let size = [usable.width(), usable.height()];
    let heading = params.heading.and_then(|heading| {
        let cells = CellGrid::of_dots(&medium, heading.cell);
        let heading = Heading::on(&heading, &cells, size, margin, beside(params.mark, &cells))?;
        Some(heading.after_label(&cells).translated(origin))
    });
    let label = CellGrid::of_dots(&medium, CellSize::MARBURG).extent(1, 1).y;
    let mark = params.mark.map(|mark| {
        let bar = sheet::bar(MmPoint::new(size[0] - margin, margin), mark);
        let moved = bar.points.iter().map(|&at| at + origin).collect();
        Run::stroke(mark.width, mark_on_grid(moved, &medium.area))
    });
    // in dots: empty ones before a tick, and its own
    let (gap, length) = ((GAP / pitch).ceil(), (TICK / pitch).round().max(LEAST_TICK));
    let beside_window = margin + (gap + length) * pitch;
    let inner = MmRect::new(
        usable.min + MmVector::new(beside_window, above(&params, label, heading.as_ref()) + beside_window),
        usable.max - MmVector::new(beside_window, beside_window),
    );
    let Windows { first, step, half, together } = windows(&medium, inner, picture)?;
    let border = params.frame.map_or(0.0, |frame| {
        let band = band(&frame, &medium);
        band.width + band.gap
    });
    let total = picture.total(first, step);
    let place = picture.within(total, border)?;
    let figure = on_grid(place, &DotMedium { area: within(&together.area, total), ..together.clone() });
    Some(Spread {
        grid: picture.grid,
        sheet,
        figure,
        mark,
        heading,
        medium: Medium::Dots(medium),
        together: Medium::Dots(together),
        first,
        corner: first.min,
        step,
        half,
        tick: [(gap + 0.5) * pitch, (gap + length - 0.5) * pitch],
        label: usable.min + MmVector::new(margin, margin),
    })
}

struct Windows {
    first: MmRect,
    step: MmVector,
    half: MmVector,
    together: DotMedium,
}

/// The windows in a part of the sheet.
fn windows(medium: &DotMedium, inner: MmRect, picture: SpreadPicture) -> Option<Windows> {
    let (DotMedium { area, pitch, .. }, overlap) = (medium, picture.overlap);
    let counts = [picture.grid.across, picture.grid.down];
    match area {
        DotArea::Free(reach) => {
            let [width, height] = [inner.width(), inner.height()];
            if width <= 2.0 * overlap || height <= 2.0 * overlap {
                return None;
            }
            let step = MmVector::new(width - overlap, height - overlap);
            let area = DotArea::Free(picture.total(*reach, step));
            let half = MmVector::new(0.5 * overlap, 0.5 * overlap);
            Some(Windows { first: inner, step, half, together: DotMedium { area, ..medium.clone() } })
        }
        DotArea::Grid(grid) => {
            let period = medium.device.cell_dots().unwrap_or([1, 1]);
            let along = |centres: &[f32], [from, to]: [f32; 2], period: usize, count: u32| {
                Along::new(centres, [from, to], 0.5 * pitch, (overlap, period), count)
            };
            let x = along(&grid.columns, [inner.min.x, inner.max.x], period[0], counts[0])?;
            let y = along(&grid.rows, [inner.min.y, inner.max.y], period[1], counts[1])?;
            let first = MmRect::new(MmPoint::new(x.window[0], y.window[0]), MmPoint::new(x.window[1], y.window[1]));
            let (step, half) = (MmVector::new(x.step, y.step), MmVector::new(x.half, y.half));
            let area = DotArea::Grid(Grid { columns: x.centres, rows: y.centres });
            Some(Windows { first, step, half, together: DotMedium { area, ..medium.clone() } })
        }
    }
}

/// The columns, or the rows, of all sheets.
struct Along {
    /// Both edges of the first window, half a pitch beyond its dots.
    window: [f32; 2],
    step: f32,
    /// From the edge of a window to the dot in the middle of an overlap.
    half: f32,
    centres: Vec<f32>,
}

impl Along {
    fn new(
        centres: &[f32],
        [from, to]: [f32; 2],
        half_pitch: f32,
        (overlap, period): (f32, usize),
        count: u32,
    ) -> Option<Self> {
        let range = whole(centres, [from + half_pitch, to - half_pitch], period);
        let length = range.len();
        let of_period = centres.get(range.start + period)? - centres.get(range.start)?;
        let shared = (overlap / of_period).ceil() as usize * period;
        // in windows of at most two overlaps, three neighbouring sheets would show the same part
        if length <= 2 * shared {
            return None;
        }
        let steps = length - shared;
        let step = centres[range.start + steps] - centres[range.start];
        let window = [centres[range.start] - half_pitch, centres[range.end - 1] + half_pitch];
        let half = centres[range.start + shared / 2] - window[0];
        let mut all = centres.to_vec();
        for at in centres.len()..centres.len() + (count as usize - 1) * steps {
            all.push(all[at - steps] + step);
        }
        Some(Self { window, step, half, centres: all })
    }
}

/// The dots between two places, in whole periods that begin where those of the sheet do.
fn whole(centres: &[f32], [from, to]: [f32; 2], period: usize) -> Range<usize> {
    let start = centres.partition_point(|&centre| centre < from).next_multiple_of(period);
    let end = centres.partition_point(|&centre| centre <= to).max(start);
    start..end - (end - start) % period
}

/// The dots in a rectangle.
fn within(area: &DotArea, place: MmRect) -> DotArea {
    let part = |centres: &[f32], from: f32, to: f32| -> Vec<f32> {
        centres.iter().copied().filter(|centre| (from..=to).contains(centre)).collect()
    };
    match area {
        DotArea::Free(_) => DotArea::Free(place),
        DotArea::Grid(grid) => DotArea::Grid(Grid {
            columns: part(&grid.columns, place.min.x, place.max.x),
            rows: part(&grid.rows, place.min.y, place.max.y),
        }),
    }
}

#[cfg(test)]
mod tests;
