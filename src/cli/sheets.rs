//! Pages that belong together, as files: one for all, or files with numbers where a format holds one sheet.

use std::path::Path;
use std::sync::OnceLock;

use tactograph::{Embossing, Error, Fonts, Note, Page, write_dots, write_pdf};

use super::args::Chosen;
use super::interrupt;
use super::output::{self, Existing};
use super::places::{self, Target};
use super::product::{DrawingFormat, Format, Product};

/// A file that is to be written.
pub(super) struct Piece<'a> {
    pub(super) target: Target,
    product: Product,
    existing: Existing,
    pub(super) bytes: &'a [u8],
}

/// Nothing was written: the file that stands in the way, and why.
pub(super) struct Failure {
    pub(super) file: String,
    pub(super) what: String,
}

/// What becomes of the file at a name that the program made up.
pub(super) type MadeUp<'a> = &'a dyn Fn(&Path) -> Existing;

/// The fonts of this machine, found once for all pictures.
pub(super) fn installed_fonts() -> &'static Fonts {
    static FONTS: OnceLock<Fonts> = OnceLock::new();
    FONTS.get_or_init(Fonts::system)
}

/// Pages that are called `title` together, in a format: one file, or one for each page.
///
/// # Errors
/// If the format cannot hold them.
pub(super) fn encode(
    title: &str,
    pages: &[Page],
    format: Format,
    chosen: Chosen,
    embossing: Embossing,
) -> Result<Vec<Vec<u8>>, Error> {
    let drawn = |page: &Page, format| page.to_drawing(format, chosen.dpi, chosen.depth, installed_fonts());
    match (format, pages) {
        (Format::Dots(format), pages) => write_dots(title, pages, format, embossing),
        (Format::Drawing(format), [page]) => drawn(page, format).map(|file| vec![file]),
        (Format::Drawing(DrawingFormat::Pdf), pages) => write_pdf(title, pages).map(|file| vec![file]),
        (Format::Drawing(format), pages) => pages.iter().map(|page| drawn(page, format)).collect(),
    }
}

/// What pages have that is not in their files of these formats; told once.
pub(super) fn not_in(pages: &[Page], formats: [Option<Format>; 2]) -> Option<Note> {
    let has_png = formats.contains(&Some(Format::Drawing(DrawingFormat::Png)));
    pages.iter().filter(|_| has_png).find_map(|page| page.not_in_png(installed_fonts()))
}

/// Where the files go: one to its target, several to names with numbers.
///
/// # Errors
/// Several files do not go to standard output.
pub(super) fn pieces<'a>(
    product: Product,
    target: &Target,
    files: &'a [Vec<u8>],
    made_up: MadeUp<'_>,
) -> Result<Vec<Piece<'a>>, Failure> {
    let piece =
        |target: Target, bytes: &'a Vec<u8>| Piece { existing: target.existing(made_up), target, product, bytes };
    match (files, target.path()) {
        ([file], _) => Ok(vec![piece(target.clone(), file)]),
        // The names with numbers are made up, also where the one without was given.
        (files, Some(path)) => {
            let numbered = (1..).zip(files);
            Ok(numbered.map(|(number, file)| piece(Target::Derived(places::numbered(path, number)), file)).collect())
        }
        (files, None) => {
            let instead = match product {
                Product::Page(Format::Dots(_)) => "name a file, or add --no-overview",
                _ => "add --format pdf, or name a file",
            };
            let what = format!("{} sheets do not go into one file of this format; {instead}", files.len());
            Err(Failure { file: places::target_name(target), what })
        }
    }
}

