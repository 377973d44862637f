//! Text to cells, by the table of a code.

use super::address;
use super::capitals::{self, CapitalContext};
use super::characters::{characters, is_accent, is_raised_letter, on_line, simpler};
use super::divide;
use super::grouped;
use super::joined;
use super::neighbours::Neighbours;
use super::numbers::{self, Written};
use super::quotes;
use super::table::{AfterNumber, Group, SignRule, Table};

/// A text in braille.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Braille {
    /// Its cells; 0 is a blank.
    pub cells: Vec<u8>,
    /// Behind which cells a line can end although no blank follows, in order: hyphens in words.
    pub breaks: Vec<usize>,
    /// Behind which cells a word can be divided, with a hyphen at the end of the line, in order.
    pub divisions: Vec<usize>,
    /// Behind which cells an address can be divided, with the sign at the end of the line that says so, in order.
    pub continued: Vec<(usize, u8)>,
    /// Blanks at which no line ends, as within an equation, in order.
    pub joined: Vec<usize>,
    /// What the code has no cells for, and is left out.
    pub lacking: Vec<Lacking>,
    /// Whether lowered or raised numbers are written as those on the line, since the code has no other way.
    pub has_script_on_line: bool,
    /// Characters that are written in others, as the code has none for them: letters without their accents, a fraction
    /// by its numbers.
    pub simplified: Vec<char>,
}

/// A character that a code has no cells for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lacking {
    /// The character.
    pub character: char,
    /// Which of the text's characters it is, from 1.
    pub at: usize,
}

impl Braille {
    /// The cells as Unicode braille.
    pub fn unicode(&self) -> String {
        unicode(&self.cells)
    }
}

/// Cells as Unicode braille.
pub fn unicode(cells: &[u8]) -> String {
    cells.iter().filter_map(|&cell| char::from_u32(0x2800 + u32::from(cell))).collect()
}

impl Table {
    /// A text in this code. Spaces at its ends fall out, and several are one. What the code has no cells for is written
    /// in other characters that say nearly the same; where there are none, it is as if it were not there: no sign of a
    /// capital is left of it, and words beside it are written as they are without it.
    pub fn translate(&self, text: &str) -> Braille {
        let mut text = plain(characters(text));
        numbers::with_degrees(&mut text);
        numbers::with_times(&mut text);
        if self.pairs_straight_quotes {
            quotes::paired(&mut text);
        }
        let (mut lacking, mut simplified): (Vec<Lacking>, Vec<char>) = (Vec::new(), Vec::new());
        loop {
            let braille = self.write(&text);
            if braille.lacking.is_empty() {
                lacking.sort_by_key(|lacking| lacking.at);
                return Braille { lacking, simplified, ..braille };
            }
            let is_lacking = |character: char, at: usize| {
                braille.lacking.iter().any(|lacking| lacking.at == at && lacking.character == character)
            };
            let mut without: Vec<(char, usize)> = Vec::with_capacity(text.len());
            for (i, &(character, at)) in text.iter().enumerate() {
                if !is_lacking(character, at) {
                    without.push((character, at));
                    continue;
                }
                let is_written = |&(letter, at): &(char, usize)| !is_lacking(letter, at);
                match self.in_others(&text, i, is_written) {
                    Some(others) => {
                        simplified.push(character);
                        without.extend(others.chars().map(|other| (other, at)));
                    }
                    // as the text has it
                    None if character == numbers::TIMES => lacking.push(Lacking { character: '\u{b7}', at }),
                    None => lacking.push(Lacking { character, at }),
                }
            }
            text = plain(without);
        }
    }

    /// A text in which each hyphen before a number that this table writes as the sign of minus is that sign, for
    /// another translator, which may leave it a hyphen. Two hyphens stay two.
    pub(super) fn with_minus(&self, text: &str) -> String {
        let letters: Vec<char> = text.chars().collect();
        let minus = self.signs.get(&MINUS.to_string());
        let writer = Writer { table: self, text: &letters, out: Braille::default(), number: Number::None };
        let is_as_minus = |(length, rule, _): (usize, &SignRule, &[SignRule])| {
            let is_before_number = length == 1 && rule.left == '_' && rule.right == '#';
            is_before_number && minus.into_iter().flatten().any(|minus| minus.cells == rule.cells)
        };
        let is_minus = |i: usize| {
            let is_hyphen = matches!(letters[i], '-' | '\u{2010}') && (i == 0 || letters[i - 1] != letters[i]);
            is_hyphen && writer.sign(i).is_some_and(is_as_minus)
        };
        (0..letters.len()).map(|i| if is_minus(i) { MINUS } else { letters[i] }).collect()
    }

