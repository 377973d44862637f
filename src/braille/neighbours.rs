//! What stands beside a sign, by which codes choose how to write it.

use super::numbers::is_script;

/// What is on one side of a sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Blank,
    /// A space, and beyond it a digit.
    BlankThenDigit,
    Letter,
    Digit,
    /// A sign that what follows leans on, such as a bracket that opens.
    Opening,
    /// A sign that belongs to the number before it: of percent, degrees, a power or a fraction.
    OfNumber,
    Sign,
}

/// The neighbours of `text[from..to]`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours {
    left: Side,
    right: Side,
}

impl Neighbours {
    pub(super) fn of(text: &[char], from: usize, to: usize) -> Self {
        Self { left: left_of(text, from), right: right_of(text, to) }
    }

    /// Whether they are what a rule asks for.
    pub(super) fn fit(self, left: char, right: char) -> bool {
        let left = match left {
            '_' => matches!(self.left, Side::Blank | Side::BlankThenDigit | Side::Opening),
            // what closes a phrase stands where its last letter stood
            'a' => matches!(self.left, Side::Letter | Side::Sign | Side::OfNumber),
            '#' => self.left == Side::Digit,
            'n' => self.left == Side::BlankThenDigit,
            '%' => self.left == Side::OfNumber,
            _ => true,
        };
        let right = match right {
            '_' => matches!(self.right, Side::Blank | Side::BlankThenDigit | Side::Sign),
            'a' => matches!(self.right, Side::Letter | Side::Opening),
            '#' => self.right == Side::Digit,
            'n' => self.right == Side::BlankThenDigit,
            _ => true,
        };
        left && right
    }
}

fn left_of(text: &[char], from: usize) -> Side {
    let Some(&before) = text[..from].last() else { return Side::Blank };
    match before {
        ' ' => beyond(text[..from].iter().rev()),
        _ if before.is_alphabetic() => Side::Letter,
        _ if before.is_ascii_digit() => Side::Digit,
        // a quotation mark opens where nothing stands before it, whatever it looks like
        _ if QUOTATION_MARKS.contains(&before) => match left_of(text, from - 1) {
            Side::Letter | Side::Digit | Side::Sign | Side::OfNumber => Side::Sign,
            Side::Blank | Side::BlankThenDigit | Side::Opening => Side::Opening,
        },
        _ if OPENING.contains(&before) => Side::Opening,
        _ if OF_NUMBER.contains(&before) || is_script(before) => Side::OfNumber,
        _ => Side::Sign,
    }
}

fn right_of(text: &[char], to: usize) -> Side {
    let Some(&after) = text.get(to) else { return Side::Blank };
    match after {
        ' ' => beyond(text[to..].iter()),
        _ if after.is_alphabetic() => Side::Letter,
        _ if after.is_ascii_digit() => Side::Digit,
        // ... and closes where nothing stands behind it
        _ if QUOTATION_MARKS.contains(&after) => match right_of(text, to + 1) {
            Side::Letter | Side::Digit | Side::Opening => Side::Opening,
            Side::Blank | Side::BlankThenDigit | Side::Sign | Side::OfNumber => Side::Sign,
        },
        _ if OPENING.contains(&after) => Side::Opening,
        _ => Side::Sign,
    }
}

/// What a space leads to.
fn beyond<'a>(mut side: impl Iterator<Item = &'a char>) -> Side {
    match side.find(|&&letter| letter != ' ') {
        Some(letter) if letter.is_ascii_digit() => Side::BlankThenDigit,
        _ => Side::Blank,
    }
}

const QUOTATION_MARKS: [char; 12] = ['"', '\'', '„', '“', '”', '‚', '‘', '’', '«', '»', '‹', '›'];
const OPENING: [char; 11] = ['(', '[', '{', '¿', '¡', '-', '–', '—', '/', '=', '+'];
const OF_NUMBER: [char; 7] = ['%', '‰', '°', '½', '¼', '¾', '⅓'];
