//! Unicode and ASCII braille, read back.

use tactograph::internals::output::dots::{DotMatrix, brf, text, ubrl};

use super::{Random, dots, reading};

#[test]
fn random_pages_come_back() {
    let mut random = Random(3);
    for _ in 0..300 {
        let pages = random.pages();
        let want: Vec<_> = pages.iter().map(dots).collect();
        for back in [reading::ubrl(&ubrl::write(&pages)), reading::brf(&brf::write(&pages))] {
            assert_eq!(back.iter().map(dots).collect::<Vec<_>>(), want);
        }
        let back: Vec<DotMatrix> = text::write(&pages).split_terminator('\u{c}').map(reading::drawn).collect();
        assert_eq!(back.iter().map(dots).collect::<Vec<_>>(), want);
    }
}

#[test]
fn all_cells_come_back_wherever_they_are() {
    for (dots_of_cell, read, write) in [
        (8, reading::ubrl as fn(&str) -> Vec<DotMatrix>, ubrl::write as fn(&[DotMatrix]) -> String),
        (6, reading::brf, brf::write),
    ] {
        let rows = dots_of_cell / 2;
        for cell in 0..1_usize << dots_of_cell {
            let mut page = reading::matrix(6, 3 * rows);
            // Braille's own numbers, 1 2 3 7 down the left side and 4 5 6 8 down the right one.
            for (y, numbers) in [[1, 4], [2, 5], [3, 6], [7, 8]][..rows].iter().enumerate() {
                for (x, number) in numbers.iter().enumerate().filter(|(_, number)| cell >> (**number - 1) & 1 == 1) {
                    assert!(*number <= dots_of_cell);
                    page.raise(2 + x, rows + y, 3);
                }
            }
            let back = read(&write(std::slice::from_ref(&page)));
            assert_eq!(back.iter().map(dots).collect::<Vec<_>>(), [dots(&page)]);
            if dots_of_cell == 8 {
                let middle = write(&[page]).lines().nth(1).and_then(|row| row.chars().nth(1));
                assert_eq!(middle.map(u32::from), Some(0x2800 + cell as u32));
            }
        }
    }
}
