//! A profile's text and the texts it inherits, laid one over the other.

use super::keys::KEYS;
use super::parse::{Written, parse};
use super::suggest::{list, unknown_profile};
use super::{Fault, Found, Origin, Profile};

/// How many faults are listed: a file that is no profile at all has one on every line.
const MOST_FAULTS: usize = 50;

/// How many missing keys are named.
const MOST_MISSING: usize = 6;

/// Reads a profile and all it inherits. `text_of` gives the texts that can be inherited, and `known_as` is the name by
/// which it would give this one, if it does.
pub(super) fn load(
    text: &str,
    place: &str,
    known_as: Option<&str>,
    text_of: &dyn Fn(&str) -> Option<&'static str>,
) -> Result<Profile, Vec<Fault>> {
    let mut faults = Vec::new();
    let chain = chain(text, place, known_as, text_of, &mut faults);
    let mut profile = Profile::blank(name_of(place).to_owned());
    lay_over(&mut profile, &chain.files);
    if chain.complete {
        faults.extend(missing(&profile, &chain.files));
    }
    faults.extend(profile.rule_faults());
    if faults.len() > MOST_FAULTS {
        let more = faults.len() - MOST_FAULTS;
        faults.truncate(MOST_FAULTS);
        faults.push(Fault { place: place.to_owned(), what: format!("there are {more} more faults") });
    }
    if faults.is_empty() { Ok(profile) } else { Err(faults) }
}

/// The last part of a path, without `.toml`.
fn name_of(place: &str) -> &str {
    let file = place.rsplit(['/', '\\']).next().unwrap_or(place);
    file.strip_suffix(".toml").unwrap_or(file)
}

/// A file and those it inherits.
struct Chain {
    /// Place and content; the file itself first. Never empty.
    files: Vec<(String, Written)>,
    /// Whether the last file inherits nothing and could be read, so that together they must give every key.
    complete: bool,
}

fn chain(
    text: &str,
    place: &str,
    known_as: Option<&str>,
    text_of: &dyn Fn(&str) -> Option<&'static str>,
    faults: &mut Vec<Fault>,
) -> Chain {
    let mut names: Vec<String> = known_as.into_iter().map(str::to_owned).collect();
    let mut next = Some((place.to_owned(), text));
    let mut chain = Chain { files: Vec::new(), complete: true };
    while let Some((place, text)) = next.take() {
        let mut found = Vec::new();
        let written = parse(text, &mut found);
        chain.complete &= !written.broken;
        if let Some((parent, line)) = &written.inherits {
            let round = names.contains(parent);
            names.push(parent.clone());
            let what = match text_of(parent) {
                None => format!("inherits cannot be followed, {}", unknown_profile(parent)),
                Some(_) if round => {
                    format!("inherits goes round in a circle, {}, take one of them away", names.join(" to "))
                }
                Some(text) => {
                    next = Some((format!("{parent}.toml"), text));
                    String::new()
                }
            };
            if next.is_none() {
                chain.complete = false;
                found.push(Found::new(*line, what));
                found.sort_by_key(|fault| fault.line);
            }
        }
        faults.extend(found.into_iter().map(|f| Fault { place: format!("{place}, line {}", f.line), what: f.what }));
        chain.files.push((place, written));
    }
    chain
}

/// Writes all values, those of the file itself last. A refused value leaves its key not held, so that no rule is
/// applied to the inherited one in its place.
fn lay_over(profile: &mut Profile, files: &[(String, Written)]) {
    let mut order = 0;
    for (place, written) in files.iter().rev() {
        for given in &written.given {
            order += 1;
            let key = &KEYS[given.key];
            if let Some(value) = given.value {
                key.put(profile, value);
            }
            let place = format!("{place}, line {}", given.line);
            profile.origins[given.key] = Origin { order, held: given.value.is_some(), place };
        }
    }
    if let Some((_, written)) = files.first() {
        profile.description = written.description.clone().unwrap_or_default();
    }
}

/// The fault of a profile that inherits nothing and does not give every key.
fn missing(profile: &Profile, files: &[(String, Written)]) -> Option<Fault> {
    let missing: Vec<_> =
        KEYS.iter().zip(&profile.origins).filter(|(_, origin)| origin.order == 0).map(|(key, _)| key.path).collect();
    let (place, _) = files.last()?;
    let count = missing.len();
    let named = match count {
        0 => return None,
        1..=MOST_MISSING => list(&missing, "and"),
        _ => format!("{} and {} more", missing[..MOST_MISSING].join(", "), count - MOST_MISSING),
    };
    let what = format!(
        "without inherits every key must be given, {named} {} missing, write inherits = \"swell-a4\" at the top to \
         take what is missing from there",
        if count == 1 { "is" } else { "are" }
    );
    Some(Fault { place: place.clone(), what })
}

#[cfg(test)]
mod tests {
    use super::super::built_in;
    use super::*;

    fn text_of(name: &str) -> Option<&'static str> {
        match name {
            "egg" => Some("inherits = \"hen\""),
            "hen" => Some("# lays\ninherits = \"egg\""),
            "self" => Some("inherits = \"self\""),
            "faulty" => Some("inherits = \"swell-a4\"\nlines.width_max = 99"),
            name => built_in::text_of(name),
        }
    }

    fn faults(text: &str, known_as: Option<&str>) -> String {
        let Err(faults) = load(text, "my.toml", known_as, &text_of) else { return "none".to_owned() };
        faults.iter().map(Fault::to_string).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn circles_are_told() {
        for (text, known_as, expected) in [
            (
                "inherits = \"egg\"",
                Some("hen"),
                "egg.toml, line 1: inherits goes round in a circle, hen to egg to hen, take one of them away",
            ),
            (
                "inherits = \"egg\"\npage.margin = 200",
                None,
                "my.toml, line 2: page.margin must be a number from 0 to 100 mm, not 200\n\
                 hen.toml, line 2: inherits goes round in a circle, egg to hen to egg, take one of them away",
            ),
            (
                "inherits = \"self\"",
                Some("self"),
                "my.toml, line 1: inherits goes round in a circle, self to self, take one of them away",
            ),
        ] {
            assert_eq!(faults(text, known_as), expected);
        }
    }

    /// Faults stay where they are, and a rule is not held against what stands in for a refused value.
    #[test]
    fn faults_of_inherited_profiles_name_them() {
        let refused = "faulty.toml, line 2: lines.width_max must be a number from 0.3 to 10 mm, not 99";
        assert_eq!(faults("inherits = \"faulty\"\nlines.width_min = 2", None), refused);
        assert_eq!(faults("inherits = \"faulty\"\nlines.width_max = 2", None), refused);
    }

    #[test]
    fn profiles_are_called_by_their_file() {
        for (place, name) in [("a/b/my.toml", "my"), ("C:\\my.toml", "my"), ("my.txt", "my.txt"), ("", "")] {
            assert_eq!(name_of(place), name);
        }
    }
}
