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
