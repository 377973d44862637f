//! What is more than basic arithmetic. Tables write it sign by sign; a mathematical code has rules of its own for it,
//! such as where a root or a power ends.

use super::joined::is_unit;
use super::numbers::is_script;

/// Signs of operations and comparisons between terms.
const OPERATORS: &str = "+=<>\u{2212}\u{d7}\u{f7}\u{b1}\u{2264}\u{2265}\u{2248}\u{2260}";
/// Strokes of fractions.
const STROKES: &str = "/\u{2044}\u{2215}\u{f7}";

/// Signs that are operations between variables, and something else in words: a minus, and a point of times.
const SIGNS_OF_VARIABLES: &str = "-\u{2010}\u{b7}\u{22c5}";
/// Units that have powers: those of length, and behind a stroke or a point that of time, as in m/s\u{b2}.
const LENGTHS: [&str; 9] = ["mm", "cm", "dm", "m", "km", "in", "ft", "yd", "mi"];
const TIME: &str = "s";
/// The elements (IUPAC 2022), and those of which several atoms by themselves are a molecule.
const ELEMENTS: &str = "\
    H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se Br Kr Rb \
    Sr Y Zr Nb Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy Ho Er Tm Yb Lu \
    Hf Ta W Re Os Ir Pt Au Hg Tl Pb Bi Po At Rn Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf Es Fm Md No Lr Rf Db \
    Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts Og";
const MOLECULES: [&str; 9] = ["H", "N", "O", "F", "Cl", "Br", "I", "P", "S"];

