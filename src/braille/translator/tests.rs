//! Tests of `translator`.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::*;
use crate::braille::Code;

#[test]
fn another_translator_is_asked_once_for_each_text() {
    let asked = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&asked);
    let other = move |text: &str| {
        count.fetch_add(1, Ordering::Relaxed);
        if text == "no" { Err("it cannot".to_owned()) } else { Ok(vec![1; text.len()]) }
    };
    let translator = Translator::new(None, Some(&other)).expect("there is another");
    for _ in 0..3 {
        assert_eq!(translator.translate("word").map(|braille| braille.cells), Ok(vec![1; 4]));
        assert_eq!(translator.translate("no"), Err("it cannot".to_owned()));
    }
    assert_eq!(asked.load(Ordering::Relaxed), 2);
}

/// liblouis 3.24 knows no lowered numbers.
#[test]
fn english_formulas_are_written_beside_contracted_words() {
    let other = |text: &str| {
        let cells: Vec<u8> = text.chars().map(|letter| u8::from(letter != ' ')).collect();
        if text.is_ascii() { Ok(cells) } else { Err("no cells".to_owned()) }
    };
    let written = |language: &str, text: &str| {
        let table = Code::of_language(language).and_then(Code::table);
        let translator = Translator::new(table, Some(&other)).expect("there is another");
        translator.translate(text).map(|braille| braille.unicode())
    };
    assert_eq!(written("en", "of H\u{2082}O, 3 l").as_deref(), Ok("⠁⠁⠀⠠⠓⠰⠢⠼⠃⠠⠕⠂⠀⠁⠀⠁"));
    assert_eq!(written("en", "10\u{207b}\u{b3} m").as_deref(), Ok("⠼⠁⠚⠔⠣⠐⠤⠼⠉⠜⠀⠁"));
    assert_eq!(written("en", "Na\u{207a}").as_deref(), Ok("⠠⠝⠁⠰⠔⠐⠖"));
    assert_eq!(written("fr", "Na\u{207a}").as_deref(), Ok("⠁⠁⠁"), "on the line");
    assert_eq!(written("en", "\u{65e5} H\u{2082}O"), Err("no cells".to_owned()));
    // its contracted braille has signs before letters for which no source was found
    assert_eq!(written("de", "H\u{2082}O"), Err("no cells".to_owned()));
}

#[test]
fn cells_of_eight_dots_are_refused() {
    let other = |_: &str| Ok(vec![1, 64]);
    let translator = Translator::new(None, Some(&other)).expect("there is another");
    assert_eq!(translator.translate("ab"), Err("cells of eight dots".to_owned()));
}

/// liblouis leaves a hyphen before a number a hyphen; German and English tables of ours write a minus sign.
#[test]
fn a_hyphen_that_the_table_writes_as_minus_is_one_for_another_translator() {
    let asked = |language: &str, text: &str, has_minus: bool| -> String {
        let other = move |text: &str| {
            let has_one = text.contains('\u{2212}');
            // what it is asked is seen in its cells
            let cells = text.chars().map(|letter| if letter == '\u{2212}' { 63 } else { 1 }).collect();
            if has_one && !has_minus { Err("no minus".to_owned()) } else { Ok(cells) }
        };
        let table = Code::of_language(language).and_then(Code::table);
        let translator = Translator::new(table, Some(&other)).expect("there is another");
        let cells = translator.translate(text).expect("it is written").cells;
        let is_minus = |(letter, cell): (char, u8)| if cell == 63 { '\u{2212}' } else { letter };
        text.chars().zip(cells).map(is_minus).collect()
    };
    for language in ["en", "de"] {
        assert_eq!(asked(language, "-3 to -5", true), "\u{2212}3 to \u{2212}5");
        assert_eq!(asked(language, "(-3), x=-3", true), "(\u{2212}3), x=\u{2212}3");
        assert_eq!(asked(language, "5-10, A-4, 3 - 2, -x", true), "5-10, A-4, 3 - 2, -x");
        assert_eq!(asked(language, "3--5, --5", true), "3--5, --5");
        assert_eq!(asked(language, "-3", false), "-3", "it has none");
    }
    // codes that write it in another way, or have one cell for both
    for language in ["fr", "es", "pt", "sv", "nl", "pl"] {
        assert_eq!(asked(language, "-3, 5-10", true), "-3, 5-10");
    }
}

/// Contracted German has "etwa" for ea, without a sign that tells the letters from the word: liblouis writes both
/// alike.
#[test]
fn letters_that_are_words_of_a_contracted_code_are_known_by_its_table() {
    let is_read = |language: &str, letters: &str| {
        let table = || Code::of_language(language).and_then(Code::table).expect("a table");
        let spell = table();
        let other = move |text: &str| Ok(spell.translate(text).cells);
        let translator = Translator::new(Some(table()), Some(&other)).expect("there is another");
        translator.is_read_as_letters(letters)
    };
    for (language, word) in [("de", "ea"), ("fr", "av"), ("fr", "cdm"), ("es", "md"), ("es", "b"), ("pt", "cd")] {
        assert!(!is_read(language, word), "{word} in {language}");
    }
    assert!(is_read("de", "ca") && is_read("fr", "ao") && is_read("en", "ea"));
}
