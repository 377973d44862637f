//! Pictures in, files out: what all commands on pictures do alike. Several pictures are worked on side by side.

use std::path::{Path, PathBuf};

use tactograph::{Error, Fonts, Note, Options, Profile};

use super::args::Shared;
use super::output::Existing;
use super::places::{self, Job, Names, Target};
use super::product::{Format, Product};
use super::report::{Exit, Report};
use super::settings::Change;
use super::side_by_side::{self, Panicked};
use super::timings::{Stopped, Timings};
use super::{input, output, panics, settings};

/// What is asked for: the command line, as far as all commands on pictures have it.
pub(super) struct Order<'a> {
    /// What is made.
    pub(super) product: Product,
    /// The pictures.
    pub(super) pictures: &'a [PathBuf],
    /// `-o`.
    pub(super) output: Option<&'a Path>,
    /// `--out-dir`.
    pub(super) out_dir: Option<&'a Path>,
    /// What was found wrong with the command line before.
    pub(super) faults: Vec<String>,
    /// What is worth knowing before the pictures are looked at: what each is about, and what it is.
    pub(super) notes: Vec<(String, String)>,
    /// What the command's own options change in the profile; counts after everything else.
    pub(super) changes: Vec<Change>,
    /// Everything else.
    pub(super) shared: &'a Shared,
    /// What does not go together with the profile.
    pub(super) check: &'a dyn Fn(&Profile) -> Vec<String>,
}

/// A picture, and how it is worked on.
pub(super) struct Input<'a> {
    pub(super) job: &'a Job,
    /// The bytes of its file.
    pub(super) bytes: &'a [u8],
    pub(super) options: &'a Options,
    pub(super) timings: &'a Timings,
}

/// What was made of a picture, ready to be written.
pub(super) struct Made {
    /// The bytes of the file; of several files with numbers, where one does not hold all.
    pub(super) files: Vec<Vec<u8>>,
    /// How many sheets these hold; 0 for what has no sheets.
    pub(super) sheets: usize,
    /// Remarks on it.
    pub(super) notes: Vec<Note>,
    /// What is said of it, where that was asked for.
    pub(super) description: Option<String>,
}

/// Everything was written.
struct Done {
    /// The names of the files, and how many sheets there are if there is more than one.
    wrote: String,
    notes: Vec<Note>,
    description: Option<String>,
    timings: Stopped,
}

/// No file was written: the file that stands in the way, and why.
struct Failure {
    file: String,
    what: String,
}

/// Calls `make` with the bytes of every picture and the options for it, writes what it gives, and tells what became of
/// each, in their order.
pub(super) fn run(order: &Order<'_>, make: impl Fn(&Input<'_>) -> Result<Made, Error> + Sync) -> Exit {
    let (jobs, profile) = match accepted(order) {
        Ok(accepted) => accepted,
        Err(exit) => return exit,
    };
    let &Order { product, shared, .. } = order;
    let unused = if matches!(product, Product::Page(_)) { profile.unused() } else { Vec::new() };
    let options = Options::new(profile).limits(shared.limits()).fonts(Fonts::system());
    let report = Report::of_pictures(jobs.len(), shared.quiet);
    order.notes.iter().for_each(|(place, what)| report.note(place, what));
    unused.iter().for_each(|key| report.note(&key.place, &key.what));
    let mut failed = 0;
    side_by_side::run(
        jobs.len(),
        side_by_side::workers(jobs.len()),
        |index| work(product, shared, &jobs[index], &options, &make),
        || report.advance(),
        |index, outcome| failed += usize::from(!tell(&jobs, index, outcome, shared.timings, &report)),
    );
    report.finish();
    if failed > 0 && jobs.len() > 1 {
        report.usage(&format!("{failed} of {} pictures could not be {}", jobs.len(), product.done()));
    }
    if failed == 0 { Exit::Done } else { Exit::Failed }
}

/// The jobs and the checked profile; the directory for the results is made. Otherwise everything that is wrong was
/// told.
fn accepted(order: &Order<'_>) -> Result<(Vec<Job>, Profile), Exit> {
    let &Order { product, pictures, output, out_dir, shared, check, .. } = order;
    let report = Report::plain();
    let changes = [&shared.changes()[..], &order.changes].concat();
    let profile = settings::profile(&shared.profile, &changes);
    let mut faults = order.faults.clone();
    faults.extend(profile.iter().flat_map(check));
    let accepted = match (places::jobs(&Names { product, pictures, output, out_dir, pages: shared.page }), profile) {
        (Ok(jobs), Ok(profile)) if faults.is_empty() => (jobs, profile),
        (jobs, profile) => {
            faults.iter().for_each(|what| report.usage(what));
            jobs.err().iter().flatten().for_each(|what| report.usage(what));
            profile.err().iter().flatten().for_each(|fault| report.error(&fault.place, &fault.what));
            return Err(Exit::Usage);
        }
    };
    match out_dir.map(|dir| (dir, output::make_directory(dir))) {
        Some((dir, Err(error))) => {
            report.error(&dir.display().to_string(), &format!("{error:#}"));
            Err(Exit::Failed)
        }
        Some((_, Ok(()))) | None => Ok(accepted),
    }
}

