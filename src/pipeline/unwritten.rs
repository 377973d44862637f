//! What is told of words that cannot be written in braille.

use crate::Note;
use crate::braille::Lacking;
use crate::listing::first_few;

/// What is told of characters that the code has no cells for.
pub(super) fn lacking(text: &str, lacking: &[Lacking]) -> Option<Note> {
    let mut lacks = Lacks::default();
    lacks.add(text, lacking);
    lacks.note()
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
