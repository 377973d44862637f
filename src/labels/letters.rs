//! Forms that only whole rows of labels have. Single letters for a row that has no room for abbreviations: the initials
//! of the months, which are known by their order, else those of the texts, or the alphabet. Numbers of an axis whose
//! unit stands with one of them.

use std::collections::{BTreeMap, BTreeSet};

use super::forms::{Form, FormKind, Forms};
use super::groups::{Group, GroupDirection, OF_AN_AXIS};
use super::placed::{Unplaced, Wanted};
use super::scale;
use crate::braille::Translator;

/// The initials of the months: in Dutch, English, French, German, Portuguese and Swedish, in Spanish, Italian, Polish
/// and Czech.
const MONTHS: [&str; 5] = ["jfmamjjasond", "efmamjjasond", "gfmamglasond", "slmkmclswplg", "lúbdkččszřlp"];

/// Gives each label of a row a letter as its last form, but for numbers that stay. Letters are no other label's cells.
pub(super) fn add(
    groups: &mut [Group],
    forms: &mut [Result<Forms, Unplaced>],
    wanted: &[Wanted],
    translator: &Translator<'_>,
) {
    let mut taken = taken_cells(forms);
    // a text has one letter on all of a page
    let mut given: BTreeMap<&str, (String, Vec<u8>)> = BTreeMap::new();
    // a few points that a person names may stand at one height by chance
    let is_row = |group: &Group| match group.lies {
        GroupDirection::Row => true,
        GroupDirection::BelowPoints => group.members.len() >= OF_AN_AXIS,
        GroupDirection::Column(_) => false,
    };
    for group in groups.iter_mut().filter(|group| is_row(group) && group.steps.is_none()) {
        let of_row: Vec<&str> = group.members.iter().map(|&label| wanted[label].text.as_str()).collect();
        let have_letters = group.members.iter().zip(scale::stay(&of_row)).filter(|(_, stays)| !stays);
        let members: Vec<usize> = have_letters.map(|(&label, _)| label).collect();
        let texts: Vec<&str> = members.iter().map(|&label| wanted[label].text.as_str()).collect();
        let spelled = |letter: char| spelled(&letter.to_string(), &taken, translator);
        let months: Option<Vec<(String, Vec<u8>)>> =
            initials_of_months(&texts).and_then(|letters| letters.into_iter().map(spelled).collect());
        group.is_of_months = initials_of_months(&texts).is_some() && (months.is_some() || given.contains_key(texts[0]));
        let known: Option<Vec<(String, Vec<u8>)>> = texts.iter().map(|text| given.get(text).cloned()).collect();
        let letters = match (known, months) {
            (Some(known), _) => known,
            (None, Some(months)) => months,
            (None, None) => {
                let all = |letters: &Vec<char>| letters.iter().map(|letter| spelled(*letter)).collect::<Option<_>>();
                let own = own_letters(&texts).iter().find_map(all);
                own.unwrap_or_else(|| ('a'..='z').filter_map(spelled).take(texts.len()).collect())
            }
        };
        if letters.len() < texts.len() {
            continue;
        }
        for (label, (letter, cells)) in members.into_iter().zip(letters) {
            taken.insert(cells.clone());
            given.insert(&wanted[label].text, (letter.clone(), cells.clone()));
            if let Ok(of) = &mut forms[label] {
                of.forms.push(Form { lines: vec![cells], abbreviation: Some(letter), kind: FormKind::Letter });
            }
        }
    }
}

