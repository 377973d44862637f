//! Tests of `sheet_windows`.

use super::*;

#[test]
fn a_place_is_called_by_its_sheet_and_counted_from_the_edges_of_that() {
    // windows of 100 by 200 mm that overlap by 10 mm, 20 and 40 mm from the edges of their sheets
    let sheets = SheetWindows {
        counts: [2, 2],
        first: MmPoint::zero(),
        step: MmVector::new(90.0, 190.0),
        half: MmVector::new(5.0, 5.0),
        corner: MmPoint::new(20.0, 40.0),
    };
    let place = |x: f32, y: f32| place_in_words(MmPoint::new(x, y), Some(&sheets));
    assert_eq!(place(30.0, 50.0), "50, 90 mm on sheet a1");
    assert_eq!(place(94.0, 50.0), "114, 90 mm on sheet a1", "both show it");
    assert_eq!(place(96.0, 50.0), "26, 90 mm on sheet a2", "both show it");
    assert_eq!(place(30.0, 380.0), "50, 230 mm on sheet b1");
    assert_eq!(place(189.0, 389.0), "119, 239 mm on sheet b2");
    assert_eq!(place(500.0, -3.0), "430, 37 mm on sheet a2", "beyond the last window there is no other");
    assert_eq!(place_in_words(MmPoint::new(96.0, 50.0), None), "96, 50 mm");
    let edges = |sheets| place_from_edges(MmPoint::new(96.0, 50.0), sheets, "sheet");
    assert_eq!(edges(Some(&sheets)), "26, 90 mm from the left and the top of sheet a2");
    assert_eq!(edges(None), "96, 50 mm from the left and the top of the sheet");
}
