//! `tactograph calibrate`: a profile in, sheets of samples out.

use tactograph::medium::{Device, Pitches};
use tactograph::{Calibration, Embossing, Error, Profile};

use super::args::{Calibrate, Chosen, EmbossingOptions};
use super::places::Target;
use super::product::Product;
use super::report::{Exit, Report};
use super::settings::Change;
use super::sheets::{Document, Failure};
use super::{dots, places, settings, sheets};

/// The key of the distance from dot to dot.
const PITCH: &str = "dots.pitch";

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
    match written(&profile, args, chosen) {
        Ok(told) => {
            profile.unused().iter().for_each(|key| report.note(&key.place, &key.what));
            told.iter().for_each(|line| report.done(line));
            Exit::Done
        }
        Err(Failure { file, what }) => {
            report.error(&file, &what);
            Exit::Failed
        }
    }
}

/// Makes the sheets, and writes those of each pitch to a file of its own. Returns what is told of them.
fn written(profile: &Profile, args: &Calibrate, chosen: Chosen) -> Result<Vec<String>, Failure> {
    let failed = |pitch: Option<f32>, error: Error| {
        let what = pitch.map_or_else(|| error.to_string(), |pitch| format!("with {PITCH}={pitch}: {error}"));
        Failure { file: args.profile.clone(), what }
    };
    let mut made: Vec<(Option<f32>, Calibration)> = Vec::new();
    for pitch in pitches(profile, args) {
        let mut profile = profile.clone();
        if let Some(pitch) = pitch {
            profile.set(PITCH, pitch).map_err(|error| failed(Some(pitch), error))?;
        }
        made.push((pitch, tactograph::calibrate(&profile).map_err(|error| failed(pitch, error))?));
    }
    let target = |pitch: Option<f32>| match pitch {
        Some(pitch) => Target::Derived(places::of_pitch(&args.output, pitch)),
        None if places::is_std(&args.output) => Target::Stdout,
        None => Target::Named(args.output.clone()),
    };
    let mut documents = Vec::new();
    for (pitch, Calibration { title, pages, .. }) in &made {
        documents.push(Document { title, pages, target: target(*pitch) });
    }
    let names = sheets::write_documents(&documents, (chosen, Embossing::default()), args.force)?;
    let pages = made.iter().flat_map(|(_, calibration)| &calibration.pages);
    let mut told: Vec<String> = pages.map(|page| page.description.clone()).collect();
    if let [(Some(first), _), _, ..] = &made[..] {
        told.push(format!(
            "{} pitches, each in files of its own that are named by it; for one alone --set {PITCH}={first}",
            made.len()
        ));
    }
    told.extend(names.iter().map(|name| format!("wrote {name}")));
    Ok(told)
}

/// The pitches that get sheets of their own, as a sheet of dots has one: all that the device has, if it has several,
/// and neither is one of them asked for nor do all go to standard output; else none but that of the profile.
fn pitches(profile: &Profile, args: &Calibrate) -> Vec<Option<f32>> {
    let is_set = args.set.iter().any(|set| set.split('=').next().is_some_and(|key| key.trim() == PITCH));
    match profile.dots.device.map(Device::pitches) {
        Some(Pitches::Listed(pitches)) if pitches.len() > 1 && !is_set && !places::is_std(&args.output) => {
            pitches.iter().copied().map(Some).collect()
        }
        _ => vec![None],
    }
}
