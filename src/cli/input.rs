//! Files and standard input into memory, with a limit.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use anyhow::{anyhow, bail};
use tactograph::Format;

/// The file at `path`, or standard input for `-`.
///
/// # Errors
/// In plain words without the file's name: it is not there, is a directory, may not be read, or is longer than
/// `most_bytes`, for which `too_long` is said.
pub(super) fn read(path: &Path, most_bytes: u64, too_long: &str) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if super::places::is_std(path) {
        limited(&mut io::stdin().lock(), &mut bytes, most_bytes)
    } else {
        let file = File::open(path).map_err(|error| not_there(path, &error))?;
        // Room for the whole file at once saves copying; the length is only a hint (pipes have none).
        let length = file.metadata().map_or(0, |data| data.len()).min(most_bytes);
        bytes.reserve_exact(usize::try_from(length).unwrap_or(0).saturating_add(1));
        limited(&mut { file }, &mut bytes, most_bytes)
    }
    .map_err(|error| explain(&error))?;
    if bytes.len() as u64 > most_bytes {
        bail!("{too_long}");
    }
    Ok(bytes)
}

/// Most bytes that are read of the file of a page, as many as the library takes.
const MOST_OF_PAGE: u64 = 100_000_000;

/// The file of a page.
///
/// # Errors
/// As [`read`].
pub(super) fn read_page(path: &Path) -> anyhow::Result<Vec<u8>> {
    read(path, MOST_OF_PAGE, "the file is longer than 100 MB, which is no page")
}

/// Looks whether there is a file at `path` that can be read, or that standard input is meant.
///
/// # Errors
/// As [`read`], for what can be known before reading.
pub(super) fn check(path: &Path) -> anyhow::Result<()> {
    if super::places::is_std(path) {
        return Ok(());
    }
    let found = std::fs::metadata(path).map_err(|error| not_there(path, &error))?;
    if found.is_dir() {
        return Err(explain(&ErrorKind::IsADirectory.into()));
    }
    Ok(())
}

/// What is said of a page that is a file of dots, by its name, to a command that reads the SVG of one.
pub(super) fn other_than_svg(page: &Path, command: &str) -> Option<String> {
    let Format::Dots(format) = Format::of_extension(page.extension()?.to_str()?)? else { return None };
    Some(format!(
        "this is a page as {}, which holds dots only, and {command} reads the SVG of a page; write it with the same \
         profile and -o {}, and {command} that",
        format.name().to_uppercase(),
        page.with_extension("svg").display()
    ))
}

/// Reads one byte more than allowed, to tell "just fits" from "too long".
fn limited(from: &mut dyn Read, bytes: &mut Vec<u8>, most_bytes: u64) -> io::Result<usize> {
    from.take(most_bytes.saturating_add(1)).read_to_end(bytes)
}

/// Why a file cannot be read. A page of several sheets has files with numbers, which are named.
fn not_there(path: &Path, error: &io::Error) -> anyhow::Error {
    let sheets = if error.kind() == ErrorKind::NotFound { sheets_of(path) } else { Vec::new() };
    match &sheets[..] {
        [] => explain(error),
        [only] => anyhow!("there is no such file, but {only}; name that"),
        [first, .., last] => anyhow!("there is no such file, but sheets of it, {first} to {last}; name one of them"),
    }
}

/// The names of the files that `path` would have as several sheets: a-1.svg, a-2.svg for a.svg.
fn sheets_of(path: &Path) -> Vec<String> {
    let (Some(stem), Some(ending)) = (path.file_stem(), path.extension()) else { return Vec::new() };
    let sheet = |number: usize| {
        path.with_file_name(format!("{}-{number}.{}", stem.to_string_lossy(), ending.to_string_lossy()))
    };
    (1..).map(sheet).take_while(|path| path.is_file()).map(|path| path.display().to_string()).collect()
}

fn explain(error: &io::Error) -> anyhow::Error {
    match error.kind() {
        ErrorKind::NotFound => anyhow!("there is no such file; check the name"),
        ErrorKind::NotADirectory => anyhow!("a part of this path is a file, not a directory; check the name"),
        ErrorKind::IsADirectory => anyhow!("this is a directory; name the files in it"),
        ErrorKind::PermissionDenied => anyhow!("you have no permission to read it; change that or use a copy"),
        ErrorKind::OutOfMemory => anyhow!("it is too large for this machine's memory; use a smaller file"),
        _ => anyhow!("it cannot be read ({error}); try again or use a copy"),
    }
}
