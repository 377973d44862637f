//! Tests of `dot_matrix`.

use super::*;

fn drawing(matrix: &DotMatrix) -> String {
    let sign = |&height: &u8| [".", "-", "+", "#"][usize::from(height)];
    (0..matrix.rows()).map(|y| matrix.row(y).iter().map(sign).collect::<String>() + "\n").collect()
}

#[test]
fn a_picture_comes_back() {
    let picture = "#..-\n.+..\n....\n...#\n";
    let matrix = DotMatrix::drawn(picture);
    assert_eq!((matrix.columns(), matrix.rows(), matrix.count()), (4, 4, 4));
    assert_eq!(drawing(&matrix), picture);
    assert_eq!([(0, 0), (3, 0), (1, 1), (2, 2)].map(|(x, y)| matrix.height(x, y)), [3, 1, 2, 0]);
}

#[test]
fn beyond_the_matrix_is_blank() {
    let mut matrix = DotMatrix::drawn("##\n##\n");
    for (x, y) in [(2, 0), (0, 2), (2, 1), (usize::MAX, 0), (0, usize::MAX)] {
        assert!(!matrix.is_raised(x, y), "{x} {y}");
        matrix.raise(x, y, 3);
    }
    assert_eq!(drawing(&matrix), "##\n##\n");
    assert_eq!((matrix.cell8(0, 0), matrix.cell8(1, 0), matrix.cell6(0, 1)), (0x1b, 0, 0));
    assert!(matrix.row(2).is_empty());
    let none = DotMatrix::new(0, 5).expect("no dots");
    assert_eq!((none.rows(), none.count(), none.cell8(0, 0)), (0, 0, 0));
}

#[test]
fn more_dots_than_any_device_has_are_refused() {
    assert!(DotMatrix::new(MOST_DOTS, 1).is_some());
    assert_eq!(DotMatrix::new(MOST_DOTS, 2), None);
    assert_eq!(DotMatrix::new(usize::MAX, usize::MAX), None);
}

#[test]
fn the_higher_dot_stays() {
    let mut matrix = DotMatrix::new(1, 1).expect("a dot");
    for (height, want) in [(2, 2), (1, 2), (3, 3), (9, 3), (0, 3)] {
        matrix.raise(0, 0, height);
        assert_eq!(matrix.height(0, 0), want);
    }
}

#[test]
fn cells_are_those_of_unicode() {
    // Braille's own numbers: 1 2 3 7 down the left side, 4 5 6 8 down the right one.
    let numbers = [[1, 4], [2, 5], [3, 6], [7, 8]];
    for (y, row) in numbers.iter().enumerate() {
        for (x, number) in row.iter().enumerate() {
            let mut matrix = DotMatrix::new(4, 8).expect("cells");
            matrix.raise(2 + x, 4 + y, 1);
            assert_eq!(matrix.cell8(1, 1), 1 << (number - 1));
            if y < 3 {
                let mut matrix = DotMatrix::new(4, 6).expect("cells");
                matrix.raise(2 + x, 3 + y, 1);
                assert_eq!(matrix.cell6(1, 1), 1 << (number - 1));
            }
        }
    }
}
