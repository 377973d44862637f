//! What a table of a braille code holds.

use std::collections::{BTreeMap, BTreeSet};

/// What a braille code has for letters, digits and signs.
#[derive(Debug, Clone, Default)]
pub struct Table {
    /// What the code is called.
    pub name: String,
    /// The language that it is for (BCP 47).
    pub(super) language: &'static str,
    /// Says that digits follow.
    pub(super) number: Vec<u8>,
    /// The digits 0 to 9.
    pub(super) digits: Vec<u8>,
    /// Says that an address of mail or of the net follows; none where a code has no such sign.
    pub(super) address: Option<Vec<u8>>,
    /// The characters of addresses that have cells of their own there.
    pub(super) in_address: BTreeMap<char, Vec<u8>>,
    /// Says at the end of a line that an address goes on in the next.
    pub(super) continuation: Option<u8>,
    /// Joins groups of digits of one number; a blank where a code has none.
    pub(super) group: Option<Group>,
    /// Says that a letter after digits is one, where it could be taken for a digit.
    pub(super) letter_after_number: Option<AfterNumber>,
    /// Numbers that stand higher than the line; none where a code has none.
    pub(super) superscript: Option<Script>,
    /// Those that stand lower; written on the line where a code has none.
    pub(super) subscript: Option<Script>,
    /// Charges of ions; none where no rule for them is known.
    pub(super) charges: Option<Charges>,
    /// Whether formulas have no contractions, so that those of a text in contracted braille are as in this table.
    pub(super) formulas_are_uncontracted: bool,
    /// Words and parts of words of the contracted code by the letters that they are written with.
    pub(super) contracted: BTreeSet<String>,
    /// The commonest words of two letters in the language.
    pub(super) short_words: BTreeSet<String>,
    /// Numbers of an order, such as the first.
    pub(super) ordinals: Option<Ordinals>,
    /// None for codes that do not write capitals.
    pub(super) capitals: Option<Capitals>,
    /// Words of the key in the language of the code, by their English names.
    pub(super) words: BTreeMap<String, String>,
    pub(super) letters: BTreeMap<char, Vec<u8>>,
    /// Signs of one or more characters, the rules of each in their order.
    pub(super) signs: BTreeMap<String, Vec<SignRule>>,
    /// Whether straight single quotation marks in pairs are those that open and close.
    pub(super) pairs_straight_quotes: bool,
    /// Length of the longest sign, in characters.
    pub(super) longest: usize,
}

impl Table {
    /// A word of the key, by its English name, in the language of the code: `key`, `blank` and the names of colours.
    /// Where there is none it is the English one.
    pub fn word<'a>(&'a self, name: &'a str) -> &'a str {
        self.words.get(name).map_or(name, String::as_str)
    }
}

/// What joins groups of digits that print parts by blanks.
#[derive(Debug, Clone)]
pub(super) struct Group {
    pub(super) cells: Vec<u8>,
    /// Whether only groups of three digits are joined, and not those of telephone numbers.
    pub(super) of_thousands_only: bool,
}

/// A sign before letters that follow digits.
#[derive(Debug, Clone)]
pub(super) struct AfterNumber {
    pub(super) sign: Vec<u8>,
    /// Whether it stands before capitals too: so where a code does not mark them.
    pub(super) before_capitals: bool,
}

/// How a code writes numbers that stand higher or lower than the line.
#[derive(Debug, Clone, Default)]
pub(super) struct Script {
    pub(super) before: Vec<u8>,
    /// The digits 0 to 9; none where they are as others, behind the sign of numbers.
    pub(super) digits: Vec<u8>,
    /// What is written before and after the digits of a negative number; none where it is not known.
    pub(super) minus: Option<(Vec<u8>, Vec<u8>)>,
}

/// How a code writes the charges of ions, as in Na\u{207a} and Ca\u{b2}\u{207a}.
#[derive(Debug, Clone, Default)]
pub(super) struct Charges {
    /// Before a sign alone, and before a number and its sign.
    pub(super) before_one: Vec<u8>,
    pub(super) before: Vec<u8>,
    /// After a number and its sign.
    pub(super) after: Vec<u8>,
    pub(super) plus: Vec<u8>,
    pub(super) minus: Vec<u8>,
}

/// How a code writes numbers of an order that end in a raised letter.
#[derive(Debug, Clone)]
pub(super) struct Ordinals {
    /// The digits 0 to 9.
    pub(super) digits: Vec<u8>,
}

/// How a code writes capitals.
#[derive(Debug, Clone, Default)]
pub(super) struct Capitals {
    /// Before one.
    pub(super) letter: Vec<u8>,
    /// Before several.
    pub(super) word: Vec<u8>,
    /// Ends a word of capitals where something else follows in the same word (the terminator). Without it each capital
    /// of such a word has its own sign.
    pub(super) end: Option<Vec<u8>>,
    /// Signs that do not end a word of capitals.
    pub(super) through: Vec<char>,
    pub(super) passage: Option<CapitalPassage>,
}

/// How a code writes several words in capitals.
#[derive(Debug, Clone)]
pub(super) struct CapitalPassage {
    pub(super) begin: Vec<u8>,
    pub(super) end: Vec<u8>,
    /// From how many words on.
    pub(super) words: usize,
    /// Whether the end stands before the last word, and not after it.
    pub(super) before_last: bool,
}

/// What a sign is written as between these neighbours.
#[derive(Debug, Clone)]
pub(super) struct SignRule {
    pub(super) left: char,
    pub(super) right: char,
    pub(super) cells: Vec<u8>,
    /// Digits that follow belong to the same number and need no number sign.
    pub(super) in_number: bool,
    /// The space before it falls out.
    pub(super) joins_left: bool,
    /// The space after it falls out.
    pub(super) joins_right: bool,
}
