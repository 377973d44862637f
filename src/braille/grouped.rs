//! Numbers whose groups of digits print parts by blanks, as 12 000: in braille they are one number.

use super::joined;
use super::table::{Group, Table};
use super::telephone;

/// Whether the space at `i` parts groups of digits that a code joins.
pub(super) fn is_in_number(group: &Group, text: &[char], i: usize) -> bool {
    is_of_thousands(text, i) || !group.of_thousands_only && telephone::is_in_number(text, i)
}

/// Whether the space at `i` parts groups of three digits of one number.
fn is_of_thousands(text: &[char], i: usize) -> bool {
    let digits = |side: &mut dyn Iterator<Item = &char>| side.take_while(|letter| letter.is_ascii_digit()).count();
    let before = digits(&mut text[..i].iter().rev());
    (1..=3).contains(&before) && digits(&mut text[i + 1..].iter()) == 3
}

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
