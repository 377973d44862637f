//! Where a device can put dots on a sheet, and what is wrong with sheets and pitches it has no room for.

use super::device::{CELL, CELL_DOT, DOT_20_DPI, Device, DotArea, Family, Grid, LINE, PIN, SAME, same};
use crate::Error;
use crate::units::{MmPoint, MmRect};

impl Device {
    /// Where dots can be on a sheet of this width and length, mm, with this pitch, mm.
    ///
    /// # Errors
    /// [`Error::CannotPress`] with every fault of the sheet and the pitch, each with what the device can do instead.
    pub fn dot_area(&self, sheet: [f32; 2], pitch: f32) -> Result<DotArea, Error> {
        self.dots_on(sheet, pitch).map_err(Error::CannotPress)
    }

    /// As [`Device::dot_area`], with the faults one by one: those of the sheet first.
    pub(crate) fn dots_on(&self, sheet: [f32; 2], pitch: f32) -> Result<DotArea, Vec<String>> {
        of(self, sheet, pitch)
    }

    /// What is said of a pitch, mm, that it does not have.
    pub(crate) fn pitch_fault(&self, pitch: f32) -> String {
        format!("{} has no dots {pitch} mm apart; it has {}", self.name, self.pitches())
    }
}

/// Blank edge of a sheet of cells, mm, with a dot's radius: embossers differ by some millimetres. Chosen by us; A4
/// then has 31 cells in 28 lines, where embossers are set to 30 to 33 in 27 to 29.
const CELLS_EDGE: f32 = 10.0;
/// The American page, mm, and its cells: 11 1/2 x 11 inches of tractor paper have 40 cells in 25 lines, with room for
/// holes and binding.
const AMERICAN: ([f32; 2], [usize; 2]) = ([292.1, 279.4], [40, 25]);

/// What the rollers of a BrailleRAP hold of a sheet's length, mm: DesktopBrailleRAP leaves as much of A4 and of A3.
const HELD: f32 = 47.0;
/// Shortest sheet of a BrailleRAP, mm: half a card more than what the rollers hold. Chosen by us.
const SHORTEST_HELD: f32 = 74.0;

/// Shortest side of a sheet that Index embossers take, mm: an inch, says their driver. The others are held to it too,
/// since nothing can be told on less.
pub(crate) const SHORTEST_SIDE: f32 = 25.4;

/// What the driver of a V4 leaves on every side, hundredths of a millimetre.
pub(crate) const INDEX_MARGIN_V4: i64 = 501;

/// Index drivers count in hundredths of a millimetre, whole numbers rounded down.
mod index {
    /// What the driver leaves for the last dot.
    pub(super) const DOT: i64 = 160;
    /// Margins that the driver takes from the hardware: left, right, top, bottom. It knows them in points of 1/72
    /// inch and rounds up.
    pub(super) const MARGINS_V3: [i64; 4] = [0, 0, 201, 501];
    pub(super) const MARGINS_V4: [i64; 4] = [super::INDEX_MARGIN_V4; 4];
    /// Widest that the head of a Basic-D embosses, which the driver does not know (BrailleUtils). No page that the
    /// driver names is that wide.
    pub(super) const REACH: i64 = 30_100;
}

pub(super) fn of(device: &Device, sheet: [f32; 2], pitch: f32) -> Result<DotArea, Vec<String>> {
    let mut faults = faults_of_sheet(device, sheet);
    let pitch = match device.pitches().find(pitch) {
        Some(pitch) if faults.is_empty() => pitch,
        Some(_) => return Err(faults),
        None => {
            faults.push(device.pitch_fault(pitch));
            return Err(faults);
        }
    };
    Ok(match device.family {
        Family::IndexV3 { .. } => DotArea::Grid(of_index(sheet, pitch, index::MARGINS_V3)),
        Family::IndexV4 => DotArea::Grid(of_index(sheet, pitch, index::MARGINS_V4)),
        Family::BrailleRap { across } => DotArea::Free(within(sheet, [across, sheet[1] - HELD], device.diameter())),
        Family::ViewPlus => DotArea::Grid(Grid {
            columns: steps(0.5 * DOT_20_DPI, DOT_20_DPI, whole(sheet[0], DOT_20_DPI)),
            rows: steps(0.5 * DOT_20_DPI, DOT_20_DPI, whole(sheet[1], DOT_20_DPI)),
        }),
        Family::Pins { columns, rows } => DotArea::Grid(Grid {
            columns: steps(0.5 * PIN, PIN, usize::from(columns)),
            rows: steps(0.5 * PIN, PIN, usize::from(rows)),
        }),
        Family::Cells => DotArea::Grid(of_cells(sheet, device.diameter())),
    })
}

