//! What the maker is told of what a person gives: words that are not taken, and lines that are too short.

use super::given::Given;
use super::words::Words;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::MmVector;
use crate::{About, Note, Reason};

/// What the maker is told of a file of lines in which there are none: why, or what to do.
pub fn told_no_lines(why: &str) -> Note {
    Note::TakenAs(About::Lines, Reason::NoLinesGiven, format!("it has no lines: {why}").into())
}

/// What the maker is told of a photograph that is given as a picture of lines.
pub(super) fn told_no_drawing() -> Note {
    let told = "it looks like no picture of lines, black on white: what is drawn are the edges of what it shows";
    Note::TakenAs(About::Lines, Reason::NoDrawing, told.to_owned().into())
}

/// What the maker is told of the words of a page of which only lines are taken, where none are given.
pub(super) fn told_words(given: &Given, words: &Words<'_>) -> Option<Note> {
    let texts = given.texts_of_page;
    let (noun, they_are) = if texts == 1 { ("text", "it is") } else { ("texts", "they are") };
    let is_given = words.title.is_some() || !words.labels.is_empty() || words.own_texts;
    (texts > 0 && !is_given).then(|| {
        let what_to_do = format!("give title and labels again, as {they_are} not taken from there");
        Note::NotOnPage(
            About::Braille,
            Reason::WordsOfPage,
            format!("{texts} braille {noun} of the page that the lines are of; {what_to_do}").into(),
        )
    })
}

/// What the maker is told of lines that were given and are too short for this figure.
pub(super) fn told_short(given: &Given, layout: &Layout, plan: &Plan) -> Option<Note> {
    let least = plan.profile().lines.min_length;
    let figure = layout.figure;
    let mut short = given.hand_lines().flat_map(|lines| lines.shorter_than(least / figure.width()));
    let (name, [x, y]) = short.next()?;
    let count = 1 + short.count();
    let (lines, the_first, them) = match count {
        1 => ("1 line".to_owned(), "", "it is"),
        _ => (format!("{count} lines"), "the first, ", "they are"),
    };
    let name = name.map_or_else(String::new, |name| format!("{name}, "));
    let at = figure.min + figure.size().to_vector().component_mul(MmVector::new(x, y));
    let why = format!("{them} shorter than {least} mm (lines.min_length) in this figure");
    let told = format!("{lines} of those given ({the_first}{name}at {}), as {why}", layout.place_in_words(at));
    Some(Note::NotOnPage(About::Lines, Reason::TooShort, told.into()))
}
