//! Where each page goes, and what must not be overwritten.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use super::args::Convert;
use super::output::directory;

/// One picture and its page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Job {
    /// The picture; `-` is standard input.
    pub(super) picture: PathBuf,
    /// Where its page goes.
    pub(super) page: Target,
}

/// Where a page goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Target {
    /// To standard output.
    Stdout,
    /// To the file that `-o` names.
    Named(PathBuf),
    /// To the file whose name follows from the picture's.
    Derived(PathBuf),
}

impl Target {
    /// The file, if it is one.
    pub(super) fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::Named(path) | Self::Derived(path) => Some(path),
        }
    }
}

/// Whether a path stands for standard input or output.
pub(super) fn is_std(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What to call a picture in messages.
pub(super) fn picture_name(path: &Path) -> String {
    if is_std(path) { "standard input".into() } else { path.display().to_string() }
}

/// What to call a page in messages.
pub(super) fn page_name(target: &Target) -> String {
    target.path().map_or_else(|| "standard output".into(), |path| path.display().to_string())
}

/// The jobs in the order of the pictures.
///
/// # Errors
/// Everything that is wrong with the names, one message each.
pub(super) fn jobs(args: &Convert) -> Result<Vec<Job>, Vec<String>> {
    let mut faults = Vec::new();
    if args.output.is_some() && args.pictures.len() > 1 {
        let count = args.pictures.len();
        faults.push(format!("-o names one page, but there are {count} pictures; use --out-dir DIR for several"));
        return Err(faults);
    }
    if let Some(fault) = args.output.as_deref().and_then(wrong_ending) {
        faults.push(fault);
    }
    if args.pictures.iter().filter(|path| is_std(path)).count() > 1 {
        faults.push("standard input (-) is given more than once; give it once".into());
        return Err(faults);
    }
    if args.out_dir.is_some() && args.pictures.iter().any(|path| is_std(path)) {
        faults.push(
            "a picture from standard input (-) has no name for a page in --out-dir; name the page with -o".into(),
        );
        return Err(faults);
    }
    let jobs = args
        .pictures
        .iter()
        .map(|picture| Job { picture: picture.clone(), page: target(picture, args) })
        .collect::<Vec<_>>();
    faults.extend(collisions(&jobs));
    if faults.is_empty() { Ok(jobs) } else { Err(faults) }
}

fn target(picture: &Path, args: &Convert) -> Target {
    match &args.output {
        Some(page) if is_std(page) => Target::Stdout,
        Some(page) => Target::Named(page.clone()),
        None if is_std(picture) => Target::Stdout,
        None => Target::Derived(derived(picture, args.out_dir.as_deref())),
    }
}

/// `photo.png` gives `photo.svg`, in `out_dir` or beside the picture. Where that is the picture itself, as for
/// `photo.svg` or (on systems that take them for one) `photo.SVG`: `photo.page.svg`.
fn derived(picture: &Path, out_dir: Option<&Path>) -> PathBuf {
    let mut name = picture.file_stem().map_or_else(|| OsString::from("page"), OsString::from);
    let beside = out_dir.is_none_or(|dir| identity(dir) == identity(directory(picture)));
    if beside && is_svg(picture) {
        name.push(".page");
    }
    name.push(".svg");
    out_dir.map_or_else(|| picture.with_file_name(&name), |dir| dir.join(&name))
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

/// A name such as `page.pdf` would promise what is not written.
fn wrong_ending(page: &Path) -> Option<String> {
    let ending = page.extension()?;
    if is_svg(page) {
        return None;
    }
    let instead = page.with_extension("svg");
    Some(format!(
        "{}: a page is not written as .{}, only as .svg; name it {}",
        page.display(),
        ending.display(),
        instead.display()
    ))
}

/// Pages that would overwrite a picture or one another.
fn collisions(jobs: &[Job]) -> Vec<String> {
    let mut faults = Vec::new();
    let is_regular = |path: &Path| fs::metadata(path).map_or(true, |found| found.is_file());
    let pictures = jobs.iter().map(|job| &job.picture).filter(|path| !is_std(path) && is_regular(path));
    let pictures = pictures.map(|path| (identity(path), path)).collect::<BTreeMap<_, _>>();
    let mut pages = BTreeMap::<_, &Job>::new();
    for job in jobs {
        let Some(page) = job.page.path() else { continue };
        let id = identity(page);
        if let Some(&picture) = pictures.get(&id) {
            let (to, from, over) = (page.display(), job.picture.display(), picture.display());
            faults.push(if job.picture == *picture {
                format!("{to}: the page would overwrite the picture itself; choose another name with -o")
            } else {
                format!("{to}: the page of {from} would overwrite the picture {over}; choose another name with -o")
            });
        }
        if let Some(other) = pages.insert(id, job) {
            let (page, one, two) = (page.display(), other.picture.display(), job.picture.display());
            faults.push(if other.picture == job.picture {
                format!("{one}: this picture is given more than once; give it once")
            } else {
                format!("{page}: would be the page of both {one} and {two}; convert one of them alone, with -o")
            });
        }
    }
    faults
}

/// What two names of the same file have in common. A hard link is another file here: replacing one by renaming leaves
/// the other as it is.
fn identity(path: &Path) -> PathBuf {
    let found = fs::canonicalize(path).or_else(|_| {
        let parent = fs::canonicalize(directory(path))?;
        Ok::<_, std::io::Error>(path.file_name().map_or(parent.clone(), |name| parent.join(name)))
    });
    let path = found.unwrap_or_else(|_| path.components().collect());
    if cfg!(any(windows, target_os = "macos")) {
        return PathBuf::from(path.to_string_lossy().to_lowercase()); // A.svg and a.svg are one file there
    }
    path
}
