//! In which forms a label can be written.

use super::abbreviate;
use crate::braille::{Lacking, Translator, wrap};

/// One form of a label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Form {
    pub(super) lines: Vec<Vec<u8>>,
    pub(super) lacking: Vec<Lacking>,
    /// What is written in place of the text.
    pub(super) abbreviation: Option<String>,
    /// What this form costs beside one in a single line: the millimetres that a label may lie further away for it.
    pub(super) cost: f32,
}

/// Labels longer than this are tried in two lines, cells.
const LONG: usize = 6;
/// What a second line costs.
const SECOND_LINE: f32 = 3.0;
/// What an abbreviation costs: more than any place within reach.
const ABBREVIATED: f32 = 1000.0;

/// The forms of each text; none of a text that cannot be written at all.
pub(super) fn of(texts: &[&str], translator: &Translator<'_>) -> Vec<Vec<Form>> {
    let short = abbreviate::all(texts);
    let of_text = |(text, short): (&&str, Option<String>)| {
        let braille = translator.translate(text).unwrap_or_default();
        let length = braille.cells.len();
        let form = |lines, abbreviation, cost| Form { lines, lacking: braille.lacking.clone(), abbreviation, cost };
        let mut forms = Vec::new();
        if length > 0 {
            forms.push(form(vec![braille.cells.clone()], None, 0.0));
        }
        if length > LONG {
            // as narrow as two lines can be
            let narrow = (1..length).map(|width| wrap(&braille, width)).find(|two| two.lines.len() == 2 && !two.cut);
            forms.extend(narrow.map(|two| form(two.lines, None, SECOND_LINE)));
        }
        forms.extend(short.and_then(|short| {
            let cells = translator.translate(&short).unwrap_or_default().cells;
            (!cells.is_empty() && cells.len() < length).then(|| form(vec![cells], Some(short), ABBREVIATED))
        }));
        forms
    };
    texts.iter().zip(short).map(of_text).collect()
}