/// Gives each of these labels of a table that has no abbreviation, such as a long number, a letter as its last form:
/// the key has what it stands for. Where a code reads a letter by itself as a word, as contracted English has "but" for
/// b, it is that letter twice, which takes no more cells than the sign of letters and one.
pub(super) fn add_to_alone(
    labels: impl Iterator<Item = usize>,
    forms: &mut [Result<Forms, Unplaced>],
    wanted: &[Wanted],
    translator: &Translator<'_>,
) {
    let is_long = |form: &Form| form.lines.iter().any(|line| line.len() > SHORT_ALONE);
    let is_whole = |form: &Form| form.abbreviation.is_none();
    let needs_one = |of: &Forms| of.forms.first().is_some_and(is_long) && of.forms.iter().all(is_whole);
    let labels: Vec<usize> = labels.filter(|&label| forms[label].as_ref().is_ok_and(needs_one)).collect();
    if labels.is_empty() {
        return; // another translator, which may be a process for each letter, is not asked
    }
    let taken = taken_cells(forms);
    let is_read = |letters: &String| translator.is_read_as_letters(letters);
    // an a is one dot, which by itself nobody takes for a letter
    let single: Vec<String> = ('b'..='z').map(String::from).collect();
    let is_any_word = !single.iter().all(is_read);
    let twice = ('b'..='z').filter(|_| is_any_word).map(|letter| letter.to_string().repeat(2)).filter(is_read);
    // rather one that may be misread than none
    let mut letters = twice.chain(single).filter_map(|letters| spelled(&letters, &taken, translator));
    let mut given: BTreeMap<&str, (String, Vec<u8>)> = BTreeMap::new();
    for label in labels {
        let Ok(of) = &mut forms[label] else { continue };
        let text = wanted[label].text.as_str();
        let Some((letter, cells)) = given.get(text).cloned().or_else(|| letters.next()) else { continue };
        given.insert(text, (letter.clone(), cells.clone()));
        of.forms.push(Form { lines: vec![cells], abbreviation: Some(letter), kind: FormKind::Short });
    }
}

/// The cells of all forms of labels: no letter has the same.
fn taken_cells(forms: &[Result<Forms, Unplaced>]) -> BTreeSet<Vec<u8>> {
    forms.iter().flatten().flat_map(|of| &of.forms).flat_map(|form| form.lines.clone()).collect()
}

/// Letters with their cells, if each has one and they are not taken.
fn spelled(letters: &str, taken: &BTreeSet<Vec<u8>>, translator: &Translator<'_>) -> Option<(String, Vec<u8>)> {
    let cells = translator.spell(letters).ok().filter(|braille| braille.lacking.is_empty())?.cells;
    (cells.len() == letters.chars().count() && !taken.contains(&cells)).then(|| (letters.to_owned(), cells))
}

/// A text of so few cells has no shorter form: an abbreviation has two or three.
const SHORT_ALONE: usize = 3;

/// Letters for the texts of a row that are no two the same, the best first: their initials; else texts that are a
/// letter keep it, and the others have letters of the alphabet.
fn own_letters(texts: &[&str]) -> Vec<Vec<char>> {
    let initial = |text: &&str| text.chars().next()?.to_lowercase().next().filter(char::is_ascii_lowercase);
    let initials: Option<Vec<char>> = texts.iter().map(initial).collect();
    let own: Vec<Option<char>> =
        texts.iter().map(|text| initial(text).filter(|_| text.chars().nth(1).is_none())).collect();
    let mut others = ('a'..='z').filter(|letter| !own.contains(&Some(*letter)));
    let mixed: Option<Vec<char>> = own.iter().map(|own| own.or_else(|| others.next())).collect();
    let differ = |letters: &Vec<char>| letters.iter().collect::<BTreeSet<_>>().len() == letters.len();
    initials.into_iter().chain(mixed).filter(differ).collect()
}

/// Gives each number of an axis its digits alone as its last form, if they have a unit.
pub(super) fn add_bare(
    groups: &[Group],
    forms: &mut [Result<Forms, Unplaced>],
    wanted: &[Wanted],
    translator: &Translator<'_>,
) {
    for &label in groups.iter().filter(|group| group.steps.is_some()).flat_map(|group| &group.members) {
        let bare = scale::without_unit(&wanted[label].text);
        let braille = bare.and_then(|bare| translator.translate(bare).ok());
        if let (Ok(of), Some(braille)) = (&mut forms[label], braille)
            && braille.lacking.is_empty()
        {
            of.forms.push(Form { lines: vec![braille.cells], abbreviation: None, kind: FormKind::Bare });
        }
    }
}

/// The initials of twelve texts that are the months, from whichever on.
fn initials_of_months(texts: &[&str]) -> Option<Vec<char>> {
    let initial = |text: &&str| {
        let is_word = text.chars().take(2).all(char::is_alphabetic);
        text.chars().next().filter(|_| is_word)?.to_lowercase().next()
    };
    let initials: Vec<char> = texts.iter().map(initial).collect::<Option<_>>()?;
    let written: String = initials.iter().collect();
    let is_year = |months: &&str| initials.len() == 12 && months.repeat(2).contains(&written);
    MONTHS.iter().any(is_year).then_some(initials)
}

#[cfg(test)]
mod tests;
