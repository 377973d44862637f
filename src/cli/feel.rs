//! `tactograph feel`: pages in, what a fingertip feels of them out.

use std::path::Path;

use anyhow::bail;
use tactograph::PageOptions;

use super::args::Feel;
use super::report::{Exit, Report};
use super::{input, output, places};

/// Feels pages and tells what is felt.
pub(super) fn run(args: &Feel) -> Exit {
    let report = Report::plain();
    if let Some(path) = &args.output {
        let is_png = path.extension().is_none_or(|ending| ending.eq_ignore_ascii_case("png"));
        if !is_png || places::is_std(path) {
            let instead = if is_png { "felt.png".into() } else { path.with_extension("png").display().to_string() };
            report.usage(&format!("{}: a map is written only to a .png file; name it {instead}", path.display()));
            return Exit::Usage;
        }
        if args.pages.len() > 1 {
            report.usage("-o takes one page; feel them one by one");
            return Exit::Usage;
        }
    }
    let pages = args.pages.iter().map(|page| one(args, page, &report));
    pages.fold(Exit::Done, |worst, exit| if matches!(exit, Exit::Done) { worst } else { exit })
}

/// Feels one of the pages.
fn one(args: &Feel, page: &Path, report: &Report) -> Exit {
    let name = places::picture_name(page);
    let (text, map) = match feel(args, page) {
        Ok(felt) => felt,
        Err(error) => {
            report.error(&name, &format!("{error:#}"));
            return Exit::Failed;
        }
    };
    let text = if args.pages.len() > 1 { format!("{name}:\n{text}\n") } else { text };
    if let Err(error) = output::to_stdout(text.as_bytes(), "report") {
        report.error("standard output", &format!("{error:#}"));
        return Exit::Failed;
    }
    let Some((path, map)) = args.output.as_ref().zip(map) else { return Exit::Done };
    match output::to_file(path, &map, "map") {
        Ok(()) => {
            report.done(&format!("{name}: wrote {}", path.display()));
            Exit::Done
        }
        Err(error) => {
            report.error(&path.display().to_string(), &format!("{error:#}"));
            Exit::Failed
        }
    }
}

/// The report, and the map if it is wanted.
fn feel(args: &Feel, page: &Path) -> anyhow::Result<(String, Option<Vec<u8>>)> {
    let bytes = input::read_page(page)?;
    let felt = match (
        tactograph::feel(bytes, &PageOptions::new().finger_mm(args.finger)),
        input::other_than_svg(page, "feel"),
    ) {
        (Err(_), Some(why)) => bail!("{why}"),
        (felt, _) => felt?,
    };
    let map = args.output.as_ref().map(|_| felt.to_png()).transpose()?;
    Ok((felt.report().to_string(), map))
}
