//! Tests of `order`.

use super::super::Told;
use super::*;

#[test]
fn what_harms_a_reader_most_is_told_first() {
    let lost = |percent: u32| Note::LinesLeftOut { millimetres: 9, percent, place: None, is_larger_turned: false };
    let missing = |reason: Reason| Note::NotOnPage(About::Lines, reason, String::new().into());
    let notes = [
        lost(1),
        Note::TakenAs(About::Overview, Reason::NoRoomForLine, String::new().into()),
        missing(Reason::LineInPieces),
        lost(30),
        Note::Abbreviated(Vec::new()),
        Note::EmptyPage,
        Note::TakenAs(About::Leaders, Reason::LeadsToNothing, String::new().into()),
        missing(Reason::NoRoomForLine),
        Note::OfFile(crate::GivenFile::Lines, Box::new(missing(Reason::TooShort))),
        missing(Reason::NoRoomForTexture),
        missing(Reason::NoRoomForArrowhead),
    ];
    let mut sorted = notes.to_vec();
    Note::sort(&mut sorted);
    assert_eq!(sorted, [5, 6, 7, 8, 2, 3, 10, 9, 4, 1, 0].map(|number: usize| notes[number].clone()));
}

/// A texture of a small area was told first, with what makes the figure larger.
#[test]
fn what_makes_the_figure_larger_is_told_with_the_worst_that_it_helps() {
    let lost = |reason: Reason, told: Told| Note::NotOnPage(About::Lines, reason, told);
    let mut notes = vec![
        lost(Reason::NoRoomForTexture, Told::from("1 texture").or_larger().or_crop().or("say it in a label")),
        lost(Reason::NoRoomForArrowhead, Told::from("1 head").or_larger().or("say it in the title")),
        lost(Reason::NoRoomForLine, Told::from("1 line").or_larger().or("say it in a label")),
    ];
    Note::sort(&mut notes);
    let wanted = [
        lost(Reason::NoRoomForLine, Told::from("1 line").or_larger().or("say it in a label")),
        lost(Reason::NoRoomForArrowhead, Told::from("1 head").or("say it in the title")),
        lost(Reason::NoRoomForTexture, Told::from("1 texture").or("say it in a label")),
    ];
    assert_eq!(notes, wanted);
}

#[test]
fn what_is_left_out_is_never_no_percent_of_all() {
    for (percent, share) in [(0, "under 1 percent"), (3, "3 percent")] {
        let told = Note::LinesLeftOut { millimetres: 9, percent, place: None, is_larger_turned: false }.to_string();
        assert!(told.starts_with(&format!("9 mm of contours, {share}, were left out, all over")), "{told}");
    }
}
