//! The words after a measuring program's name: options, their values, and files.

use std::str::FromStr;

/// The words, one after the other.
#[derive(Debug)]
pub struct Words {
    words: std::vec::IntoIter<String>,
    help: &'static str,
}

impl Words {
    /// The words that the program was started with. `help` is the source file whose head explains them.
    pub fn of_program(help: &'static str) -> Self {
        Self::new(std::env::args().skip(1), help)
    }

    /// Words from elsewhere.
    pub fn new(words: impl IntoIterator<Item = String>, help: &'static str) -> Self {
        Self { words: words.into_iter().collect::<Vec<_>>().into_iter(), help }
    }

    /// The value of an option, which is the next word.
    ///
    /// # Errors
    /// There is none.
    pub fn value(&mut self, option: &str) -> Result<String, String> {
        self.words.next().ok_or_else(|| format!("{option} needs a value; see the head of {}", self.help))
    }

    /// The value of an option as a number.
    ///
    /// # Errors
    /// There is none, or it is no such number.
    pub fn number<T: FromStr>(&mut self, option: &str) -> Result<T, String> {
        let text = self.value(option)?;
        text.parse().map_err(|_| format!("{option} needs a number, not {text}; see the head of {}", self.help))
    }

    /// The value of an option as a whole number from 1 on.
    ///
    /// # Errors
    /// There is none, or it is no such number.
    pub fn whole_number(&mut self, option: &str) -> Result<usize, String> {
        match self.number(option)? {
            0 => Err(format!("{option} needs a whole number from 1 on, not 0")),
            count => Ok(count),
        }
    }

    /// What to say of a word that the program does not know.
    pub fn unknown(&self, word: &str) -> String {
        format!("{word} is not known; see the head of {}", self.help)
    }
}

impl Iterator for Words {
    type Item = String;

    fn next(&mut self) -> Option<String> {
        self.words.next()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_take_the_next_word() {
        let mut words = Words::new(["--a", "3", "--b", "x", "--c", "0", "--d"].map(str::to_owned), "main.rs");
        assert_eq!((words.next().as_deref(), words.whole_number("--a")), (Some("--a"), Ok(3)));
        assert_eq!(words.next().as_deref(), Some("--b"));
        assert_eq!(words.number::<f64>("--b"), Err("--b needs a number, not x; see the head of main.rs".into()));
        assert_eq!(words.next().as_deref(), Some("--c"));
        assert_eq!(words.whole_number("--c"), Err("--c needs a whole number from 1 on, not 0".into()));
        assert_eq!(words.next().as_deref(), Some("--d"));
        assert_eq!(words.value("--d"), Err("--d needs a value; see the head of main.rs".into()));
    }
}