    /// The character at `i` in others that this code has; an accent falls away where its letter `is_written`.
    fn in_others(
        &self,
        text: &[(char, usize)],
        i: usize,
        is_written: impl Fn(&(char, usize)) -> bool,
    ) -> Option<String> {
        let (character, at) = text[i];
        if is_accent(character) {
            let mut before = text[..i].iter().rev().take_while(|(_, of)| *of == at);
            let letter = before.find(|(letter, _)| !is_accent(*letter))?;
            return (letter.0.is_alphabetic() && is_written(letter)).then(String::new);
        }
        let beside = |at: Option<usize>| at.and_then(|at| text.get(at)).map(|(character, _)| *character);
        let sign = numbers::sign_on_line(beside(i.checked_sub(1)), character, beside(Some(i + 1)));
        let others = if is_raised_letter(character) {
            numbers::is_of_order(text, i).then(|| on_line(character)).flatten()?.to_string()
        } else {
            sign.map(String::from).or_else(|| simpler(character))?
        };
        let has = |other: char| {
            let is_letter = small(other).is_some_and(|small| self.letters.contains_key(&small));
            let sign = other.to_string();
            let is_sign = |sign: &str| self.signs.contains_key(sign);
            other.is_ascii_digit() || other == ' ' || is_letter || is_sign(&sign) || same_as(&sign).is_some_and(is_sign)
        };
        // a fraction behind a whole number is not to be read as its digits
        let follows_digit = i > 0 && text[i - 1].0.is_ascii_digit();
        let parted = if follows_digit && others.contains('/') { format!(" {others}") } else { others };
        parted.chars().all(has).then_some(parted)
    }

    /// A text in which what the code has as a sign is no capital letter: its cells say that it is one.
    fn without_signs(&self, text: &[char]) -> Vec<char> {
        let has = |sign: &str| self.signs.contains_key(sign);
        let is_sign = |letter: char| {
            let sign = letter.to_string();
            letter.is_uppercase() && (has(&sign) || same_as(&sign).is_some_and(has))
        };
        text.iter().map(|&letter| if is_sign(letter) { NO_LETTER } else { letter }).collect()
    }

    fn write(&self, text: &[(char, usize)]) -> Braille {
        let (text, places): (Vec<char>, Vec<usize>) = text.iter().copied().unzip();
        let around = match &self.capitals {
            Some(capitals) => capitals::signs(&self.without_signs(&text), capitals),
            None => vec![CapitalContext::default(); text.len()],
        };
        let (before_address, addresses) = (self.address.as_deref().unwrap_or_default(), address::places(&text));
        let mut divisions = divide::places(&text, self.language).into_iter().peekable();
        let mut joined = joined::spaces(&text).into_iter().peekable();
        let mut out = Writer { table: self, text: &text, out: Braille::default(), number: Number::None };
        let (mut i, mut is_in_address) = (0, false);
        while i < text.len() {
            is_in_address = is_in_address && text[i] != ' ' || addresses.contains(&i);
            while divisions.next_if(|&at| at <= i).is_some_and(|at| at == i) {
                // a hyphen there would be one of the address
                out.out.divisions.extend((!is_in_address).then_some(out.out.cells.len()));
            }
            if addresses.contains(&i) {
                out.out.cells.extend(before_address);
            }
            if let Some(cells) = self.in_address.get(&text[i]).filter(|_| is_in_address) {
                out.out.cells.extend(cells);
                out.number = Number::None;
                i += 1;
                continue;
            }
            out.out.cells.extend(&around[i].before);
            while joined.next_if(|&at| at <= i).is_some_and(|at| at == i) {
                out.out.joined.push(out.out.cells.len());
            }
            let breaks = out.out.breaks.len();
            let read = out.character(i, places[i], &around[i]);
            let last = (i + read).min(text.len()) - 1;
            out.out.cells.extend(&around[last].after);
            if let Some(sign) = self.continuation.filter(|_| is_in_address) {
                out.out.breaks.truncate(breaks);
                let is_place = !text[last].is_alphanumeric() && text.get(last + 1).is_some_and(|c| c.is_alphanumeric());
                out.out.continued.extend(is_place.then_some((out.out.cells.len(), sign)));
            }
            i += read;
        }
        while out.out.cells.last() == Some(&0) {
            out.out.cells.pop();
        }
        out.out
    }
}

