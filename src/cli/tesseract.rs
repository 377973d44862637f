//! Words in bitmaps by an installed Tesseract: it gets each line of text that was found as a picture, and gives words.

use std::ffi::OsString;
use std::time::Duration;

use super::external::Program;

/// The program.
const PROGRAM: Program = Program { name: "tesseract", remedy: "install Tesseract (tesseract-ocr), or leave --ocr out" };
/// Its three letters of a language for the two of a tag (ISO 639-2).
const LANGUAGES: &[(&str, &str)] = &[
    ("bg", "bul"),
    ("ca", "cat"),
    ("cs", "ces"),
    ("da", "dan"),
    ("de", "deu"),
    ("el", "ell"),
    ("en", "eng"),
    ("es", "spa"),
    ("et", "est"),
    ("eu", "eus"),
    ("fi", "fin"),
    ("fr", "fra"),
    ("ga", "gle"),
    ("gl", "glg"),
    ("hr", "hrv"),
    ("hu", "hun"),
    ("is", "isl"),
    ("it", "ita"),
    ("lt", "lit"),
    ("lv", "lav"),
    ("nb", "nor"),
    ("nl", "nld"),
    ("nn", "nor"),
    ("no", "nor"),
    ("pl", "pol"),
    ("pt", "por"),
    ("ro", "ron"),
    ("ru", "rus"),
    ("sk", "slk"),
    ("sl", "slv"),
    ("sr", "srp"),
    ("sv", "swe"),
    ("tr", "tur"),
    ("uk", "ukr"),
];
/// How long the list of languages may take, and reading; the latter and so much more for each line. A line takes 0.1 s.
const LISTING: Duration = Duration::from_secs(20);
const READING: Duration = Duration::from_secs(30);
const READING_OF_LINE: Duration = Duration::from_secs(5);
/// A word of which Tesseract is less sure than this, in percent, is taken as not read.
const LEAST_SURE: f32 = 50.0;

/// What Tesseract calls a language, if it has it.
///
/// # Errors
/// In one line, if Tesseract or its data of the language is not installed.
pub(super) fn language(tag: &str) -> Result<String, String> {
    let primary = tag.split('-').next().unwrap_or(tag).to_ascii_lowercase();
    let known = LANGUAGES.iter().find(|(two, _)| *two == primary).map(|(_, three)| (*three).to_owned());
    let name = match known {
        Some(name) => name,
        None if primary.len() == 3 => primary,
        None => {
            let why = "it is not known what Tesseract calls the language";
            return Err(format!("--ocr: {why} {primary}; give its three letters (ISO 639-2) with --lang"));
        }
    };
    let listed = PROGRAM.run(&["--list-langs"], &[], LISTING).map_err(|why| format!("--ocr: {why}"))?;
    let listed = String::from_utf8_lossy(&listed.out).into_owned() + &listed.told;
    if listed.lines().any(|line| line.trim() == name) {
        Ok(name)
    } else {
        Err(format!("--ocr: tesseract has no data of the language {name}; install it (tesseract-ocr-{name})"))
    }
}

/// The words in pictures of a line each, in PNG; empty where none can be read.
///
/// # Errors
/// In one line, if Tesseract fails.
pub(super) fn read(language: &str, lines: &[Vec<u8>]) -> Result<Vec<String>, String> {
    let folder = tempfile::tempdir().map_err(|error| format!("no folder for the texts can be made: {error}"))?;
    let no_file = |error| format!("the texts cannot be written to a temporary folder: {error}");
    let mut list = Vec::new();
    for (number, line) in lines.iter().enumerate() {
        let path = folder.path().join(format!("{number}.png"));
        std::fs::write(&path, line).map_err(no_file)?;
        list.extend_from_slice(path.as_os_str().as_encoded_bytes());
        list.push(b'\n');
    }
    let path = folder.path().join("lines.txt");
    std::fs::write(&path, list).map_err(no_file)?;
    // each picture is one line of text
    let args = ["stdout", "-l", language, "--psm", "7", "--dpi", "300", "tsv"].map(OsString::from);
    let args = [&[path.into_os_string()][..], &args].concat();
    let written = PROGRAM.run(&args, &[], READING + READING_OF_LINE * lines.len() as u32)?;
    words(&String::from_utf8_lossy(&written.out), lines.len())
}

/// The words of each page in a table of Tesseract: level, page, block, paragraph, line, word, four numbers of its
/// place, how sure it is, and the word.
fn words(table: &str, pages: usize) -> Result<Vec<String>, String> {
    const WORD: &str = "5";
    let mut words = vec![String::new(); pages];
    let mut rows = table.lines();
    if !rows.next().is_some_and(|heading| heading.starts_with("level\tpage_num\t")) {
        return Err("tesseract writes no table of words".to_owned());
    }
    for row in rows {
        let columns: Vec<&str> = row.splitn(12, '\t').collect();
        let [WORD, page, .., sure, word] = columns[..] else { continue };
        let page = page.parse::<usize>().ok().and_then(|page| page.checked_sub(1)).and_then(|at| words.get_mut(at));
        let is_sure = sure.parse::<f32>().is_ok_and(|sure| sure >= LEAST_SURE);
        if let (Some(page), true) = (page, is_sure) {
            *page += word.trim();
            page.push(' ');
        }
    }
    words.iter_mut().for_each(|words| words.truncate(words.trim_end().len()));
    Ok(words)
}

#[cfg(test)]
mod tests;
