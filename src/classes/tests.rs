//! Tests of `classes`.

use super::*;

#[test]
fn a_picture_of_one_colour_is_sorted_as_one_that_is_nearly_so() {
    let size = Size::new(40, 30);
    let params = Params { cell: 4.0, blur: 8.0, beside: 2.0, smoothing: 6.0, min_area: 100.0, ..Params::TEST };
    for rgb in [[1.0, 1.0, 1.0], [0.02, 0.05, 0.6], [0.3, 0.3, 0.3]] {
        let mut planes = rgb.map(|light: f32| vec![light; size.len()]);
        let even = sort(&Raster::colour(size, planes.clone()), &[], &params);
        planes[0][0] *= 1.0 - f32::EPSILON;
        let nearly = sort(&Raster::colour(size, planes), &[], &params);
        assert_eq!((&even.size, &even.region, &even.regions), (&nearly.size, &nearly.region, &nearly.regions));
        assert_eq!((even.lightness.size, even.fringe), (nearly.lightness.size, nearly.fringe));
        let mut both = even.lightness.values.iter().zip(&nearly.lightness.values);
        assert!(both.all(|(a, b)| (a - b).abs() < 1e-5), "{rgb:?}");
    }
}
