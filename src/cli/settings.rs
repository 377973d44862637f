//! `--profile`, `--set` and what is short for it become a checked profile, or the list of everything that is wrong with them.

use std::path::Path;

use tactograph::{Fault, Profile, built_in};

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
                    faults.extend(more);
                    break;
                }
            },
        };
        faults.extend(apply(target, &change.set).err());
    }
    faults.extend(profile.iter().flat_map(Profile::check));
    let named = |fault| changes.iter().fold(fault, |fault, change| change.named(fault));
    match profile {
        Some(profile) if faults.is_empty() => Ok(profile),
        _ => Err(faults.into_iter().map(named).collect()),
    }
}

fn load(profile: &str) -> Result<Profile, Vec<Fault>> {
    if !is_file(profile) {
        return Profile::named(profile).map_err(|mut faults| {
            faults.iter_mut().for_each(|fault| fault.what += "; for a file of your own give a name that ends in .toml");
            faults
        });
    }
    let bytes =
        input::read(Path::new(profile), MOST_PROFILE_BYTES, "this is too large for a profile; give a TOML file")
            .map_err(|error| fault(profile, format!("{error:#}")))?;
    let text = String::from_utf8(bytes)
        .map_err(|_| fault(profile, "this is not text in UTF-8; give a profile, which is a TOML file".into()))?;
    Profile::from_toml(&text, profile)
}

fn fault(place: &str, what: String) -> Vec<Fault> {
    vec![Fault { place: place.into(), what }]
}

fn is_file(profile: &str) -> bool {
    let path = Path::new(profile);
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) || path.components().count() > 1
}

fn apply(profile: &mut Profile, set: &str) -> Result<(), Fault> {
    match set.split_once('=') {
        Some((key, value)) if !key.trim().is_empty() => profile.set(key.trim(), value.trim()),
        _ => Err(Fault {
            place: format!("--set {set}"),
            what: "write it as key=value, such as lines.width_max=1.2".into(),
        }),
    }
}
