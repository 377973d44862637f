//! Tests of `texts`.

use super::*;

fn text(string: &str, x: f32, y: f32) -> DrawnText {
    let (min, max) = (PxPoint::new(x, y), PxPoint::new(x + 12.0 * string.chars().count() as f32, y + 24.0));
    DrawnText { string: string.to_owned(), min, max, angle: 0.0, size: 20.0, hidden: false }
}

fn strings(texts: Vec<DrawnText>) -> Vec<String> {
    sentences(texts).into_iter().map(|text| text.string).collect()
}

#[test]
fn lines_of_a_sentence_are_one_text() {
    let lines = [text("The boiler", 10.0, 10.0), text("heats the", 10.0, 34.0), text("water.", 10.0, 58.0)];
    let joined = sentences(lines.to_vec());
    assert_eq!(joined.len(), 1);
    assert_eq!(joined[0].string, "The boiler heats the water.");
    assert_eq!((joined[0].min, joined[0].max), (lines[0].min, PxPoint::new(130.0, 82.0)));
    let divided = [text("A spider-", 10.0, 10.0), text("ling", 10.0, 34.0)];
    assert_eq!(strings(divided.to_vec()), ["A spiderling"]);
    let town = [text("La Chaux-", 10.0, 10.0), text("de-Fonds", 10.0, 34.0)];
    assert_eq!(strings(town.to_vec()), ["La Chaux-de-Fonds"]);
    let station = [text("U-Bahn-Sta-", 10.0, 10.0), text("tion am Zoo", 10.0, 34.0)];
    assert_eq!(strings(station.to_vec()), ["U-Bahn-Station am Zoo"]);
}

#[test]
fn lists_and_texts_apart_are_several() {
    let list = [text("duck", 10.0, 10.0), text("sea gull", 10.0, 34.0), text("Great tit", 10.0, 58.0)];
    assert_eq!(strings(list.to_vec()).len(), 3);
    let apart = [text("The boiler", 10.0, 10.0), text("heats the water", 10.0, 60.0)];
    assert_eq!(strings(apart.to_vec()).len(), 2, "too far below");
    let beside = [text("The boiler", 10.0, 10.0), text("heats the water", 60.0, 34.0)];
    assert_eq!(strings(beside.to_vec()).len(), 2, "not in line");
    let ended = [text("The end.", 10.0, 10.0), text("not its own", 10.0, 34.0)];
    assert_eq!(strings(ended.to_vec()).len(), 2, "the sentence has ended");
}

/// Pieces as one text: what they say, where they begin, and their size.
fn pieces(of: &[(&str, f32, f32, f32)]) -> String {
    let piece = |&(text, x, y, size): &(&str, f32, f32, f32)| Piece {
        text: text.to_owned(),
        goes_on: false,
        at: Some(Place { frame: 0, x, y }),
        size,
        up: 0.0,
    };
    joined(&in_order(of.iter().map(piece).collect()))
}

#[test]
fn digits_and_powers_of_a_formula_are_one_number() {
    // as matplotlib writes the numbers of a logarithmic axis
    assert_eq!(pieces(&[("1", 0.0, -0.7, 10.0), ("0", 6.4, -0.7, 10.0), ("3", 12.8, -4.8, 7.0)]), "10\u{b3}");
    let negative =
        [("1", 0.0, 0.0, 10.0), ("0", 6.4, 0.0, 10.0), ("\u{2212}", 12.8, -4.1, 7.0), ("2", 18.7, -4.1, 7.0)];
    assert_eq!(pieces(&negative), "10\u{207b}\u{b2}");
    assert_eq!(pieces(&[("H", 0.0, 0.0, 10.0), ("2", 7.6, 1.6, 7.0), ("O", 12.1, 0.0, 10.0)]), "H\u{2082}O");
    assert_eq!(pieces(&[("1", 0.0, 0.0, 10.0), (".", 6.4, 0.0, 10.0), ("5", 9.6, 0.0, 10.0)]), "1.5");
    assert_eq!(pieces(&[("1", 0.0, 0.0, 10.0), ("2", 9.5, 0.0, 10.0)]), "1 2", "a space between them");
    assert_eq!(pieces(&[("1", 0.0, 0.0, 10.0), ("2", 0.0, 12.0, 10.0)]), "1 2", "below one another");
    assert_eq!(pieces(&[("Rain", 0.0, 0.0, 10.0), ("2", 60.0, -4.0, 7.0)]), "Rain 2", "too far off");
    assert_eq!(pieces(&[("Room", 0.0, 0.0, 10.0), ("2", 0.0, 9.0, 7.0)]), "Room 2", "a small line below");
    assert_eq!(pieces(&[("1 ", 0.0, 0.0, 10.0), ("0 ", 6.4, 0.0, 10.0), ("3", 12.8, -4.0, 7.0)]), "10\u{b3}", "blanks");
    let unknown = |text: &str| Piece { text: text.to_owned(), goes_on: false, at: None, size: 9.0, up: 0.0 };
    assert_eq!(joined(&["Rain", "in mm"].map(unknown)), "Rain in mm");
}

