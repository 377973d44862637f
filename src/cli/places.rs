//! Where each page or trace goes, and what must not be overwritten.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use super::args::Pages;
use super::output::{Existing, directory};
use super::product::{DrawingFormat, Format, Product};

/// What is told of a preview of a page that goes to standard output.
pub(super) const NO_NAME_OF_PREVIEW: &str =
    "--preview: there is no name for it beside standard output; name the page with -o";

/// What the command line says of names.
pub(super) struct Names<'a> {
    /// What is made of the pictures.
    pub(super) product: Product,
    /// The pictures; `-` is standard input.
    pub(super) pictures: &'a [PathBuf],
    /// `-o`.
    pub(super) output: Option<&'a Path>,
    /// `--out-dir`.
    pub(super) out_dir: Option<&'a Path>,
    /// `--page`.
    pub(super) pages: Option<Pages>,
    /// `--preview`.
    pub(super) preview: Option<DrawingFormat>,
    /// `--report`.
    pub(super) report: Option<&'a Path>,
}

/// One picture and what is made of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Job {
    /// The picture; `-` is standard input.
    pub(super) picture: PathBuf,
    /// The page of it that is asked for.
    pub(super) page: Option<u32>,
    /// Where the result goes.
    pub(super) target: Target,
    /// Where its preview goes, if there is one.
    pub(super) preview: Option<PathBuf>,
}

/// Where a result goes.
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
    /// What becomes of a file that is there already, where `made_up` says so of names that the program made up.
    pub(super) fn existing(&self, made_up: &dyn Fn(&Path) -> Existing) -> Existing {
        match self {
            Self::Derived(path) => made_up(path),
            Self::Stdout | Self::Named(_) => Existing::Named,
        }
    }

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

/// What to call a job's picture in messages, with its page.
pub(super) fn job_name(job: &Job) -> String {
    with_page(picture_name(&job.picture), job.page)
}

/// A name with the page that is asked for.
pub(super) fn with_page(name: String, page: Option<u32>) -> String {
    page.map_or_else(|| name.clone(), |page| format!("{name}, page {page}"))
}

/// What to call a result's place in messages.
pub(super) fn target_name(target: &Target) -> String {
    target.path().map_or_else(|| "standard output".into(), |path| path.display().to_string())
}

/// What to call a file that is written in messages.
pub(super) fn output_name(path: &Path) -> String {
    if is_std(path) { "standard output".into() } else { path.display().to_string() }
}

/// The jobs in the order of the pictures.
///
/// # Errors
/// Everything that is wrong with the names, one message each.
pub(super) fn jobs(names: &Names<'_>) -> Result<Vec<Job>, Vec<String>> {
    let mut faults = Vec::new();
    let product = names.product;
    let noun = product.noun();
    if names.output.is_some() && names.pictures.len() > 1 {
        let count = names.pictures.len();
        faults.push(format!("-o names one {noun}, but there are {count} pictures; use --out-dir DIR for several"));
        return Err(faults);
    }
    if let Some(fault) = names.output.and_then(|path| wrong_ending(path, product)) {
        faults.push(fault);
    }
    if names.pictures.iter().filter(|path| is_std(path)).count() > 1 {
        faults.push("standard input (-) is given more than once; give it once".into());
        return Err(faults);
    }
    if names.out_dir.is_some() && names.pictures.iter().any(|path| is_std(path)) {
        faults.push(format!(
            "a picture from standard input (-) has no name for a {noun} in --out-dir; name the {noun} with -o"
        ));
        return Err(faults);
    }
    // of -o - it was told with the other options
    if names.preview.is_some()
        && names.output.is_none()
        && names.pictures.iter().any(|picture| target(picture, names) == Target::Stdout)
    {
        faults.push(NO_NAME_OF_PREVIEW.into());
        return Err(faults);
    }
    let jobs: Vec<Job> = names.pictures.iter().flat_map(|picture| jobs_of(picture, names)).collect();
    let is_range = matches!(names.pages, Some(Pages::Range(..)));
    if is_range && names.pictures.iter().any(|path| is_std(path)) {
        faults.push("several pages are read one by one, so not from standard input (-); give a file".into());
    } else if is_range && jobs.iter().any(|job| job.target == Target::Stdout) {
        faults.push(format!("several {noun}s do not go to standard output; name them with -o or --out-dir"));
    }
    faults.extend(collisions(&jobs, product));
    faults.extend(names.report.and_then(|report| report_in_the_way(report, &jobs)));
    if faults.is_empty() { Ok(jobs) } else { Err(faults) }
}

