//! The tables in docs/speed.md, a short one for everybody and all of them, and the few rows in README.md.

use std::fs;

use tactograph_tools::marks;

use crate::args::Args;
use crate::readme;
use crate::table::Table;

const DOCS: &str = "docs/speed.md";
const README: &str = "README.md";
/// Marks between whose lines a page is written anew.
const SHORT: &str = "bench-all";
const ALL: &str = "bench-all-tables";

/// Writes all of them. `made` says when and of which sources.
///
/// # Errors
/// A page cannot be written, or lacks the marks between which the tables stand; a row of README was not measured.
pub(crate) fn write(short: &Table, tables: &[Table], args: &Args, made: &str) -> Result<(), String> {
    marks::write(DOCS, SHORT, &short.body())?;
    let mut all = format!(
        "Made by `{}` {made}, on {}, with {} rounds. Other machines take other times; the ratios are what to look at. How \
         each figure is taken stands at the head of [the program](../tools/src/bin/bench_all/main.rs).\n\n",
        marks::command("bench_all"),
        machine(),
        args.runs
    );
    all.extend(tables.iter().map(Table::text));
    marks::write(DOCS, ALL, &all)?;
    // last, so that a row that it lacks costs no other table
    marks::write(README, SHORT, &readme::table(tables)?.body())
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
    fn the_pages_have_the_marks() {
        for (page, mark) in [(DOCS, SHORT), (DOCS, ALL), (README, SHORT)] {
            let text = fs::read_to_string(format!("{}/{page}", tactograph_tools::ROOT)).unwrap();
            marks::exchanged(page, &text, mark, "").unwrap();
        }
    }
}
