//! Tests of `letters`.

use hayro_interpret::kurbo::Vec2;

use super::*;

#[test]
fn the_letters_of_a_run_have_one_size() {
    let size = |widths: &[f64]| em(widths.iter().copied()).round() as u32;
    assert_eq!(size(&[684.0, 635.0, 635.0, 278.0, 615.0, 521.0]), 1000, "Apples");
    assert_eq!([size(&[278.0]), size(&[974.0]), size(&[])], [1000; 3], "l, m and none");
    // pixels of letters of 83 pixels
    assert_eq!(size(&[62_000.0, 46_000.0, 46_000.0, 23_000.0, 0.0]), 88_500);
}

#[test]
fn forms_are_named_after_their_letters() {
    let letter = |form: &str| glyph_name(form).map(letter_named);
    assert_eq!(letter("F1-DejaVuSans-minus"), Some(Some('\u{2212}')));
    assert_eq!(letter("F12-DejaVuSans-Bold-ccaron"), Some(Some('\u{10d}')));
    assert_eq!(letter("F1-DejaVuSans-odd"), Some(None), "a letter, nobody knows which");
    assert_eq!([letter("Fm0"), letter("F1-minus"), letter("M1-DejaVuSans-minus"), letter("F-a-b")], [None; 4]);
}

#[test]
fn a_form_that_is_a_letter_fills_one_path() {
    let minus = outline(b"106 355 m\n732 355 l\n732 272 l\n106 272 l\n106 355 l\nh\nf\n").expect("a path");
    let form = FormLetter { string: Some("\u{2212}".to_owned()), outline: minus.clone() };
    assert!(form.is(&minus));
    assert_eq!(form.element(), "<path d=\"M106,355 L732,355 L732,272 L106,272 L106,355 Z\"");
    let letter = form.letter(Affine::new([0.01, 0.0, 0.0, -0.01, 50.0, 80.0]));
    assert!((letter.to - Point::new(58.38, 80.0)).hypot() < 1e-6, "{:?}", letter.to);
    assert!((letter.up - Vec2::new(0.0, -10.0)).hypot() < 1e-6, "{:?}", letter.up);
    assert!(outline(b"0 0 m 9 9 l h f 0 0 m 5 5 l h f").is_none(), "two paths");
    assert!(outline(b"0 0 m 9 9 l S").is_none(), "a stroke");
    assert!(outline(b"/F1-DejaVuSans-minus Do").is_none(), "another form");
}

#[test]
fn an_outline_that_is_longer_than_letters_are_is_none() {
    let of = |lines: usize| outline(format!("0 0 m\n{}h\nf\n", "1 1 l\n".repeat(lines)).as_bytes());
    assert!(of(100).is_some());
    assert!(of(10_000).is_none());
}

#[test]
fn letters_of_one_size_and_height_are_on_one_line() {
    let letter = |x: f64, y: f64, size: f64| Letter {
        string: None,
        from: Point::new(x, y),
        to: Point::new(x + 5.0, y),
        up: Vec2::new(0.0, -size),
        along: Vec2::new(size, 0.0),
        hidden: false,
    };
    let of = |x: f64, y: f64, size: f64| is_on_line(&letter(50.0, 50.0, 10.0), &letter(x, y, size));
    assert!(of(10.0, 50.0, 10.0) && of(200.0, 50.1, 10.0));
    assert!(!of(55.0, 51.0, 10.0), "below");
    assert!(!of(55.0, 50.0, 7.0), "smaller");
}
