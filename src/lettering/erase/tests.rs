//! Tests of `erase`.

use super::*;

#[test]
fn a_ground_of_one_colour_closes_over_what_is_erased() {
    let size = Size::new(20, 12);
    let is_letter = |cell: usize| (4..9).contains(&(cell % 20)) && (3..9).contains(&(cell / 20));
    let plane: Vec<f32> = (0..size.len()).map(|cell| if is_letter(cell) { 0.1 } else { 0.7 }).collect();
    let mask: Vec<bool> = (0..size.len()).map(is_letter).collect();
    let erased = erased(&Raster::grey(size, plane), &mask);
    assert!(erased.planes().iter().flatten().all(|value| (value - 0.7).abs() < 1e-6));
}

#[test]
fn a_margin_stops_before_other_things() {
    let size = Size::new(9, 1);
    let set = |at: usize| (0..9).map(|cell| cell == at).collect::<Vec<bool>>();
    let mask = with_margin(&set(3), &set(5), size, 3);
    assert_eq!(mask, [true, true, true, true, true, false, false, false, false]);
}

#[test]
fn a_picture_of_nothing_else_stays() {
    let raster = Raster::grey(Size::new(3, 3), vec![0.2; 9]);
    assert_eq!(erased(&raster, &[true; 9]), raster);
}
