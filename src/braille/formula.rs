//! What is more than basic arithmetic. Tables write it sign by sign; a mathematical code has rules of its own for it,
//! such as where a root or a power ends.

use super::joined::is_unit;
use super::numbers::is_script;

/// Signs of operations and comparisons between terms.
const OPERATORS: &str = "+=<>\u{2212}\u{d7}\u{f7}\u{b1}\u{2264}\u{2265}\u{2248}\u{2260}";
/// Strokes of fractions.
const STROKES: &str = "/\u{2044}\u{2215}\u{f7}";

/// Whether a text is more than basic arithmetic: it has a root, infinity, a sum or the like, a power or an index beside
/// an operator, or a fraction with an operation in brackets. A power of a unit behind its number is none, nor is the
/// index of a formula of chemistry.
pub fn is_formula(text: &str) -> bool {
    text.contains(is_higher) || has_script_beside_operator(text) || has_bracketed_fraction(text)
}

/// Whether a character is a sign of more than arithmetic: of logic, sets, derivatives, sums, roots or integrals. Those
/// of a diameter and of a difference stand in labels too.
fn is_higher(character: char) -> bool {
    matches!(
        character,
        '\u{2200}'..='\u{2204}'
            | '\u{2207}'..='\u{220d}'
            | '\u{220f}'..='\u{2211}'
            | '\u{221a}'..='\u{221c}'
            | '\u{221e}'
            | '\u{2227}'..='\u{2233}'
    )
}

/// Whether a character stands higher or lower: a digit, or one of the signs and letters of powers and indices.
fn is_raised_or_lowered(character: char) -> bool {
    is_script(character) || matches!(character, '\u{2071}' | '\u{207a}'..='\u{208e}' | '\u{2090}'..='\u{209c}')
}

fn is_operator(character: char) -> bool {
    OPERATORS.contains(character)
}

fn has_script_beside_operator(text: &str) -> bool {
    let terms: Vec<&str> =
        text.split(|c: char| c.is_whitespace() || is_operator(c)).filter(|term| !term.is_empty()).collect();
    let is_of_formula = |at: usize| {
        let term = terms[at];
        let unit = term.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | ','));
        let is_behind_number = unit.len() < term.len()
            || at.checked_sub(1).is_some_and(|before| terms[before].ends_with(|c: char| c.is_ascii_digit()));
        let is_measure = is_behind_number && is_unit(&unit.chars().collect::<Vec<_>>());
        term.contains(is_raised_or_lowered) && !is_measure && !is_of_chemistry(term)
    };
    text.contains(is_operator) && (0..terms.len()).any(is_of_formula)
}

/// Whether a term with indices only begins with a capital, as CO₂ does: what a finger reads as one name.
fn is_of_chemistry(term: &str) -> bool {
    let is_lowered = |c: char| matches!(c, '\u{2080}'..='\u{209c}');
    let has_name = term.chars().find(|c| c.is_alphabetic()).is_some_and(char::is_uppercase);
    has_name && term.chars().filter(|c| is_raised_or_lowered(*c)).all(is_lowered)
}

fn has_bracketed_fraction(text: &str) -> bool {
    text.char_indices().filter(|(_, c)| STROKES.contains(*c)).any(|(at, stroke)| {
        let (before, after) = (text[..at].trim_end(), text[at + stroke.len_utf8()..].trim_start());
        let above = before.strip_suffix(')').map(|before| inner(before.chars().rev(), [')', '(']));
        let below = after.strip_prefix('(').map(|after| inner(after.chars(), ['(', ')']));
        [above, below].into_iter().flatten().any(|inner| is_operation(&inner))
    })
}

/// What stands in brackets, read from one of them to the other.
fn inner(characters: impl Iterator<Item = char>, [open, close]: [char; 2]) -> Vec<char> {
    let mut depth = 1;
    let is_inside = |c: &char| {
        depth += i32::from(*c == open) - i32::from(*c == close);
        depth > 0
    };
    characters.take_while(is_inside).collect()
}

/// Whether there is an operation in this. A hyphen is one between terms of a letter or a number, not within words.
fn is_operation(inner: &[char]) -> bool {
    let has_word = inner.windows(2).any(|pair| pair.iter().all(|c| c.is_alphabetic()));
    inner.iter().any(|c| is_operator(*c)) || inner.contains(&'-') && !has_word
}

#[cfg(test)]
mod tests;
