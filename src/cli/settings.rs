//! `--profile`, `--set` and what is short for it become a checked profile, or the list of everything that is wrong
//! with them.

use std::path::Path;

use tactograph::{Error, Fault, Profile, built_in, is_path};

use super::input;

/// Largest profile read. The built-in ones have some kilobytes; a picture given by mistake is told at once.
const MOST_PROFILE_BYTES: u64 = 1 << 20;

/// One value of the profile that the command line changes.
#[derive(Debug, Clone)]
pub(super) struct Change {
    /// The option as it was typed, such as `--detail 0.2`.
    option: String,
    /// `KEY=VALUE`.
    set: String,
}

impl Change {
    /// `--set KEY=VALUE`.
    pub(super) fn set(set: &str) -> Self {
        Self { option: format!("--set {set}"), set: set.to_owned() }
    }

    /// An option that is short for `--set KEY=VALUE`.
    pub(super) fn short(option: &str, set: &str) -> Self {
        Self { option: option.to_owned(), set: set.to_owned() }
    }

    /// The fault with the option that was typed in place of what it is short for.
    fn named(&self, fault: Fault) -> Fault {
        let long = format!("--set {}", self.set);
        let named = |text: String| if long == self.option { text } else { text.replace(&long, &self.option) };
        Fault { place: named(fault.place), what: named(fault.what) }
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
            None => match Profile::named(built_in()[0].name) {
                Ok(default) => stand_in.get_or_insert(default),
                Err(more) => {
                    faults.extend(faults_of(more));
                    break;
                }
            },
        };
        faults.extend(apply(target, &change.set).err().into_iter().flatten());
    }
    faults.extend(profile.iter().filter_map(|profile| profile.check().err()).flat_map(faults_of));
    let named = |fault| changes.iter().fold(fault, |fault, change| change.named(fault));
    match profile {
        Some(profile) if faults.is_empty() => Ok(profile),
        _ => Err(faults.into_iter().map(named).collect()),
    }
}

/// What is wrong with a profile, fault by fault.
pub(super) fn faults_of(error: Error) -> Vec<Fault> {
    match error {
        Error::Profile(faults) => faults,
        other => vec![Fault { place: "profile".to_owned(), what: other.to_string() }],
    }
}

fn load(profile: &str) -> Result<Profile, Vec<Fault>> {
    if !is_path(profile) {
        return Profile::named(profile).map_err(|error| {
            let mut faults = faults_of(error);
            faults.iter_mut().for_each(|fault| fault.what += "; for a file of your own give a name that ends in .toml");
            faults
        });
    }
    let text = text_of(profile).map_err(|what| vec![Fault { place: profile.to_owned(), what }])?;
    let inherited = |path: &str| text_of(path).map_err(|why| format!("{path}: {why}"));
    Profile::from_toml_with(&text, profile, &inherited).map_err(faults_of)
}

/// The text of a profile's file, or why it cannot be read.
fn text_of(path: &str) -> Result<String, String> {
    let bytes = input::read(Path::new(path), MOST_PROFILE_BYTES, "this is too large for a profile; give a TOML file")
        .map_err(|error| format!("{error:#}"))?;
    String::from_utf8(bytes).map_err(|_| "this is not text in UTF-8; give a profile, which is a TOML file".to_owned())
}

fn apply(profile: &mut Profile, set: &str) -> Result<(), Vec<Fault>> {
    match set.split_once('=') {
        Some((key, value)) if !key.trim().is_empty() => profile.set(key.trim(), value.trim()).map_err(faults_of),
        _ => Err(vec![Fault {
            place: format!("--set {set}"),
            what: "write it as key=value, such as lines.width_max=1.2".into(),
        }]),
    }
}
