//! Numbers that stand higher or lower than the line, and those of an order, which some codes write with lowered digits.

use super::characters::is_raised_letter;
use super::joined::is_unit;
use super::table::{Ordinals, Script, Table};

/// What is written for characters from one on.
pub(super) struct Written {
    /// How many characters that are.
    pub(super) length: usize,
    pub(super) cells: Vec<u8>,
    /// Whether its last cell could go on as a number.
    pub(super) ends_in_digits: bool,
    /// Whether a lowered number is written as one on the line.
    pub(super) is_on_line: bool,
}

/// The raised or lowered number that begins at `i`. Where the code has none, lowered ones stand on the line, as H2O,
/// and raised ones behind a unit, as m2; elsewhere that would say something else.
pub(super) fn script(table: &Table, text: &[char], i: usize) -> Option<Written> {
    let number = |digit: fn(char) -> Option<u32>, from: usize| -> Vec<u32> {
        text[from..].iter().map_while(|&character| digit(character)).collect()
    };
    let is_negative = text[i] == RAISED_MINUS;
    let above = number(raised, i + usize::from(is_negative));
    let below = number(lowered, i);
    let (digits, script) = if above.is_empty() { (below, &table.subscript) } else { (above, &table.superscript) };
    if digits.is_empty() {
        return None;
    }
    let length = digits.len() + usize::from(is_negative);
    let Some(script) = script else {
        let is_known = lowered(text[i]).is_some() || is_of_unit(text, i, length);
        let cells = with_sign(table, &digits);
        return is_known.then_some(Written { length, cells, ends_in_digits: true, is_on_line: true });
    };
    let (before, after) = if is_negative { script.minus.as_ref()? } else { &(script.before.clone(), Vec::new()) };
    let mut cells = before.clone();
    cells.extend(of_digits(table, script, &digits));
    cells.extend(after);
    let ends_in_digits = script.digits.is_empty() && after.is_empty();
    Some(Written { length, cells, ends_in_digits, is_on_line: false })
}

/// The charge of an ion that begins at `i`, a raised sign perhaps with a number before it, if the code has such. A sum
/// or a negative number is none.
pub(super) fn charge(table: &Table, text: &[char], i: usize) -> Option<Written> {
    let charges = table.charges.as_ref()?;
    let digits: Vec<u32> = text[i..].iter().map_while(|&digit| raised(digit)).collect();
    let at = i + digits.len();
    let sign = match *text.get(at)? {
        RAISED_PLUS => charges.plus.as_slice(),
        RAISED_MINUS => charges.minus.as_slice(),
        _ => return None,
    };
    let goes_on = text.get(at + 1).is_some_and(|&next| next == RAISED_PLUS || raised_or_minus(next));
    let is_behind = i > 0 && (text[i - 1].is_alphanumeric() || matches!(text[i - 1], ')' | ']'));
    if goes_on || !is_behind {
        return None;
    }
    let cells = if digits.is_empty() {
        [charges.before_one.as_slice(), sign].concat()
    } else {
        let number = of_digits(table, table.superscript.as_ref()?, &digits);
        [charges.before.as_slice(), number.as_slice(), sign, charges.after.as_slice()].concat()
    };
    Some(Written { length: at + 1 - i, cells, ends_in_digits: false, is_on_line: false })
}

/// A raised or lowered sign without a number beside it, on the line: as in Na+.
pub(super) fn sign_on_line(before: Option<char>, sign: char, after: Option<char>) -> Option<char> {
    let on_line = match sign {
        RAISED_PLUS | LOWERED_PLUS => '+',
        RAISED_MINUS | LOWERED_MINUS => '\u{2212}',
        _ => return None,
    };
    let is_number = |beside: char| raised(beside).is_some() || lowered(beside).is_some();
    let is_alone = ![before, after].into_iter().flatten().any(is_number);
    is_alone.then_some(on_line)
}

/// A text with such signs on the line, and which these were.
pub(super) fn with_signs_on_line(text: &str) -> (String, Vec<char>) {
    let letters: Vec<char> = text.chars().collect();
    let at = |at: Option<usize>| at.and_then(|at| letters.get(at)).copied();
    let on_line = |i: usize| sign_on_line(at(i.checked_sub(1)), letters[i], at(Some(i + 1)));
    let signs = (0..letters.len()).filter(|&i| on_line(i).is_some()).map(|i| letters[i]).collect();
    ((0..letters.len()).map(|i| on_line(i).unwrap_or(letters[i])).collect(), signs)
}

