//! The overview for those who change the library: does it name every module and every file?

use std::collections::BTreeSet;

use crate::{MAY_USE, complain, name_of, root, walk};

/// The overview for those who change the library has rows for each module, in the order of [`MAY_USE`], and in them
/// every file of the module, as often as there are files of that name, and none that is gone.
#[test]
fn the_overview_names_every_module_and_file() {
    let overview = std::fs::read_to_string(root().join("src/ARCHITECTURE.md")).expect("the overview");
    let rows = rows_of_modules(&overview);
    let modules: Vec<&str> = MAY_USE.iter().map(|(module, _)| *module).collect();
    assert_eq!(rows.iter().map(|(module, _)| *module).collect::<Vec<_>>(), modules);
    let mut files = Vec::new();
    walk(&root().join("src"), &mut files);
    let files: Vec<String> = files.iter().map(|file| name_of(file)).collect();
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    complain(rows.iter().flat_map(|(module, rows)| faults_of_rows(module, rows, &files)).collect());
}

/// Most letters of a row of the overview: nobody reads longer ones.
const LONGEST_ROW: usize = 300;

#[test]
fn rows_of_the_overview_are_short() {
    let overview = std::fs::read_to_string(root().join("src/ARCHITECTURE.md")).expect("the overview");
    let rows = overview.lines().enumerate().filter(|(_, line)| line.starts_with("| "));
    let long = rows.filter(|(_, row)| row.chars().count() > LONGEST_ROW);
    complain(
        long.map(|(number, _)| {
            let line = number + 1;
            format!("src/ARCHITECTURE.md:{line}: a row of more than {LONGEST_ROW} letters; begin another with `| | `")
        })
        .collect(),
    );
}

/// The modules of the overview with their rows: the one with the name of the module, and those that go on with it.
fn rows_of_modules(overview: &str) -> Vec<(&str, Vec<&str>)> {
    let mut modules: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in overview.lines() {
        if let Some((module, row)) = line.strip_prefix("| [`").and_then(|row| row.split_once("`] | ")) {
            modules.push((module, vec![row]));
        } else if let (Some(row), Some((_, rows))) = (line.strip_prefix("| | "), modules.last_mut()) {
            rows.push(row);
        }
    }
    modules
}

/// What of the files of a module its rows do not name, and what they name of files that are not there.
fn faults_of_rows(module: &str, rows: &[&str], files: &[&str]) -> Vec<String> {
    let mut folders_and_files = BTreeSet::new();
    let mut all_names: BTreeSet<&str> = BTreeSet::new();
    for file in files {
        let (path, is_rust) = match file.strip_suffix(".rs") {
            Some(path) => (path, true),
            None => (*file, false),
        };
        let path = path.strip_prefix("src/").unwrap_or_default();
        let parts: Vec<&str> = path.split('/').filter(|part| !["mod", "tests"].contains(part)).collect();
        if parts.first() == Some(&module) {
            all_names.extend(&parts[1..]);
            folders_and_files.extend((2..=parts.len()).filter(|_| is_rust).map(|length| parts[..length].to_vec()));
        }
    }
    let names: Vec<&str> = folders_and_files.iter().filter_map(|parts| parts.last().copied()).collect();
    let count = |name: &str, all: &[&str]| all.iter().filter(|other| **other == name).count();
    let told: Vec<&str> = rows.iter().flat_map(|row| told_in(row)).collect();
    let untold = folders_and_files.iter().filter_map(|parts| {
        let name = parts.last()?;
        (count(name, &told) < count(name, &names)).then(|| {
            format!(
                "src/{}: `{name}` is not in its rows of src/ARCHITECTURE.md as often as there are such",
                parts.join("/")
            )
        })
    });
    let gone = told.iter().filter(|name| !all_names.contains(*name));
    let gone = gone.map(|name| format!("src/ARCHITECTURE.md: `{name}` is no file of `{module}`"));
    untold.chain(gone).collect()
}

/// The names in backquotes in the last cell of a row that can be those of files; links to modules are none.
fn told_in(row: &str) -> Vec<&str> {
    let cell = row.trim_end().trim_end_matches('|').rsplit(" | ").next().unwrap_or_default();
    let quoted = cell.split('`').collect::<Vec<_>>();
    let is_name = |name: &str| name.chars().all(|of| of.is_ascii_lowercase() || of.is_ascii_digit() || of == '_');
    let words = quoted.windows(2).step_by(2).filter(|pair| !pair[0].ends_with('['));
    words.map(|pair| pair[1].trim_end_matches('/')).filter(|name| is_name(name)).collect()
}

#[test]
fn rows_without_a_file_and_files_without_a_row_are_found() {
    let rust = ["src/a/mod.rs", "src/a/b.rs", "src/a/b/tests.rs", "src/a/c/mod.rs", "src/a/c/b.rs", "src/d.rs"];
    let files = [&rust[..], &["src/a/data/e.txt"]].concat();
    let faults = |row: &str| faults_of_rows("a", &[row], &files);
    assert_eq!(faults("what it does | `b` (as [`d`] has it, in `data/`), `c/` (its own `b`) |"), [""; 0]);
    assert_eq!(faults("what it does | `b`, `c/` |").len(), 2, "which of the two is not told");
    assert_eq!(faults("what it does | `b`, `b`, `c`, `gone` |"), ["src/ARCHITECTURE.md: `gone` is no file of `a`"]);
    let rows = "| [`a`] | what it does | `b` |\n| | the rest | `c/`: `b` |\n| [`d`] | more | |\n| a word | another |";
    let rows = rows_of_modules(rows);
    assert_eq!(rows.iter().map(|(module, rows)| (*module, rows.len())).collect::<Vec<_>>(), [("a", 2), ("d", 1)]);
    assert_eq!(faults_of_rows("a", &rows[0].1, &files), [""; 0]);
}
