//! Pictures in, files out: what all commands on pictures do alike. Several pictures are worked on side by side.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use serde_json::Value;
use tactograph::{Error, Note, Options, Profile};

use super::args::Shared;
use super::output::Existing;
use super::places::{self, Job, Names, Target};
use super::product::{DrawingFormat, Format, Product};
use super::record::{Record, Written};
use super::remedies::{self, Making};
use super::report::{Exit, Report};
use super::session::Session;
use super::settings::Change;
use super::sheets::{self, Failure, Piece};
use super::side_by_side::{self, Panicked};
use super::timings::{Stopped, Timings};
use super::{input, interrupt, output, panics, settings};

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
    /// `--preview`.
    pub(super) preview: Option<DrawingFormat>,
    /// `--report`.
    pub(super) report: Option<&'a Path>,
    /// The run that this is a part of, if it goes on.
    pub(super) session: Option<&'a Session>,
    /// What was found wrong with the command line before.
    pub(super) faults: Vec<String>,
    /// What is worth knowing before the pictures are looked at: what each is about, and what it is.
    pub(super) notes: Vec<(String, String)>,
    /// What the command's own options change in the profile; counts after everything else.
    pub(super) changes: Vec<Change>,
    /// Everything else.
    pub(super) shared: &'a Shared,
    /// What does not go together with the profile.
    pub(super) check: &'a (dyn Fn(&Profile) -> Vec<String> + Sync),
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
#[derive(Default)]
pub(super) struct Made {
    /// The bytes of the file; of several files with numbers, where one does not hold all.
    pub(super) files: Vec<Vec<u8>>,
    /// Those of the preview.
    pub(super) previews: Vec<Vec<u8>>,
    /// What each of their sheets is; none for what has no sheets.
    pub(super) sheets: Vec<String>,
    /// Remarks on it.
    pub(super) notes: Vec<Note>,
    /// What it is, for the options that help.
    pub(super) making: Making,
    /// What is said of it, where that was asked for.
    pub(super) description: Option<String>,
    /// What is said of each sheet, for the report.
    pub(super) checked: Vec<Value>,
}

/// Everything was written.
struct Done {
    /// The names of the files, and how many sheets there are if there is more than one, for a message.
    wrote: String,
    pages: Vec<String>,
    previews: Vec<String>,
    checked: Vec<Value>,
    notes: Vec<String>,
    labels_left_out: Vec<(Vec<String>, &'static str)>,
    description: Option<String>,
    timings: Stopped,
}

/// What became of a picture, and how long that took.
type Outcome = (Result<Done, Failure>, Duration);

/// Calls `make` with the bytes of every picture and the options for it, writes what it gives, and tells what became of
/// each, in their order.
pub(super) fn run(order: &Order<'_>, make: impl Fn(&Input<'_>) -> Result<Made, Error> + Sync) -> Exit {
    let start = Instant::now();
    let &Order { product, shared, session, pictures, .. } = order;
    // of a run that goes on: what became of each picture
    let settle = |failed: &dyn Fn(&Path) -> bool| {
        for (session, picture) in session.iter().flat_map(|session| pictures.iter().map(move |own| (session, own))) {
            session.settle(picture, failed(picture));
        }
    };
    let (jobs, profile) = match accepted(order) {
        Ok(accepted) => accepted,
        Err(exit) => {
            settle(&|_| true);
            return exit;
        }
    };
    let notes = notes_before(order, &jobs, &profile);
    let mut record = Record::new(&profile.name, product.name(), &notes);
    let options = Options::new(profile).limits(shared.limits()).fonts(sheets::installed_fonts().clone());
    let options = session.iter().fold(options, |options, session| {
        let stop = Arc::clone(&session.stop);
        options.cancelled(move || stop.load(Ordering::Relaxed))
    });
    let report = Report::of_pictures(if session.is_some() { 1 } else { jobs.len() }, shared.quiet);
    notes.iter().for_each(|(place, what)| report.note(place, what));
    let mut failed: Vec<&Path> = Vec::new();
    interrupt::begin(jobs.len(), product.done());
    let workers = side_by_side::workers(jobs.len());
    side_by_side::run(
        jobs.len(),
        workers,
        |index| {
            let start = Instant::now();
            (work(order, &jobs[index], workers == 1, &options, &make), start.elapsed())
        },
        || report.advance(),
        |index, outcome| {
            let done = tell(order, (&jobs, index), &outcome, &report);
            note_down(&mut record, &jobs[index], &outcome);
            match (done, session) {
                (false, _) => failed.push(&jobs[index].picture),
                (true, Some(session)) => session.count_page(),
                (true, None) => {}
            }
        },
    );
    report.finish();
    settle(&|picture| failed.contains(&picture));
    if !failed.is_empty() && jobs.len() > 1 && session.is_none() {
        report.usage(&format!("{} of {} pictures could not be {}", failed.len(), jobs.len(), product.done()));
    }
    if let Some(path) = order.report
        && let Err(error) = record.write(path, start.elapsed())
    {
        report.error(&places::output_name(path), &format!("{error:#}"));
        return Exit::Failed;
    }
    if failed.is_empty() { Exit::Done } else { Exit::Failed }
}

