//! Tests of `words`.

use super::*;

/// Letters of half a font size of 10, at these places.
fn texts(letters: &[(&str, f64, f64)]) -> Vec<String> {
    let mut texts = Texts::default();
    for (string, x, y) in letters {
        let from = Point::new(*x, *y);
        let (up, along) = (Vec2::new(0.0, -10.0), Vec2::new(10.0, 0.0));
        let string = (*string != "?").then(|| (*string).to_owned());
        let letter = Letter { string, from, to: from + Vec2::new(5.0, 0.0), up, along, hidden: false };
        texts.add(letter, Some(Rect::new(0.0, 0.0, 200.0, 100.0)));
    }
    texts.finish().0.into_iter().map(|text| text.string).collect()
}

#[test]
fn letters_are_joined_by_their_gaps() {
    assert_eq!(texts(&[("a", 0.0, 50.0), ("b", 6.0, 50.0), ("c", 10.0, 50.0)]), ["abc"]);
    assert_eq!(texts(&[("a", 0.0, 50.0), ("b", 7.5, 50.0)]), ["a b"], "a gap of a quarter of the size");
    assert_eq!(texts(&[("a", 0.0, 50.0), (" ", 5.0, 50.0), ("b", 10.0, 50.0)]), ["a b"], "a space that is written");
    assert_eq!(texts(&[("a", 0.0, 50.0), ("b", 25.0, 50.0)]), ["a", "b"], "a gap of two sizes");
    assert_eq!(texts(&[("a", 0.0, 50.0), ("b", 5.0, 62.0)]), ["a", "b"], "the next line");
    assert_eq!(texts(&[("a", 50.0, 50.0), ("b", 0.0, 50.0)]), ["a", "b"], "back to the left");
    assert_eq!(texts(&[("a", 0.0, 50.0), ("b", 300.0, 50.0)]), ["a"], "off the page");
    assert_eq!(texts(&[(" ", 0.0, 50.0), ("a", 5.0, 50.0), (" ", 10.0, 50.0)]), ["a"], "spaces around");
}

/// Letters with their sizes, which are half as broad as those, at these places.
fn sized(letters: &[(&str, f64, f64, f64)]) -> Vec<String> {
    let mut texts = Texts::default();
    for (string, x, y, size) in letters {
        let from = Point::new(*x, *y);
        let (up, along) = (Vec2::new(0.0, -size), Vec2::new(*size, 0.0));
        let to = from + Vec2::new(0.5 * size, 0.0);
        let letter = Letter { string: Some((*string).to_owned()), from, to, up, along, hidden: false };
        texts.add(letter, Some(Rect::new(0.0, 0.0, 200.0, 100.0)));
    }
    texts.finish().0.into_iter().map(|text| text.string).collect()
}

#[test]
fn raised_and_lowered_numbers_have_characters_of_their_own() {
    let power = [("1", 10.0, 50.0, 10.0), ("0", 15.0, 50.0, 10.0), ("-", 20.1, 46.0, 7.0), ("3", 23.6, 46.0, 7.0)];
    assert_eq!(sized(&power), ["10\u{207b}\u{b3}"]);
    let unit = [("k", 30.0, 50.0, 10.0), ("g", 35.0, 50.0, 10.0)];
    assert_eq!(sized(&[&power[..], &unit[..]].concat()), ["10\u{207b}\u{b3} kg"]);
    let water = [("H", 10.0, 50.0, 10.0), ("2", 15.0, 51.6, 7.0), ("O", 18.5, 50.0, 10.0)];
    assert_eq!(sized(&water), ["H\u{2082}O"]);
    let both = [("x", 10.0, 50.0, 10.0), ("2", 15.3, 45.6, 7.0), ("1", 15.0, 53.2, 7.0), ("y", 19.0, 50.0, 10.0)];
    assert_eq!(sized(&both), ["x\u{2081}\u{b2}y"]);
    assert_eq!(sized(&[("C", 10.0, 50.0, 10.0), ("3", 15.0, 53.0, 7.0), ("2", 18.5, 46.0, 7.0)]), ["C\u{2083}\u{b2}"]);
}

#[test]
fn other_small_texts_are_texts_of_their_own() {
    let one = ("1", 10.0, 50.0, 10.0);
    assert_eq!(sized(&[one, ("e", 15.0, 46.0, 7.0)]), ["1", "e"], "a letter");
    assert_eq!(sized(&[one, ("n", 15.0, 46.0, 7.0), ("s", 18.7, 50.0, 10.0)]), ["1^n s"], "a power");
    assert_eq!(sized(&[one, ("+", 15.0, 46.0, 7.0)]), ["1", "+"], "a sign");
    assert_eq!(sized(&[one, ("3", 18.0, 46.0, 7.0)]), ["1", "3"], "too far off");
    assert_eq!(sized(&[one, ("3", 15.0, 50.0, 7.0)]), ["1", "3"], "on the line");
    assert_eq!(sized(&[one, ("3", 10.0, 57.0, 7.0)]), ["1", "3"], "below");
    assert_eq!(sized(&[one, ("3", 15.0, 46.0, 9.0)]), ["1", "3"], "nearly as large");
    let fraction = [("3", 10.0, 50.0, 10.0), ("1", 15.5, 46.5, 7.0), ("2", 15.5, 53.6, 7.0)];
    assert_eq!(sized(&fraction), ["3", "1", "2"]);
}
