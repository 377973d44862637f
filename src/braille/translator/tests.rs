//! Tests of `translator`.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::*;

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

#[test]
fn cells_of_eight_dots_are_refused() {
    let other = |_: &str| Ok(vec![1, 64]);
    let translator = Translator::new(None, Some(&other)).expect("there is another");
    assert_eq!(translator.translate("ab"), Err("cells of eight dots".to_owned()));
}
