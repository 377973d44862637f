//! Numbers whose groups of digits print parts by blanks, as 12 000: in braille they are one number.

use std::iter::successors;

use super::joined::{self, DIGITS, digits};
use super::table::{Group, Table};
use super::telephone;

/// Whether the space at `i` parts groups of digits that a code joins.
pub(super) fn is_in_number(group: &Group, text: &[char], i: usize) -> bool {
    is_of_thousands(text, i) || !group.of_thousands_only && telephone::is_in_number(text, i)
}

/// Whether the space at `i` parts groups of three digits of one number, which begins with no zero. Of 0,5 100 the first
/// is a fraction. Beside another number, as in 10 100 1000, only noughts are surely groups.
fn is_of_thousands(text: &[char], i: usize) -> bool {
    if !parts_digits(text, i) {
        return false;
    }
    let is_next = |at: &usize| text.get(*at) == Some(&' ') && parts_digits(text, *at);
    let first = successors(Some(i), |at| at.checked_sub(1 + DIGITS).filter(is_next)).last().unwrap_or(i);
    let blanks: Vec<usize> = successors(Some(first), |at| Some(at + 1 + DIGITS).filter(is_next)).collect();
    let begin = first - digits(text[..first].iter().rev());
    let value =
        |digits: &[char]| digits.iter().filter_map(|digit| digit.to_digit(10)).fold(0, |sum, own| 10 * sum + own);
    let mut values = vec![value(&text[begin..first])];
    values.extend(blanks.iter().map(|at| value(&text[at + 1..=at + DIGITS])));
    let end = blanks.last().map_or(i, |at| at + 1 + DIGITS);
    let is_beside = begins_number(text[..begin].iter().rev()) || begins_number(text[end..].iter());
    let may_be_list = is_list(&values) || is_beside && values[1..].iter().any(|value| *value > 0);
    let is_fraction = first - begin < DIGITS && text[..begin].last().is_some_and(|before| matches!(before, ',' | '.'));
    !may_be_list && !is_fraction && text[begin] != '0'
}

/// Whether the values of groups are a list, as 100 200 300 or 50 100 200: they rise or fall, and all are round, or in
/// even steps. No number of a list has noughts before it, as the last groups of 1 002 003.
fn is_list(values: &[u32]) -> bool {
    let rise_or_fall = values.is_sorted_by(|a, b| a < b) || values.is_sorted_by(|a, b| a > b);
    let are_round = values.iter().all(|value| value % 5 == 0);
    let are_even = values[0] >= LEAST && values.windows(3).all(|of| of[1] + of[1] == of[0] + of[2]);
    values.len() > 2 && rise_or_fall && values[1..].iter().all(|value| *value >= LEAST) && (are_round || are_even)
}

/// Whether a space and a digit come first.
fn begins_number<'a>(mut letters: impl Iterator<Item = &'a char>) -> bool {
    letters.next() == Some(&' ') && letters.next().is_some_and(char::is_ascii_digit)
}

/// Whether the space at `i` stands behind one to three digits and before three.
fn parts_digits(text: &[char], i: usize) -> bool {
    joined::parts_digits(&text[..i], &text[i + 1..])
}

/// The least number of as many digits as a group has.
const LEAST: u32 = 100;

/// Whether a text has such a number, and its code leaves the blanks in it: as two lines it would be two numbers.
pub fn is_in_groups(text: &str, cells: &[u8]) -> bool {
    let words: Vec<&str> = text.split_whitespace().collect();
    let letters: Vec<char> = words.join(" ").chars().collect();
    let has_groups = (0..letters.len()).any(|at| letters[at] == ' ' && is_of_thousands(&letters, at));
    has_groups && cells.iter().filter(|cell| **cell == 0).count() + 1 == words.len()
}

/// The cells that another translator gives for a text, with the groups of its numbers joined as the table of its code
/// joins them: it may leave them numbers by themselves, each with the sign of one.
pub(super) fn join(table: &Table, text: &str, mut cells: Vec<u8>) -> Vec<u8> {
    let Some(group) = &table.group else { return cells };
    let letters: Vec<char> = text.chars().collect();
    let Some(blanks) = joined::blanks_of_spaces(&letters, &cells) else { return cells };
    let parting = blanks.into_iter().filter(|&(space, _)| is_in_number(group, &letters, space));
    for (_, blank) in parting.rev() {
        if cells[blank + 1..].starts_with(&table.number) {
            cells.splice(blank..=blank + table.number.len(), group.cells.iter().copied());
        }
    }
    cells
}

#[cfg(test)]
mod tests;
