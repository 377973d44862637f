//! Abbreviations of two or three letters: from the letters of their text, no two the same to a finger, and none the
//! cells of a label of its own.

use std::collections::{BTreeMap, BTreeSet};

use super::placed::WrittenLabel;
use super::scale;
use crate::braille::{Braille, Lacking, Translator, characters};

/// An abbreviation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Short {
    pub(super) letters: String,
    pub(super) cells: Vec<u8>,
}

/// Most cells of an abbreviation: letters with accents may take two each.
const MOST_CELLS: usize = 3;

/// An abbreviation for each text; none for texts without two letters, which are short or numbers, and where all
/// are taken. The same text has the same one. Letters are spelled, also where texts are contracted, those that the
/// code lacks are passed over, and so are those that are a word by themselves, as "of", and "fr" for "friend" in
/// contracted English. `known` has the texts in braille, and `written` are on the page already.
pub(super) fn all(
    texts: &[&str],
    written: &[WrittenLabel],
    known: &BTreeMap<&str, Result<Braille, String>>,
    translator: &Translator<'_>,
) -> Vec<Option<Short>> {
    // labels as they are written, and as they would be spelled
    let whole = known.iter().flat_map(|(text, braille)| {
        // a formula may keep its letters and digits
        let is_short = text.chars().nth(MOST_CELLS).is_none() && formula(text).is_none();
        let spelled = is_short.then(|| translator.spell(&text.to_lowercase()).ok()).flatten();
        [braille.as_ref().ok().map(|braille| braille.cells.clone()), spelled.map(|braille| braille.cells)]
    });
    let on_page = written.iter().map(|label| label.cells.clone());
    let mut taken: BTreeSet<Vec<u8>> = whole.flatten().chain(on_page).collect();
    let as_written = |label: &WrittenLabel| {
        label.abbreviation.clone().map(|letters| Some(Short { letters, cells: label.cells.clone() }))
    };
    let mut of_text: BTreeMap<&str, Option<Short>> =
        written.iter().filter_map(|label| Some((label.text.as_str(), as_written(label)?))).collect();
    for &text in texts {
        if !of_text.contains_key(text) {
            // what cannot be written cannot be abbreviated either
            let written = known.get(text).and_then(|braille| braille.as_ref().ok());
            let numbered = texts.iter().find_map(|other| numbered(text, other));
            let quantity = written.and_then(|_| quantity(text, numbered.is_some()));
            // of a quantity without its minus sign it would be another one
            let numbered = numbered.filter(|_| quantity.is_none());
            let formula = written.and_then(|_| formula(text));
            let in_letters = written.filter(|_| quantity.is_none() && formula.is_none());
            let proposals = in_letters.map(|braille| proposals(&without(text, &braille.lacking), texts));
            let own_word = texts.iter().find_map(|other| own_word(text, other));
            let as_formula = formula.into_iter().flat_map(of_formula);
            let numbers = numbered.into_iter().chain(quantity.into_iter().flatten());
            let in_letters = proposals.into_iter().flatten();
            let all = own_word.into_iter().chain(as_formula).chain(numbers).chain(in_letters);
            let possible = all.filter_map(|letters| {
                let Braille { cells, lacking, .. } = translator.spell(&letters).ok()?;
                let is_whole = lacking.is_empty() && (2..=most_cells(&letters)).contains(&cells.len());
                (is_whole && !taken.contains(&cells)).then_some(Short { letters, cells })
            });
            let short = first_of_letters(possible, translator);
            taken.extend(short.iter().map(|short| short.cells.clone()));
            of_text.insert(text, short);
        }
    }
    texts.iter().map(|text| of_text.get(text).cloned().flatten()).collect()
}

/// Most cells of an abbreviation of these letters: more where it has a number.
fn most_cells(letters: &str) -> usize {
    let of_number = letters.chars().filter(|letter| is_of_number(*letter)).count();
    // a letter behind a number may have a sign before it
    let begins_with_number = usize::from(letters.starts_with(is_of_number) && of_number < letters.len());
    // a formula has two letters and the sign of its number
    let of_letters = letters.chars().filter(|letter| letter.is_alphabetic()).count();
    let is_formula = of_number > 0 && of_letters > 1 && letters.starts_with(char::is_alphabetic);
    // in English a minus sign has two cells
    let of_minus = 2 * letters.chars().filter(|letter| scale::is_minus(*letter)).count();
    MOST_CELLS + of_number.saturating_sub(1) + begins_with_number + usize::from(is_formula) + of_minus
}