#[test]
fn signs_of_a_formula_are_in_the_order_in_which_they_stand() {
    // as matplotlib writes them: those of one size and style together
    let number = [
        ("1", 0.0, -0.7, 10.0),
        ("0", 6.4, -0.7, 10.0),
        ("", 23.4, -0.7, 10.0),
        ("k", 26.6, -0.7, 10.0),
        ("g", 32.4, -0.7, 10.0),
        ("\u{2212}", 12.8, -4.8, 7.0),
        ("3", 18.7, -4.8, 7.0),
    ];
    assert_eq!(pieces(&number), "10\u{207b}\u{b3} kg");
    let energy = [
        ("E", 0.0, 0.0, 10.0),
        ("m", 18.6, 0.0, 10.0),
        ("c", 28.3, 0.0, 10.0),
        ("=", 8.3, 0.0, 10.0),
        ("2", 34.3, -4.4, 7.0),
    ];
    assert_eq!(pieces(&energy), "E = m c\u{b2}");
    let hebrew = [("\u{5d0}", 20.0, 0.0, 10.0), ("\u{5d1}", 14.0, 0.0, 10.0), ("2", 26.0, -4.0, 7.0)];
    assert_eq!(pieces(&hebrew), "\u{5d0} \u{5d1} 2");
}

#[test]
fn numbers_of_a_fraction_are_no_powers() {
    assert_eq!(pieces(&[("3", 0.0, 0.0, 10.0), ("1", 7.0, -3.4, 7.0), ("2", 7.0, 3.6, 7.0)]), "3 1 2");
    let mixed = [
        ("=", 0.0, 0.0, 10.0),
        ("1", 9.0, -3.8, 7.0),
        ("3", 11.0, 3.4, 7.0),
        ("0", 13.4, -3.8, 7.0),
        ("y", -8.0, 0.0, 10.0),
    ];
    assert_eq!(pieces(&mixed), "= 1 3 0 y", "not in another order either");
    assert_eq!(pieces(&[("x", 0.0, 0.0, 10.0), ("1", 5.9, 3.2, 7.0), ("2", 6.4, -4.4, 7.0)]), "x\u{2081}\u{b2}");
}

#[test]
fn raised_signs_are_charges() {
    assert_eq!(pieces(&[("Na", 0.0, 0.0, 10.0), ("+", 13.0, -4.0, 7.0)]), "Na\u{207a}");
    assert_eq!(pieces(&[("Cl", 0.0, 0.0, 10.0), ("-", 11.0, -4.0, 7.0)]), "Cl\u{207b}");
    assert_eq!(pieces(&[("Ca", 0.0, 0.0, 10.0), ("2+", 13.0, -4.0, 7.0)]), "Ca\u{b2}\u{207a}");
}

#[test]
fn powers_without_characters_of_their_own_are_typed() {
    let of = |base: &str, own: &str| {
        let behind = 6.4 * base.chars().count() as f32;
        pieces(&[(base, 0.0, 0.0, 10.0), (own, behind, -4.0, 7.0)]).trim_end().to_owned()
    };
    assert_eq!(
        [of("10", "1.5"), of("2", "n"), of("e", "-x"), of("y = 2", "n+1")],
        ["10^1.5", "2^n", "e^(-x)", "y = 2^(n+1)"]
    );
    assert_eq!([of("1", "er"), of("Rain", "x"), of("5", ","), of("12", "h")], ["1 er", "Rain x", "5 ,", "12 h"]);
    let lowered = [("v", 0.0, 0.0, 10.0), ("x", 6.0, 3.0, 7.0)];
    assert_eq!(pieces(&lowered), "v x");
    let sum = [("2", 0.0, 0.0, 10.0), ("n", 6.4, -4.0, 7.0), ("+", 10.8, -4.0, 7.0), ("k", 16.7, -4.0, 7.0)];
    assert!(!pieces(&sum).contains('^'), "where it ends is not known");
}
