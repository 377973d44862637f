//! Tests of `dot_spread`.

use super::*;

#[test]
fn windows_are_whole_dots_apart_and_one_grid_has_them_all() {
    let centres: Vec<f32> = (0..60).map(|i| 1.0 + 2.5 * i as f32).collect();
    let along = Along::new(&centres, [10.0, 140.0], 1.25, (15.0, 1), 3).expect("room");
    assert_eq!(along.centres[..60], centres);
    // 6 dots are shared
    assert!((along.window[1] - along.window[0] - along.step - 15.0).abs() < 1e-3, "{:?}", along.window);
    assert!(((along.step / 2.5) - (along.step / 2.5).round()).abs() < 1e-4);
    assert_eq!(along.centres.len(), 60 + 2 * (along.step / 2.5).round() as usize);
    assert!(along.centres.windows(2).all(|pair| (pair[1] - pair[0] - 2.5).abs() < 1e-3));
    assert!(Along::new(&centres, [10.0, 39.0], 1.25, (15.0, 1), 3).is_none(), "too small");
    // cells of text: a window begins with a cell
    let cells: Vec<f32> = (0..60).map(|i| 3.1 * (i / 2 * 2) as f32 + 2.5 * (i % 2) as f32).collect();
    let along = Along::new(&cells, [10.0, 170.0], 1.25, (15.0, 2), 2).expect("room");
    assert!((along.step / 6.2 - (along.step / 6.2).round()).abs() < 1e-3);
    for (i, centre) in along.centres.iter().enumerate() {
        assert!((centre - 3.1 * (i / 2 * 2) as f32 - 2.5 * (i % 2) as f32).abs() < 1e-2);
    }
}