/// Most proposals of which another translator is asked, which may be a process for each.
const MOST_ASKED: usize = 12;

/// The first of these that is read as its letters; the first of all where none is, as with a table that writes letters
/// in another way.
fn first_of_letters(possible: impl Iterator<Item = Short>, translator: &Translator<'_>) -> Option<Short> {
    let mut first = None;
    for short in possible.take(MOST_ASKED) {
        if translator.is_read_as_letters(&short.letters) {
            return Some(short);
        }
        first.get_or_insert(short);
    }
    first
}

/// Whether a character is one of a number: a digit, or the point or comma in one.
fn is_of_number(letter: char) -> bool {
    letter.is_ascii_digit() || matches!(letter, '.' | ',')
}

/// The numbers of a text, each as it is written.
fn numbers(text: &str) -> Vec<&str> {
    let parts = text.split(|letter| !is_of_number(letter)).map(|part| part.trim_matches(['.', ',']));
    parts.filter(|part| !part.is_empty()).collect()
}

/// Most digits of an abbreviation, with the point or comma of its number: that of a room or a year.
const MOST_DIGITS: usize = 4;

/// "c12" for "cup 12" beside "cup 1": the first letter, and the whole number by which it differs from another text
/// that is the same but for its numbers, as those of numbered things are. None where there is no letter, or the number
/// is long.
fn numbered(text: &str, other: &str) -> Option<String> {
    let letters = |text: &str| -> String { text.chars().filter(|letter| !is_of_number(*letter)).collect() };
    let (of_text, of_other) = (numbers(text), numbers(other));
    // a power without its exponent is another number
    let is_alike = of_text.len() == of_other.len() && letters(text) == letters(other) && !scale::is_power(text);
    let number = of_text.into_iter().zip(of_other).find(|(own, other)| is_alike && own != other)?.0;
    let letter = text.to_lowercase().chars().find(|letter| letter.is_alphabetic())?;
    (number.len() <= MOST_DIGITS).then(|| format!("{letter}{number}"))
}

/// "5a" for "Class 5a" beside "Class 6b": the one word by which it differs from another text, if that is a number with
/// letters behind it.
fn own_word(text: &str, other: &str) -> Option<String> {
    let words = |text: &str| -> Vec<String> { text.to_lowercase().split_whitespace().map(str::to_owned).collect() };
    let (of_text, of_other) = (words(text), words(other));
    let mut differ = of_text.iter().zip(&of_other).filter(|(own, other)| own != other).map(|(own, _)| own);
    let (own, next) = (differ.next()?, differ.next());
    let is_numbered = own.starts_with(|letter: char| letter.is_ascii_digit()) && own.ends_with(char::is_alphabetic);
    let is_alike = of_text.len() == of_other.len() && of_text.len() > 1 && next.is_none();
    let is_short = own.chars().count() < MOST_DIGITS && own.chars().all(char::is_alphanumeric);
    (is_alike && is_numbered && is_short).then(|| own.clone())
}

/// The letters and digits of a word that is a chemical formula with a number, as "co2" of CO2, perhaps with lowered
/// digits: symbols of elements, two letters and more, and digits behind some.
fn formula(text: &str) -> Option<String> {
    let digit = |letter: char| match letter {
        '\u{2080}'..='\u{2089}' => char::from_digit(u32::from(letter) - 0x2080, 10),
        _ => Some(letter),
    };
    let plain: String = text.chars().filter_map(digit).collect();
    let of_letters = |is_one: fn(&char) -> bool| plain.chars().filter(is_one).count();
    let (letters, digits) = (of_letters(char::is_ascii_alphabetic), of_letters(char::is_ascii_digit));
    let is_only_of_these = letters + digits == plain.chars().count();
    let begins_with_symbol = plain.starts_with(|letter: char| letter.is_ascii_uppercase());
    // the second letter of a symbol is a small one
    let pairs = || plain.chars().zip(plain.chars().skip(1));
    let are_symbols = pairs().all(|(before, after)| !after.is_ascii_lowercase() || before.is_ascii_uppercase());
    let has_number = pairs().any(|(before, after)| before.is_ascii_alphabetic() && after.is_ascii_digit());
    // the number of a room rather
    let has_long_number = pairs().any(|(before, after)| before.is_ascii_digit() && after.is_ascii_digit());
    let goes_on = pairs().any(|(before, after)| before.is_ascii_digit() && after.is_ascii_alphabetic());
    let is_written_so = is_only_of_these && begins_with_symbol && are_symbols && has_number;
    (letters > 1 && is_written_so && (goes_on || !has_long_number)).then(|| plain.to_lowercase())
}

