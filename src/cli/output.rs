//! Files out: complete or not at all.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use anyhow::{anyhow, bail};

use super::product::Product;
use super::temporary::Temporary;

/// What becomes of a file that is there already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Existing {
    /// It is replaced only if it is as this program wrote it: a name that the user did not give must not cost them a
    /// drawing, nor the work they put into a page.
    KeepOthers,
    /// It is replaced, for the user named it.
    Named,
    /// It is replaced, whoever wrote it, because of `--force`.
    Forced,
}

/// Most symbolic links followed from a name to its file, as many as Linux allows.
const MOST_LINKS: usize = 40;

/// Writes to standard output what is called `noun` in messages. A reader that has gone away (`| head`) is no error.
///
/// # Errors
/// In plain words, such as when the disk behind it is full.
pub(super) fn to_stdout(bytes: &[u8], noun: &str) -> anyhow::Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        done => done.map_err(|error| explain(&error, noun)),
    }
}

/// Looks for what would keep a result from being written to `path`, so that it is told before the work and not after.
///
/// A file to be kept unless it is as this program wrote it may also be empty. Formats that cannot tell who wrote a
/// file are for [`check_bytes`].
///
/// # Errors
/// In plain words, without the path.
pub(super) fn check(path: &Path, product: Product, existing: Existing) -> anyhow::Result<()> {
    let noun = product.noun();
    let Some((path, found)) = check_place(path, noun)? else { return Ok(()) };
    let kept = existing == Existing::KeepOthers && !product.has_no_seal() && found.is_file() && found.len() > 0;
    if kept && !is_own(&path, product)? {
        bail!(
            "this file exists and was not written by tactograph, or changed since; name the {noun} with -o, move that \
             file away, or replace it with --force"
        );
    }
    Ok(())
}

/// Looks whether a file can be written to `path`. Returns the file that is there already, with the links to it
/// followed.
///
/// # Errors
/// In plain words, without the path.
pub(super) fn check_place(path: &Path, noun: &str) -> anyhow::Result<Option<(PathBuf, Metadata)>> {
    let path = follow(path, noun)?;
    match fs::metadata(&path) {
        Ok(found) => {
            refuse(&found, noun)?;
            Ok(Some((path, found)))
        }
        Err(error) if error.kind() == ErrorKind::NotFound => {
            fs::metadata(directory(&path)).map_err(|error| explain(&error, noun))?;
            Ok(None)
        }
        Err(error) => Err(explain(&error, noun)),
    }
}

/// Of formats in which a file cannot tell who wrote it, one that is to be kept may hold nothing but the very `bytes`
/// that are to be written, as when a command is given twice.
///
/// # Errors
/// In plain words, without the path.
pub(super) fn check_bytes(path: &Path, product: Product, existing: Existing, bytes: &[u8]) -> anyhow::Result<()> {
    if existing != Existing::KeepOthers || !product.has_no_seal() {
        return Ok(());
    }
    let noun = product.noun();
    let path = follow(path, noun)?;
    let Some(found) = fs::metadata(&path).ok().filter(|found| found.is_file() && found.len() > 0) else {
        return Ok(());
    };
    let same = found.len() == bytes.len() as u64 && fs::read(&path).map_err(|error| explain(&error, noun))? == bytes;
    if !same {
        bail!(
            "this file exists and is another one, and files of this format cannot tell whether somebody has changed \
             them; name the {noun} with -o, move that file away, or replace it with --force"
        );
    }
    Ok(())
}

/// Writes to a temporary file beside `path` and renames it, so that at every moment `path` is the old file or
/// the new one, and stays the old one if anything fails. Symbolic links stay links: the file they lead to is
/// replaced. A file that is there keeps its permissions; a new one gets the usual ones. What is no file (`/dev/null`,
/// a pipe) is simply written to.
///
/// # Errors
/// In plain words, without the path.
pub(super) fn to_file(path: &Path, bytes: &[u8], noun: &str) -> anyhow::Result<()> {
    stage(path, bytes, noun)?.commit()
}

/// A file that is complete on the disk and only lacks its name.
pub(super) struct Staged<'a> {
    path: PathBuf,
    noun: &'a str,
    how: How<'a>,
}

enum How<'a> {
    /// Beside its place.
    Temporary(Temporary),
    /// What is no file is written to at the end.
    Special(File, &'a [u8]),
}

/// The first half of [`to_file`]: everything but the renaming. Without the second half, nothing stays.
///
/// # Errors
/// As [`to_file`].
pub(super) fn stage<'a>(path: &Path, bytes: &'a [u8], noun: &'a str) -> anyhow::Result<Staged<'a>> {
    let path = follow(path, noun)?;
    let found = fs::metadata(&path).ok();
    if let Some(found) = &found {
        refuse(found, noun)?;
        if !found.is_file() {
            let special = OpenOptions::new().write(true).open(&path).map_err(|error| explain(&error, noun))?;
            return Ok(Staged { path, noun, how: How::Special(special, bytes) });
        }
    }
    let file = temporary(&path, bytes, found.as_ref()).map_err(|error| explain(&error, noun))?;
    Ok(Staged { path, noun, how: How::Temporary(file) })
}

