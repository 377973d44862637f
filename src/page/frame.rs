//! The frame: rows of fine dots around a picture, neutral as the texture of grey and much finer. Of dots that a
//! device raises it is a single row: on a grid a ring of dots, every so many, with as many empty dots inside it as
//! make up its gap.

use super::medium::DotMedium;
use super::parts::Dots;
use super::sheet::FrameParams;
use crate::devices::{DotArea, Grid};
use crate::units::{MmPoint, MmRect, MmVector};

/// A frame of several rows, for print: rows as in a hexagonal lattice, as many as the band has room for, the
/// innermost at its inner edge.
pub fn printed(picture: MmRect, params: &FrameParams) -> Dots {
    let row_pitch = params.pitch * 0.75_f32.sqrt();
    let rows = ((params.width - params.dot) / row_pitch).floor().max(0.0) as u32 + 1;
    let mut dots = Dots { diameter: params.dot, at: Vec::new() };
    for row in 0..rows {
        let out = params.gap + 0.5 * params.dot + row as f32 * row_pitch;
        even(picture.inflate(out, out), params.pitch, row % 2 == 1, &mut dots.at);
    }
    dots
}

/// Dots evenly on the four sides: whole steps with a dot in each corner, or half a step further for every other row.
fn even(rect: MmRect, pitch: f32, between: bool, dots: &mut Vec<MmPoint>) {
    let (right, down) = (MmVector::new(rect.width(), 0.0), MmVector::new(0.0, rect.height()));
    let corners = [rect.min, rect.min + right, rect.max, rect.min + down];
    for (i, &from) in corners.iter().enumerate() {
        let side = corners[(i + 1) % 4] - from;
        let steps = (side.length() / pitch).round().max(1.0);
        let shift = if between { 0.5 } else { 0.0 };
        dots.extend((0..steps as u32).map(|k| from + side * ((k as f32 + shift) / steps)));
    }
}

/// A frame of one row, of dots that a device raises.
pub fn dotted(picture: MmRect, params: &FrameParams, medium: &DotMedium) -> Dots {
    match &medium.area {
        DotArea::Grid(grid) => ring(picture, grid, params, medium),
        DotArea::Free(_) => {
            let (width, pitch) = (medium.diameter(), params.pitch.max(1.5 * medium.pitch));
            printed(picture, &FrameParams { width, dot: width, pitch, gap: params.gap })
        }
    }
}

/// Empty dots between the frame and the picture.
pub(super) fn empty(params: &FrameParams, medium: &DotMedium) -> i32 {
    (params.gap / medium.pitch).round().max(1.0) as i32
}

/// The frame around a picture on a grid: every so many dots of a ring, one in each corner.
fn ring(picture: MmRect, grid: &Grid, params: &FrameParams, medium: &DotMedium) -> Dots {
    let out = empty(params, medium) + 1;
    let step = (params.pitch / medium.pitch).round().max(2.0) as i32;
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
    Dots { diameter: medium.diameter(), at: at.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::devices::Device;

    #[test]
    fn on_a_grid_a_frame_has_a_dot_in_each_corner_and_as_many_empty_ones_as_asked() {
        let device = Device::named("index-basic-d-v5").expect("in the table");
        let medium = DotMedium::on(device, 2.5, [210.0, 297.0]).expect("its own sheet");
        let DotArea::Grid(grid) = &medium.area else { panic!("it has a grid") };
        let (columns, rows) = (&grid.columns, &grid.rows);
        let picture = MmRect::new(MmPoint::new(columns[20], rows[20]), MmPoint::new(columns[49], rows[61]));
        // two empty dots, and then every third
        let params = FrameParams { width: 3.0, dot: 0.8, pitch: 7.5, gap: 5.0 };
        let dots = dotted(picture, &params, &medium);
        let bounds = dots.bounds().expect("dots").inflate(-0.5 * dots.diameter, -0.5 * dots.diameter);
        let expected = MmRect::new(MmPoint::new(columns[17], rows[17]), MmPoint::new(columns[52], rows[64]));
        assert!((bounds.min - expected.min).length() < 1e-3 && (bounds.max - expected.max).length() < 1e-3);
        let top: Vec<f32> = dots.at.iter().filter(|at| (at.y - rows[17]).abs() < 1e-3).map(|at| at.x).collect();
        assert_eq!(top[..3], [columns[17], columns[20], columns[23]]);
        assert_eq!(top.last(), Some(&columns[52]));
    }

    #[test]
    fn no_two_dots_touch_and_all_keep_their_distance_from_the_picture() {
        let picture = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(137.3, 98.1));
        let params = FrameParams { width: 3.0, dot: 0.8, pitch: 1.6, gap: 5.0 };
        let dots = printed(picture, &params);
        assert!(dots.at.len() > 400);
        for (i, p) in dots.at.iter().enumerate() {
            let outside =
                (picture.min.x - p.x).max(p.x - picture.max.x).max(picture.min.y - p.y).max(p.y - picture.max.y);
            assert!(outside >= params.gap + 0.39 && outside <= params.gap + params.width - 0.39, "{p:?}");
            assert!(dots.at[..i].iter().all(|q| (*q - *p).length() > params.dot + 0.3), "a dot touches {p:?}");
        }
    }
}
