//! Could contracted braille be written without an installed liblouis? Gives the phrases in `tests/braille/phrases` to
//! louis-rs (pure Rust, LGPL) and to liblouis itself, by the same tables, and prints in how many the two agree:
//!
//! ```text
//! cargo run --release --manifest-path tools/louis/Cargo.toml
//! ```
//!
//! It needs liblouis with its tables and `lou_translate` (`liblouis-bin` on Debian). `TABLES` in the environment names
//! another directory of tables than `/usr/share/liblouis/tables`.

use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use louis::{Direction, Translator};

/// Contracted tables of the languages for which `braille.grade = 2` has one.
const TABLES: &[(&str, &str)] = &[
    ("de", "de-g2.ctb"),
    ("en", "en-ueb-g2.ctb"),
    ("es", "es-g2.ctb"),
    ("fr", "fr-bfu-g2.ctb"),
    ("pt", "pt-pt-g2.ctb"),
    ("sv", "sv-g2.ctb"),
];
/// The table that writes cells as Unicode braille.
const DISPLAY: &str = "unicode.dis";

fn main() -> Result<(), Box<dyn Error>> {
    let tables = std::env::var_os("TABLES").map_or_else(|| "/usr/share/liblouis/tables".into(), PathBuf::from);
    let recorded = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/braille/phrases");
    println!("| table | phrases | the same in louis-rs |\n|---|---|---|");
    for (language, table) in TABLES {
        let recorded = std::fs::read_to_string(recorded.join(format!("{language}.tsv")))?;
        let phrases: Vec<&str> = recorded.lines().filter_map(|line| line.split('\t').next()).collect();
        let wanted = by_liblouis(table, &tables, &phrases)?;
        let louis = Translator::with_search_path(&[DISPLAY, table], Direction::Forward, vec![tables.clone()])
            .map_err(|why| format!("{table}: {why}"))?;
        let mut same = 0;
        for (phrase, wanted) in phrases.iter().zip(&wanted) {
            same += u32::from(louis.translate(phrase)? == *wanted);
        }
        println!("| `{table}` | {} | {same} |", phrases.len());
    }
    Ok(())
}

/// What liblouis makes of the phrases.
fn by_liblouis(table: &str, tables: &Path, phrases: &[&str]) -> Result<Vec<String>, Box<dyn Error>> {
    let mut program = Command::new("lou_translate")
        .args(["--forward", &format!("{DISPLAY},{table}")])
        .env("LOUIS_TABLEPATH", tables)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|why| format!("lou_translate: {why}; install liblouis (liblouis-bin)"))?;
    let mut stdin = program.stdin.take().ok_or("lou_translate takes no text")?;
    let asked: String = phrases.iter().map(|phrase| format!("{phrase}\n")).collect();
    // beside reading, as it writes while it reads
    let given = std::thread::spawn(move || stdin.write_all(asked.as_bytes()));
    let written = String::from_utf8(program.wait_with_output()?.stdout)?;
    given.join().map_err(|_| "phrases were not given")??;
    let written: Vec<String> = written.lines().map(str::to_owned).collect();
    if written.len() == phrases.len() {
        Ok(written)
    } else {
        Err(format!("{table}: {} lines of braille for {} phrases", written.len(), phrases.len()).into())
    }
}
