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

#[test]
fn the_spaces_of_a_frame_on_a_grid_are_even_to_one_dot_from_corner_to_corner() {
    for (length, step) in (6..150).flat_map(|length| (2..7).map(move |step| (length, step))) {
        let mut places: Vec<i32> = along(3, 3 + length, step).collect();
        places.sort_unstable();
        places.dedup();
        assert_eq!((places.first(), places.last()), (Some(&3), Some(&(3 + length))));
        let spaces: Vec<i32> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let (least, most) = (spaces.iter().min().copied(), spaces.iter().max().copied());
        let (least, most) = (least.expect("a space"), most.expect("a space"));
        assert!(least >= 2 && most - least <= 1, "{length} dots, every {step}: {spaces:?}");
        let backwards: Vec<i32> = spaces.iter().rev().copied().collect();
        assert_eq!(spaces, backwards, "{length} dots, every {step}");
        // on a side of some length they are as far apart as asked, to one dot
        let is_as_asked = length < 6 * step || (step - 1..=step + 1).contains(&least);
        assert!(is_as_asked, "{length} dots, every {step}: {spaces:?}");
    }
    // a side of an Index page that had two dots side by side in its middle
    let mut places: Vec<i32> = along(0, 73, 2).collect();
    places.sort_unstable();
    places.dedup();
    assert_eq!(places.windows(2).filter(|pair| pair[1] - pair[0] == 3).count(), 3, "{places:?}");
}