/// Abbreviations of such a formula: all of it, else a letter twice, its first one before others. Two of its letters
/// would be another substance, as "co" is.
fn of_formula(formula: String) -> impl Iterator<Item = String> {
    let first = formula.chars().next();
    let letters = first.into_iter().chain('a'..='z');
    let twice: Vec<String> = letters.map(|letter| letter.to_string().repeat(2)).collect();
    std::iter::once(formula).chain(twice)
}

/// "100" or else "k100" for "100 km": an abbreviation of a quantity has its number, as the unit alone says nothing.
/// None for texts that are no quantity, or whose unit has no two letters, as those have none, unless another text
/// `is_alike`, of which the number tells it apart: "667" for "667 m" beside "34 m".
fn quantity(text: &str, is_alike: bool) -> Option<[String; 2]> {
    // in a key a blank parts an abbreviation from its text
    let number = scale::without_unit(text)?.replace(char::is_whitespace, "");
    let lower = text.to_lowercase();
    let mut letters = lower.chars().filter(|letter| letter.is_alphabetic());
    let letter = letters.next()?;
    let with_letter = format!("{letter}{number}");
    (is_alike || letters.next().is_some()).then_some([number, with_letter])
}

/// A text without the characters that its code lacks.
fn without(text: &str, lacking: &[Lacking]) -> String {
    let lacks = |at: usize| lacking.binary_search_by_key(&at, |lacking| lacking.at).is_ok();
    characters(text).into_iter().filter(|(_, at)| !lacks(*at)).map(|(letter, _)| letter).collect()
}

/// Abbreviations in the order in which they are read best: "nh" for "north hill", "ap" for "apple"; but among `others`
/// that they would fit as well, those of the first letter that tells the text apart: "jn" for "Jun" beside "Jul".
fn proposals(text: &str, others: &[&str]) -> impl Iterator<Item = String> + use<> {
    let words = words(text);
    let letters = letters(&words);
    let others: Vec<Vec<Vec<char>>> = others.iter().map(|other| self::words(other)).collect();
    let is_shared = |own: &String| others.iter().any(|other| *other != words && initials(other).as_ref() == Some(own));
    let initials = initials(&words).filter(|own| !is_shared(own));
    let from = first_telling(&letters, &others);
    let of_three = letters.clone().into_iter().take(MOST_LETTERS_OF_THREE).collect::<Vec<_>>();
    // the first letter with each that follows, then with each two
    let count = letters.len();
    let two = (from..count).chain(1..from.min(count)).map(move |i| [letters[0], letters[i]].iter().collect());
    let three = (1..of_three.len()).flat_map(move |i| {
        let of_three = of_three.clone();
        (i + 1..of_three.len()).map(move |j| [of_three[0], of_three[i], of_three[j]].iter().collect())
    });
    initials.into_iter().chain(two).chain(three)
}

/// The words of a text, without what is no letter.
fn words(text: &str) -> Vec<Vec<char>> {
    let lower = text.to_lowercase();
    let words = lower.split(|letter: char| !letter.is_alphabetic()).filter(|word| !word.is_empty());
    words.map(|word| word.chars().collect()).collect()
}

/// All letters of words, up to as many as abbreviations are made of.
fn letters(words: &[Vec<char>]) -> Vec<char> {
    words.iter().flatten().copied().take(MOST_LETTERS).collect()
}

/// The initials of two words or three.
fn initials(words: &[Vec<char>]) -> Option<String> {
    let initials: String = words.iter().take(3).filter_map(|word| word.first()).collect();
    (initials.chars().count() > 1).then_some(initials)
}

/// The first letter, counted from 0, by which a text differs from all others that begin with the same two letters and
/// more; the second where none does.
fn first_telling(own: &[char], others: &[Vec<Vec<char>>]) -> usize {
    let same = |other: &Vec<Vec<char>>| own.iter().zip(letters(other)).take_while(|(a, b)| **a == *b).count();
    others.iter().map(same).filter(|same| (2..own.len()).contains(same)).max().unwrap_or(1)
}

/// Most letters of a text that abbreviations of two are made of; the alphabet is not longer.
const MOST_LETTERS: usize = 40;
/// Most letters of a text that abbreviations of three are made of.
const MOST_LETTERS_OF_THREE: usize = 12;

#[cfg(test)]
mod tests;
