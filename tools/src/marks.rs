//! What measuring programs write into pages of the docs, between lines that mark its place, and how it came about.

use std::fs;
use std::process::{Command, Stdio};

/// Exchanges what stands in a page between the lines `<!-- mark -->` and `<!-- /mark -->`.
///
/// # Errors
/// The page cannot be read or written, or lacks these lines.
pub fn write(page: &str, mark: &str, new: &str) -> Result<(), String> {
    let told = |fault| format!("{page}: {fault}");
    let text = fs::read_to_string(page).map_err(told)?;
    fs::write(page, exchanged(page, &text, mark, new)?).map_err(told)
}

/// The text of a page with what stands between the lines of a mark exchanged.
///
/// # Errors
/// The page lacks these lines.
pub fn exchanged(page: &str, text: &str, mark: &str, new: &str) -> Result<String, String> {
    let (begin, end) = (format!("<!-- {mark} -->\n"), format!("<!-- /{mark} -->\n"));
    let parts = text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
    let (before, after) = parts.ok_or_else(|| format!("{page} has no lines {} and {}", begin.trim(), end.trim()))?;
    Ok(format!("{before}{begin}\n{}\n\n{end}{after}", new.trim_end()))
}

/// On which day, and of which sources, as far as the system tells: "on 28 November 2026, from commit 064294af". That files
/// were changed since the commit is told too, but not of the pages and tables that such programs write.
pub fn made() -> String {
    let says = |program: &str, words: &[&str]| {
        let output = Command::new(program).args(words).env("LC_ALL", "C").stderr(Stdio::null()).output().ok()?;
        let said = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        (output.status.success() && !said.is_empty()).then_some(said)
    };
    let day = says("date", &["-u", "+%-d %B %Y"]).unwrap_or_else(|| "an unknown day".into());
    let commit = says("git", &["describe", "--always"]).unwrap_or_else(|| "an unknown one".into());
    let differs = ["diff", "--quiet", "HEAD", "--", ".", ":!docs", ":!README.md"];
    let differs = Command::new("git").args(differs).stderr(Stdio::null()).status();
    let changes = if differs.is_ok_and(|ended| ended.code() == Some(1)) { " with changes" } else { "" };
    format!("on {day}, from commit {commit}{changes}")
}

/// The command with which a measuring program was started, as one types it.
pub fn command(name: &str) -> String {
    typed(name, std::env::args().skip(1))
}

fn typed(name: &str, words: impl Iterator<Item = String>) -> String {
    let words: String = words.map(|word| format!(" {word}")).collect();
    let dashes = if words.is_empty() { "" } else { " --" };
    format!("cargo run --release -p tactograph-tools --bin {name}{dashes}{words}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_exchanged_and_the_rest_stays() {
        let (begin, end) = ("<!-- a-mark -->", "<!-- /a-mark -->");
        let old = format!("before\n{begin}\nold\n{end}\nafter\n");
        let new = exchanged("page", &old, "a-mark", "| new |\n").unwrap();
        assert_eq!(new, format!("before\n{begin}\n\n| new |\n\n{end}\nafter\n"));
        assert_eq!(exchanged("page", &new, "a-mark", "| new |").unwrap(), new);
        assert!(exchanged("page", "no marks", "a-mark", "").is_err());
    }

    #[test]
    fn a_command_has_the_words_as_they_were_given() {
        let of = |words: &[&str]| typed("knee", words.iter().map(|&word| word.to_owned()));
        assert_eq!(of(&[]), "cargo run --release -p tactograph-tools --bin knee");
        assert_eq!(of(&["--rounds", "3"]), "cargo run --release -p tactograph-tools --bin knee -- --rounds 3");
    }
}