/// Writes all or, as far as can be known before, nothing.
///
/// # Errors
/// What is in the way of the first file that cannot be written.
pub(super) fn write(pieces: &[Piece<'_>]) -> Result<(), Failure> {
    let about = |piece: &Piece<'_>, error: anyhow::Error| Failure {
        file: places::target_name(&piece.target),
        what: format!("{error:#}"),
    };
    for piece in pieces {
        if let Some(path) = piece.target.path() {
            output::check(path, piece.product, piece.existing)
                .and_then(|()| output::check_bytes(path, piece.product, piece.existing, piece.bytes))
                .map_err(|error| about(piece, error))?;
        }
    }
    // All are complete on the disk before the first takes its name.
    let mut staged = Vec::new();
    for piece in pieces {
        if let Some(path) = piece.target.path() {
            let noun = piece.product.noun();
            staged.push((piece, output::stage(path, piece.bytes, noun).map_err(|error| about(piece, error))?));
        }
    }
    for piece in pieces.iter().filter(|piece| piece.target.path().is_none()) {
        interrupt::leaves();
        output::to_stdout(piece.bytes, piece.product.noun()).map_err(|error| about(piece, error))?;
    }
    interrupt::one_more(|| {
        staged.into_iter().try_for_each(|(piece, staged)| staged.commit().map_err(|error| about(piece, error)))
    })
}

/// What files are called together in a message.
pub(super) fn names(pieces: &[Piece<'_>]) -> String {
    let name = |piece: Option<&Piece<'_>>| piece.map_or_else(String::new, |piece| places::target_name(&piece.target));
    match pieces {
        [_] | [] => name(pieces.first()),
        _ => format!("{} to {}", name(pieces.first()), name(pieces.last())),
    }
}

/// Pages that are called `title` together, and where they go.
pub(super) struct Document<'a> {
    pub(super) title: &'a str,
    pub(super) pages: &'a [Page],
    pub(super) target: Target,
}

/// Writes pages that are called `title` together, and their preview if one is asked for, to the file that the user
/// named, or to as many files as the formats take. Returns the names, each with how many sheets it has if there is one
/// file for several.
///
/// # Errors
/// What is in the way, with the file that it is about.
pub(super) fn write_pages(
    (title, pages): (&str, &[Page]),
    how: (Chosen, Embossing),
    to: &Path,
    force: bool,
) -> Result<Vec<String>, Failure> {
    let target = if places::is_std(to) { Target::Stdout } else { Target::Named(to.to_path_buf()) };
    write_documents(&[Document { title, pages, target }], how, force)
}

/// The same of several documents: all of them or, as far as can be known before, none.
///
/// # Errors
/// As [`write_pages`].
pub(super) fn write_documents(
    documents: &[Document<'_>],
    (chosen, embossing): (Chosen, Embossing),
    force: bool,
) -> Result<Vec<String>, Failure> {
    let encoded = |document: &Document<'_>, format| {
        encode(document.title, document.pages, format, chosen, embossing)
            .map_err(|error| Failure { file: places::target_name(&document.target), what: error.to_string() })
    };
    let mut files = Vec::new();
    for document in documents {
        files.push((chosen.format, document.target.clone(), encoded(document, chosen.format)?, document.pages));
        let preview = chosen.preview.map(Format::Drawing).zip(places::preview(&document.target, chosen.preview));
        if let Some((format, path)) = preview {
            files.push((format, Target::Derived(path), encoded(document, format)?, document.pages));
        }
    }
    let made_up = |_: &Path| if force { Existing::Forced } else { Existing::KeepOthers };
    let (mut all, mut told) = (Vec::new(), Vec::new());
    for (format, target, files, pages) in &files {
        all.extend(pieces(Product::Page(*format), target, files, &made_up)?);
        told.extend(after_names(files.len(), pages));
    }
    write(&all)?;
    Ok(all.iter().zip(told).map(|(piece, sheets)| places::target_name(&piece.target) + &sheets).collect())
}

/// What is said after the name of each of so many files of pages.
fn after_names(count: usize, pages: &[Page]) -> Vec<String> {
    let parts: Vec<String> = pages.iter().map(Page::part_of_set).collect();
    match count {
        // a figure alone is the page itself
        1 if parts.len() == 1 && parts[0] != "figure" => vec![format!(": {}", parts[0])],
        1 => vec![output::and_sheets(&parts, 1)],
        // of several files each is named by itself
        _ if count == parts.len() && !output::are_alike(&parts) => {
            parts.iter().map(|part| format!(": {part}")).collect()
        }
        _ => vec![String::new(); count],
    }
}
