//! Tests of `outlined`.

use super::*;

/// A drawing with a text whose letters are paths: what its comment says, the numbers of the outlines, and what turns
/// their group.
fn drawing(comment: &str, letters: &[u8], turned: &str) -> String {
    let all: String = letters.iter().map(|letter| format!("<use href='#Font-{letter:x}'/>")).collect();
    let outlines: String =
        (0x40..0x80_u8).map(|letter| format!("<path id='Font-{letter:x}' d='M0 0H9V9z'/>")).collect();
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'><g id='text_1'><!-- {comment} -->\
         <g transform='translate(20 50) {turned}'><defs>{outlines}<path id='Font-20'/></defs>{all}</g></g></svg>"
    )
}

/// What the text of such a drawing says, if it is one.
fn read(comment: &str, letters: &[u8], turned: &str) -> Option<String> {
    let text = drawing(comment, letters, turned);
    let found = of_document(&text, &Document::parse(&text).expect("a drawing"))?;
    assert!(!found.bare.contains("<use") && found.marked.contains("<use"), "{}", found.bare);
    assert_eq!(found.texts.len(), 1);
    found.texts.into_values().next()
}

const FLIPPED: &str = "scale(0.1 -0.1)";

#[test]
fn a_comment_says_which_letters_the_paths_behind_it_are() {
    let read = |comment: &str, letters: &[u8]| read(comment, letters, FLIPPED);
    assert_eq!(read("Apple", b"Apple").as_deref(), Some("Apple"));
    assert_eq!(read("Apple", &[0x44, 0x50, 0x50, 0x51, 0x52]).as_deref(), Some("Apple"), "numbers of another kind");
    assert_eq!(read("a b", b"a b").as_deref(), Some("a b"), "with the outline of a blank");
    assert_eq!(read("a &amp; b", b"a@b").as_deref(), Some("a & b"));
    assert_eq!(read("office", b"oAce").as_deref(), Some("office"), "three letters that are drawn as one");
    assert_eq!(read("5 $", b"A B").as_deref(), Some("5 $"));
    let power = read("$\\mathdefault{10^{-1}}$ m", b"ABCA m");
    assert_eq!(power.as_deref(), Some("10\u{207b}\u{b9} m"));
}

#[test]
fn what_is_not_sure_to_be_a_text_is_none() {
    assert_eq!(read("Apple", b"Appl", FLIPPED), None, "a letter less");
    assert_eq!(read("three", b"aaaaa", FLIPPED), None, "five copies of one shape");
    assert_eq!(read("$10^3$ m", b"103", FLIPPED), None, "a formula");
    assert_eq!(read("$\\frac{1}{2}$", b"ABC", FLIPPED), None, "a formula that is not known");
    assert_eq!(read("Apple", b"Apple", "scale(0.1)"), None, "not upside down");
    assert_eq!(read("Apple", b"Apple", "scale(0.1 -0.2)"), None);
    assert_eq!(read("", b"", FLIPPED), None);
    let other = drawing("Apple", b"Apple", FLIPPED).replace("</defs>", "</defs><rect width='9' height='9'/>");
    assert!(of_document(&other, &Document::parse(&other).expect("a drawing")).is_none(), "something else is drawn");
    let named = drawing("Apple", b"Apple", FLIPPED).replace("Font-", "leaf");
    assert!(of_document(&named, &Document::parse(&named).expect("a drawing")).is_none(), "shapes with other names");
}

#[test]
fn letters_that_are_drawn_elsewhere_are_no_text() {
    let within = |open: &str, close: &str| {
        let text = drawing("Apple", b"Apple", FLIPPED);
        let text = text.replace("<g id='text_1'>", open).replace("</g></g>", &format!("</g>{close}"));
        of_document(&text, &Document::parse(&text).expect("a drawing")).is_some()
    };
    assert!(within("<g>", "</g>") && within("<a>", "</a>"));
    for around in ["defs", "symbol", "pattern", "clipPath", "use"] {
        assert!(!within(&format!("<{around}><g>"), &format!("</g></{around}>")), "{around}");
    }
}

#[test]
fn texts_of_paths_have_a_place_a_size_and_an_angle() {
    let text = drawing("Apple", b"Apple", "rotate(-90) scale(0.1 -0.1)");
    let found = of_document(&text, &Document::parse(&text).expect("a drawing")).expect("a text");
    let tree = Tree::from_str(&found.marked, &usvg::Options::default()).expect("a drawing");
    let texts = found.of_tree(&tree, Transform::from_scale(2.0, 2.0), Size::new(400, 200));
    let [DrawnText { string, min, max, angle, size, hidden }] = &texts[..] else { panic!("{texts:?}") };
    assert_eq!((string.as_str(), *hidden), ("Apple", false));
    assert!((angle - 90.0).abs() < 0.1 && (size - 20.0).abs() < 0.01, "{angle} {size}");
    // from 0.75 of 10 px left of its line to 0.22 right of it, and 0.9 up
    let expected = [2.0 * 12.5, 2.0 * 22.2, 2.0 * 49.1, 2.0 * 50.0];
    let place = [min.x, max.x, min.y, max.y];
    assert!(place.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.01), "{place:?}");
    let bare = Tree::from_str(&found.bare, &usvg::Options::default()).expect("a drawing");
    assert_eq!(found.of_tree(&bare, Transform::identity(), Size::new(200, 100)), []);
    let elsewhere = found.of_tree(&tree, Transform::from_translate(300.0, 0.0), Size::new(200, 100));
    assert_eq!(elsewhere, [], "beside the picture");
}
