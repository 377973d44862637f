//! A table of titles: what the page of each picture is called, and what is on it.

use std::fmt;
use std::path::{Component, Path, PathBuf};

use tactograph::Options;

use super::{input, places};

/// Largest table, bytes: some ten thousand pictures.
const MOST_BYTES: u64 = 4 << 20;
/// The columns that there are.
const COLUMNS: &str = "the columns are file, title and alt";

/// The table.
#[derive(Debug, Default)]
pub(super) struct Titles {
    /// As it was given.
    table: String,
    rows: Vec<Row>,
}

/// The words for one picture.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Row {
    line: u64,
    /// Name of the picture, with or without its directory.
    file: PathBuf,
    title: Option<String>,
    alt: Option<String>,
}

impl Titles {
    /// Reads a table.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its line.
    pub(super) fn read(path: &Path) -> Result<Self, Vec<String>> {
        let table = path.display().to_string();
        let of_table = |what: &dyn fmt::Display| vec![format!("--titles {table}: {what}")];
        let bytes = input::read(path, MOST_BYTES, "this is too large for a table of titles")
            .map_err(|error| of_table(&format!("{error:#}")))?;
        let text =
            String::from_utf8(bytes).map_err(|_| of_table(&"this is not text in UTF-8; save it as CSV in UTF-8"))?;
        let rows = rows(&text)
            .map_err(|faults| faults.iter().map(|fault| format!("--titles {table}, {fault}")).collect::<Vec<_>>())?;
        Ok(Self { table, rows })
    }

    /// The row of a picture: that of its whole path, else that of its name.
    fn of(&self, picture: &Path) -> Option<&Row> {
        let by_name =
            || self.rows.iter().find(|row| is_bare(&row.file) && picture.file_name() == Some(row.file.as_os_str()));
        self.rows.iter().find(|row| row.file == plain(picture)).or_else(by_name)
    }

    /// Rows that are of more than one of these pictures, one message each.
    pub(super) fn faults(&self, pictures: &[PathBuf]) -> Vec<String> {
        let of_two = |row: &Row| {
            let mut own = pictures.iter().filter(|picture| self.of(picture) == Some(row));
            let one = own.next()?;
            let two = own.find(|other| *other != one)?;
            Some(format!(
                "--titles {}, line {}: {} is the name of both {} and {}; write it with its directory",
                self.table,
                row.line,
                row.file.display(),
                one.display(),
                two.display()
            ))
        };
        self.rows.iter().filter_map(of_two).collect()
    }

    /// Pictures without a row, or without words in it: what each is about, and what is to be known.
    pub(super) fn without_words(&self, pictures: &[PathBuf]) -> Vec<(String, String)> {
        let told = pictures.iter().filter_map(|picture| {
            if let Some(Row { line, title, alt, .. }) = self.of(picture) {
                let what = format!("{}, line {line} has neither a title nor an alt for it", self.table);
                return (title.is_none() && alt.is_none()).then(|| (places::picture_name(picture), what));
            }
            let mut what = format!("{} has no row for it, so it gets no title from there", self.table);
            let name = picture.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
            let alike = |row: &&Row| row.file.to_string_lossy().to_lowercase() == name;
            if let Some(Row { line, file, .. }) = self.rows.iter().find(alike) {
                what += &format!("; line {line} has {}, in other capitals", file.display());
            }
            Some((places::picture_name(picture), what))
        });
        told.collect()
    }

    /// Rows without a picture, in the same way.
    pub(super) fn without_picture(&self, pictures: &[PathBuf]) -> Vec<(String, String)> {
        let is_used = |row: &Row| pictures.iter().any(|picture| self.of(picture) == Some(row));
        let without_picture = self.rows.iter().filter(|row| !is_used(row)).map(|row| {
            let what = format!("no picture that is given is called {}", row.file.display());
            (format!("{}, line {}", self.table, row.line), what)
        });
        without_picture.collect()
    }

    /// Puts the words for a picture into the options of the library.
    pub(super) fn add_to(&self, options: Options, picture: &Path) -> Options {
        let Some(Row { title, alt, .. }) = self.of(picture) else { return options };
        let options = title.iter().fold(options, |options, title| options.title(title));
        alt.iter().fold(options, |options, alt| options.description(alt))
    }
}

/// A path without `./` before it.
fn plain(path: &Path) -> PathBuf {
    path.components().filter(|part| *part != Component::CurDir).collect()
}

/// Whether a name has no directory.
fn is_bare(file: &Path) -> bool {
    file.file_name() == Some(file.as_os_str())
}

