//! Tests of `letters`.

use super::super::{forms, groups};
use super::*;
use crate::braille::{Code, Translate};
use crate::units::{MmPoint, MmRect, MmVector};

#[test]
fn months_are_known_by_their_order() {
    let year = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];
    let of = |texts: &[&str]| initials_of_months(texts).map(String::from_iter);
    assert_eq!(of(&year).as_deref(), Some("jfmamjjasond"));
    let school: Vec<&str> = year.iter().cycle().skip(8).take(12).copied().collect();
    assert_eq!(of(&school).as_deref(), Some("sondjfmamjja"));
    assert_eq!(of(&year[..11]), None, "a part of a year has several Js that nobody can count");
    let backwards: Vec<&str> = year.iter().rev().copied().collect();
    assert_eq!(of(&backwards), None);
    assert_eq!(
        of(&[
            "styczeń",
            "luty",
            "marzec",
            "kwiecień",
            "maj",
            "czerwiec",
            "lipiec",
            "sierpień",
            "wrzesień",
            "październik",
            "listopad",
            "grudzień"
        ])
        .as_deref(),
        Some("slmkmclswplg")
    );
}

#[test]
fn letters_of_a_row_are_those_of_its_texts_where_they_can_be() {
    let of = |texts: &[&str]| own_letters(texts).first().map(String::from_iter);
    assert_eq!(of(&["Apples", "Pears", "Kiwis"]).as_deref(), Some("apk"));
    assert_eq!(of(&["R1", "R2", "A"]).as_deref(), Some("bca"), "what is a letter is no other text's");
    assert_eq!(of(&["Mon", "Tue", "Wed", "Thu"]).as_deref(), Some("abcd"));
    assert_eq!(of(&["A", "a"]), None);
}

/// The letters of texts that stand in a row.
fn letters_of_row(texts: &[&str]) -> Vec<Option<String>> {
    let translator = Translator::new(Code::of_language("en").and_then(Code::table), None).expect("a table");
    let text = |(at, text): (usize, &&str)| {
        let corner = MmPoint::new(10.0 * at as f32, 90.0);
        let anchor = MmRect::new(corner, corner + MmVector::new(4.0, 4.0));
        Wanted { text: (*text).to_owned(), anchor, lost_leader: None, kept_leader: None, is_nameless: false }
    };
    let wanted: Vec<Wanted> = texts.iter().enumerate().map(text).collect();
    let mut groups = groups::of(&wanted, |_| true, |_| true, |_| true);
    let mut forms = forms::of(texts, &[], &translator);
    add(&mut groups, &mut forms, &wanted, &translator);
    let letter = |of: Result<Forms, Unplaced>| {
        let letter = of.ok()?.forms.into_iter().find(|form| form.kind == FormKind::Letter)?;
        letter.abbreviation
    };
    forms.into_iter().map(letter).collect()
}

#[test]
fn a_number_has_no_letter_that_would_be_felt_as_a_digit() {
    assert_eq!(letters_of_row(&["0", "1", "10\u{b2}", "7", "3"]), vec![None; 5]);
    let with_words = letters_of_row(&["5", "40", "Total", "Rest"]);
    assert_eq!(with_words, [None, None, Some("t".to_owned()), Some("r".to_owned())]);
    let years = letters_of_row(&["1990", "1995", "2003"]);
    assert_eq!(years.iter().flatten().count(), 3, "years below bars are names");
}

/// A letter by itself is a word in contracted English, before which liblouis writes the sign of letters.
#[test]
fn long_numbers_of_tables_are_letters_that_are_no_words() {
    let table = || Code::of_language("en").and_then(Code::table).expect("a table");
    let letters = |marked: &'static [&'static str], is_own: bool| -> Vec<Option<String>> {
        let spell = table();
        let other = move |text: &str| {
            let is_marked = marked.contains(&text) || marked == ["*"] && text.starts_with(char::is_alphabetic);
            Ok(is_marked.then_some(0b11_0000).into_iter().chain(spell.translate(text).cells).collect())
        };
        let other: Option<&Translate> = if is_own { None } else { Some(&other) };
        let translator = Translator::new(Some(table()), other).expect("a table");
        let texts = ["3,645,000", "12", "709,037", "3,645,000", "20,907"];
        let mut forms = forms::of(&texts, &[], &translator);
        let place = MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(0.0, 0.0));
        let wanted = texts.map(|text| Wanted {
            text: text.to_owned(),
            anchor: place,
            lost_leader: None,
            kept_leader: None,
            is_nameless: false,
        });
        add_to_alone(0..texts.len(), &mut forms, &wanted, &translator);
        let last = |of: &Result<Forms, Unplaced>| of.as_ref().ok()?.forms.last()?.abbreviation.clone();
        forms.iter().map(last).collect()
    };
    let of = |letters: [&str; 3]| {
        let [first, second, third] = letters.map(|letter| Some(letter.to_owned()));
        vec![first.clone(), None, second, first, third]
    };
    assert_eq!(letters(&[], true), of(["b", "c", "d"]));
    assert_eq!(letters(&[], false), of(["b", "c", "d"]));
    assert_eq!(letters(&["b", "e", "cc"], false), of(["bb", "dd", "ee"]));
    // rather one that may be misread than none
    assert_eq!(letters(&["*"], false), of(["b", "c", "d"]));
}
