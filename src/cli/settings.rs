//! `--profile` and `--set` become a checked plan, or the list of everything that is wrong with them.

use std::path::Path;

use tactograph::internals::profile::{Fault, Plan, Profile, built_in};

use super::input;

/// Largest profile read. The built-in ones have some kilobytes; a picture given by mistake is told at once.
const MOST_PROFILE_BYTES: u64 = 1 << 20;

/// The plan for `--profile` and all `--set`.
///
/// # Errors
/// Every fault at once: those of the profile, of each `--set` and of the values taken together.
pub(super) fn plan(profile: &str, sets: &[String]) -> Result<Plan, Vec<Fault>> {
    let (mut profile, mut faults) = match load(profile) {
        Ok(profile) => (Some(profile), Vec::new()),
        Err(faults) => (None, faults),
    };
    // With a profile that cannot be read, the keys of --set can still be looked at, in the default one.
    let mut stand_in = None;
    for set in sets {
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
        faults.extend(apply(target, set).err());
    }
    let plan = profile.map(|profile| Plan::new(&profile));
    match plan {
        Some(Ok(plan)) if faults.is_empty() => Ok(plan),
        Some(Err(more)) => {
            faults.extend(more);
            Err(faults)
        }
        _ => Err(faults),
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
