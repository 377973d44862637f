//! A profile's text and the texts it inherits, laid one over the other.

use super::built_in;
use super::fault::{Fault, FaultInText};
use super::keys::{KEYS, Origin, Profile};
use super::parse::{WrittenKey, parse};
use super::suggest::unknown_profile;
use crate::listing::{first_few, list};

/// How many faults are listed: a file that is no profile at all has one on every line.
const MOST_FAULTS: usize = 50;

/// How many missing keys are named.
const MOST_MISSING: usize = 6;

/// How many texts are laid one over the other. The built-in profiles are three deep; files that name one another by
/// ever other paths come to an end here.
const MOST_TEXTS: usize = 16;

/// Gives the text of a profile file that another inherits, by its path, or says why it cannot.
pub(super) type FindFile<'a> = dyn Fn(&str) -> Result<String, String> + 'a;

/// Whose text a profile is read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ProfileOrigin {
    /// One of the profiles that come with the program.
    BuiltIn,
    /// A file of the maker's own.
    File,
}

/// Reads a profile and all it inherits. `place` is the name of the file, or of the built-in profile.
pub(super) fn load(text: &str, place: &str, source: ProfileOrigin, find: &FindFile<'_>) -> Result<Profile, Vec<Fault>> {
    let mut faults = Vec::new();
    let texts = texts(text, place, source, find, &mut faults);
    let mut profile = Profile::blank(name_of(place).to_owned());
    lay_over(&mut profile, &texts.layers);
    if texts.complete {
        faults.extend(missing(&profile, &texts.layers));
    }
    faults.extend(profile.rule_faults());
    if faults.len() > MOST_FAULTS {
        let more = faults.len() - MOST_FAULTS;
        faults.truncate(MOST_FAULTS);
        faults.push(Fault::new(place, format!("there are {more} more faults")));
    }
    if faults.is_empty() { Ok(profile) } else { Err(faults) }
}

/// The last part of a path, without `.toml`.
fn name_of(place: &str) -> &str {
    let file = place.rsplit(['/', '\\']).next().unwrap_or(place);
    file.strip_suffix(".toml").unwrap_or(file)
}

/// A text and those it inherits.
struct ProfileTexts {
    /// The text itself first. Never empty.
    layers: Vec<ProfileLayer>,
    /// Whether the last one inherits nothing and could be read, so that together they must give every key.
    complete: bool,
}

struct ProfileLayer {
    place: String,
    source: ProfileOrigin,
    written: WrittenKey,
}

fn texts(text: &str, place: &str, source: ProfileOrigin, find: &FindFile<'_>, faults: &mut Vec<Fault>) -> ProfileTexts {
    let mut texts = ProfileTexts { layers: Vec::new(), complete: true };
    let mut next = Some((text.to_owned(), place.to_owned(), source));
    while let Some((text, place, source)) = next.take() {
        let mut found = Vec::new();
        let written = parse(&text, &mut found);
        texts.complete &= !written.broken;
        let parent = written.inherits.clone();
        texts.layers.push(ProfileLayer { place: place.clone(), source, written });
        if let Some((parent, line)) = parent {
            match inherited(&parent, &texts.layers, find) {
                Ok(text) => next = Some(text),
                Err(what) => {
                    texts.complete = false;
                    found.push(FaultInText::new(line, what));
                    found.sort_by_key(|fault| fault.line);
                }
            }
        }
        faults.extend(found.into_iter().map(|found| found.in_file(&place)));
    }
    texts
}

