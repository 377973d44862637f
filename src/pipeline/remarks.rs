//! What is told of a page, or of all sheets of a picture: gathered here in one order for both.

use super::finish::{PictureFacts, told_of_pages};
use super::key::Key;
use super::print_words;
use super::unwritten::NoRoomAbove;
use crate::Note;
use crate::page::{Medium, Page};
use crate::profile::Plan;

/// Remarks as they are gathered, from stage to stage. What a stage decides on are facts, not these.
#[derive(Debug, Default)]
pub(super) struct Remarks(Vec<Note>);

/// The finished sheets of a picture, and what is asked of them as a whole.
pub(super) struct FinishedSheets<'a> {
    /// The page, or the sheets of several, with the overview.
    pub(super) of_picture: Vec<&'a Page>,
    pub(super) key: &'a [Page],
    /// Whether the figure has lines.
    pub(super) has_lines: bool,
    pub(super) medium: &'a Medium,
}

impl Remarks {
    /// Those of the marks of a picture.
    pub(super) fn of_marks(notes: Vec<Note>) -> Self {
        Self(notes)
    }

    /// Adds others.
    pub(super) fn extend(&mut self, notes: impl IntoIterator<Item = Note>) {
        self.0.extend(notes);
    }

    /// Adds those of words: what could not be `written`, what has no room `above` the figure, those of labels and of
    /// the key, which also says more of what it tells.
    pub(super) fn add_words(&mut self, written: &[Note], above: NoRoomAbove, of_labels: Vec<Note>, key: &Key) {
        self.extend(written.iter().cloned());
        self.extend(above.told(key.told.title.is_some()));
        self.extend(of_labels);
        key.tell_of_blank(&mut self.0);
        self.extend(key.notes.iter().cloned());
    }

    /// All in the order in which they are told, with those of the finished sheets.
    pub(super) fn of_sheets(mut self, sheets: &FinishedSheets<'_>, facts: PictureFacts, plan: &Plan) -> Vec<Note> {
        let of_picture = || sheets.of_picture.iter().copied();
        self.extend(print_words::left_out(of_picture().chain(sheets.key), plan));
        if of_picture().all(Page::is_empty) {
            self.extend([if facts.all_erased { Note::AllErased } else { Note::EmptyPage }]);
        } else if plan.profile().figure.lines && !sheets.has_lines && !facts.none_sought {
            self.extend([Note::NoLines]);
        }
        self.extend(told_of_pages(of_picture(), sheets.medium, plan));
        Note::sort(&mut self.0);
        self.0
    }
}

#[cfg(test)]
mod tests;
