//! Where things lie on a device's grid of dots: as on paper, moved on to the grid.
//!
//! From left to right the picture is centred on the grid, so that a flipped one takes the same dots, flipped; from top to bottom
//! it begins in the middle between two rows. The frame is a ring of dots, every so many, with as many empty dots inside it as
//! make up its gap.

use super::layout::{FrameParams, Layout, MarkParams, Params, PressParams, Sheet};
use super::{Dots, Run};
use crate::devices::{Grid, Room};
use crate::units::{MmPoint, MmRect, MmVector};

/// Less than anything that is pressed, mm.
const HAIR: f32 = 1e-3;

/// A picture whose width is `aspect` times its height, as large as the device allows on a sheet that lies this way, but not
/// wider than `widest`. None where the device does not take the sheet.
pub(super) fn fit(aspect: f32, widest: f32, size: [f32; 2], params: &Params, press: &PressParams) -> Option<Layout> {
    let room = press.device.room(size, press.pitch).ok()?;
    // A dot of a grid stands for what is half a pitch around it; elsewhere bounds are those of the centres of dots.
    let half = if matches!(room, Room::Grid(_)) { 0.5 * press.pitch } else { 0.0 };
    let usable = room.bounds().inflate(half, half);
    let overview = params.overview;
    let params = Params {
        // The grid ends where the device does; on it the margin is as on any sheet.
        frame: params.frame.map(|frame| ring_params(frame, press)),
        mark: params.mark.map(|mark| MarkParams { width: press.pitch, ..mark }),
        overview: None,
        ..*params
    };
    let sheet = Sheet::new([usable.width(), usable.height()], &params);
    let place = |widest: f32| {
        let laid_out = sheet.lay_out(aspect, sheet.figure_width(aspect).min(widest));
        let figure = laid_out.figure.translate(usable.min.to_vector());
        (on_grid(figure, &room, press), laid_out.mark)
    };
    let (figure, mark) = place(widest);
    let overview = overview.map(|overview| place(overview.scale * figure.width()).0);
    let mark = mark.map(|mark| {
        let moved = mark.points.iter().map(|&at| at + usable.min.to_vector()).collect();
        Run::stroke(mark.width, marked(moved, &room))
    });
    Some(Layout { sheet: size, figure, overview, mark, room: Some(room) })
}

/// A band of one dot, and half a pitch for the grid, whose rows and columns are where they are.
fn ring_params(frame: FrameParams, press: &PressParams) -> FrameParams {
    let gap = empty(frame, press) as f32 * press.pitch;
    FrameParams { width: 1.5 * press.pitch, dot: press.diameter, pitch: frame.pitch, gap }
}

/// Empty dots between the frame and the picture.
fn empty(frame: FrameParams, press: &PressParams) -> i32 {
    (frame.gap / press.pitch).round().max(1.0) as i32
}

/// The same rectangle in the middle of the columns, its top in the middle between two rows.
fn on_grid(figure: MmRect, room: &Room, press: &PressParams) -> MmRect {
    let Room::Grid(grid) = room else { return figure };
    let corner = |mm: f32, centres: &[f32]| {
        let index = centres.partition_point(|&centre| centre < mm);
        // the nearer one of the middles around; before the first dot it is half a pitch away
        let middle = |index: usize| match (index.checked_sub(1).and_then(|i| centres.get(i)), centres.get(index)) {
            (Some(a), Some(b)) => 0.5 * (a + b),
            (None, Some(b)) => b - 0.5 * press.pitch,
            (Some(a), None) => a + 0.5 * press.pitch,
            (None, None) => mm,
        };
        let around = [index.saturating_sub(1), index, index + 1].map(middle);
        around.into_iter().min_by(|a, b| (a - mm).abs().total_cmp(&(b - mm).abs())).unwrap_or(mm)
    };
    // a hair narrower, so that no column lies on an edge
    let (middle, half) = (room.bounds().center().x, 0.5 * figure.width());
    let top = corner(figure.min.y, &grid.rows);
    let min = MmPoint::new(middle - half + HAIR, top);
    MmRect::new(min, min + MmVector::new(figure.width() - 2.0 * HAIR, figure.height()))
}

/// The ends of the orientation mark on dots that are as many columns as rows apart; the lower right one is the nearest, so that all
/// of it keeps the margin.
fn marked(points: Vec<MmPoint>, room: &Room) -> Vec<MmPoint> {
    let (Room::Grid(grid), [a, .., b]) = (room, &points[..]) else { return points };
    let (from, to) = (grid.nearest(*a), grid.nearest(*b));
    let (Some([left, top]), Some([right, _])) = (from, to) else { return points };
    let steps = (right - left).max(2);
    [grid.at(right.saturating_sub(steps), top), grid.at(right, top + steps)].into_iter().flatten().collect()
}

/// A frame of one row of dots, where they can be anywhere.
pub(crate) fn row(frame: FrameParams, press: &PressParams) -> FrameParams {
    let pitch = frame.pitch.max(1.5 * press.pitch);
    FrameParams { width: press.diameter, dot: press.diameter, pitch, gap: frame.gap }
}

/// The frame around a picture on a grid: every so many dots of a ring, one in each corner.
pub(crate) fn ring(picture: MmRect, grid: &Grid, frame: FrameParams, press: &PressParams) -> Dots {
    let out = empty(frame, press) + 1;
    let step = (frame.pitch / press.pitch).round().max(2.0) as i32;
    let range = |from: f32, to: f32, centres: &[f32]| {
        let first = centres.partition_point(|&centre| centre < from) as i32;
        let last = centres.partition_point(|&centre| centre <= to) as i32 - 1;
        [(first - out).max(0), (last + out).min(centres.len() as i32 - 1)]
    };
    let [left, right] = range(picture.min.x, picture.max.x, &grid.columns);
    let [top, bottom] = range(picture.min.y, picture.max.y, &grid.rows);
    // from both corners to the middle, so that a flipped picture has the flipped frame
    let steps = |low: i32, high: i32| {
        let half = (low..=(low + high) / 2).step_by(step as usize);
        half.flat_map(move |at| [at, low + high - at])
    };
    let mut cells: Vec<(i32, i32)> = steps(left, right).flat_map(|x| [(x, top), (x, bottom)]).collect();
    cells.extend(steps(top, bottom).flat_map(|y| [(left, y), (right, y)]));
    cells.sort_unstable_by_key(|&(x, y)| (y, x));
    cells.dedup();
    let at = cells.into_iter().filter_map(|(x, y)| grid.at(usize::try_from(x).ok()?, usize::try_from(y).ok()?));
    Dots { diameter: press.diameter, at: at.collect() }
}
