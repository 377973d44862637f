//! Tests of `planes`.

use super::*;

#[test]
fn what_is_done_to_one_plane_is_done_to_all() {
    let grey = Planes::Grey(2);
    let colour = Planes::Colour([1, 2, 3]);
    assert_eq!(grey.map(|v| v * 2), Planes::Grey(4));
    assert_eq!(colour.map(|v| v * 2), Planes::Colour([2, 4, 6]));
    assert_eq!((grey.as_slice(), colour.as_slice()), (&[2][..], &[1, 2, 3][..]));
    assert_eq!((grey.as_colour(), colour.as_colour()), ([2; 3], [1, 2, 3]));
    assert_eq!(colour.map(|v| (v < 3).then_some(v)).all(), None);
    assert_eq!(colour.map(Some).all(), Some(colour));
}

#[test]
fn a_raster_is_flat_when_all_planes_are() {
    let size = Size::new(2, 1);
    assert!(Raster::grey(size, vec![0.5; 2]).is_flat());
    assert!(!Raster::colour(size, [vec![0.0; 2], vec![0.0; 2], vec![0.0, 0.1]]).is_flat());
}