/// One job for each page that is asked for.
fn jobs_of(picture: &Path, names: &Names<'_>) -> Vec<Job> {
    let target = target(picture, names);
    let job = |page, target| {
        let preview = preview(&target, names.preview);
        Job { picture: picture.to_path_buf(), page, target, preview }
    };
    match names.pages {
        None => vec![job(None, target)],
        Some(Pages::One(page)) => vec![job(Some(page), target)],
        Some(pages) => {
            let of_page = |page: u32| match target.path() {
                // The names with numbers are made up, also where the one without was given.
                Some(path) => job(Some(page), Target::Derived(numbered(path, page as usize))),
                None => job(Some(page), target.clone()),
            };
            pages.numbers().map(of_page).collect()
        }
    }
}

fn target(picture: &Path, names: &Names<'_>) -> Target {
    match names.output {
        Some(path) if is_std(path) => Target::Stdout,
        Some(path) => Target::Named(path.to_path_buf()),
        None if is_std(picture) => Target::Stdout,
        None => Target::Derived(derived(picture, names.out_dir, names.product)),
    }
}

/// Where the preview of a result goes: `photo.idx` gives `photo.idx.preview.png` beside it, so that another format of
/// the same picture has a preview of its own.
pub(super) fn preview(target: &Target, format: Option<DrawingFormat>) -> Option<PathBuf> {
    let mut name = target.path()?.as_os_str().to_owned();
    name.push(format!(".preview.{}", Format::Drawing(format?).extension()));
    Some(name.into())
}

/// `photo.png` gives `photo.svg`, in `out_dir` or beside the picture. Where that is the picture itself, as for
/// `photo.svg` or (on systems that take them for one) `photo.SVG`: `photo.page.svg`. So also for traces.
fn derived(picture: &Path, out_dir: Option<&Path>, product: Product) -> PathBuf {
    let (noun, ending) = (product.noun(), product.ending());
    let mut name = picture.file_stem().map_or_else(|| OsString::from(noun), OsString::from);
    let beside = out_dir.is_none_or(|dir| identity(dir) == identity(directory(picture)));
    if beside && ends_in(picture, ending) {
        name.push(format!(".{noun}"));
    }
    name.push(format!(".{ending}"));
    out_dir.map_or_else(|| picture.with_file_name(&name), |dir| dir.join(&name))
}

/// Whether a name has this ending, in capitals or not.
pub(super) fn ends_in(path: &Path, wanted: &str) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(wanted))
}

/// A name such as `page.jpg` would promise what is not written.
pub(super) fn wrong_ending(path: &Path, product: Product) -> Option<String> {
    let ending = path.extension()?;
    let (noun, own) = (product.noun(), product.ending());
    if ends_in(path, own) {
        return None;
    }
    if ends_in(path, "prn") {
        let (name, pdf, png) = (path.display(), path.with_extension("pdf"), path.with_extension("png"));
        return Some(format!(
            "{name}: the languages of printers are not written; to print the page, name it {}, or for the driver of \
             a ViewPlus embosser take --format pixels and name it {}",
            pdf.display(),
            png.display()
        ));
    }
    let instead = path.with_extension(own);
    Some(format!(
        "{}: a {noun} is not written as .{}, only as {}; name it {}",
        path.display(),
        ending.display(),
        product.endings(),
        instead.display()
    ))
}

