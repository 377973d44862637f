//! Several pages that belong together: one PDF, or files with numbers.

use std::path::{Path, PathBuf};

use tactograph::{Embossing, Error, Page, write_dots, write_pdf};

use super::args::Chosen;
use super::output::Existing;
use super::product::{DrawingFormat, Format, Product};
use super::{convert, output, places};

/// A file and the bytes that go there.
struct File {
    /// None is standard output.
    path: Option<PathBuf>,
    /// Whether the program made up the name.
    made_up: bool,
    bytes: Vec<u8>,
}

/// Writes pages that are called `title` together to the file that the user named, or to as many files as the format
/// takes. Returns the names.
///
/// # Errors
/// What is in the way, with the file that it is about. All files are looked at before the first is written.
pub(super) fn write(
    (title, pages): (&str, &[Page]),
    (chosen, embossing): (Chosen, Embossing),
    to: &Path,
    force: bool,
) -> Result<Vec<String>, (String, String)> {
    let product = Product::Page(chosen.format);
    let files = files(title, pages, (chosen, embossing), to)?;
    let name =
        |file: &File| file.path.as_ref().map_or_else(|| "standard output".into(), |path| path.display().to_string());
    let about = |file: &File, error: anyhow::Error| (name(file), format!("{error:#}"));
    for file in &files {
        if let Some(path) = &file.path {
            let existing = match (force, file.made_up) {
                (true, _) => Existing::Forced,
                (false, true) => Existing::KeepOthers,
                (false, false) => Existing::Named,
            };
            output::check(path, product, existing).map_err(|error| about(file, error))?;
        }
    }
    for file in &files {
        match &file.path {
            Some(path) => output::to_file(path, &file.bytes, product.noun()),
            None => output::to_stdout(&file.bytes, product.noun()),
        }
        .map_err(|error| about(file, error))?;
    }
    Ok(files.iter().map(name).collect())
}

fn files(
    title: &str,
    pages: &[Page],
    (chosen, embossing): (Chosen, Embossing),
    to: &Path,
) -> Result<Vec<File>, (String, String)> {
    let path = (!places::is_std(to)).then(|| to.to_path_buf());
    let about_target = |error: Error| (to.display().to_string(), error.to_string());
    let bytes = match chosen.format {
        Format::Dots(format) => write_dots(title, pages, format, embossing),
        Format::Drawing(DrawingFormat::Pdf) => write_pdf(title, pages).map(|file| vec![file]),
        Format::Drawing(format) => pages.iter().map(|page| convert::write(page, format, chosen)).collect(),
    };
    let mut bytes = bytes.map_err(about_target)?;
    match (bytes.len(), path) {
        (1, path) => Ok(bytes.drain(..).map(|bytes| File { path: path.clone(), made_up: false, bytes }).collect()),
        (count, None) => {
            let what =
                format!("{count} sheets do not go into one file of this format; add --format pdf, or name a file");
            Err(("standard output".into(), what))
        }
        (_, Some(path)) => {
            let numbered = (1..).zip(bytes).map(|(number, bytes)| File {
                path: Some(places::numbered(&path, number)),
                made_up: true,
                bytes,
            });
            Ok(numbered.collect())
        }
    }
}
