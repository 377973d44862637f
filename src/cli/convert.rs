//! `tactograph convert`: pictures in, pages out.

use tactograph::pipeline::{self, Request};
use tactograph::profile::Plan;
use tactograph::raster::decode::Limits;
use tactograph::{Error, Note};

use super::args::Convert;
use super::fonts::SystemFonts;
use super::places::{self, Job, Target};
use super::report::Report;
use super::side_by_side::{self, Panicked};
use super::timings::{Stopped, Timings};
use super::{Exit, input, output, settings};

/// A page was written.
struct Done {
    notes: Vec<Note>,
    timings: Stopped,
}

/// No page was written: the file that stands in the way, and why.
struct Failure {
    file: String,
    what: String,
}

/// What all pictures have in common.
struct Common {
    plan: Plan,
    limits: Limits,
    fonts: SystemFonts,
}

/// Converts all pictures and tells what became of each, in their order.
pub(super) fn run(args: &Convert) -> Exit {
    let report = Report::plain();
    let (jobs, plan) = match (places::jobs(args), settings::plan(&args.profile, &args.set)) {
        (Ok(jobs), Ok(plan)) => (jobs, plan),
        (jobs, plan) => {
            jobs.err().iter().flatten().for_each(|what| report.usage(what));
            plan.err().iter().flatten().for_each(|fault| report.error(&fault.place, &fault.what));
            return Exit::Usage;
        }
    };
    if let Some(dir) = &args.out_dir
        && let Err(error) = output::make_directory(dir)
    {
        report.error(&dir.display().to_string(), &format!("{error:#}"));
        return Exit::Failed;
    }
    let limits = Limits { megapixels: args.max_megapixels, memory_mb: args.max_memory };
    let common = Common { plan, limits, fonts: SystemFonts::default() };
    let report = Report::of_pictures(jobs.len(), args.quiet);
    let mut failed = 0;
    side_by_side::run(
        jobs.len(),
        side_by_side::workers(jobs.len()),
        |index| convert(&jobs[index], &common),
        || report.advance(),
        |index, outcome| failed += usize::from(!tell(&jobs, index, outcome, args.timings, &report)),
    );
    report.finish();
    if failed > 0 && jobs.len() > 1 {
        report.usage(&format!("{failed} of {} pictures could not be converted", jobs.len()));
    }
    if failed == 0 { Exit::Done } else { Exit::Failed }
}

/// One picture, from the file to the file.
fn convert(job: &Job, common: &Common) -> Result<Done, Failure> {
    let mut timings = Timings::start();
    let about_picture = |what: String| Failure { file: places::picture_name(&job.picture), what };
    let about_page = |error: anyhow::Error| Failure { file: places::page_name(&job.page), what: format!("{error:#}") };

    if let Some(path) = job.page.path() {
        output::check(path, matches!(job.page, Target::Derived(_))).map_err(about_page)?;
    }
    let memory_mb = common.limits.memory_mb;
    let too_long = format!("the file is longer than the memory limit of {memory_mb} MB; raise it with --max-memory");
    let bytes = timings
        .step("read", || input::read(&job.picture, memory_mb.saturating_mul(1_000_000), &too_long))
        .map_err(|error| about_picture(format!("{error:#}")))?;

    let fonts = || common.fonts.get();
    let title = title(job);
    let request = Request { plan: &common.plan, limits: common.limits, fonts: &fonts, title: &title };
    let drawing = pipeline::convert(&bytes, &request, &mut |event| timings.watch(event))
        .map_err(|error| about_picture(explain(&error)))?;

    timings
        .step("write", || {
            let svg = tactograph::output::svg::write(&drawing.page);
            match job.page.path() {
                None => output::to_stdout(svg.as_bytes()),
                Some(path) => output::to_file(path, svg.as_bytes()),
            }
        })
        .map_err(about_page)?;
    Ok(Done { notes: drawing.notes, timings: timings.stop() })
}

/// The library does not know the options of this program: where it says that a limit can be raised, say with which.
fn explain(error: &Error) -> String {
    match error {
        Error::TooManyPixels { .. } => format!("{error} with --max-megapixels"),
        Error::TooMuchMemory { .. } => format!("{error} with --max-memory"),
        _ => error.to_string(),
    }
}

/// The page is called as the picture's file is.
fn title(job: &Job) -> String {
    let name = if places::is_std(&job.picture) { None } else { job.picture.file_name() };
    name.map_or_else(|| "picture".into(), |name| name.to_string_lossy().into_owned())
}

/// Tells what became of one picture. Returns whether its page is written.
fn tell(
    jobs: &[Job],
    index: usize,
    outcome: Result<Result<Done, Failure>, Panicked>,
    timings: bool,
    report: &Report,
) -> bool {
    let job = &jobs[index];
    let picture = places::picture_name(&job.picture);
    match outcome {
        Ok(Ok(done)) => {
            done.notes.iter().for_each(|note| report.note(&picture, &note.to_string()));
            let wrote = format!("wrote {}", places::page_name(&job.page));
            report.done(&match jobs.len() {
                1 => wrote,
                count => format!("{} of {count}: {picture}: {wrote}", index + 1),
            });
            if timings {
                report.asked_for(&done.timings.table(&picture));
            }
            true
        }
        Ok(Err(failure)) => {
            report.error(&failure.file, &failure.what);
            false
        }
        Err(Panicked) => {
            report.error(
                &picture,
                "an error in tactograph itself; please report it with this picture and the lines above",
            );
            false
        }
    }
}
