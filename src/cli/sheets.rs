//! Several pages that belong together: one PDF, or files with numbers.

use std::path::{Path, PathBuf};

use tactograph::{Calibration, Error, Page, write_pdf};

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

/// Writes calibration sheets to the file that the user named, or to as many files as the format takes. Returns the
/// names.
///
/// # Errors
/// What is in the way, with the file that it is about. All files are looked at before the first is written.
pub(super) fn write(
    calibration: &Calibration,
    (format, chosen): (DrawingFormat, Chosen),
    to: &Path,
    force: bool,
) -> Result<Vec<String>, (String, String)> {
    let product = Product::Page(Format::Drawing(format));
    let files = files(&calibration.title, &calibration.pages, (format, chosen), to)?;
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
    (format, chosen): (DrawingFormat, Chosen),
    to: &Path,
) -> Result<Vec<File>, (String, String)> {
    let path = (!places::is_std(to)).then(|| to.to_path_buf());
    let one = |bytes| vec![File { path: path.clone(), made_up: false, bytes }];
    let about_target = |error: Error| (to.display().to_string(), error.to_string());
    let bytes = |page| convert::write(page, format, chosen).map_err(about_target);
    match (pages, &path) {
        (_, _) if format == DrawingFormat::Pdf => write_pdf(title, pages).map(one).map_err(about_target),
        ([page], _) => Ok(one(bytes(page)?)),
        (_, None) => {
            let what = format!(
                "{} sheets do not go into one file of this format; add --format pdf, or name a file",
                pages.len()
            );
            Err(("standard output".into(), what))
        }
        (_, Some(path)) => {
            let numbered = pages.iter().enumerate().map(|(index, page)| {
                Ok(File { path: Some(places::numbered(path, index + 1)), made_up: true, bytes: bytes(page)? })
            });
            numbered.collect()
        }
    }
}
