//! Which words stay on one line: those of an equation, a number with its unit, and the day of a month with the month.

/// Signs that join what stands beside them with blanks.
const SIGNS: &str = "=+\u{2212}\u{d7}\u{f7}\u{b7}<>\u{2264}\u{2265}\u{2248}\u{2260}\u{b1}\u{221d}";
/// Signs that do so between numbers and letters of equations only; between words they are dashes and the like.
const SIGNS_OF_TERMS: &str = "-\u{2010}\u{2013}*/:";
/// Signs of comparison, in front of which a long equation is divided.
const COMPARISONS: &str = "=<>\u{2264}\u{2265}\u{2248}\u{2260}\u{221d}";
/// Signs of currencies stand before their number or behind it.
const CURRENCIES: &str = "\u{20ac}$\u{a3}\u{a5}\u{a2}";
/// Most letters of a term, such as those of a line between two points.
const LETTERS_OF_TERM: usize = 2;
/// An equation of more characters is divided in front of its signs of comparison: labels have no more in a line.
const LONG: usize = 20;
/// Units, as they stand behind numbers; those with a stroke, such as km/h, are made of them.
const UNITS: [&str; 56] = [
    "%", "\u{2030}", "\u{b0}", "\u{b0}C", "\u{b0}F", "K", "mm", "cm", "dm", "m", "km", "in", "ft", "yd", "mi", "ha",
    "a", "mg", "g", "kg", "t", "lb", "oz", "ml", "cl", "dl", "l", "hl", "L", "s", "ms", "min", "h", "d", "Std", "Hz",
    "kHz", "MHz", "V", "mV", "kV", "A", "mA", "W", "kW", "MW", "kWh", "J", "kJ", "N", "kN", "Pa", "hPa", "kPa", "bar",
    "mol",
];

/// The months in small letters as they stand behind a day, in English, German, Dutch and Swedish, French, Spanish,
/// Portuguese, Italian, Polish and Czech, each as far as they differ; of abbreviations those that are no other word.
const MONTHS: [&str; 12] = [
    "january february march april may june july august september october november december",
    "jan feb apr aug sept oct nov dec",
    "januar j\u{e4}nner februar m\u{e4}rz mai juni juli oktober dezember okt dez",
    "januari februari maart mei augustus mars maj augusti",
    "janvier f\u{e9}vrier avril juin juillet ao\u{fb}t septembre octobre novembre d\u{e9}cembre",
    "janv f\u{e9}vr juil d\u{e9}c",
    "enero febrero marzo abril mayo junio julio agosto septiembre setiembre octubre noviembre diciembre",
    "janeiro fevereiro mar\u{e7}o maio junho julho setembro outubro novembro dezembro",
    "gennaio febbraio aprile maggio giugno luglio settembre ottobre dicembre",
    "stycznia lutego marca kwietnia maja czerwca lipca sierpnia wrze\u{15b}nia pa\u{17a}dziernika listopada grudnia",
    "ledna \u{fa}nora b\u{159}ezna dubna kv\u{11b}tna \u{10d}ervna \u{10d}ervence srpna",
    "z\u{e1}\u{159}\u{ed} \u{159}\u{ed}jna listopadu prosince",
];
/// What stands between the day and the month in Spanish and Portuguese.
const OF: &str = "de";

/// The spaces of a text at which no line ends, in order.
pub(super) fn spaces(text: &[char]) -> Vec<usize> {
    let words: Vec<&[char]> = text.split(|letter| *letter == ' ').collect();
    let mut ends = Vec::with_capacity(words.len());
    let mut at = 0;
    for word in &words {
        at += word.len();
        ends.push(at);
        at += 1;
    }
    let mut joined: Vec<usize> = (1..words.len()).filter(|&next| is_joined(&words, next)).collect();
    // what belongs together may be too long for a line
    let is_long = |next: usize, joined: &[usize]| {
        let first = (1..=next).rev().take_while(|before| joined.contains(before)).last().unwrap_or(next);
        let last = (next..words.len()).take_while(|after| joined.contains(after)).last().unwrap_or(next);
        ends[last] - (ends[first - 1] - words[first - 1].len()) > LONG
    };
    let all = joined.clone();
    joined.retain(|&next| !is_one_of(words[next], COMPARISONS) || !is_long(next, &all));
    joined.into_iter().map(|next| ends[next - 1]).collect()
}

/// The blanks of cells at which no line ends, where another program wrote this text: known where it has as many words
/// as its braille.
pub(super) fn blanks(text: &str, cells: &[u8]) -> Vec<usize> {
    let text: Vec<char> = text.chars().collect();
    let joined = spaces(&text);
    let blanks = blanks_of_spaces(&text, cells).unwrap_or_default();
    blanks.into_iter().filter(|(space, _)| joined.contains(space)).map(|(_, blank)| blank).collect()
}

