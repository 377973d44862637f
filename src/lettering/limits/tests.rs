//! Tests of `limits`.

use super::*;

/// A word as clear as print is.
const WORD: Row = Row {
    letters: 8,
    is_pair: false,
    angle: 0.0,
    width: 7.0,
    unevenness: 0.01,
    spread: 0.01,
    stroke_spread: 0.1,
    clutter: 0.0,
    contrast: 90.0,
    aligned: 1.0,
    complex: 1.0,
    height: 12.0,
};

#[test]
fn clear_rows_are_text_if_they_are_long_enough() {
    for strict in [Strictness::Drawing, Strictness::Photograph, Strictness::Context, Strictness::Label] {
        let is_text = |letters: usize| strict.allows(&Row { letters, is_pair: letters == 2, ..WORD });
        let least = (0..9).find(|&letters| is_text(letters)).filter(|&least| (least..9).all(is_text));
        assert_eq!(least, Some(strict.least_letters()), "{strict:?}");
    }
    let two = Row { letters: 2, ..WORD };
    assert!(!Strictness::Drawing.allows(&two) && !Strictness::Context.allows(&two), "no number");
    assert!(!Strictness::Context.allows(&Row { letters: 1, width: 11.0, ..WORD }));
}

#[test]
fn each_limit_is_held() {
    let worse: [fn(&mut Row); 7] = [
        |row| row.unevenness = 0.19,
        |row| row.spread = 0.26,
        |row| row.stroke_spread = 0.46,
        |row| row.clutter = 0.51,
        |row| row.contrast = 24.0,
        |row| row.aligned = 0.59,
        |row| row.complex = 0.39,
    ];
    for (number, worsen) in worse.into_iter().enumerate() {
        let mut row = WORD;
        worsen(&mut row);
        assert!(!Strictness::Photograph.allows(&row), "{number}");
        // a drawing may be faint
        assert_eq!(Strictness::Drawing.allows(&row), number == 4, "{number}");
    }
    let large = Row { height: 49.0, ..WORD };
    assert!(!Strictness::Photograph.allows(&large) && Strictness::Drawing.allows(&large));
}

#[test]
fn small_letters_of_a_drawing_are_less_even_and_faint_ones_of_one_colour() {
    let allows = |strict: Strictness, row: Row| strict.allows(&row);
    let small = Row { unevenness: 0.15, ..WORD };
    let large = Row { height: 20.0, ..small };
    assert_eq!([small, large].map(|row| allows(Strictness::Drawing, row)), [true, false]);
    assert!(![small, large].iter().any(|row| allows(Strictness::Photograph, *row)));
    let one = Row { letters: 1, unevenness: 0.12, ..WORD };
    let strict = [Strictness::Context, Strictness::Label, Strictness::Single];
    assert_eq!(strict.map(|strict| allows(strict, one)), [false, true, true]);
    let beside_ticks = Row { clutter: 0.3, ..one };
    assert_eq!(strict.map(|strict| allows(strict, beside_ticks)), [false, false, true]);
    let pieces = Row { spread: 0.15, contrast: 20.0, angle: 65.0, ..WORD };
    let [clear, level] = [Row { contrast: 40.0, ..pieces }, Row { angle: 0.0, ..pieces }];
    assert_eq!([pieces, clear, level].map(|row| allows(Strictness::Drawing, row)), [false, true, true]);
}

#[test]
fn elephants_in_a_row_and_spots_of_a_leopard_are_no_text() {
    let elephants = Row { letters: 4, spread: 0.098, stroke_spread: 0.245, contrast: 46.0, height: 21.0, ..WORD };
    let spots = Row { letters: 6, spread: 0.062, stroke_spread: 0.146, aligned: 0.83, contrast: 44.0, ..WORD };
    let on_a_ship = Row { letters: 4, spread: 0.017, stroke_spread: 0.098, complex: 0.75, height: 11.0, ..WORD };
    let is_text = [elephants, spots, on_a_ship].map(|row| Strictness::Photograph.allows(&row));
    assert_eq!(is_text, [false, false, true]);
}

#[test]
fn short_small_and_slanted_rows_of_photographs_stand_clearer() {
    let most = |row: Row| {
        let is_text = |percent: &u32| Strictness::Photograph.allows(&Row { clutter: *percent as f32 / 100.0, ..row });
        (0..=100).rev().find(is_text)
    };
    let of = |letters: usize| [0.0, 30.0, 85.0].map(|angle| most(Row { letters, angle, ..WORD }));
    assert_eq!(of(3), [Some(10); 3]);
    assert_eq!(of(4), [Some(15), Some(5), Some(15)]);
    assert_eq!(of(5), [Some(30), Some(15), Some(30)]);
    assert_eq!(of(9), [Some(40), Some(30), Some(40)]);
    assert_eq!(most(Row { height: 5.0, ..WORD }), Some(30), "small ones");
}