/// The number of an order that begins at `i`, such as `1.\u{ba}`, if the code has such.
pub(super) fn ordinal(table: &Table, text: &[char], i: usize) -> Option<Written> {
    let Ordinals { digits } = table.ordinals.as_ref()?;
    let number: Vec<u32> = text[i..].iter().map_while(|digit| digit.to_digit(10)).collect();
    let has_point = text.get(i + number.len()) == Some(&'.');
    let at = i + number.len() + usize::from(has_point);
    let ending = match text.get(at)? {
        MASCULINE => 'o',
        FEMININE => 'a',
        _ => return None,
    };
    let mut cells = table.number.clone();
    cells.extend(number.iter().filter_map(|&digit| digits.get(digit as usize)));
    cells.extend(table.letters.get(&ending)?);
    (!number.is_empty()).then_some(Written { length: at + 1 - i, cells, ends_in_digits: false, is_on_line: false })
}

/// Whether a number stands higher or lower than the line.
pub fn is_script(character: char) -> bool {
    raised_or_minus(character) || lowered(character).is_some()
}

/// The number that signs say which are all raised, such as an exponent.
pub fn power(signs: &str) -> Option<i32> {
    let digits = signs.strip_prefix(RAISED_MINUS).unwrap_or(signs);
    let number: String = digits.chars().map(|sign| char::from_digit(raised(sign)?, 10)).collect::<Option<_>>()?;
    let number: i32 = number.parse().ok()?;
    Some(if digits.len() < signs.len() { -number } else { number })
}

const RAISED_PLUS: char = '\u{207a}';
const RAISED_MINUS: char = '\u{207b}';
const LOWERED_PLUS: char = '\u{208a}';
const LOWERED_MINUS: char = '\u{208b}';
const MASCULINE: &char = &'\u{ba}';
const FEMININE: &char = &'\u{aa}';

/// The sign of degrees where a raised o stands for it, as in 20 ºC: keyboards have the one and not the other.
pub(super) fn with_degrees(text: &mut [(char, usize)]) {
    for i in 0..text.len() {
        let mut after = text[i + 1..].iter().map(|(character, _)| *character).skip_while(|after| *after == ' ');
        let is_scale =
            matches!(after.next(), Some('C' | 'F')) && after.next().is_none_or(|after| !after.is_alphanumeric());
        if text[i].0 == *MASCULINE && is_scale {
            text[i].0 = '\u{b0}';
        }
    }
}

/// The point of times where a formula has one: signs of comparison say that a text is one.
pub(super) fn with_times(text: &mut [(char, usize)]) {
    let is_comparison = |(character, _): &(char, usize)| {
        matches!(character, '=' | '<' | '>' | '\u{2248}' | '\u{2260}' | '\u{2264}' | '\u{2265}' | '\u{221d}')
    };
    if text.iter().any(is_comparison) {
        text.iter_mut().filter(|(character, _)| *character == '\u{b7}').for_each(|(point, _)| *point = TIMES);
    }
}

pub(super) const TIMES: char = '\u{22c5}';

/// Whether raised letters around `i` end a number of an order or a word, such as 1\u{1d49}\u{02b3} or
/// XXI\u{1d49}: behind one small letter they could be a power.
pub(super) fn is_of_order(text: &[(char, usize)], i: usize) -> bool {
    let before = text[..i].iter().rev().map(|(character, _)| *character);
    let before: Vec<char> = before.skip_while(|&character| is_raised_letter(character)).take(2).collect();
    match before[..] {
        // of a Roman number, or of Mme
        [last, ..] if last.is_ascii_digit() || "IVXLCDM".contains(last) => true,
        [last, other] => last.is_alphabetic() && other.is_alphabetic(),
        _ => false,
    }
}

/// Whether characters from `i` on end a unit, such as km².
fn is_of_unit(text: &[char], i: usize, length: usize) -> bool {
    let letters = text[..i].iter().rev().take_while(|letter| letter.is_alphabetic() || **letter == '/').count();
    letters > 0 && is_unit(&text[i - letters..i + length])
}

fn of_digits(table: &Table, script: &Script, digits: &[u32]) -> Vec<u8> {
    if script.digits.is_empty() {
        return with_sign(table, digits);
    }
    digits.iter().filter_map(|&digit| script.digits.get(digit as usize)).copied().collect()
}

fn with_sign(table: &Table, digits: &[u32]) -> Vec<u8> {
    let digits = digits.iter().filter_map(|&digit| table.digits.get(digit as usize));
    table.number.iter().chain(digits).copied().collect()
}

fn raised_or_minus(character: char) -> bool {
    character == RAISED_MINUS || raised(character).is_some()
}

/// The digit that is raised.
fn raised(character: char) -> Option<u32> {
    Some(match character {
        '\u{b9}' => 1,
        '\u{b2}' => 2,
        '\u{b3}' => 3,
        '\u{2070}' | '\u{2074}'..='\u{2079}' => u32::from(character) - 0x2070,
        _ => return None,
    })
}

/// The digit that is lowered.
fn lowered(character: char) -> Option<u32> {
    matches!(character, '\u{2080}'..='\u{2089}').then(|| u32::from(character) - 0x2080)
}