/// The characters of a text with their places in it, from 1: one space for any white space, none at the ends. What is
/// never seen is left out.
fn plain(text: Vec<(char, usize)>) -> Vec<(char, usize)> {
    let mut plain: Vec<(char, usize)> = Vec::new();
    for (character, at) in text {
        let character = if character.is_whitespace() { ' ' } else { character };
        let is_unseen = matches!(character, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}');
        let is_more_space = character == ' ' && plain.last().is_none_or(|last| last.0 == ' ');
        if !is_unseen && !is_more_space {
            plain.push((character, at));
        }
    }
    while plain.last().is_some_and(|last| last.0 == ' ') {
        plain.pop();
    }
    plain
}

struct Writer<'t> {
    table: &'t Table,
    text: &'t [char],
    out: Braille,
    number: Number,
}

/// What the cells so far end in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Number {
    None,
    /// Digits, and digits that follow need no number sign.
    GoesOn,
    /// Digits of a number that is at its end, such as a power.
    Ended,
}

impl<'t> Writer<'t> {
    /// Writes what begins at `i`; gives how many characters that was.
    fn character(&mut self, i: usize, place: usize, around: &CapitalContext) -> usize {
        let (table, character) = (self.table, self.text[i]);
        if character == ' ' {
            self.space(i);
            return 1;
        }
        if let Some(digit) = character.to_digit(10) {
            if self.number != Number::GoesOn {
                if let Some(written) = numbers::ordinal(table, self.text, i) {
                    return self.put(&written);
                }
                self.out.cells.extend(&table.number);
            }
            self.number = Number::GoesOn;
            self.out.cells.extend(table.digits.get(digit as usize));
            return 1;
        }
        if let Some(written) = numbers::charge(table, self.text, i).or_else(|| numbers::script(table, self.text, i)) {
            return self.put_higher(written);
        }
        if let Some((length, rule, rules)) = self.sign(i) {
            if rule.joins_left && self.out.cells.last() == Some(&0) {
                self.out.cells.pop();
            }
            self.out.cells.extend(&rule.cells);
            // a point between a digit and a letter is that of a number to a finger
            let may_go_on =
                self.number == Number::GoesOn && rules.iter().any(|other| other.in_number && other.cells == rule.cells);
            self.number = if may_go_on && !rule.in_number { Number::Ended } else { after_sign(rule, table) };
            if is_hyphen_in_word(self.text, i) {
                self.out.breaks.push(self.out.cells.len());
            }
            let drops_space = rule.joins_right && self.text.get(i + length) == Some(&' ');
            return length + usize::from(drops_space);
        }
        // a cell that is written as such stands for itself; there is no room for the lower two dots of eight
        if let '\u{2800}'..='\u{283f}' = character {
            self.out.cells.push((u32::from(character) - 0x2800) as u8);
            self.number = Number::None;
            return 1;
        }
        let small = small(character);
        match small.and_then(|small| table.letters.get(&small)) {
            Some(cells) => {
                self.after_number(character, around);
                self.out.cells.extend(cells);
            }
            None => self.out.lacking.push(Lacking { character, at: place }),
        }
        self.number = Number::None;
        1
    }

    /// Writes a number that is raised, lowered or of an order; gives how many characters it has.
    fn put(&mut self, written: &Written) -> usize {
        self.out.cells.extend(&written.cells);
        self.out.has_script_on_line |= written.is_on_line;
        self.number = if written.ends_in_digits { Number::Ended } else { Number::None };
        written.length
    }