/// One picture, from the file to the file.
fn work(
    product: Product,
    shared: &Shared,
    job: &Job,
    options: &Options,
    make: impl Fn(&Input<'_>) -> Result<Made, Error>,
) -> Result<Done, Failure> {
    let timings = Timings::start();
    let about_picture = |what: String| Failure { file: places::job_name(job), what };
    let about_target =
        |error: anyhow::Error| Failure { file: places::target_name(&job.target), what: format!("{error:#}") };

    // Where both names are wrong, it is the picture's that was mistyped: the result's follows from it.
    input::check(&job.picture).map_err(|error| about_picture(format!("{error:#}")))?;
    let existing = job.target.existing(shared.force);
    if let Some(path) = job.target.path() {
        output::check(path, product, existing).map_err(about_target)?;
    }
    let memory_mb = shared.limits().memory_mb;
    let too_long = format!("the file is longer than the memory limit of {memory_mb} MB; raise it with --max-memory");
    let bytes = timings
        .step("read", || input::read(&job.picture, memory_mb.saturating_mul(1_000_000), &too_long))
        .map_err(|error| about_picture(format!("{error:#}")))?;
    let told = timings.clone();
    let options = options.clone().picture_name(name_of(job)).progress(move |event| told.watch(event));
    let options = job.page.into_iter().fold(options, Options::page);
    let Made { files, sheets, notes, description } =
        make(&Input { job, bytes: &bytes, options: &options, timings: &timings })
            .map_err(|error| about_picture(explain(&error)))?;
    let names = timings.step("write", || write(product, job, &files, existing))?;
    // of several files the numbers say it
    let wrote = if files.len() == 1 { names + &output::and_sheets(sheets) } else { names };
    Ok(Done { wrote, notes, description, timings: timings.stop() })
}

/// Writes what was made of a picture: one file as it is called, several with numbers. Returns their names for a
/// message.
fn write(product: Product, job: &Job, files: &[Vec<u8>], existing: Existing) -> Result<String, Failure> {
    let about = |target: &Target, error: anyhow::Error| Failure {
        file: places::target_name(target),
        what: format!("{error:#}"),
    };
    let noun = product.noun();
    match (files, job.target.path()) {
        ([file], None) => output::to_stdout(file, noun).map_err(|error| about(&job.target, error))?,
        ([file], Some(path)) => output::check_bytes(path, product, existing, file)
            .and_then(|()| output::to_file(path, file, noun))
            .map_err(|error| about(&job.target, error))?,
        (files, None) => {
            let instead = match product {
                Product::Page(Format::Dots(_)) => "name a file, or add --no-overview",
                _ => "add --format pdf, or name a file",
            };
            let what = format!("{} sheets do not go into one file of this format; {instead}", files.len());
            return Err(Failure { file: places::target_name(&job.target), what });
        }
        (files, Some(path)) => {
            let targets: Vec<_> =
                (1..=files.len()).map(|number| Target::Derived(places::numbered(path, number))).collect();
            // The names with numbers are made up, also where the one without was given.
            let existing = if existing == Existing::Forced { existing } else { Existing::KeepOthers };
            for (target, file) in targets.iter().zip(files) {
                let path = target.path().unwrap_or(path);
                output::check(path, product, existing)
                    .and_then(|()| output::check_bytes(path, product, existing, file))
                    .map_err(|error| about(target, error))?;
            }
            for (target, file) in targets.iter().zip(files) {
                let path = target.path().unwrap_or(path);
                output::to_file(path, file, noun).map_err(|error| about(target, error))?;
            }
            let name = |target: Option<&Target>| target.map_or_else(String::new, places::target_name);
            return Ok(format!("{} to {}", name(targets.first()), name(targets.last())));
        }
    }
    Ok(places::target_name(&job.target))
}

/// The library does not know the options of this program: where it says that a limit can be raised, say with which.
fn explain(error: &Error) -> String {
    match error {
        Error::TooManyPixels { .. } => format!("{error} with --max-megapixels"),
        Error::TooMuchMemory { .. } => format!("{error} with --max-memory"),
        Error::TooFine { .. } => format!("{error} with --dpi"),
        Error::TooWide { wanted, most, without_overview: Some(without) } => format!(
            "a figure {wanted} mm wide does not fit; {most:.1} mm is the most for this picture on this sheet, or \
             {without:.1} mm with --no-overview, so take one of these or a larger sheet"
        ),
        _ => error.to_string(),
    }
}

/// What is remarked, with the option that helps.
fn remark(note: &Note) -> String {
    match note {
        Note::FirstPageOnly { pages } => {
            format!("this is page 1 of {pages}; take another with --page 2, or all with --page 1-{pages}")
        }
        _ => note.to_string(),
    }
}

/// A picture is called as its file is, and the page of it that was asked for.
fn name_of(job: &Job) -> String {
    let name = if places::is_std(&job.picture) { None } else { job.picture.file_name() };
    let name = name.map_or_else(|| "picture".into(), |name| name.to_string_lossy().into_owned());
    places::with_page(name, job.page)
}

/// Tells what became of one picture. Returns whether its file is written.
fn tell(
    jobs: &[Job],
    index: usize,
    outcome: Result<Result<Done, Failure>, Panicked>,
    timings: bool,
    report: &Report,
) -> bool {
    let job = &jobs[index];
    let picture = places::job_name(job);
    match outcome {
        Ok(Ok(done)) => {
            done.notes.iter().for_each(|note| report.note(&picture, &remark(note)));
            let wrote = format!("wrote {}", done.wrote);
            report.done(&match jobs.len() {
                1 => wrote,
                count => format!("{} of {count}: {picture}: {wrote}", index + 1),
            });
            if timings {
                report.asked_for(&done.timings.table(&picture));
            }
            let told = done.description.map(|text| {
                let between = if index > 0 { "\n" } else { "" };
                output::to_stdout(format!("{between}{text}").as_bytes(), "description")
            });
            match told {
                Some(Err(error)) => {
                    report.error("standard output", &format!("{error:#}"));
                    false
                }
                _ => true,
            }
        }
        Ok(Err(failure)) => {
            report.error(&failure.file, &failure.what);
            false
        }
        Err(Panicked) => {
            report.error(&picture, &panics::line());
            false
        }
    }
}
