//! Tests of `forms`.

use super::*;
use crate::braille::Code;

/// Whether each of these words may be divided.
fn are_divided(words: &[&str], on_display: bool) -> Vec<bool> {
    let table = Code::of_language("en").and_then(Code::table);
    let translator = Translator::new(table, None).expect("a table");
    let mut all = of(words, &[], &translator);
    if on_display {
        without_splinters(&mut all);
    }
    let is_divided = |form: &Form| form.kind == FormKind::TwoLines(Division::InWord);
    all.iter().map(|of| of.as_ref().is_ok_and(|of| of.forms.iter().any(is_divided))).collect()
}

#[test]
fn no_number_is_two_in_two_lines() {
    let lines = |language: &str, text: &str| {
        let table = Code::of_language(language).and_then(Code::table);
        let translator = Translator::new(table, None).expect("a table");
        let all = of(&[text], &[], &translator);
        all[0].as_ref().map_or(0, |of| of.forms.iter().filter(|form| form.kind != FormKind::Short).count())
    };
    assert_eq!(lines("it", "20 000"), 1, "its groups have a blank between them");
    assert_eq!(lines("fr", "20 000"), 1);
    assert_eq!(lines("fr", "20 000 km"), 2, "the unit stands below");
}

#[test]
fn no_splinter_of_a_word_stands_in_a_line_of_a_display() {
    let words = ["Animals", "evaporation"];
    assert_eq!(are_divided(&words, false), [true, true]);
    assert_eq!(are_divided(&words, true), [false, true]);
}