impl Staged<'_> {
    /// Gives it its name.
    ///
    /// # Errors
    /// In plain words, without the path.
    pub(super) fn commit(self) -> anyhow::Result<()> {
        let done = match self.how {
            How::Temporary(file) => file.persist(&self.path),
            How::Special(mut special, bytes) => special.write_all(bytes),
        };
        done.map_err(|error| explain(&error, self.noun))
    }
}

fn temporary(path: &Path, bytes: &[u8], found: Option<&Metadata>) -> io::Result<Temporary> {
    let mut temporary = Temporary::new_in(directory(path))?;
    let file = temporary.file()?;
    file.write_all(bytes)?;
    if let Some(found) = found {
        file.set_permissions(found.permissions())?;
        // Without this, a power cut just after the rename could leave neither the old file nor the new one.
        file.sync_all()?;
    }
    Ok(temporary)
}

fn refuse(found: &Metadata, noun: &str) -> anyhow::Result<()> {
    if found.is_dir() {
        bail!("the {noun} cannot be written here, as this is a directory; name a file, or use --out-dir");
    }
    if found.permissions().readonly() {
        bail!("the {noun} cannot be written here, as this file is write-protected; lift that or choose another name");
    }
    Ok(())
}

/// Whether a file is as this program wrote it, with no work of a person in it.
fn is_own(path: &Path, product: Product) -> anyhow::Result<bool> {
    let noun = product.noun();
    let mut head = Vec::new();
    let file = File::open(path).map_err(|error| explain(&error, noun))?;
    file.take(product.needs_of_file()).read_to_end(&mut head).map_err(|error| explain(&error, noun))?;
    Ok(product.is_own(&head))
}

/// The file that `path` leads to over symbolic links, whether it exists or not.
fn follow(path: &Path, noun: &str) -> anyhow::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        if !fs::symlink_metadata(&path).is_ok_and(|found| found.is_symlink()) {
            return Ok(path);
        }
        // What is not a file on disk can have a link that names no path ("pipe:[123]" behind /dev/fd/63): open it as
        // it is.
        if fs::metadata(&path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
            return Ok(path);
        }
        let target = fs::read_link(&path).map_err(|error| explain(&error, noun))?;
        path = directory(&path).join(target);
    }
    bail!("the {noun} cannot be written here, as this link leads round in a circle; choose another name")
}

/// What is said after the name of a file of sheets of these `parts` of a picture, or of several files with numbers:
/// which of them is what; nothing for one sheet.
pub(super) fn and_sheets(parts: &[String], files: usize) -> String {
    if parts.len() < 2 {
        return String::new();
    }
    let count = if files == 1 { format!(", {} sheets", parts.len()) } else { String::new() };
    if are_alike(parts) {
        return count;
    }
    let alike = parts.chunk_by(|a, b| a == b).map(|alike| match alike {
        [one] => one.clone(),
        [one, ..] => format!("{} of the {one}", alike.len()),
        [] => String::new(),
    });
    format!("{count}: {}", alike.collect::<Vec<_>>().join(", "))
}

/// Whether sheets are all of one kind, which says nothing of any of them.
pub(super) fn are_alike(parts: &[String]) -> bool {
    parts.windows(2).all(|pair| pair[0] == pair[1])
}

/// The directory that a file lies in.
pub(super) fn directory(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Makes the directory for `--out-dir`.
///
/// # Errors
/// In plain words, without the path.
pub(super) fn make_directory(path: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(path).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists | ErrorKind::NotADirectory => {
            anyhow!("this directory cannot be made, as a file has its name; choose another name")
        }
        ErrorKind::PermissionDenied => {
            anyhow!("this directory cannot be made, as you have no permission there; choose another place")
        }
        _ => anyhow!("this directory cannot be made ({error}); choose another place"),
    })
}

fn explain(error: &io::Error, noun: &str) -> anyhow::Error {
    match error.kind() {
        ErrorKind::NotFound => {
            anyhow!("the {noun} cannot be written here, as the directory is missing; make it, or use --out-dir")
        }
        ErrorKind::NotADirectory => {
            anyhow!(
                "the {noun} cannot be written here, as a part of this path is a file, not a directory; check the name"
            )
        }
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
            anyhow!("the {noun} cannot be written here, as you have no permission; choose another place with -o")
        }
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            anyhow!("the {noun} cannot be written, as the disk is full; make room and try again")
        }
        ErrorKind::FileTooLarge => anyhow!(
            "the {noun} cannot be written, as the system takes no file of this length here; raise that limit \
             (ulimit -f) or choose another place with -o"
        ),
        _ => anyhow!("the {noun} cannot be written here ({error}); choose another place with -o"),
    }
}