/// What is told before the first picture: what is known of their words, and keys that do not count.
fn notes_before(order: &Order<'_>, jobs: &[Job], profile: &Profile) -> Vec<(String, String)> {
    // of a run that goes on they are told at its beginning, when there are no pictures yet
    let tells_unused = matches!(order.product, Product::Page(_)) && (order.session.is_none() || jobs.is_empty());
    let unused = if tells_unused { profile.unused() } else { Vec::new() };
    let mut notes = order.notes.clone();
    notes.extend(unused.into_iter().map(|key| (key.place, key.what)));
    notes
}

/// The jobs and the checked profile; the directory for the results is made. Otherwise everything that is wrong was
/// told.
fn accepted(order: &Order<'_>) -> Result<(Vec<Job>, Profile), Exit> {
    let &Order { product, pictures, output, out_dir, preview, report: record, shared, check, .. } = order;
    let report = Report::plain();
    let changes = [&shared.changes()[..], &order.changes].concat();
    let profile = settings::profile(&shared.profile, &changes);
    let mut faults = order.faults.clone();
    faults.extend(profile.iter().flat_map(check));
    let names = Names { product, pictures, output, out_dir, pages: shared.page, preview, report: record };
    let accepted = match (places::jobs(&names), profile) {
        (Ok(jobs), Ok(profile)) if faults.is_empty() => (jobs, profile),
        (jobs, profile) => {
            faults.iter().for_each(|what| report.usage(what));
            jobs.err().iter().flatten().for_each(|what| report.usage(what));
            profile.err().iter().flatten().for_each(|fault| report.error(&fault.place, &fault.what));
            return Err(Exit::Usage);
        }
    };
    let made = out_dir.map(|dir| (dir, output::make_directory(dir))).filter(|(_, made)| made.is_err());
    let record = record.filter(|path| !places::is_std(path));
    let record = || record.map(|path| (path, output::check_place(path, "report").map(drop)));
    match made.or_else(record) {
        Some((path, Err(error))) => {
            report.error(&path.display().to_string(), &format!("{error:#}"));
            Err(Exit::Failed)
        }
        Some((_, Ok(()))) | None => Ok(accepted),
    }
}

