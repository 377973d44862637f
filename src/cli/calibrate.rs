//! `tactograph calibrate`: a profile in, sheets of samples out.

use tactograph::Embossing;

use super::args::{Calibrate, EmbossingOptions};
use super::product::Product;
use super::report::{Exit, Report};
use super::settings::Change;
use super::sheets::Failure;
use super::{dots, places, settings, sheets};

/// Makes the sheets and tells what is on them.
pub(super) fn run(args: &Calibrate) -> Exit {
    let report = Report::of_pictures(1, args.quiet);
    let (chosen, mut faults) = args.writing.choose(Some(&args.output));
    faults.extend(places::wrong_ending(&args.output, Product::Page(chosen.format)));
    let changes: Vec<Change> = args.set.iter().map(|set| Change::set(set)).collect();
    let profile = settings::profile(&args.profile, &changes);
    let not_given = EmbossingOptions { copies: None, impact: None };
    faults.extend(profile.iter().flat_map(|profile| dots::faults(chosen.format, profile, &not_given)));
    faults.iter().for_each(|what| report.usage(what));
    let profile = match profile {
        Ok(profile) if faults.is_empty() => profile,
        profile => {
            profile.err().iter().flatten().for_each(|fault| report.error(&fault.place, &fault.what));
            return Exit::Usage;
        }
    };
    let calibration = match tactograph::calibrate(&profile) {
        Ok(calibration) => calibration,
        Err(error) => {
            report.error(&args.profile, &error.to_string());
            return Exit::Failed;
        }
    };
    profile.unused().iter().for_each(|key| report.note(&key.place, &key.what));
    match sheets::write_pages(
        (&calibration.title, &calibration.pages),
        (chosen, Embossing::default()),
        &args.output,
        args.force,
    ) {
        Ok(names) => {
            calibration.pages.iter().for_each(|page| report.done(&page.description));
            names.iter().for_each(|name| report.done(&format!("wrote {name}")));
            Exit::Done
        }
        Err(Failure { file, what }) => {
            report.error(&file, &what);
            Exit::Failed
        }
    }
}
