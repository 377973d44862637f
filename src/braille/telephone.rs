//! Telephone numbers and ISBNs, of which spaces part the groups of one number.

/// Fewest digits of a telephone number with its code; dates have eight at most, and no zero before a year.
const FEWEST_DIGITS: usize = 9;
/// Digits of an ISBN, which begins with 978 or 979.
const DIGITS_OF_ISBN: usize = 13;
/// Most digits of a telephone number (ITU-T E.164, section 6), and most characters of one with a space after each: what
/// is longer is a list of numbers, and is not looked at any further.
const MOST_DIGITS: usize = 15;
const MOST_CHARACTERS: usize = 2 * MOST_DIGITS - 1;
/// English words directly before a number that say that it is one of a telephone.
const MARKERS: [&str; 5] = ["tel", "telephone", "phone", "mobile", "fax"];
/// Words that may stand between the two, as in "phone no. 555 123 4567"; all are looked for in so many characters.
const BETWEEN: [&str; 2] = ["no", "number"];
const CHARACTERS_BEFORE: usize = 24;

/// Whether the space at `i` parts groups of a telephone number, as in 020 7946 0018: one that begins with a zero before
/// other digits, with a plus or with a code in brackets, or that is called one and is of groups as in North America
/// (Tel. 555 123 4567); or of an ISBN. It has at least so many digits in all.
///
/// Three numbers of a list may have the lengths of such groups, so that these alone say nothing.
pub(super) fn is_in_number(text: &[char], i: usize) -> bool {
    let is_of_number = |at: usize| {
        let is_digit = |at: Option<usize>| at.and_then(|at| text.get(at)).is_some_and(char::is_ascii_digit);
        is_digit(Some(at)) || text[at] == ' ' && is_digit(at.checked_sub(1)) && is_digit(Some(at + 1))
    };
    let first = i.saturating_sub(MOST_CHARACTERS);
    let from = (first..i).rev().take_while(|&at| is_of_number(at)).last().unwrap_or(i);
    let letters = (from..text.len()).take(MOST_CHARACTERS + 1).take_while(|&at| is_of_number(at));
    let number: Vec<char> = letters.map(|at| text[at]).collect();
    let groups: Vec<usize> = number.split(|letter| *letter == ' ').map(<[char]>::len).collect();
    let digits: usize = groups.iter().sum();
    let before = &text[..from];
    let code = code_in_brackets(before);
    let begins = || {
        let is_international = before.ends_with(&['+']);
        let has_zero = number.starts_with(&['0']) && number.get(1).is_some_and(char::is_ascii_digit);
        let has_code = code.starts_with(&['0']) || code.len() == 3 && groups == [3, 4];
        let is_isbn =
            digits == DIGITS_OF_ISBN && (number.starts_with(&['9', '7', '8']) || number.starts_with(&['9', '7', '9']));
        is_international || has_zero || has_code || is_isbn || groups == [3, 3, 4] && is_called_one(before)
    };
    // a list of hours has none of three
    let has_long = groups.iter().any(|group| *group >= 3) || is_in_pairs(&number, &groups);
    let is_as_long = code.len() + digits >= FEWEST_DIGITS && digits <= MOST_DIGITS;
    is_of_number(i) && has_long && is_as_long && begins()
}

/// Whether a number is five pairs of digits, as in France (01 44 49 35 35). Pairs in even steps are a list.
fn is_in_pairs(number: &[char], groups: &[usize]) -> bool {
    let value =
        |pair: &[char]| pair.iter().filter_map(|digit| digit.to_digit(10)).fold(0, |sum, digit| 10 * sum + digit);
    let pairs: Vec<u32> = number.split(|letter| *letter == ' ').map(value).collect();
    let is_list = pairs.windows(3).all(|of| of[1] + of[1] == of[0] + of[2]);
    *groups == [2; 5] && number.starts_with(&['0']) && !is_list
}

/// Whether the last word of a text calls what follows the number of a telephone.
fn is_called_one(before: &[char]) -> bool {
    let near: String = before[before.len().saturating_sub(CHARACTERS_BEFORE)..].iter().collect();
    let near = near.to_lowercase();
    let mut words = near.split(|letter: char| !letter.is_alphabetic()).filter(|word| !word.is_empty()).rev().peekable();
    words.next_if(|word| BETWEEN.contains(word));
    words.next().is_some_and(|word| MARKERS.contains(&word))
}

/// The digits of a code in brackets at the end of a text, as before the rest of (212) 555 0199; none without one.
fn code_in_brackets(text: &[char]) -> &[char] {
    let [before @ .., ')', ' '] = text else { return &[] };
    let count = before.iter().rev().take_while(|digit| digit.is_ascii_digit()).count();
    let (before, code) = before.split_at(before.len() - count);
    if before.ends_with(&['(']) { code } else { &[] }
}

#[cfg(test)]
mod tests;