    /// Writes one that is raised or lowered: where a number sign before it in this word says that letters stand for
    /// themselves, it needs no other sign for that.
    fn put_higher(&mut self, mut written: Written) -> usize {
        let of_word = self.out.cells.rsplit(|cell| ENDS_LETTERS.contains(cell)).next().unwrap_or_default();
        let is_said = of_word.windows(self.table.number.len()).any(|cells| cells == self.table.number);
        if let Some(AfterNumber { sign, .. }) = self.table.letter_after_number.as_ref().filter(|_| is_said)
            && written.cells.starts_with(sign)
        {
            written.cells.drain(..sign.len());
        }
        self.put(&written)
    }

    fn space(&mut self, i: usize) {
        let goes_on = |group: &&Group| self.number == Number::GoesOn && grouped::is_in_number(group, self.text, i);
        match self.table.group.as_ref().filter(goes_on) {
            Some(group) => self.out.cells.extend(&group.cells),
            None => {
                self.out.cells.push(0);
                self.number = Number::None;
            }
        }
    }

    /// The sign for a letter that would be a digit after digits. Where a capital has its mark, that stands between; a
    /// letter within a word of capitals has none.
    fn after_number(&mut self, letter: char, around: &CapitalContext) {
        if let Some(sign) = &self.table.letter_after_number
            && self.number != Number::None
            && ('a'..='j').contains(&letter.to_ascii_lowercase())
            && (sign.before_capitals || around.before.is_empty())
        {
            self.out.cells.extend(&sign.sign);
        }
    }

    /// The longest sign that begins at `i`: its length, its rule here and all its rules.
    fn sign(&self, i: usize) -> Option<(usize, &'t SignRule, &'t [SignRule])> {
        let (table, rest) = (self.table, &self.text[i..]);
        (1..=table.longest.min(rest.len())).rev().find_map(|length| {
            let sign: String = rest[..length].iter().collect();
            let rules = table.signs.get(&sign).or_else(|| table.signs.get(same_as(&sign)?))?;
            let neighbours = Neighbours::of(self.text, i, i + length);
            let rule = rules.iter().find(|rule| neighbours.fit(rule.left, rule.right))?;
            Some((length, rule, rules.as_slice()))
        })
    }
}

/// What a sign leaves of a number: some are numbers themselves, such as a half.
fn after_sign(rule: &SignRule, table: &Table) -> Number {
    let ends_in_digit = rule.cells.last().is_some_and(|last| table.digits.contains(last));
    let has_number = rule.cells.windows(table.number.len()).any(|cells| cells == table.number);
    match rule.in_number {
        true => Number::GoesOn,
        false if ends_in_digit && has_number => Number::Ended,
        false => Number::None,
    }
}

/// A blank, and a hyphen or the end of a dash (dots 3 and 6): behind these letters need their sign again.
const ENDS_LETTERS: [u8; 2] = [0, 0b10_0100];

/// The sign of minus.
const MINUS: char = '\u{2212}';

/// What is no letter, in place of a sign.
const NO_LETTER: char = '\u{2423}';

/// Whether a hyphen stands between two letters.
fn is_hyphen_in_word(text: &[char], i: usize) -> bool {
    let is_letter = |at: Option<usize>| at.and_then(|at| text.get(at)).is_some_and(|letter| letter.is_alphabetic());
    matches!(text[i], '-' | '\u{2010}') && is_letter(i.checked_sub(1)) && is_letter(Some(i + 1))
}

/// The small letter of a letter.
fn small(letter: char) -> Option<char> {
    let mut small = letter.to_lowercase();
    small.next().filter(|_| small.next().is_none())
}

/// A sign that is read as this one, for codes that do not tell them apart.
fn same_as(sign: &str) -> Option<&'static str> {
    Some(match sign {
        "\u{2010}" | "\u{2011}" | "\u{2212}" => "-",
        "\u{2013}" | "\u{2014}" => "\u{2013}",
        "\u{2019}" | "\u{2bc}" => "'",
        "\u{22c5}" | "\u{2219}" => "\u{b7}",
        "\u{3bc}" => "\u{b5}",
        "\u{2126}" => "\u{3a9}",
        "\u{2026}" => "...",
        _ => return None,
    })
}
