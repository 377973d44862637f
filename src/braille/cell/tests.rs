//! Tests of `cell`.

use super::*;

#[test]
fn labels_read_as_in_unicode() {
    let unicode = |cells: Vec<u8>| -> String {
        cells.iter().map(|&cell| char::from_u32(0x2800 + u32::from(cell)).expect("braille")).collect()
    };
    assert_eq!(unicode(letter(0)) + &unicode(letter(9)), "⠁⠚");
    assert_eq!(unicode(number(1)), "⠼⠁");
    assert_eq!(unicode(number(1023)), "⠼⠁⠚⠃⠉");
    assert_eq!(unicode(TRIAL.to_vec()), "⠿⠙⠕⠞");
}

#[test]
fn dots_fill_their_size_and_lie_in_their_columns() {
    let (cells, size) = (number(8), CellSize::MARBURG.extent(2, PRINTED));
    let dots = CellSize::MARBURG.dots(&cells, PRINTED);
    assert_eq!(dots.len(), 4 + 3);
    let edge = |at: fn(&MmPoint) -> f32| dots.iter().map(at).fold(0.0, f32::max) + 0.5 * PRINTED;
    assert!((edge(|dot| dot.x) - size.x).abs() < 1e-4 && (edge(|dot| dot.y) - size.y).abs() < 1e-4);
    // dot 1 of the second cell
    assert!(dots.iter().any(|dot| (*dot - MmPoint::new(6.65, 0.65)).length() < 1e-4), "{dots:?}");
    for (cells, width) in [(0, 3.79), (1, 3.8), (1, 9.79), (2, 9.8), (31, 183.9)] {
        assert_eq!(CellSize::MARBURG.cells_in(width, PRINTED), cells, "{width}");
    }
}