/// Whether a text is more than basic arithmetic: it has a root, infinity, a sum or the like, a power or an index beside
/// an operator, a power behind `^`, or a fraction with an operation in brackets. A power of a unit behind its number is
/// none, nor is the index of a formula of chemistry.
pub fn is_formula(text: &str) -> bool {
    text.contains(is_higher) || has_script_beside_operator(text) || has_caret(text) || has_bracketed_fraction(text)
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
pub fn is_raised_or_lowered(character: char) -> bool {
    is_script(character) || matches!(character, '\u{2071}' | '\u{207a}'..='\u{208e}' | '\u{2090}'..='\u{209c}')
}

fn is_operator(character: char) -> bool {
    OPERATORS.contains(character)
}

fn has_script_beside_operator(text: &str) -> bool {
    let is_between = |c: char| c.is_whitespace() || is_operator(c) || matches!(c, '-' | '\u{2010}');
    let terms: Vec<&str> = text.split(is_between).filter(|term| !term.is_empty()).collect();
    let is_of_formula = |at: usize| {
        let before = at.checked_sub(1).map(|before| terms[before]);
        terms[at].contains(is_raised_or_lowered) && !is_measure(terms[at], before) && !is_of_chemistry(terms[at])
    };
    (text.contains(is_operator) || joins_variables(text)) && (0..terms.len()).any(is_of_formula)
}

/// Whether there is a minus or a point of times between two terms of one letter or a number, one of which has a letter:
/// a hyphen between words is none, nor is the dash of 5-10.
fn joins_variables(text: &str) -> bool {
    let is_between = |c: char| c.is_whitespace() || is_operator(c) || SIGNS_OF_VARIABLES.contains(c);
    text.char_indices().filter(|(_, c)| SIGNS_OF_VARIABLES.contains(*c)).any(|(at, sign)| {
        let before = text[..at].trim_end().rsplit(is_between).next().unwrap_or_default();
        let after = text[at + sign.len_utf8()..].trim_start().split(is_between).next().unwrap_or_default();
        let has_letter = |term: &str| term.contains(char::is_alphabetic);
        [before, after].iter().all(|term| is_variable(term, 1)) && (has_letter(before) || has_letter(after))
    })
}

/// Whether a term is a number, so many letters at most, or a number of those, with powers and indices.
fn is_variable(term: &str, letters: usize) -> bool {
    let term = term.trim_start_matches('(').trim_end_matches(')');
    let rest = term.trim_start_matches(is_of_number);
    let count = rest.chars().take_while(|c| c.is_alphabetic() && !is_raised_or_lowered(*c)).count();
    let is_raised = |c: char| is_raised_or_lowered(c) || matches!(c, '\'' | '\u{2032}');
    !term.is_empty() && count <= letters && rest.chars().skip(count).all(is_raised)
}

fn is_of_number(character: char) -> bool {
    character.is_ascii_digit() || matches!(character, '.' | ',')
}

/// Whether a term is a unit with a power, behind its number in it or in the term before; one with a stroke or a point,
/// as m/s\u{b2}, is one by itself.
fn is_measure(term: &str, before: Option<&str>) -> bool {
    let unit = term.trim_start_matches(is_of_number);
    let is_behind_number =
        unit.len() < term.len() || before.is_some_and(|before| before.ends_with(|c: char| c.is_ascii_digit()));
    let joints = ['/', '\u{b7}', '\u{22c5}'];
    let is_known = |(at, part): (usize, &str)| {
        let base = part.trim_end_matches(|c: char| !c.is_alphabetic());
        let has_power = part.contains(|c: char| c.is_ascii_digit() || is_raised_or_lowered(c));
        let takes_power = LENGTHS.contains(&base) || at > 0 && base == TIME;
        is_unit(&part.chars().collect::<Vec<_>>()) && (takes_power || !has_power)
    };
    (is_behind_number || unit.contains(joints)) && unit.split(joints).enumerate().all(is_known)
}

/// Whether `^` stands between what has a power and the power, as in x^2; behind a unit it is one of that, and behind a
/// word none.
fn has_caret(text: &str) -> bool {
    let is_between = |c: char| c.is_whitespace() || is_operator(c);
    text.char_indices().filter(|(_, c)| *c == '^').any(|(at, _)| {
        let mut before = text[..at].rsplit(is_between);
        let term = before.next().unwrap_or_default();
        let is_of_unit = is_measure(&format!("{term}2"), before.find(|term| !term.is_empty()));
        let base = term.rsplit(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        let has_base = term.ends_with(')') || is_variable(base, MOST_LETTERS);
        let has_power = text[at + 1..].starts_with(|c: char| c.is_alphanumeric() || "({-\u{2212}".contains(c));
        has_base && has_power && !is_of_unit
    })
}

/// Most letters of what has a power: two variables, as in mc^2.
const MOST_LETTERS: usize = 2;

/// Whether a term is of symbols of elements with indices and charges only, as CO\u{2082} and Na\u{207a}: what a finger
/// reads as one name; so is an electron. An index of chemistry is a count from 2 on, so that V\u{2081} is a variable,
/// and a single element has one in its molecule, or a charge.
fn is_of_chemistry(term: &str) -> bool {
    let letters: Vec<char> = term.chars().collect();
    let (mut symbols, mut at, mut has_charge) = (Vec::new(), 0, false);
    while at < letters.len() {
        let index: String = letters[at..].iter().copied().take_while(|c| is_raised_or_lowered(*c)).collect();
        if !index.is_empty() {
            let charge = index.trim_start_matches(|c: char| matches!(c, '\u{2080}'..='\u{2089}'));
            let count = &index[..index.len() - charge.len()];
            let is_known = charge.is_empty() || is_charge(charge);
            if !is_known || count.starts_with('\u{2080}') || count == "\u{2081}" {
                return false;
            }
            has_charge |= !charge.is_empty();
            at += index.chars().count();
        } else if letters[at].is_alphabetic() {
            let is_long = letters.get(at + 1).is_some_and(|next| next.is_lowercase() && !is_raised_or_lowered(*next));
            let symbol: String = letters[at..=at + usize::from(is_long)].iter().collect();
            at += symbol.chars().count();
            symbols.push(symbol);
        } else {
            at += 1;
        }
    }
    let is_electron = |symbol: &String| has_charge && symbol == "e";
    let is_element =
        |symbol: &String| ELEMENTS.split_whitespace().any(|element| element == symbol) || is_electron(symbol);
    let is_name = |symbol: &String| symbols.len() > 1 || has_charge || MOLECULES.contains(&symbol.as_str());
    !symbols.is_empty() && symbols.iter().all(|symbol| is_element(symbol) && is_name(symbol))
}

/// Whether raised signs are a charge: a plus or a minus, perhaps behind a number.
fn is_charge(signs: &str) -> bool {
    let number = signs.strip_suffix(['\u{207a}', '\u{207b}']);
    number.is_some_and(|number| number.chars().all(|c| is_script(c) && c != '\u{207b}'))
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

/// Whether there is an operation in this. A hyphen or a point is one between terms of a letter or a number, not within
/// words.
fn is_operation(inner: &[char]) -> bool {
    let has_word = inner.windows(2).any(|pair| pair.iter().all(|c| c.is_alphabetic()));
    let joins = || inner.iter().any(|c| SIGNS_OF_VARIABLES.contains(*c));
    inner.iter().any(|c| is_operator(*c)) || !has_word && joins()
}

#[cfg(test)]
mod tests;
