//! Formulas as matplotlib is given them, between dollar signs, where they can be said on one line: the number
//! `$\mathdefault{10^{-3}}$`, `$x_1$`, `30 $\mu$g`. TeX writes them alike.

use super::names::letter_named;
use super::texts::scripted;

/// A text with its formulas read.
pub(super) struct Formula {
    pub(super) string: String,
    /// How many signs are drawn, without blanks.
    pub(super) signs: usize,
}

/// Whether a text has formulas.
pub(super) fn is_formula(text: &str) -> bool {
    let dollars = text.matches('$').count();
    text.contains('\\') || dollars > 0 && dollars.is_multiple_of(2)
}

/// A text with formulas, if all that they are made of is known.
pub(super) fn read(text: &str) -> Option<Formula> {
    let mut all = Formula { string: String::new(), signs: 0 };
    for (i, part) in text.split('$').enumerate() {
        if i.is_multiple_of(2) {
            if part.contains('\\') {
                return None;
            }
            all.string.push_str(part);
            all.signs += part.chars().filter(|sign| !sign.is_whitespace()).count();
        } else {
            let mut reading = Reading { rest: part, signs: 0 };
            all.string.push_str(&reading.row(0)?);
            all.signs += reading.signs;
            if !reading.rest.is_empty() {
                return None;
            }
        }
    }
    let string = all.string.split_whitespace().collect::<Vec<_>>().join(" ");
    Some(Formula { string, ..all })
}

/// Most braces inside one another.
const MOST_LEVELS: u32 = 20;

/// A formula while it is read.
struct Reading<'a> {
    rest: &'a str,
    signs: usize,
}

impl Reading<'_> {
    fn take(&mut self) -> Option<char> {
        let next = self.rest.chars().next()?;
        self.rest = &self.rest[next.len_utf8()..];
        Some(next)
    }

    /// What stands up to the end or to the brace that closes it.
    fn row(&mut self, level: u32) -> Option<String> {
        let mut row = String::new();
        while !self.rest.is_empty() && !self.rest.starts_with('}') {
            match self.rest.chars().next()? {
                sign @ ('^' | '_') => {
                    self.take()?;
                    let script = self.script(&row, sign == '^', level)?;
                    row.truncate(row.trim_end().len());
                    row.push_str(&script);
                }
                sign if sign.is_whitespace() => row.extend(self.take()),
                _ => row.push_str(&self.part(level)?),
            }
        }
        Some(row)
    }

    /// What is raised or lowered behind a row.
    fn script(&mut self, row: &str, is_raised: bool, level: u32) -> Option<String> {
        let own = self.part(level)?;
        let own = own.trim();
        if is_raised && own.chars().eq([DEGREE]) {
            return Some(own.to_owned());
        }
        let has_base = !row.trim_end().is_empty() && !own.is_empty();
        let is_power = is_raised && has_base && !ORDINALS.contains(&own);
        Some(scripted(own, is_raised).unwrap_or_else(|| if is_power { typed(own) } else { format!(" {own} ") }))
    }

    /// A sign, a command or what is in braces.
    fn part(&mut self, level: u32) -> Option<String> {
        let level = Some(level + 1).filter(|level| *level <= MOST_LEVELS)?;
        self.rest = self.rest.trim_start();
        let sign = match self.take()? {
            '{' => {
                let row = self.row(level)?;
                return (self.take() == Some('}')).then_some(row);
            }
            '\\' => return self.command(level),
            // two scripts in a row, and primes, are not read
            '}' | '^' | '_' | '\'' | '~' => return None,
            '-' => '\u{2212}',
            sign => sign,
        };
        self.signs += 1;
        Some(sign.to_string())
    }

    /// What stands for a command, behind its backslash.
    fn command(&mut self, level: u32) -> Option<String> {
        let length = self.rest.find(|sign: char| !sign.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        if length == 0 {
            return match self.take()? {
                ' ' | ',' | ';' | ':' | '>' => Some(" ".to_owned()),
                '!' => Some(String::new()),
                sign @ ('%' | '#' | '&' | '_' | '{' | '}') => {
                    self.signs += 1;
                    Some(sign.to_string())
                }
                _ => None,
            };
        }
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest.trim_start();
        if FONTS.contains(&name) {
            return self.part(level);
        }
        if name == "quad" || name == "qquad" {
            return Some(" ".to_owned());
        }
        let known = COMMANDS.iter().find(|(own, _)| *own == name).map(|(_, sign)| *sign);
        let sign = known.or_else(|| letter_named(name))?;
        self.signs += 1;
        Some(sign.to_string())
    }
}

/// A power as it is typed, with a blank behind it: in brackets, unless it is one sign or a number.
fn typed(power: &str) -> String {
    let is_number = power.chars().all(|sign| sign.is_ascii_digit() || sign == '.' || sign == ',');
    if is_number || power.chars().count() == 1 { format!("^{power} ") } else { format!("^({power}) ") }
}

/// What is raised behind numbers and is no power: in English and French.
const ORDINALS: [&str; 6] = ["st", "nd", "rd", "th", "er", "\u{e8}re"];

/// Commands that choose a font for what comes next.
const FONTS: [&str; 8] = ["mathdefault", "mathregular", "mathrm", "mathit", "mathbf", "mathsf", "mathtt", "text"];

const DEGREE: char = '\u{b0}';

/// Signs that have other names in fonts, or none.
const COMMANDS: [(&str, char); 12] = [
    ("times", '\u{d7}'),
    ("cdot", '\u{b7}'),
    ("pm", '\u{b1}'),
    ("circ", DEGREE),
    ("degree", DEGREE),
    ("infty", '\u{221e}'),
    ("approx", '\u{2248}'),
    ("neq", '\u{2260}'),
    ("leq", '\u{2264}'),
    ("geq", '\u{2265}'),
    ("rightarrow", '\u{2192}'),
    ("to", '\u{2192}'),
];

#[cfg(test)]
mod tests;
