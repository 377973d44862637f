//! Tests of `frame`.

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
        let outside = (picture.min.x - p.x).max(p.x - picture.max.x).max(picture.min.y - p.y).max(p.y - picture.max.y);
        assert!(outside >= params.gap + 0.39 && outside <= params.gap + params.width - 0.39, "{p:?}");
        assert!(dots.at[..i].iter().all(|q| (*q - *p).length() > params.dot + 0.3), "a dot touches {p:?}");
    }
}
