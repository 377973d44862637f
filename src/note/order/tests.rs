//! Tests of `order`.

use super::*;
use crate::Reason;

#[test]
fn what_makes_a_page_wrong_is_told_first() {
    let lost = |percent: u32| Note::LinesLeftOut { millimetres: 9, percent, place: None, is_larger_turned: false };
    let told = |about: About| Note::TakenAs(about, Reason::NoSign, String::new());
    let in_margin = Note::TakenAs(About::Braille, Reason::InMargin, String::new());
    let notes = [
        lost(1),
        told(About::Overview),
        Note::NotOnPage(About::Areas, Reason::NoSign, String::new()),
        lost(30),
        Note::EmptyPage,
        told(About::Leaders),
        in_margin,
    ];
    let mut sorted = notes.to_vec();
    Note::sort(&mut sorted);
    assert_eq!(sorted, [4, 5, 2, 3, 0, 6, 1].map(|number: usize| notes[number].clone()));
}

#[test]
fn what_is_left_out_is_never_no_percent_of_all() {
    for (percent, share) in [(0, "under 1 percent"), (3, "3 percent")] {
        let told = Note::LinesLeftOut { millimetres: 9, percent, place: None, is_larger_turned: false }.to_string();
        assert!(told.starts_with(&format!("9 mm of contours, {share}, were left out, all over")), "{told}");
    }
}
