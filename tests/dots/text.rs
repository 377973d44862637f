//! Unicode and ASCII braille, read back.

use tactograph::internals::output::dots::{Matrix, art, brf, ubrl};

use super::{Random, dots};

#[test]
fn random_pages_come_back() {
    let mut random = Random(3);
    for _ in 0..300 {
        let pages = random.pages();
        let want: Vec<_> = pages.iter().map(dots).collect();
        for back in [ubrl::read(&ubrl::write(&pages)), brf::read(&brf::write(&pages))] {
            let back = back.unwrap_or_else(|fault| panic!("{fault}: {pages:?}"));
            assert_eq!(back.iter().map(dots).collect::<Vec<_>>(), want);
        }
        let text = art::write(&pages);
        let back: Vec<Matrix> =
            text.split_terminator('\u{c}').map(|page| Matrix::drawn(&page.replace('o', "#"))).collect();
        assert_eq!(back.iter().map(dots).collect::<Vec<_>>(), want);
    }
}

#[test]
fn all_cells_come_back_wherever_they_are() {
    for (dots_of_cell, read, write) in [
        (8, ubrl::read as fn(&str) -> Result<Vec<Matrix>, String>, ubrl::write as fn(&[Matrix]) -> String),
        (6, brf::read, brf::write),
    ] {
        let rows = dots_of_cell / 2;
        for cell in 0..1_usize << dots_of_cell {
            let mut page = Matrix::new(6, 3 * rows);
            // Braille's own numbers, 1 2 3 7 down the left side and 4 5 6 8 down the right one.
            for (y, numbers) in [[1, 4], [2, 5], [3, 6], [7, 8]][..rows].iter().enumerate() {
                for (x, number) in numbers.iter().enumerate().filter(|(_, number)| cell >> (**number - 1) & 1 == 1) {
                    assert!(*number <= dots_of_cell);
                    page.raise(2 + x, rows + y, 3);
                }
            }
            let back = read(&write(std::slice::from_ref(&page))).expect("braille");
            assert_eq!(back.iter().map(dots).collect::<Vec<_>>(), [dots(&page)]);
            if dots_of_cell == 8 {
                let middle = write(&[page]).lines().nth(1).and_then(|row| row.chars().nth(1));
                assert_eq!(middle.map(u32::from), Some(0x2800 + cell as u32));
            }
        }
    }
}
