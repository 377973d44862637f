//! What is told of words that cannot be written in braille.

use crate::Note;
use crate::braille::Lacking;

/// What is told of characters that the code has no cells for.
pub(super) fn lacking(text: &str, lacking: &[Lacking]) -> Option<Note> {
    let characters = lacking.iter().map(|lacking| (lacking.character, lacking.at)).collect();
    (!lacking.is_empty()).then(|| Note::NotInBraille { text: text.to_owned(), lacking: characters })
}

/// Texts with characters that their code has no cells for: told together.
#[derive(Debug, Default)]
pub(super) struct Lacks(Vec<(String, Vec<char>, Note)>);

impl Lacks {
    pub(super) fn add(&mut self, text: &str, of: &[Lacking]) {
        if let Some(note) = lacking(text, of).filter(|note| !self.0.iter().any(|(.., known)| known == note)) {
            self.0.push((text.to_owned(), of.iter().map(|lacking| lacking.character).collect(), note));
        }
    }

    pub(super) fn note(self) -> Option<Note> {
        if self.0.len() < 2 {
            return self.0.into_iter().map(|(.., note)| note).next();
        }
        let mut characters: Vec<char> = Vec::new();
        let all = self.0.iter().flat_map(|(_, characters, _)| characters);
        all.for_each(|character| {
            if !characters.contains(character) {
                characters.push(*character);
            }
        });
        let texts = self.0.into_iter().map(|(text, ..)| text).collect();
        Some(Note::NotInBrailleOfTexts { texts, lacking: characters })
    }
}

/// Names texts: all of up to five.
pub(super) fn named(texts: &[&str]) -> String {
    let named: Vec<String> = texts.iter().take(5).map(|text| format!("\"{text}\"")).collect();
    let more = if texts.len() > 5 { format!(" and {} more", texts.len() - 5) } else { String::new() };
    format!("{}{more}", named.join(", "))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_several_texts_lack_is_told_once() {
        let lacking = |character: char| [Lacking { character, at: 1 }];
        let mut lacks = Lacks::default();
        lacks.add("α = 39", &lacking('α'));
        lacks.add("α = 39", &lacking('α'));
        assert!(matches!(lacks.note(), Some(Note::NotInBraille { .. })), "one text");
        let mut lacks = Lacks::default();
        for (text, character) in [("α = 39", 'α'), ("β", 'β'), ("2α", 'α')] {
            lacks.add(text, &lacking(character));
        }
        lacks.add("apple", &[]);
        let told = lacks.note().expect("a note").to_string();
        let wanted = "left out of the braille of \"α = 39\", \"β\", \"2α\", as its code has no \
                      cells for them: 'α', 'β'; write them in words";
        assert!(told.starts_with(wanted), "{told}");
        assert_eq!(Lacks::default().note(), None);
    }
}
