//! `--profile`, `--set` and options that stand for a `--set` become a checked profile, or the list of everything that
//! is wrong with them.

use std::path::Path;

use tactograph::{Error, Fault, Profile};

use super::input;

/// Largest profile read. The built-in ones have some kilobytes; a picture given by mistake is told at once.
const MOST_PROFILE_BYTES: u64 = 1 << 20;

/// How many letters of an option a message repeats; no option with a sensible value has as many.
const LONGEST_OPTION: usize = 80;

/// One value of the profile that the command line changes.
#[derive(Debug, Clone)]
pub(super) struct Change {
    /// The option as it was typed, such as `--detail 0.2`, by which messages call it.
    option: String,
    /// `KEY=VALUE`.
    set: String,
}

impl Change {
    /// `--set KEY=VALUE`.
    pub(super) fn set(set: &str) -> Self {
        Self::of_option(&format!("--set {set}"), set)
    }

    /// An option that does the same as `--set KEY=VALUE`.
    pub(super) fn of_option(option: &str, set: &str) -> Self {
        let mut shown: String = option.chars().take(LONGEST_OPTION).collect();
        if shown.len() < option.len() {
            shown += "...";
        }
        Self { option: shown, set: set.to_owned() }
    }

    /// Makes the change.
    fn apply(&self, profile: &mut Profile) -> Result<(), Vec<Fault>> {
        match self.set.split_once('=') {
            Some((key, value)) if !key.trim().is_empty() => {
                profile.set_from(key, value, &self.option).map_err(faults_of)
            }
            _ => Err(vec![Fault::new(&self.option, "write it as key=value, such as lines.width_max=1.2")]),
        }
    }
}

/// The checked profile for `--profile` and all changes.
///
/// # Errors
/// Every fault at once: those of the profile, of each change and of the values taken together.
pub(super) fn profile(profile: &str, changes: &[Change]) -> Result<Profile, Vec<Fault>> {
    let (mut profile, mut faults) = match load(profile) {
        Ok(profile) => (Some(profile), Vec::new()),
        Err(faults) => (None, faults),
    };
    // With a profile that cannot be read, the changes can still be looked at, in the default one.
    let mut stand_in = None;
    for change in changes {
        let target = match &mut profile {
            Some(profile) => profile,
            None => match Profile::named(Profile::built_in()[0].name) {
                Ok(default) => stand_in.get_or_insert(default),
                Err(more) => {
                    faults.extend(faults_of(more));
                    break;
                }
            },
        };
        faults.extend(change.apply(target).err().into_iter().flatten());
    }
    faults.extend(profile.iter().filter_map(|profile| profile.check().err()).flat_map(faults_of));
    match profile {
        Some(profile) if faults.is_empty() => Ok(profile),
        _ => Err(faults),
    }
}

/// What is wrong with a profile, fault by fault.
pub(super) fn faults_of(error: Error) -> Vec<Fault> {
    match error {
        Error::Profile(faults) => faults,
        other => vec![Fault::new("profile", other.to_string())],
    }
}

/// The profile of this name, or in this file, as it is written.
///
/// # Errors
/// Every fault at once.
pub(super) fn load(profile: &str) -> Result<Profile, Vec<Fault>> {
    if !Profile::is_path(profile) {
        return Profile::named(profile).map_err(|error| {
            vec![Fault::new("profile", format!("{error}; for a file of your own give a name that ends in .toml"))]
        });
    }
    let text = text_of(profile).map_err(|what| vec![Fault::new(profile, what)])?;
    let inherited = |path: &str| text_of(path).map_err(|why| format!("{path}: {why}"));
    Profile::from_toml_with(&text, profile, &inherited).map_err(faults_of)
}

/// The text of a profile's file, or why it cannot be read.
fn text_of(path: &str) -> Result<String, String> {
    let bytes = input::read(Path::new(path), MOST_PROFILE_BYTES, "this is too large for a profile; give a TOML file")
        .map_err(|error| format!("{error:#}"))?;
    String::from_utf8(bytes).map_err(|_| "this is not text in UTF-8; give a profile, which is a TOML file".to_owned())
}