fn faults_of_sheet(device: &Device, sheet: [f32; 2]) -> Vec<String> {
    let Device { name, widest, longest, .. } = *device;
    let [width, length] = sheet;
    if let Some(field) = device.field() {
        let fits = same(width, field[0]) && same(length, field[1]);
        let fault = || {
            format!(
                "{name} shows {} x {} mm, {} x {} pins; the sheet is {width} x {length} mm",
                field[0],
                field[1],
                field[0] / PIN,
                field[1] / PIN
            )
        };
        return if fits { Vec::new() } else { vec![fault()] };
    }
    let shortest = if matches!(device.family, Family::BrailleRap { .. }) { SHORTEST_HELD } else { SHORTEST_SIDE };
    let fits = |[width, length]: [f32; 2]| {
        // NaN fails every comparison, so it fits nowhere.
        width >= SHORTEST_SIDE && length >= shortest && width <= widest + SAME && length <= longest + SAME
    };
    let turned = if fits([length, width]) {
        format!("; turned, as {length} x {width} mm, the sheet fits")
    } else {
        String::new()
    };
    let fault = |what: &str, side: f32, least: f32, most: f32| {
        if side >= least && side <= most + SAME {
            return None;
        }
        let can = format!("{name} takes sheets {least} to {most} mm {what}");
        Some(format!("the sheet is {side} mm {what}; {can}{turned}"))
    };
    [fault("wide", width, SHORTEST_SIDE, widest), fault("long", length, shortest, longest)]
        .into_iter()
        .flatten()
        .collect()
}

/// The grid of the driver: as many columns and rows as it counts. It says nothing of where on the paper they are;
/// they are taken to lie in the middle between the margins that it states, which is derived and may be off by a column.
fn of_index(sheet: [f32; 2], pitch: f32, [left, right, top, bottom]: [i64; 4]) -> Grid {
    let [width, length] = sheet.map(hundredths);
    let step = hundredths(pitch);
    // A cell of eight dots is two columns of four rows, and the driver sends whole cells.
    let wide = ((width - left - right - index::DOT) / step).min(index::REACH / step + 1) / 2 * 2;
    let high = (length - top - bottom - index::DOT) / step / 4 * 4;
    let along = |side: i64, before: i64, after: i64, count: i64| {
        let free = side - before - after - (count - 1) * step;
        (0..count).map(|i| (before + i * step) as f32 / 100.0 + free as f32 / 200.0).collect()
    };
    Grid { columns: along(width, left, right, wide), rows: along(length, top, bottom, high) }
}

/// As Index drivers count.
pub(crate) fn hundredths(mm: f32) -> i64 {
    (f64::from(mm) * 100.0).round() as i64
}

/// What the stylus reaches, in the middle of the sheet; a dot must lie on the paper. Where its zero is on the paper
/// is nowhere said, so the middle is derived: the figure on paper may lie some millimetres aside.
fn within(sheet: [f32; 2], reach: [f32; 2], diameter: f32) -> MmRect {
    let size: [f32; 2] = std::array::from_fn(|i| reach[i].min(sheet[i] - diameter));
    let corner: [f32; 2] = std::array::from_fn(|i| 0.5 * (sheet[i] - size[i]));
    MmRect::new(corner.into(), MmPoint::from(corner) + MmPoint::from(size).to_vector())
}

/// As many cells of two columns and three rows as the sheet has room for, in its middle.
fn of_cells(sheet: [f32; 2], diameter: f32) -> Grid {
    let spans = [CELL_DOT + diameter, 2.0 * CELL_DOT + diameter];
    let steps = [CELL, LINE];
    let (american, cells) = AMERICAN;
    let counts: [usize; 2] = if same(sheet[0], american[0]) && same(sheet[1], american[1]) {
        cells
    } else {
        std::array::from_fn(|i| whole(sheet[i] - 2.0 * CELLS_EDGE - spans[i] + steps[i], steps[i]).max(1))
    };
    let along = |i: usize, dots: usize| {
        let span = (counts[i] - 1) as f32 * steps[i] + spans[i] - diameter;
        let first = 0.5 * (sheet[i] - span);
        let of_cell = |cell| (0..dots).map(move |dot| first + cell as f32 * steps[i] + dot as f32 * CELL_DOT);
        (0..counts[i]).flat_map(of_cell).collect()
    };
    Grid { columns: along(0, 2), rows: along(1, 3) }
}

/// How many whole steps fit; a hundredth of a step short is no step less.
fn whole(length: f32, step: f32) -> usize {
    (length / step + 0.01).max(0.0) as usize
}

fn steps(first: f32, step: f32, count: usize) -> Vec<f32> {
    (0..count).map(|i| first + i as f32 * step).collect()
}
