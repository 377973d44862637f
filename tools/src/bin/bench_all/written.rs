//! The tables in docs/speed.md, and the first of them in README.md.

use std::fs;

use crate::args::Args;
use crate::table::Table;

const README: &str = "README.md";
const DOCS: &str = "docs/speed.md";
/// What stands in the README between these is written anew.
const BEGIN: &str = "<!-- bench-all -->\n";
const END: &str = "<!-- /bench-all -->\n";

/// Writes both.
///
/// # Errors
/// A file cannot be written, or the README lacks the marks between which the table stands.
pub(crate) fn write(short: &Table, tables: &[Table], args: &Args) -> Result<(), String> {
    let readme = fs::read_to_string(README).map_err(|fault| format!("{README}: {fault}"))?;
    fs::write(README, between(&readme, &short.body())?).map_err(|fault| format!("{README}: {fault}"))?;
    let mut docs = format!(
        "# How fast it is\n\n`cargo run --release -p tactograph-tools --bin bench_all -- --write` made these tables, on {}, with {} rounds. \
         Other machines take other times; the ratios are what to look at. How each figure is taken stands at the head of \
         [the program](../tools/src/bin/bench_all/main.rs).\n\n",
        machine(),
        args.runs
    );
    docs.extend(tables.iter().map(Table::text));
    fs::write(DOCS, docs.trim_end().to_owned() + "\n").map_err(|fault| format!("{DOCS}: {fault}"))
}

fn between(text: &str, table: &str) -> Result<String, String> {
    let parts = text.split_once(BEGIN).and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    let (before, after) = parts.ok_or_else(|| format!("{README} has no lines {} and {}", BEGIN.trim(), END.trim()))?;
    Ok(format!("{before}{BEGIN}\n{table}\n{END}{after}"))
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
        let old = format!("before\n{BEGIN}old\n{END}after\n");
        let new = between(&old, "| new |\n").unwrap();
        assert_eq!(new, format!("before\n{BEGIN}\n| new |\n\n{END}after\n"));
        assert_eq!(between(&new, "| new |\n").unwrap(), new);
        assert!(between("no marks", "").is_err());
    }
}
