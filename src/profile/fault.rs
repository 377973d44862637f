//! Faults of profiles, and the pieces that their messages are put together from.

/// Longest name or text that a message repeats, in letters; no real key comes near.
const LONGEST: usize = 40;

/// One fault in a profile.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Fault {
    /// Where: a file's name and line, or what the place of a value was called
    /// ([`Profile::set_from`](crate::Profile::set_from)).
    pub place: String,
    /// The line of the file, counted from 1, where it is one of a file's text.
    pub line: Option<usize>,
    /// What is wrong and what would do.
    pub what: String,
    /// The keys that it is about, by [`Key::path`](crate::Key::path): the one whose value is refused, those whose
    /// values do not go together, or those that are missing. Empty where it is about none that there is: a misspelt
    /// name, a mistake in the TOML.
    pub keys: Vec<&'static str>,
}

impl Fault {
    /// A fault that is about no key.
    pub fn new(place: impl Into<String>, what: impl Into<String>) -> Self {
        Self::of_keys(&[], place, what)
    }

    pub(super) fn of_keys(keys: &[&'static str], place: impl Into<String>, what: impl Into<String>) -> Self {
        Self { place: place.into(), line: None, what: what.into(), keys: keys.to_vec() }
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.place, self.what)
    }
}

pub(crate) fn faults_in_one_line(faults: &[Fault]) -> String {
    faults.iter().map(Fault::to_string).collect::<Vec<_>>().join("; ")
}

/// A fault in a text whose name is not known yet.
#[derive(Debug)]
pub(super) struct FaultInText {
    /// Counted from 1.
    pub(super) line: usize,
    pub(super) what: String,
    /// The key that it is about, if it is about one.
    key: Option<&'static str>,
}

impl FaultInText {
    pub(super) fn new(line: usize, what: String) -> Self {
        Self { line, what, key: None }
    }

    pub(super) fn of_key(key: &'static str, line: usize, what: String) -> Self {
        Self { line, what, key: Some(key) }
    }

    pub(super) fn in_file(self, place: &str) -> Fault {
        let fault = Fault::of_keys(self.key.as_slice(), format!("{place}, line {}", self.line), self.what);
        Fault { line: Some(self.line), ..fault }
    }
}

/// Names joined by points; one that is not plain letters is quoted, without anything that would break the line.
pub(super) fn quoted_path(names: &[&str]) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-' || c == '.';
    let parts = names.iter().map(|name| {
        if !name.is_empty() && name.len() <= LONGEST && name.chars().all(plain) {
            (*name).to_owned()
        } else {
            quoted(name)
        }
    });
    parts.collect::<Vec<_>>().join(".")
}

/// A text in quotes, on one line and not too long, as it is written there.
pub(crate) fn quoted(text: &str) -> String {
    let (mut short, mut count) = (String::new(), 0);
    for letter in text.chars() {
        let written = if letter == '\'' { letter.to_string() } else { letter.escape_debug().to_string() };
        count += written.chars().count();
        if count > LONGEST {
            short.push_str("...");
            break;
        }
        short.push_str(&written);
    }
    format!("\"{short}\"")
}

/// Whether a value is a number with a comma where TOML wants a point, such as `1,5`.
pub(super) fn has_decimal_comma(value: &str) -> bool {
    value.as_bytes().windows(3).any(|w| w[0].is_ascii_digit() && w[1] == b',' && w[2].is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_quoted_is_short_as_it_is_written() {
        assert_eq!(quoted("a 'b' \"c\""), r#""a 'b' \"c\"""#);
        assert_eq!(quoted("\u{18}"), r#""\u{18}""#);
        for text in ["\u{18}".repeat(30), "x".repeat(50)] {
            let short = quoted(&text);
            assert!(short.ends_with("...\"") && short.len() <= LONGEST + 5, "{short}");
        }
    }
}
