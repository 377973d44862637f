//! `tactograph check`: a page in, what fingers could not read of it out.

use std::path::Path;

use anyhow::bail;
use tactograph::{Checked, PageOptions, Profile, Rule};

use super::args::{Check, CheckFormat};
use super::remedies::{self, Making};
use super::report::{Exit, Report};
use super::{input, output, places, settings};

/// Checks pages, or lists the rules.
pub(super) fn run(args: &Check) -> Exit {
    let report = Report::plain();
    let profile = match args.profile.as_deref().map(|name| settings::profile(name, &[])).transpose() {
        Ok(profile) => profile,
        Err(faults) => {
            faults.iter().for_each(|fault| report.error(&fault.place, &fault.what));
            return Exit::Usage;
        }
    };
    let several = args.pages.len() > 1;
    let [page] = &args.pages[..] else {
        let one_only = match args.format {
            _ if args.mark.is_some() => Some("--mark"),
            CheckFormat::Json => Some("--format json"),
            CheckFormat::Sarif => Some("--format sarif"),
            CheckFormat::Text => None,
        };
        return match one_only.filter(|_| several) {
            Some(option) => {
                report.usage(&format!("{option} takes one page; check them one by one"));
                Exit::Usage
            }
            None if several => args
                .pages
                .iter()
                .map(|page| one(args, page, profile.as_ref(), &report))
                .fold(Exit::Done, |worst, exit| if matches!(exit, Exit::Done) { worst } else { exit }),
            None => list(profile, args.format, &report),
        };
    };
    if let Some(path) = &args.mark {
        let is_svg = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"));
        if !is_svg || places::is_std(path) || path == page {
            report.usage(&format!("--mark {}: give the name of another .svg file than the page", path.display()));
            return Exit::Usage;
        }
    }
    one(args, page, profile.as_ref(), &report)
}

/// Checks one of the pages.
fn one(args: &Check, page: &Path, profile: Option<&Profile>, report: &Report) -> Exit {
    let name = places::picture_name(page);
    match checked(page, profile, args.mark.is_some()) {
        Ok((checked, marked)) => tell(args, &name, &checked, marked.as_deref(), report),
        Err(error) => {
            report.error(&name, &format!("{error:#}"));
            Exit::Failed
        }
    }
}

/// Lists the rules.
fn list(profile: Option<Profile>, format: CheckFormat, report: &Report) -> Exit {
    let profile = profile.map_or_else(|| Profile::named(Profile::built_in()[0].name), Ok);
    let listed = |profile: Profile| match format {
        CheckFormat::Json => Rule::listed_as_json(&profile),
        CheckFormat::Text | CheckFormat::Sarif => Rule::listed(&profile),
    };
    if format == CheckFormat::Sarif {
        report.usage("rules are listed as text or json; the findings of a page as sarif name their rules");
        return Exit::Usage;
    }
    match profile.and_then(listed) {
        Ok(text) => written(&text, "rules", Exit::Done, report),
        Err(error) => {
            report.usage(&error.to_string());
            Exit::Usage
        }
    }
}

/// What is found on a page, and the page with marks if it is wanted.
fn checked(page: &Path, profile: Option<&Profile>, mark: bool) -> anyhow::Result<(Checked, Option<String>)> {
    let bytes = input::read_page(page)?;
    let options = profile.cloned().into_iter().fold(PageOptions::new(), PageOptions::profile);
    let checked = match (tactograph::check(&bytes, &options), input::other_than_svg(page, "check")) {
        (Err(_), Some(why)) => bail!("{why}"),
        (checked, _) => checked?,
    };
    let marked = mark.then(|| checked.marked(&bytes)).transpose()?;
    Ok((checked, marked))
}

fn tell(args: &Check, name: &str, checked: &Checked, marked: Option<&str>, report: &Report) -> Exit {
    checked.notes.iter().for_each(|note| report.note(name, &remedies::of_note(note, Making::Other)));
    let text = match args.format {
        CheckFormat::Text if args.pages.len() > 1 => format!("{name}:\n{checked}\n"),
        CheckFormat::Text => checked.to_string(),
        CheckFormat::Json => checked.to_json(),
        CheckFormat::Sarif => checked.to_sarif(name),
    };
    let faulty = checked.errors() > 0 || (args.strict && checked.warnings() > 0);
    let exit = written(&text, "report", if faulty { Exit::Failed } else { Exit::Done }, report);
    if let Some((path, marked)) = args.mark.as_ref().zip(marked) {
        if let Err(error) = output::to_file(path, marked.as_bytes(), "marked page") {
            report.error(&path.display().to_string(), &format!("{error:#}"));
            return Exit::Failed;
        }
        report.done(&format!("{name}: wrote {}", path.display()));
    }
    exit
}

fn written(text: &str, what: &str, exit: Exit, report: &Report) -> Exit {
    match output::to_stdout(text.as_bytes(), what) {
        Ok(()) => exit,
        Err(error) => {
            report.error("standard output", &format!("{error:#}"));
            Exit::Failed
        }
    }
}
