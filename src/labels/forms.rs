//! In which forms a label can be written.

use std::collections::BTreeMap;

use super::abbreviate;
use super::placed::{Unplaced, WrittenLabel};
use crate::braille::{
    Braille, Divide, Lacking, Translator, in_two, in_two_at_any_blank, is_accent, is_in_groups, is_of_formula,
};
use crate::page::cells::CellGrid;
use crate::units::MmVector;

/// What a form of a label is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FormKind {
    /// The whole text in one line.
    OneLine,
    /// The same in two.
    TwoLines(Division),
    /// An abbreviation of two or three cells; a letter, or one twice, for a text without one in a cell of a table.
    Short,
    /// A single letter, as which only a whole row of labels is written.
    Letter,
    /// A number without its unit, of an axis where another number has it.
    Bare,
}

impl FormKind {
    /// Whether a label may be written so by itself, and not only with all of its row.
    pub(super) fn is_of_one(self) -> bool {
        matches!(self, Self::OneLine | Self::TwoLines(_) | Self::Short)
    }

    /// What it costs beside one line: the millimetres that a label may lie further away for it.
    pub(super) fn cost(self) -> f32 {
        match self {
            Self::OneLine => 0.0,
            Self::TwoLines(Division::BetweenWords) => SECOND_LINE,
            Self::TwoLines(Division::InWord) => DIVIDED,
            Self::TwoLines(Division::InEquation) => TORN,
            Self::Short => ABBREVIATED,
            Self::Letter => LETTER,
            Self::Bare => BARE,
        }
    }
}

/// Where a text is divided into two lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Division {
    /// Between two words that need not stay together.
    BetweenWords,
    /// In a word.
    InWord,
    /// In an equation, or between a number and its unit.
    InEquation,
}

/// One form of a label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Form {
    pub(super) lines: Vec<Vec<u8>>,
    /// What is written in place of the text.
    pub(super) abbreviation: Option<String>,
    pub(super) kind: FormKind,
}

impl Form {
    /// The box around its dots.
    pub(super) fn extent(&self, cells: &CellGrid<'_>) -> MmVector {
        cells.extent(self.lines.iter().map(Vec::len).max().unwrap_or(0), self.lines.len())
    }

    /// Whether it is the whole text in two lines that divide no word.
    pub(super) fn is_in_two_lines(&self) -> bool {
        matches!(self.kind, FormKind::TwoLines(Division::BetweenWords | Division::InEquation))
    }
}

/// What a label can be written as.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Forms {
    pub(super) forms: Vec<Form>,
    /// What its code has no cells for.
    pub(super) lacking: Vec<Lacking>,
}

/// Most characters of a label: as many as a sheet of braille has cells (25 lines of 40). Without a limit the key of one
/// text of a megabyte had a thousand sheets, and took two minutes and 8 GB.
pub const LONGEST: usize = 1000;
/// Labels longer than this are tried in two lines, cells.
const LONG: usize = 6;
/// What a second line costs.
const SECOND_LINE: f32 = 3.0;
/// What two lines cost that divide a word.
const DIVIDED: f32 = 15.0;
/// What two lines cost that tear an equation, or a number from its unit: more than any place within reach in one.
const TORN: f32 = 60.0;
/// What an abbreviation costs: more than any place within reach.
pub(super) const ABBREVIATED: f32 = 1000.0;
/// What a number costs whose unit another one has, mm: it is understood as well.
const BARE: f32 = 5.0;
/// What a letter costs: more than an abbreviation.
const LETTER: f32 = 1500.0;

