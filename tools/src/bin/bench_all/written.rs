//! The tables in docs/speed.md, a short one for everybody and all of them, and the few rows in README.md.

use std::fs;
use std::process::{Command, Stdio};

use crate::args::Args;
use crate::readme;
use crate::table::Table;

const DOCS: &str = "docs/speed.md";
const README: &str = "README.md";
/// What stands in a page between the lines of a mark is written anew.
const SHORT: &str = "bench-all";
const ALL: &str = "bench-all-tables";

/// Writes all of them.
///
/// # Errors
/// A page cannot be written, or lacks the marks between which the tables stand; a row of README was not measured.
pub(crate) fn write(short: &Table, tables: &[Table], args: &Args) -> Result<(), String> {
    let page = read(DOCS)?;
    let page = between(DOCS, &page, SHORT, short.body().trim_end())?;
    let mut all = format!(
        "Made by `cargo run --release -p tactograph-tools --bin bench_all -- --write`,{} on {}, with {} rounds. Other \
         machines take other times; the ratios are what to look at. How each figure is taken stands at the head of \
         [the program](../tools/src/bin/bench_all/main.rs).\n\n",
        made(),
        machine(),
        args.runs
    );
    all.extend(tables.iter().map(Table::text));
    save(DOCS, &between(DOCS, &page, ALL, all.trim_end())?)?;
    // last, so that a row that it lacks costs no other table
    let few = readme::table(tables)?;
    save(README, &between(README, &read(README)?, SHORT, few.body().trim_end())?)
}

fn read(page: &str) -> Result<String, String> {
    fs::read_to_string(page).map_err(|fault| format!("{page}: {fault}"))
}

fn save(page: &str, text: &str) -> Result<(), String> {
    fs::write(page, text).map_err(|fault| format!("{page}: {fault}"))
}

/// The text of a page with what stands between the lines `<!-- mark -->` and `<!-- /mark -->` exchanged.
fn between(page: &str, text: &str, mark: &str, new: &str) -> Result<String, String> {
    let (begin, end) = (format!("<!-- {mark} -->\n"), format!("<!-- /{mark} -->\n"));
    let parts = text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
    let (before, after) = parts.ok_or_else(|| format!("{page} has no lines {} and {}", begin.trim(), end.trim()))?;
    Ok(format!("{before}{begin}\n{new}\n\n{end}{after}"))
}

/// When, and of which sources, as far as the system tells.
fn made() -> String {
    let says = |program: &str, words: &[&str]| {
        let output = Command::new(program).args(words).env("LC_ALL", "C").stderr(Stdio::null()).output().ok()?;
        let said = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        (output.status.success() && !said.is_empty()).then_some(said)
    };
    let day = says("date", &["-u", "+%-d %B %Y"]).map(|day| format!(" on {day},"));
    let commit = says("git", &["rev-parse", "--short", "HEAD"]).map(|commit| format!(" from commit {commit},"));
    [day, commit].into_iter().flatten().collect()
}

/// What the figures depend on most.
fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let about = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = about.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": ")).map(|(_, name)| name);
    format!("{cores} cores ({})", model.unwrap_or("of an unknown kind"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_exchanged_and_the_rest_stays() {
        let (begin, end) = ("<!-- bench-all -->", "<!-- /bench-all -->");
        let old = format!("before\n{begin}\nold\n{end}\nafter\n");
        let new = between(DOCS, &old, SHORT, "| new |").unwrap();
        assert_eq!(new, format!("before\n{begin}\n\n| new |\n\n{end}\nafter\n"));
        assert_eq!(between(DOCS, &new, SHORT, "| new |").unwrap(), new);
        assert!(between(DOCS, "no marks", ALL, "").is_err());
    }

    #[test]
    fn the_pages_have_the_marks() {
        for (page, mark) in [(DOCS, SHORT), (DOCS, ALL), (README, SHORT)] {
            let text = read(&format!("{}/{page}", tactograph_tools::ROOT)).unwrap();
            between(page, &text, mark, "").unwrap();
        }
    }
}
