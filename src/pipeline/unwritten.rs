//! What is told of words that cannot be written in braille.

use crate::Note;
use crate::braille::Lacking;

/// What is told of characters that the code has no cells for.
pub(super) fn lacking(text: &str, lacking: &[Lacking]) -> Option<Note> {
    let characters = lacking.iter().map(|lacking| (lacking.character, lacking.at)).collect();
    (!lacking.is_empty()).then(|| Note::NotInBraille { text: text.to_owned(), lacking: characters })
}

/// Texts that a translator could not write, each with what it says: told once for each reason.
#[derive(Debug, Default)]
pub(super) struct Refused(Vec<(String, Vec<String>)>);

impl Refused {
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