/// The forms of each text, or why it has none. `written` labels are on the
/// page already.
pub(super) fn of(
    texts: &[&str],
    written: &[WrittenLabel],
    translator: &Translator<'_>,
) -> Vec<Result<Forms, Unplaced>> {
    let mut known: BTreeMap<&str, Result<Braille, String>> = BTreeMap::new();
    let is_too_long = |text: &str| text.chars().nth(LONGEST).is_some();
    for &text in texts.iter().filter(|text| !is_too_long(text)) {
        known.entry(text).or_insert_with(|| translator.translate(text));
    }
    let short = abbreviate::all(texts, written, &known, translator);
    let of_text = |(&text, short): (&&str, Option<abbreviate::Short>)| {
        let braille = match known.get(text) {
            None => return Err(Unplaced::TooLong),
            Some(Err(why)) => return Err(Unplaced::NotTranslated(why.clone())),
            Some(Ok(braille)) if braille.cells.is_empty() => return Err(Unplaced::NoCells(braille.lacking.clone())),
            Some(Ok(braille)) if braille.lacking.iter().any(|lacking| says_something(lacking.character)) => {
                return Err(Unplaced::Misleading(braille.lacking.clone()));
            }
            Some(Ok(braille)) => braille,
        };
        let length = braille.cells.len();
        let form = |lines, kind| Form { lines, abbreviation: None, kind };
        let two = |lines: [Vec<u8>; 2], division| form(lines.into(), FormKind::TwoLines(division));
        let mut forms = vec![form(vec![braille.cells.clone()], FormKind::OneLine)];
        if length > LONG {
            let whole = in_two(braille, Divide::Never);
            let divided = in_two(braille, Divide::Words).filter(|lines| Some(lines) != whole.as_ref());
            let is_whole = whole.is_some() || is_in_groups(text, &braille.cells);
            let torn = if is_whole { None } else { in_two_at_any_blank(braille) };
            forms.extend(torn.map(|lines| two(lines, Division::InEquation)));
            forms.extend(whole.map(|lines| two(lines, Division::BetweenWords)));
            forms.extend(divided.map(|lines| two(lines, Division::InWord)));
        }
        forms.extend(
            short
                .filter(|short| short.cells.len() < length)
                .map(|short| Form { abbreviation: Some(short.letters), ..form(vec![short.cells], FormKind::Short) }),
        );
        Ok(Forms { forms, lacking: braille.lacking.clone() })
    };
    texts.iter().zip(short).map(of_text).collect()
}

/// Takes away the lines that divide a word where one of the two would be a splinter: on a display, where few cells have
/// room, "An-" and "imals" take as much of it as an abbreviation with its blank, and are read no faster.
pub(super) fn without_splinters(forms: &mut [Result<Forms, Unplaced>]) {
    let is_divided = |form: &Form| form.kind == FormKind::TwoLines(Division::InWord);
    let is_splinter = |form: &Form| form.lines.iter().zip(FEWEST_OF_DIVIDED).any(|(line, fewest)| line.len() < fewest);
    for forms in forms.iter_mut().flatten() {
        // one without an abbreviation keeps them
        if forms.forms.iter().any(|form| form.kind == FormKind::Short) {
            forms.forms.retain(|form| !is_divided(form) || !is_splinter(form));
        }
    }
}

/// Fewest cells of the first line of a divided word, with its hyphen, and of the second. Chosen by us.
const FEWEST_OF_DIVIDED: [usize; 2] = [5, 4];

/// Whether a text says something else without this character: letters, numbers, signs of mathematics and currencies and
/// arrows do, ornaments and pictures do not.
fn says_something(character: char) -> bool {
    let is_sign = matches!(
        character,
        '%' | '*' | '/' | '&' | '#' | '@' | '^' | '~' | '|' | '$' | '£' | '¥' | '¢' | '§' | '°'
            | '\u{2030}'..='\u{2037}' | '\u{20a0}'..='\u{20cf}' | '\u{2190}'..='\u{21ff}' | '\u{27f0}'..='\u{27ff}'
            | '\u{2900}'..='\u{297f}'
    );
    // a letter without its accent is another letter
    is_sign || is_of_formula(character) || is_accent(character) || character.is_alphanumeric()
}

#[cfg(test)]
mod tests;