/// The rows below the heading.
///
/// # Errors
/// Everything that is wrong, each with its line.
fn rows(text: &str) -> Result<Vec<Row>, Vec<String>> {
    let text = text.trim_start_matches('\u{feff}');
    let heading = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    // what stands between the names of the columns, in none of them and in no name of a file: programs for tables
    // write a comma, a semicolon or a tab
    let is_parting = |sign: &char| *sign == '\t' || sign.is_ascii_punctuation() && !"\"_-./\\".contains(*sign);
    let parting = heading.chars().find(is_parting);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(parting.unwrap_or(',') as u8)
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    // The reader counts a record from the end of the one before it, so that blank lines would count for the next.
    let line_at = |byte: u64| {
        let from = usize::try_from(byte).unwrap_or(usize::MAX).min(text.len());
        let blank = text[from..].len() - text[from..].trim_start().len();
        text[..from + blank].matches('\n').count() as u64 + 1
    };
    let records = reader.records().map(|record| {
        let record = record.map_err(|error| error.to_string())?;
        Ok((line_at(record.position().map_or(0, csv::Position::byte)), record))
    });
    let records = records.collect::<Result<Vec<_>, String>>().map_err(|error| vec![error])?;
    let mut records = records.into_iter();
    let Some((line, heading)) = records.next() else {
        return Err(vec![format!("line 1: the table is empty; {COLUMNS}")]);
    };
    let columns = Columns::of(&heading).map_err(|faults| at_line(line, faults))?;
    let (mut rows, mut faults) = (Vec::<Row>::new(), Vec::new());
    for (line, record) in records.filter(|(_, record)| record.iter().any(|field| !field.is_empty())) {
        match columns.row(line, &record) {
            Ok(row) => match rows.iter().find(|other| other.file == row.file) {
                Some(Row { line: first, file, .. }) => {
                    faults.push(format!("line {line}: {} has a row already, line {first}; keep one", file.display()));
                }
                None => rows.push(row),
            },
            Err(more) => faults.extend(at_line(line, more)),
        }
    }
    if faults.is_empty() { Ok(rows) } else { Err(faults) }
}

fn at_line(line: u64, faults: Vec<String>) -> Vec<String> {
    faults.into_iter().map(|fault| format!("line {line}: {fault}")).collect()
}

/// Where each column stands.
struct Columns {
    count: usize,
    file: usize,
    title: usize,
    alt: Option<usize>,
}

impl Columns {
    /// From the heading.
    fn of(heading: &csv::StringRecord) -> Result<Self, Vec<String>> {
        let names: Vec<String> = heading.iter().map(str::to_lowercase).collect();
        let mut faults = Vec::new();
        for (i, name) in names.iter().enumerate() {
            if !["file", "title", "alt", ""].contains(&name.as_str()) {
                faults.push(format!("there is no column \"{}\"; {COLUMNS}", name.chars().take(20).collect::<String>()));
            } else if !name.is_empty() && names[..i].contains(name) {
                faults.push(format!("the column {name} is there twice"));
            }
        }
        let at = |name: &str| names.iter().position(|own| own == name);
        match (at("file"), at("title")) {
            (Some(file), Some(title)) if faults.is_empty() => {
                Ok(Self { count: names.len(), file, title, alt: at("alt") })
            }
            (file, title) => {
                let missing = [("file", file), ("title", title)].into_iter().filter(|(_, at)| at.is_none());
                faults.extend(missing.map(|(name, _)| {
                    format!("the heading has no column {name}; {COLUMNS}, and the first line has their names")
                }));
                Err(faults)
            }
        }
    }

    fn row(&self, line: u64, record: &csv::StringRecord) -> Result<Row, Vec<String>> {
        // a line break in a cell of a table is no more than a blank
        let field = |at: usize| record.get(at).map(|text| text.replace("\r\n", " ").replace(['\n', '\r'], " "));
        let words = |at: usize| field(at).filter(|text| !text.trim().is_empty());
        let (file, title, alt) = (words(self.file), words(self.title), self.alt.and_then(words));
        let mut faults = Vec::new();
        if record.iter().skip(self.count).any(|field| !field.is_empty()) {
            faults.push(format!(
                "there are {} columns, and the heading has {}; put a text that has the sign between columns in it in \
                 quotation marks",
                record.len(),
                self.count
            ));
        }
        if file.is_none() {
            faults.push("there is no name of a file".to_owned());
        }
        match file {
            Some(file) if faults.is_empty() => Ok(Row { line, file: plain(Path::new(&file)), title, alt }),
            _ => Err(faults),
        }
    }
}

#[cfg(test)]
mod tests;