/// Results that would overwrite a picture or one another.
fn collisions(jobs: &[Job], product: Product) -> Vec<String> {
    let mut faults = Vec::new();
    let (noun, verb) = (product.noun(), product.verb());
    let is_regular = |path: &Path| fs::metadata(path).map_or(true, |found| found.is_file());
    let pictures = jobs.iter().map(|job| &job.picture).filter(|path| !is_std(path) && is_regular(path));
    let pictures = pictures.map(|path| (identity(path), path)).collect::<BTreeMap<_, _>>();
    let mut targets = BTreeMap::<_, &Job>::new();
    let of_job = |job: &'_ Job| -> Vec<(PathBuf, &'static str)> {
        let page = job.target.path().map(|path| (path.to_path_buf(), noun));
        page.into_iter().chain(job.preview.iter().map(|path| (path.clone(), "preview"))).collect()
    };
    for (job, (target, noun)) in jobs.iter().flat_map(|job| of_job(job).into_iter().map(move |file| (job, file))) {
        let id = identity(&target);
        if let Some(&picture) = pictures.get(&id) {
            let (to, from, over) = (target.display(), job.picture.display(), picture.display());
            faults.push(if job.picture == *picture {
                format!("{to}: the {noun} would overwrite the picture itself; choose another name with -o")
            } else {
                format!("{to}: the {noun} of {from} would overwrite the picture {over}; choose another name with -o")
            });
        }
        if let Some(other) = targets.insert(id, job) {
            let (to, one, two) = (target.display(), other.picture.display(), job.picture.display());
            faults.push(if other.picture == job.picture {
                format!("{one}: this picture is given more than once; give it once")
            } else {
                format!("{to}: would be the {noun} of both {one} and {two}; {verb} one of them alone, with -o")
            });
        }
    }
    faults
}

/// A report that would take the place of a picture, a page or a preview.
fn report_in_the_way(report: &Path, jobs: &[Job]) -> Option<String> {
    let id = identity(report);
    let files = |job: &'_ Job| -> Vec<PathBuf> {
        let files = [Some(job.picture.clone()), job.target.path().map(Path::to_path_buf), job.preview.clone()];
        files.into_iter().flatten().collect()
    };
    let taken = !is_std(report) && jobs.iter().flat_map(files).any(|path| !is_std(&path) && identity(&path) == id);
    if taken {
        return Some(format!("--report {}: a picture or a page has this name; choose another one", report.display()));
    }
    let both = is_std(report) && jobs.iter().any(|job| job.target == Target::Stdout);
    both.then(|| "--report -: the page goes to standard output already; name a file for one of them".to_owned())
}

/// What two names of the same file have in common. A hard link is another file here: replacing one by renaming leaves
/// the other as it is.
pub(super) fn identity(path: &Path) -> PathBuf {
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

/// `sheet.svg` gives `sheet-2.svg`.
pub(super) fn numbered(path: &Path, number: usize) -> PathBuf {
    with_more(path, &number.to_string())
}

/// `sheet.idx` gives `sheet-1.6.idx`: for dots so many mm apart, to a tenth, as those of devices are.
pub(super) fn of_pitch(path: &Path, pitch: f32) -> PathBuf {
    with_more(path, &format!("{pitch:.1}"))
}

/// A name with more of it before the ending.
fn with_more(path: &Path, more: &str) -> PathBuf {
    let mut name = path.file_stem().map_or_else(OsString::new, OsString::from);
    name.push(format!("-{more}"));
    if let Some(ending) = path.extension() {
        name.push(".");
        name.push(ending);
    }
    path.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_before_the_ending() {
        for (name, want) in [("a.svg", "a-2.svg"), ("d/a.b.png", "d/a.b-2.png"), ("a", "a-2")] {
            assert_eq!(numbered(Path::new(name), 2), Path::new(want));
        }
        assert_eq!(numbered(&of_pitch(Path::new("a.svg"), 1.6), 2), Path::new("a-1.6-2.svg"));
    }
}
