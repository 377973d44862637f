//! Abbreviations of two or three letters: from the letters of their text, no two the same, and none a label of its own.

use std::collections::{BTreeMap, BTreeSet};

/// An abbreviation for each text; none for texts without two letters, which are short or numbers, and where all
/// are taken. The same text has the same one.
pub(super) fn all(texts: &[&str]) -> Vec<Option<String>> {
    let mut taken: BTreeSet<String> = texts.iter().map(|text| text.to_lowercase()).collect();
    let mut of_text: BTreeMap<&str, Option<String>> = BTreeMap::new();
    for &text in texts {
        if !of_text.contains_key(text) {
            let short = proposals(text).into_iter().find(|short| !taken.contains(short));
            taken.extend(short.clone());
            of_text.insert(text, short);
        }
    }
    texts.iter().map(|text| of_text.get(text).cloned().flatten()).collect()
}

/// Abbreviations in the order in which they are read best: "nh" for "north hill", "ap" for "apple".
fn proposals(text: &str) -> Vec<String> {
    let lower = text.to_lowercase();
    let words: Vec<Vec<char>> = lower
        .split(|letter: char| !letter.is_alphabetic())
        .filter(|word| !word.is_empty())
        .map(|word| word.chars().collect())
        .collect();
    let letters: Vec<char> = words.concat();
    let mut proposals = Vec::new();
    let initials: String = words.iter().take(3).filter_map(|word| word.first()).collect();
    if initials.chars().count() > 1 {
        proposals.push(initials);
    }
    if let Some((&first, rest)) = letters.split_first() {
        // the first letter with each that follows, then with each two
        proposals.extend(rest.iter().map(|letter| [first, *letter].iter().collect()));
        let rest = &rest[..rest.len().min(MOST_LETTERS)];
        for (i, second) in rest.iter().enumerate() {
            proposals.extend(rest[i + 1..].iter().map(|third| [first, *second, *third].iter().collect()));
        }
    }
    proposals
}

/// Most letters of a text that abbreviations of three are made of.
const MOST_LETTERS: usize = 12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn abbreviations_are_short_readable_and_unique() {
        let texts = ["Apple", "Apricot", "North Hill", "apple tree", "Apple", "1995", "ap", "X", "Aps"];
        let short = all(&texts);
        let short: Vec<&str> = short.iter().map(|short| short.as_deref().unwrap_or("-")).collect();
        // "ap" is a label of its own
        assert_eq!(short, ["al", "ar", "nh", "at", "al", "-", "-", "-", "as"]);
    }
}
