//! What is written on a page in braille.

use super::request::Request;
use crate::braille::{Braille, Code};
use crate::page::cells::CellGrid;
use crate::page::heading::HeadingParams;
use crate::page::layout::Layout;
use crate::page::{BrailleText, Dots, LANGUAGE, TextRole};
use crate::profile::Plan;
use crate::units::Size;
use crate::{Error, Note};

/// What the maker of a page wants to be written on it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Words<'a> {
    /// The title; none if the maker gave none: a file's name is no title.
    pub title: Option<&'a str>,
    /// The language of the words (BCP 47); without it they are English.
    pub language: Option<&'a str>,
}

/// The words of a page in braille.
#[derive(Debug, Default)]
pub(super) struct Written {
    title: Option<Title>,
    language: String,
    /// What could not be written.
    pub(super) notes: Vec<Note>,
}

#[derive(Debug)]
struct Title {
    text: String,
    braille: Braille,
    params: HeadingParams,
}

impl Written {
    /// The words in the code that the profile names, or that of their language.
    pub(super) fn new(words: &Words<'_>, plan: &Plan) -> Self {
        let settings = &plan.profile().braille;
        let language = words.language.unwrap_or(LANGUAGE);
        let mut written = Self { language: language.to_owned(), ..Self::default() };
        let Some(text) = words.title.filter(|_| settings.on) else { return written };
        let Some(table) = settings.code.or_else(|| Code::of_language(language)).and_then(Code::table) else {
            written.notes.push(Note::NoBrailleCode(language.to_owned()));
            return written;
        };
        let braille = table.translate(text);
        if !braille.lacking.is_empty() {
            let lacking = braille.lacking.iter().map(|lacking| (lacking.character, lacking.at)).collect();
            written.notes.push(Note::NotInBraille { text: text.to_owned(), lacking });
        }
        written.title = HeadingParams::of(&braille, settings.cell, settings.align).map(|params| Title {
            text: text.to_owned(),
            braille,
            params,
        });
        written
    }

    /// Where a picture lies below its title. Where a title would leave the figure too small, or narrower than it is
    /// asked for, there is none.
    pub(super) fn layout(&self, size: Size, request: &Request<'_>) -> Result<Layout, Error> {
        let (fit, plan) = (&request.fit, request.plan);
        let least = plan.profile().figure.min_side;
        let below = self.title.as_ref().and_then(|title| fit.layout_below(size, plan, Some(title.params)).ok());
        match below.filter(|layout| layout.figure.width().min(layout.figure.height()) >= least) {
            Some(layout) => Ok(layout),
            None => fit.layout(size, plan),
        }
    }

    /// The words where they stand on the sheet.
    pub(super) fn on(&self, layout: &Layout) -> Vec<BrailleText> {
        let (Some(title), Some(heading)) = (&self.title, &layout.heading) else { return Vec::new() };
        let unicode = |line: Vec<u8>| Braille { cells: line, ..Braille::default() }.unicode();
        let diameter = CellGrid::of(&layout.medium, title.params.cell).diameter;
        vec![BrailleText {
            role: TextRole::Title,
            text: title.text.clone(),
            language: self.language.clone(),
            lines: heading.lines(&title.braille).into_iter().map(unicode).collect(),
            dots: Dots { diameter, at: heading.dots(&title.braille, &layout.medium) },
        }]
    }

    /// What is told of words that have no room.
    pub(super) fn left_out(&self, layout: &Layout) -> Option<Note> {
        self.title
            .as_ref()
            .filter(|_| layout.heading.is_none())
            .map(|title| Note::NoRoomForTitle { cells: title.braille.cells.len() })
    }
}
