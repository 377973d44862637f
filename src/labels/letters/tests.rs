//! Tests of `letters`.

use super::*;

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