/// The spaces of such a text, each with its blank; none if there are not as many of both.
pub(super) fn blanks_of_spaces(text: &[char], cells: &[u8]) -> Option<Vec<(usize, usize)>> {
    let spaces: Vec<usize> = (0..text.len()).filter(|&at| text[at] == ' ').collect();
    let blanks: Vec<usize> = (0..cells.len()).filter(|&at| cells[at] == 0).collect();
    (spaces.len() == blanks.len()).then(|| spaces.into_iter().zip(blanks).collect())
}

/// Whether a word stays on the line of the one before it.
fn is_joined(words: &[&[char]], next: usize) -> bool {
    let (before, after) = (words[next - 1], words[next]);
    let other = |at: Option<usize>| at.and_then(|at| words.get(at)).is_some_and(|word| is_term(word));
    let is_sign = is_one_of(before, SIGNS) || is_one_of(after, SIGNS);
    let is_between_terms = is_one_of(before, SIGNS_OF_TERMS) && is_term(after) && other(next.checked_sub(2))
        || is_one_of(after, SIGNS_OF_TERMS) && is_term(before) && other(Some(next + 1));
    let is_measure = is_number(before)
        && (is_unit(after) || parts_digits(before, after) || is_one_of(after, CURRENCIES))
        || is_one_of(before, CURRENCIES) && is_number(after);
    is_sign || is_between_terms || is_measure || is_date(words, next)
}

/// Whether a word is the month of the day before it, or what stands between the two.
fn is_date(words: &[&[char]], next: usize) -> bool {
    let is_of = |at: usize| words.get(at).is_some_and(|word| word.iter().copied().eq(OF.chars()));
    let is_day_at = |at: Option<usize>| at.and_then(|at| words.get(at)).is_some_and(|word| is_day(word));
    let is_month_at = |at: usize| words.get(at).is_some_and(|word| is_month(word));
    let is_behind_day = is_day_at(next.checked_sub(1)) && (is_month_at(next) || is_of(next) && is_month_at(next + 1));
    is_behind_day || is_of(next - 1) && is_day_at(next.checked_sub(2)) && is_month_at(next)
}

/// Whether a word is the day of a month: one digit or two, perhaps with the point or the letters of an order.
fn is_day(word: &[char]) -> bool {
    let digits = word.iter().take_while(|digit| digit.is_ascii_digit()).count();
    let order: String = word[digits..].iter().collect();
    (1..=2).contains(&digits) && ["", ".", "st", "nd", "rd", "th", "er", "\u{ba}"].contains(&order.as_str())
}

/// Whether a word is a month, perhaps with punctuation behind it.
fn is_month(word: &[char]) -> bool {
    let word: String = word.iter().collect::<String>().to_lowercase();
    let word = word.trim_end_matches([',', '.', ';', ':', '?', '!', ')']);
    MONTHS.iter().any(|months| months.split(' ').any(|month| month == word))
}

fn is_one_of(word: &[char], signs: &str) -> bool {
    matches!(word, [sign] if signs.contains(*sign))
}

/// A number or a few letters, as they stand in equations.
fn is_term(word: &[char]) -> bool {
    word.iter().any(char::is_ascii_digit)
        || (1..=LETTERS_OF_TERM).contains(&word.len()) && word.iter().all(|letter| letter.is_alphabetic())
}

fn is_number(word: &[char]) -> bool {
    let digits = word.iter().filter(|letter| letter.is_ascii_digit()).count();
    digits > 0 && word.last().is_some_and(char::is_ascii_digit) && word.len() - digits <= digits
}

/// Digits of a group of a number.
pub(super) const DIGITS: usize = 3;

/// Whether one to three digits stand before a blank and three behind it, as in 12 000 or 1:25 000: they may be groups
/// of one number ([`super::grouped`] says whether they surely are), and stay on one line.
pub(super) fn parts_digits(before: &[char], after: &[char]) -> bool {
    (1..=DIGITS).contains(&digits(before.iter().rev())) && digits(after.iter()) == DIGITS
}

/// How many digits there are up to the first other sign.
pub(super) fn digits<'a>(letters: impl Iterator<Item = &'a char>) -> usize {
    letters.take_while(|letter| letter.is_ascii_digit()).count()
}

/// Whether a word is a unit, perhaps with a power and with punctuation behind it.
pub(super) fn is_unit(word: &[char]) -> bool {
    let word: String = word.iter().collect();
    let word = word.trim_end_matches([',', '.', ';', ':', '?', '!', ')']);
    let is_known = |part: &str| UNITS.contains(&part.trim_end_matches(['\u{b2}', '\u{b3}', '2', '3']));
    !word.is_empty() && word.split('/').all(is_known)
}

#[cfg(test)]
mod tests;