/// One picture, from the file to the file; `is_alone` if no others are worked on meanwhile.
fn work(
    order: &Order<'_>,
    job: &Job,
    is_alone: bool,
    options: &Options,
    make: impl Fn(&Input<'_>) -> Result<Made, Error>,
) -> Result<Done, Failure> {
    let &Order { product, shared, session, .. } = order;
    let timings = Timings::start(is_alone);
    let about_picture = |what: String| Failure { file: places::job_name(job), what };
    let made_up = |path: &Path| match session {
        _ if shared.force => Existing::Forced,
        Some(session) if session.is_own(path) => Existing::Named,
        _ => Existing::KeepOthers,
    };

    // Where both names are wrong, it is the picture's that was mistyped: the result's follows from it.
    input::check(&job.picture).map_err(|error| about_picture(format!("{error:#}")))?;
    let preview = order.preview.map(|format| Product::Page(Format::Drawing(format)));
    let preview = preview.zip(job.preview.clone().map(Target::Derived));
    [(product, job.target.clone())].iter().chain(&preview).try_for_each(|(product, target)| {
        let Some(path) = target.path() else { return Ok(()) };
        output::check(path, *product, target.existing(&made_up))
            .map_err(|error| Failure { file: places::target_name(target), what: format!("{error:#}") })
    })?;
    let memory_mb = shared.limits().memory_mb;
    let too_long = format!("the file is longer than the memory limit of {memory_mb} MB; raise it with --max-memory");
    let bytes = timings
        .step("read", || input::read(&job.picture, memory_mb.saturating_mul(1_000_000), &too_long))
        .map_err(|error| about_picture(format!("{error:#}")))?;
    let told = timings.clone();
    let options = options.clone().picture_name(name_of(job)).progress(move |event| told.watch(event));
    let options = job.page.into_iter().fold(options, Options::page);
    let Made { files, previews, sheets, notes, making, checked, description } =
        make(&Input { job, bytes: &bytes, options: &options, timings: &timings })
            .map_err(|error| about_picture(remedies::of_error(&error)))?;
    let pages = sheets::pieces(product, &job.target, &files, &made_up)?;
    let previews = match &preview {
        Some((product, target)) => sheets::pieces(*product, target, &previews, &made_up)?,
        None => Vec::new(),
    };
    let labels_left_out = notes.iter().filter_map(labels_left_out).collect();
    let mut notes = remedies::of_notes(&notes, making);
    let (wrote, page_names) = (wrote(&pages, &previews, &sheets), names_of(&pages));
    let preview_names = names_of(&previews);
    let all: Vec<Piece<'_>> = pages.into_iter().chain(previews).collect();
    timings.step("write", || sheets::write(&all))?;
    for (path, piece) in all.iter().filter_map(|piece| piece.target.path().map(|path| (path, piece))) {
        let other = session.and_then(|session| session.writes(path, piece.bytes, &job.picture));
        notes.extend(other.map(|other| format!("{} was made of {} before", path.display(), other.display())));
    }
    let timings = timings.stop();
    let (pages, previews) = (page_names, preview_names);
    Ok(Done { wrote, pages, previews, checked, notes, labels_left_out, description, timings })
}

fn labels_left_out(note: &Note) -> Option<(Vec<String>, &'static str)> {
    match note {
        Note::LabelsLeftOut { texts, why, .. } => Some((texts.clone(), *why)),
        _ => None,
    }
}

fn names_of(pieces: &[Piece<'_>]) -> Vec<String> {
    pieces.iter().map(|piece| places::target_name(&piece.target)).collect()
}

/// What was written, for a message.
fn wrote(pages: &[Piece<'_>], previews: &[Piece<'_>], sheets: &[String]) -> String {
    let page = sheets::names(pages) + &output::and_sheets(sheets, pages.len());
    match (previews, sheets.len()) {
        ([], _) => page,
        (_, 0 | 1) => format!("{page} and {}", sheets::names(previews)),
        _ => format!("{page}, and {}", sheets::names(previews)),
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
    order: &Order<'_>,
    (jobs, index): (&[Job], usize),
    outcome: &Result<Outcome, Panicked>,
    report: &Report,
) -> bool {
    let job = &jobs[index];
    let picture = places::job_name(job);
    match outcome {
        Ok((Ok(done), _)) => {
            done.notes.iter().for_each(|note| report.note(&picture, note));
            let wrote = format!("wrote {}", done.wrote);
            report.done(&match jobs.len() {
                _ if order.session.is_some() => format!("{picture}: {wrote}"),
                1 => wrote,
                count => format!("{} of {count}: {picture}: {wrote}", index + 1),
            });
            if order.shared.timings {
                report.asked_for(&done.timings.table(&picture));
            }
            let told = done.description.as_ref().map(|text| {
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
        Ok((Err(failure), _)) => {
            report.error(&failure.file, &failure.what);
            false
        }
        Err(Panicked) => {
            report.error(&picture, &panics::line());
            false
        }
    }
}

/// The same for the report of the run.
fn note_down(record: &mut Record, job: &Job, outcome: &Result<Outcome, Panicked>) {
    match outcome {
        Ok((Ok(done), took)) => {
            let Done { pages, previews, checked, notes, labels_left_out, .. } = done;
            let notes = notes.clone();
            record.done(job, &Written { pages, previews, sheets: checked, notes, labels_left_out }, *took);
        }
        Ok((Err(failure), took)) => record.failed(job, Some((&failure.file, &failure.what)), Some(*took)),
        Err(Panicked) => record.failed(job, None, None),
    }
}
