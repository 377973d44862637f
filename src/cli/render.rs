//! `tactograph render`: a page in, edited or not, the same page in any format out.

use tactograph::{Page, PageOptions, Profile, RenderOptions, Value, language_of_page};

use super::args::Render;
use super::dots;
use super::product::{Format, Product};
use super::remedies::{self, Making};
use super::report::{Exit, Report};
use super::settings::Change;
use super::sheets::Failure;
use super::{input, louis, places, settings, sheets};

/// Reads one page and writes it.
pub(super) fn run(args: &Render) -> Exit {
    let report = Report::of_pictures(1, args.quiet);
    let (chosen, mut faults) = args.writing.choose(Some(&args.output));
    faults.extend(places::wrong_ending(&args.output, Product::Page(chosen.format)));
    if args.profile.is_none() && !args.set.is_empty() {
        faults.push("--set needs --profile NAME, which lays the page out anew: that of the page, or another".into());
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
    let not_in_file = sheets::not_in(&pages, formats);
    not_in_file.iter().for_each(|note| report.note(&page, &remedies::of_note(note, Making::Other)));
    // what is out of its range was told before anything was done
    let embossing = args.embossing.numbers().unwrap_or_default();
    match sheets::write_pages((&title, &pages), (chosen, embossing), &args.output, args.force) {
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
    let bytes = input::read_page(&args.page).map_err(|error| failed(format!("{error:#}")))?;
    let own = Profile::of_page(&bytes).map_err(|error| failed(error.to_string()))?;
    if other.is_none() {
        let (chosen, _) = args.writing.choose(Some(&args.output));
        let faults = dots::faults(chosen.format, &own, &args.embossing);
        if !faults.is_empty() {
            return Err((Exit::Usage, faults));
        }
    }
    let (other, table) = contracted(&bytes, &own, other, args, |why| report.note(name, why))
        .map_err(|what| (Exit::Usage, vec![what]))?;
    let making = if other.is_some() { Making::PageAnew } else { Making::Other };
    let options = other.into_iter().fold(RenderOptions::new().key(args.key.sheets()), RenderOptions::profile);
    let options = args.title.iter().fold(options, |options, title| options.title(title));
    let options = match table {
        Some(table) => options.translator(move |text| louis::translate(&table, text)),
        None => options,
    };
    let drawing = tactograph::render(&bytes, &options).map_err(|error| failed(remedies::of_error(&error)))?;
    remedies::of_notes(&drawing.notes, making).iter().for_each(|note| report.note(name, note));
    errors_left(&drawing.page).iter().for_each(|told| report.note(name, told));
    let title = drawing.page.title.clone();
    Ok(([drawing.page].into_iter().chain(drawing.overview).chain(drawing.key).collect(), title))
}

/// What is told of a page on which a check finds errors: what a person draws too near to something stays there. Its
/// lines and areas have other numbers than in the file that was read, so places are told and no names.
fn errors_left(page: &Page) -> Option<String> {
    let checked = tactograph::check(page.to_svg(), &PageOptions::new()).ok()?;
    let (errors, first) = (checked.errors(), checked.findings.first()?);
    (errors > 0).then(|| {
        let found = if errors == 1 { "1 error".to_owned() } else { format!("{errors} errors, such as") };
        let at = first
            .at
            .map_or_else(String::new, |at| format!(", {:.0} mm from the left and {:.0} mm from the top", at.x, at.y));
        let (rule, place) = (first.rule.id, &first.place);
        format!("a check finds {found} ({rule}): {place}{at}; tactograph check of the page tells all, and what to do")
    })
}

/// The profile that the page is laid out anew for, with contracted braille where the page has that, unless `--set` says
/// otherwise; and the table of liblouis that writes it, or the one that is asked for.
///
/// # Errors
/// In one line, if the one that is asked for is none, or liblouis is not installed.
fn contracted(
    bytes: &[u8],
    own: &Profile,
    other: Option<&Profile>,
    args: &Render,
    tell: impl Fn(&str),
) -> Result<(Option<Profile>, Option<String>), String> {
    const GRADE: &str = "braille.grade";
    let is_contracted = |profile: &Profile| profile.get(GRADE) == Ok(Value::Number(2.0));
    let is_set = args.set.iter().any(|set| set.split('=').next().is_some_and(|key| key.trim() == GRADE));
    let mut other = other.cloned();
    if let Some(other) = other.as_mut().filter(|_| is_contracted(own) && !is_set) {
        // a number that the page has is one that the key takes
        let _ = other.set(GRADE, "2");
    }
    let profile = other.as_ref().unwrap_or(own);
    let language = language_of_page(bytes).unwrap_or_default();
    if let Some(asked) = args.braille_table.as_deref() {
        let table = louis::wanted(Some(asked), profile, &language)?;
        if other.is_none() {
            tell("--braille-table counts for words that were changed on the page; the others keep their cells");
        }
        return Ok((other, table));
    }
    let table = if is_contracted(profile) { louis::wanted(None, profile, &language) } else { Ok(None) };
    let table = table.unwrap_or_else(|why| {
        tell(&format!("{why}; until then words that are written anew are uncontracted"));
        None
    });
    Ok((other, table))
}
