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
    let size = Size::new(9, 3);
    // the others are below the letter's row, too, where the picture ends
    let others: Vec<bool> = (0..size.len()).map(|cell| cell == 14 || cell >= 18).collect();
    let mut cells = with_margin(&[12], &others, size, 3);
    cells.sort_unstable();
    // from the letter in the fourth column around the corner of what is right of it
    assert_eq!(cells, [0, 1, 2, 3, 4, 5, 6, 9, 10, 11, 12, 13, 15]);
    assert_eq!(with_margin(&[], &others, size, 3), [0_usize; 0]);
}

#[test]
fn a_picture_of_nothing_else_stays() {
    let raster = Raster::grey(Size::new(3, 3), vec![0.2; 9]);
    assert_eq!(erased(&raster, &[true; 9]), raster);
}
