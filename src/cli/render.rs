//! `tactograph render`: a page in, edited or not, the same page in any format out.

use tactograph::{Page, Profile, profile_of_page, render_with_key};

use super::args::Render;
use super::dots;
use super::product::{Format, Product};
use super::report::{Exit, Report};
use super::settings::Change;
use super::sheets::Failure;
use super::{input, places, settings, sheets};

/// Longest page that is read, bytes.
const MOST_BYTES: u64 = 100_000_000;

/// Reads one page and writes it.
pub(super) fn run(args: &Render) -> Exit {
    let report = Report::of_pictures(1, args.quiet);
    let (chosen, mut faults) = args.writing.choose(Some(&args.output));
    faults.extend(places::wrong_ending(&args.output, Product::Page(chosen.format)));
    if args.profile.is_none() && !args.set.is_empty() {
        faults.push("--set changes the profile that --profile names; name one to lay the page out anew".into());
    }
    let changes: Vec<Change> = args.set.iter().map(|set| Change::set(set)).collect();
    let other = args.profile.as_ref().map(|name| settings::profile(name, &changes)).transpose();
    faults.extend(other.iter().flatten().flat_map(|profile| dots::faults(chosen.format, profile, &args.embossing)));
    faults.iter().for_each(|what| report.usage(what));
    let other = match other {
        Ok(other) if faults.is_empty() => other,
        other => {
            other.err().iter().flatten().for_each(|fault| report.error(&fault.place, &fault.what));
            return Exit::Usage;
        }
    };
    let page = places::picture_name(&args.page);
    let (pages, title) = match read(args, other.as_ref(), &report, &page) {
        Ok(read) => read,
        Err((exit, told)) => {
            told.iter().for_each(|what| report.error(&page, what));
            return exit;
        }
    };
    let formats = [Some(chosen.format), chosen.preview.map(Format::Drawing)];
    sheets::not_in(&pages, formats).into_iter().for_each(|note| report.note(&page, &note.to_string()));
    match sheets::write_pages((&title, &pages), (chosen, args.embossing.numbers()), &args.output, args.force) {
        Ok(names) => {
            names.iter().for_each(|name| report.done(&format!("wrote {name}")));
            Exit::Done
        }
        Err(Failure { file, what }) => {
            report.error(&file, &what);
            Exit::Failed
        }
    }
}

/// The pages, and what they are called together.
fn read(
    args: &Render,
    other: Option<&Profile>,
    report: &Report,
    name: &str,
) -> Result<(Vec<Page>, String), (Exit, Vec<String>)> {
    let failed = |what: String| (Exit::Failed, vec![what]);
    let too_long = format!("the file is longer than {} MB, which is no page", MOST_BYTES / 1_000_000);
    let bytes = input::read(&args.page, MOST_BYTES, &too_long).map_err(|error| failed(format!("{error:#}")))?;
    if other.is_none() {
        let own = profile_of_page(&bytes).map_err(|error| failed(error.to_string()))?;
        let (chosen, _) = args.writing.choose(Some(&args.output));
        let faults = dots::faults(chosen.format, &own, &args.embossing);
        if !faults.is_empty() {
            return Err((Exit::Usage, faults));
        }
    }
    let drawing = render_with_key(&bytes, other, args.key.sheets()).map_err(|error| failed(error.to_string()))?;
    drawing.notes.iter().for_each(|note| report.note(name, &note.to_string()));
    let title = drawing.page.title.clone();
    Ok(([drawing.page].into_iter().chain(drawing.overview).chain(drawing.key).collect(), title))
}
