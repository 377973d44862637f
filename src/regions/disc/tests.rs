//! Tests of `disc`.

use super::*;

#[test]
fn a_disc_has_the_cells_that_are_near_enough_and_in_the_grid() {
    let size = Size::new(9, 7);
    for most in [0, 1, 2, 5, 9, 200] {
        let disc = CellDisc::new(size, |square| square <= most);
        for cell in 0..size.len() {
            let square =
                |other: usize| ((cell % 9).abs_diff(other % 9).pow(2) + (cell / 9).abs_diff(other / 9).pow(2)) as u32;
            let near: Vec<usize> = (0..size.len()).filter(|&other| square(other) <= most).collect();
            assert_eq!(disc.around(cell).flatten().collect::<Vec<_>>(), near);
        }
    }
    assert_eq!(CellDisc::new(size, |_| false).around(3).count(), 0);
}
