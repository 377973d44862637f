//! What a remark says, in parts: what helps is kept apart until it is told, as of several remarks that want a larger
//! figure only the first says so. From where a place is counted stands in the words, and is found by them.

use std::fmt;

/// What a remark says: what is so, with where and why, and what helps. It says itself within the sentence of its
/// remark.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Told {
    what: String,
    helps: Vec<Help>,
    /// What is said behind that.
    more: String,
}

/// What helps against what a remark tells.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Help {
    /// A larger figure; and how to get one, where that is known.
    Larger(Option<String>),
    /// A part of the picture alone, which is larger too; of a chart or a family tree it is not what is wanted.
    Crop,
    Other(String),
}

impl fmt::Display for Help {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Larger(None) => f.write_str("make the figure larger"),
            Self::Larger(Some(how)) => write!(f, "make the figure larger {how}"),
            Self::Crop => f.write_str("crop the picture"),
            Self::Other(what) => f.write_str(what),
        }
    }
}

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)?;
        if let [first @ .., last] = &self.helps[..] {
            let before: String = first.iter().map(|help| format!("{help}, ")).collect();
            let or = if first.is_empty() { "" } else { "or " };
            write!(f, "; {before}{or}{last}")?;
        }
        f.write_str(&self.more)
    }
}

impl From<String> for Told {
    fn from(what: String) -> Self {
        Self { what, ..Self::default() }
    }
}

impl From<&str> for Told {
    fn from(what: &str) -> Self {
        what.to_owned().into()
    }
}

/// From where places on a sheet are counted, behind their numbers; `of` is what the sheet is called.
pub(crate) fn from_edges(of: &str) -> String {
    format!(" from the left and the top of {of}")
}

/// What a sheet is called that is no one of several.
const ALONE: [&str; 2] = ["the sheet", "the display"];

impl Told {
    /// The same, with a larger figure as the next that helps.
    #[must_use]
    pub fn or_larger(self) -> Self {
        self.or_help(Help::Larger(None))
    }

    /// The same, with a part of the picture alone as the next that helps; it is left out with a larger figure where
    /// another remark says that.
    #[must_use]
    pub(crate) fn or_crop(self) -> Self {
        self.or_help(Help::Crop)
    }

    /// The same, with what is to be done as the next that helps, such as "say it in a label".
    #[must_use]
    pub fn or(self, what: impl Into<String>) -> Self {
        self.or_help(Help::Other(what.into()))
    }

    fn or_help(mut self, help: Help) -> Self {
        self.helps.push(help);
        self
    }

    /// Says more behind what helps.
    pub(crate) fn add(&mut self, more: &str) {
        self.more.push_str(more);
    }

    /// Whether a larger figure helps.
    pub fn wants_larger(&self) -> bool {
        self.helps.iter().any(|help| matches!(help, Help::Larger(_)))
    }

    /// Says `how` the figure is made larger, where that helps; whether it does.
    pub(super) fn say_how_larger(&mut self, how: &str) -> bool {
        for help in &mut self.helps {
            if let Help::Larger(known) = help {
                *known = Some(how.to_owned());
            }
        }
        self.wants_larger()
    }

    /// Leaves out that a larger figure helps, and a part of the picture that is larger.
    pub(super) fn leave_larger_out(&mut self) {
        self.helps.retain(|help| matches!(help, Help::Other(_)));
    }

    /// Whether it says from where a place is counted, of a single sheet or display.
    pub(super) fn has_origin(&self) -> bool {
        ALONE.into_iter().any(|of| self.what.contains(&from_edges(of)))
    }

    /// Leaves out from where a place is counted.
    pub(super) fn leave_origin_out(&mut self) {
        for of in ALONE {
            self.what = self.what.replace(&from_edges(of), "");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_helps_is_told_behind_what_is_so() {
        let told = || Told::from("1 line: no room");
        assert_eq!(told().to_string(), "1 line: no room");
        assert_eq!(told().or_larger().to_string(), "1 line: no room; make the figure larger");
        let mut all = told().or_larger().or_crop().or("say it in a label");
        all.add("; the key has it");
        let behind = "crop the picture, or say it in a label; the key has it";
        assert_eq!(all.to_string(), format!("1 line: no room; make the figure larger, {behind}"));
        assert!(all.say_how_larger("(--sheets 2x2)"));
        assert_eq!(all.to_string(), format!("1 line: no room; make the figure larger (--sheets 2x2), {behind}"));
        all.leave_larger_out();
        assert!(!all.wants_larger() && !all.say_how_larger("(--sheets 2x2)"));
        assert_eq!(all.to_string(), "1 line: no room; say it in a label; the key has it");
    }
}
