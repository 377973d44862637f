//! `tactograph describe`: a page in, sentences out.

use tactograph::PageOptions;

use super::args::Describe;
use super::report::{Exit, Report};
use super::{input, output, places};

/// Describes one page.
pub(super) fn run(args: &Describe) -> Exit {
    let report = Report::plain();
    let page = places::picture_name(&args.page);
    match described(args) {
        Ok(text) => match output::to_stdout(text.as_bytes(), "description") {
            Ok(()) => Exit::Done,
            Err(error) => {
                report.error("standard output", &format!("{error:#}"));
                Exit::Failed
            }
        },
        Err(error) => {
            let is_usage = matches!(error.downcast_ref(), Some(tactograph::Error::NoSuchName { .. }));
            let (place, exit) = if is_usage { ("--lang", Exit::Usage) } else { (&page[..], Exit::Failed) };
            report.error(place, &format!("{error:#}"));
            exit
        }
    }
}

fn described(args: &Describe) -> anyhow::Result<String> {
    let bytes = input::read_page(&args.page)?;
    let other = input::other_than_svg(&args.page, "describe");
    let options = args.lang.iter().fold(PageOptions::new(), PageOptions::language);
    let description = match (tactograph::describe(bytes, &options), other) {
        (Err(error), Some(why)) if !matches!(error, tactograph::Error::NoSuchName { .. }) => anyhow::bail!("{why}"),
        (description, _) => description?,
    };
    Ok(if args.json { description.to_json() } else { description.to_string() })
}
