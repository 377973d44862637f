//! What is told of words that cannot be written in braille.

use crate::braille::{Braille, Lacking, Translator, is_formula, is_greek, is_of_formula, is_script};
use crate::listing::first_few;
use crate::note::{About, Note, Reason};

/// A title in braille, and what is told of it. A letter that the code has no cells for is left out of it; a formula
/// that would lose a sign is not written at all, as a label is not.
pub(super) fn title(text: &str, translator: &Translator<'_>) -> (Option<Braille>, Vec<Note>) {
    let not_written = |why: String| Note::NotTranslated { texts: vec![text.to_owned()], why };
    let braille = match translator.translate(text) {
        Ok(braille) => braille,
        Err(why) => return (None, vec![not_written(why)]),
    };
    let mut lacks = Lacks::default();
    lacks.add(text, &braille.lacking);
    let mut notes: Vec<Note> = lacks.note().into_iter().collect();
    if braille.lacking.iter().any(|lacking| is_of_formula(lacking.character) && !is_in_greek_word(text, lacking.at)) {
        notes.push(not_written(FORMULA.to_owned()));
        return (None, notes);
    }
    notes.extend(told_otherwise(&[text], translator));
    ((!braille.cells.is_empty()).then_some(braille), notes)
}

/// What is told of texts that are written, but not as they stand in print.
pub(super) fn told_otherwise(texts: &[&str], translator: &Translator<'_>) -> Vec<Note> {
    let told = [on_line(texts, translator), in_other_letters(texts, translator), sign_by_sign(texts, translator)];
    told.into_iter().flatten().collect()
}

/// What has no room at the top of a sheet, or of one of several.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct NoRoomAbove {
    /// The cells of the title, if that has none.
    pub(super) title: Option<usize>,
    /// Whether the page number has none.
    pub(super) number: bool,
}

impl NoRoomAbove {
    /// The same, or what `other` has no room for.
    pub(super) fn or(self, other: Self) -> Self {
        Self { title: self.title.or(other.title), number: self.number || other.number }
    }

    /// What is told of it where the title stands in the key, or is nowhere.
    pub(super) fn told(self, in_key: bool) -> impl Iterator<Item = Note> {
        let title = self.title.map(|cells| Note::NoRoomForTitle { cells, in_key });
        title.into_iter().chain(self.number.then_some(Note::NoRoomForNumber))
    }
}

/// Why a title is not written.
const FORMULA: &str = "without signs that its code has no cells for it would say something else";

/// Whether the character of this number, from 1, is one of three Greek letters and more: those of a word, not of a
/// formula.
fn is_in_greek_word(text: &str, at: usize) -> bool {
    let letters: Vec<char> = text.chars().collect();
    let (before, after) = letters.split_at(at.saturating_sub(1).min(letters.len()));
    let of_word = |letter: &&char| is_greek(**letter);
    let count = before.iter().rev().take_while(of_word).count() + after.iter().take_while(of_word).count();
    after.first().is_some_and(|letter| is_greek(*letter)) && count >= 3
}

/// Tells of texts some of whose characters are written in others.
fn in_other_letters(texts: &[&str], translator: &Translator<'_>) -> Option<Note> {
    let mut characters: Vec<char> = Vec::new();
    let mut named_texts: Vec<&str> = Vec::new();
    for text in texts.iter().filter(|text| !text.is_ascii()) {
        let simplified = translator.translate(text).map_or(Vec::new(), |braille| braille.simplified);
        if !simplified.is_empty() && !named_texts.contains(text) {
            named_texts.push(text);
        }
        for character in simplified {
            if !characters.contains(&character) {
                characters.push(character);
            }
        }
    }
    let which: Vec<String> = characters.iter().map(|character| format!("\u{2018}{character}\u{2019}")).collect();
    let told = || {
        let what = format!(
            "written in braille by other letters or signs, without accents, as its table has no cells for {}: {}",
            which.join(", "),
            named(&named_texts)
        );
        Note::TakenAs(About::Braille, Reason::OtherLetters, what.into())
    };
    (!named_texts.is_empty()).then(told)
}

/// Tells of texts whose lowered or raised numbers stand on the line.
fn on_line(texts: &[&str], translator: &Translator<'_>) -> Option<Note> {
    let is_on_line = |text: &&&str| translator.translate(text).is_ok_and(|braille| braille.has_script_on_line);
    let has_script = |text: &&&str| text.contains(is_script);
    let mut named_texts: Vec<&str> = Vec::new();
    for text in texts.iter().filter(has_script).filter(is_on_line) {
        if !named_texts.contains(text) {
            named_texts.push(text);
        }
    }
    let what = "lowered and raised numbers stand on the line in braille, as in H2O, since this table has no other \
                cells for them";
    let told =
        || Note::TakenAs(About::Braille, Reason::NumbersOnLine, format!("{what}: {}", named(&named_texts)).into());
    (!named_texts.is_empty()).then(told)
}

/// Tells of formulas that our table writes sign by sign, where a mathematical code has rules: of roots, powers and
/// indices beside operators, and fractions with brackets. Another translator may have such a code.
fn sign_by_sign(texts: &[&str], translator: &Translator<'_>) -> Option<Note> {
    let mut formulas: Vec<&str> = Vec::new();
    for &text in texts {
        if translator.is_own() && is_formula(text) && !formulas.contains(&text) {
            formulas.push(text);
        }
    }
    let told = || {
        let what = "written in braille sign by sign, not by the rules of a mathematical code";
        Note::TakenAs(About::Braille, Reason::SignBySign, format!("{what}: {}", named(&formulas)).into())
    };
    (!formulas.is_empty()).then(told)
}

/// Texts with characters that their code has no cells for: told together.
#[derive(Debug, Default)]
pub(super) struct Lacks(Vec<(String, Vec<(char, usize)>)>);

impl Lacks {
    pub(super) fn add(&mut self, text: &str, of: &[Lacking]) {
        if !of.is_empty() && self.0.iter().all(|(known, _)| known != text) {
            self.0.push((text.to_owned(), of.iter().map(|lacking| (lacking.character, lacking.at)).collect()));
        }
    }

    pub(super) fn note(self) -> Option<Note> {
        let (texts, characters): (Vec<String>, Vec<_>) = self.0.into_iter().unzip();
        let mut lacking = Vec::new();
        for (character, at) in characters.into_iter().flatten() {
            if texts.len() == 1 || lacking.iter().all(|(known, _)| *known != character) {
                lacking.push((character, at));
            }
        }
        (!texts.is_empty()).then_some(Note::NotInBraille { texts, lacking })
    }
}

/// Names texts: all of up to five.
pub(super) fn named(texts: &[&str]) -> String {
    first_few(texts, 5, |text| format!("\"{text}\""))
}

/// Texts that a translator could not write, each with what it says: told once for each reason.
#[derive(Debug, Default)]
pub(super) struct RefusedTexts(Vec<(String, Vec<String>)>);

impl RefusedTexts {
    pub(super) fn add(&mut self, text: &str, why: String) {
        let at = self.0.iter().position(|(known, _)| *known == why).unwrap_or_else(|| {
            self.0.push((why, Vec::new()));
            self.0.len() - 1
        });
        if let Some((_, texts)) = self.0.get_mut(at)
            && !texts.iter().any(|known| known == text)
        {
            texts.push(text.to_owned());
        }
    }

    pub(super) fn notes(self) -> impl Iterator<Item = Note> {
        self.0.into_iter().map(|(why, texts)| Note::NotTranslated { texts, why })
    }
}

#[cfg(test)]
mod tests;