/// The text, place and source of what the last of `layers` inherits.
fn inherited(
    parent: &str,
    layers: &[ProfileLayer],
    find: &FindFile<'_>,
) -> Result<(String, String, ProfileOrigin), String> {
    let child = layers.last().map_or("", |layer| layer.place.as_str());
    let (place, source) = if built_in::is_path(parent) {
        (beside(child, parent), ProfileOrigin::File)
    } else {
        (format!("{parent}.toml"), ProfileOrigin::BuiltIn)
    };
    let names = || layers.iter().map(|layer| layer.name()).chain([parent]).collect::<Vec<_>>().join(" to ");
    if layers.iter().any(|layer| layer.source == source && same_file(&layer.place, &place)) {
        return Err(format!("inherits goes round in a circle, {}, take one of them away", names()));
    }
    if layers.len() >= MOST_TEXTS {
        return Err(format!("inherits goes through more than {MOST_TEXTS} profiles, {}, use fewer", names()));
    }
    let text = match source {
        ProfileOrigin::BuiltIn => {
            built_in::text_of(parent).map(str::to_owned).ok_or_else(|| unknown_profile(parent).to_string())
        }
        ProfileOrigin::File => find(&place),
    };
    let text = text.map_err(|why| format!("inherits cannot be followed, {why}"))?;
    Ok((text, place, source))
}

impl ProfileLayer {
    /// As a profile names it that inherits it.
    fn name(&self) -> &str {
        match self.source {
            ProfileOrigin::BuiltIn => name_of(&self.place),
            ProfileOrigin::File => &self.place,
        }
    }
}

/// A path that is meant from the folder of the file `child`.
fn beside(child: &str, path: &str) -> String {
    let absolute = path.starts_with(['/', '\\']) || path.get(1..2) == Some(":");
    match child.rfind(['/', '\\']).and_then(|end| child.get(..=end)) {
        Some(folder) if !absolute => format!("{folder}{path}"),
        _ => path.to_owned(),
    }
}

/// Whether two paths name one file as far as their letters tell.
fn same_file(a: &str, b: &str) -> bool {
    let parts = |path: &str| {
        let mut parts: Vec<String> = Vec::new();
        for part in path.split(['/', '\\']).enumerate().filter(|&(i, part)| part != "." && (i == 0 || !part.is_empty()))
        {
            match parts.last() {
                Some(last) if part.1 == ".." && last != ".." && !last.is_empty() => drop(parts.pop()),
                _ => parts.push(part.1.to_owned()),
            }
        }
        parts
    };
    parts(a) == parts(b)
}

/// Writes all values, those of the text itself last. A refused value leaves its key not held, so that no rule is
/// applied to the inherited one in its place.
fn lay_over(profile: &mut Profile, layers: &[ProfileLayer]) {
    let mut order = 0;
    for (depth, layer) in layers.iter().enumerate().rev() {
        for given in &layer.written.given {
            order += 1;
            let held = given.value.as_ref().is_some_and(|value| KEYS[given.key].put(profile, value));
            let own = depth == 0 && layer.source == ProfileOrigin::File;
            let place = format!("{}, line {}", layer.place, given.line);
            profile.origins[given.key] = Origin { order, held, own, place };
        }
    }
    if let Some(layer) = layers.first() {
        profile.description = layer.written.description.clone().unwrap_or_default();
    }
    let inherited = layers.iter().find(|layer| layer.source == ProfileOrigin::BuiltIn).map(ProfileLayer::name);
    if let Some(base) = built_in::built_in().iter().find(|one| Some(one.name) == inherited) {
        profile.base = base.name;
    }
}

/// The fault of a profile that inherits nothing and does not give every key.
fn missing(profile: &Profile, layers: &[ProfileLayer]) -> Option<Fault> {
    let missing: Vec<_> =
        KEYS.iter().zip(&profile.origins).filter(|(_, origin)| origin.order == 0).map(|(key, _)| key.path).collect();
    let place = &layers.last()?.place;
    let count = missing.len();
    let named = match count {
        0 => return None,
        1..=MOST_MISSING => list(&missing, "and"),
        _ => first_few(&missing, MOST_MISSING, |key| (*key).to_owned()),
    };
    let what = format!(
        "without inherits every key must be given, {named} {} missing, write inherits = \"swell-a4\" at the top to \
         take what is missing from there",
        if count == 1 { "is" } else { "are" }
    );
    Some(Fault::of_keys(&missing, place, what))
}

#[cfg(test)]
mod tests;
