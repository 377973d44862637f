//! "Did you mean": the names nearest to one that does not exist.

use super::built_in::built_in;
use super::fault::{list, quoted_path};
use super::keys::{KEYS, SECTIONS};

/// How many letters of a name are compared; no real one has as many.
const LONGEST: usize = 40;

/// How many names are offered at most: more are no help.
const MOST: usize = 4;

/// What to say of a key that does not exist; `section` does.
pub(super) fn unknown_key(section: &str, name: &str) -> String {
    let own = || KEYS.iter().filter(|key| key.section() == section);
    let same_section = nearest(name, own().map(|key| (key.name(), key.path)));
    let any_section = nearest(name, KEYS.iter().map(|key| (key.name(), key.path)));
    let word: Vec<_> = own().filter(|key| key.name().split('_').any(|word| word == name)).map(|key| key.path).collect();
    // A slip of one letter is likelier than half a name, that than the wrong section, and that than a worse slip.
    let near = match (same_section.distance, any_section.distance) {
        (0 | 1, _) => same_section.offers,
        _ if !word.is_empty() => word,
        (_, 0) => any_section.offers,
        (usize::MAX, _) => any_section.offers,
        _ => same_section.offers,
    };
    let advice = did_you_mean(&near).unwrap_or_else(|| {
        format!("the keys of {section} are {}", list(&own().map(|key| key.name()).collect::<Vec<_>>(), "and"))
    });
    format!("there is no key {}, {advice}", quoted_path(&[section, name]))
}

/// What to say of a name at the top of a file, or alone in `--set`, that is neither a section nor one of `others`.
pub(super) fn unknown_section(name: &str, others: &[&'static str]) -> String {
    let sections = nearest(name, SECTIONS.iter().chain(others).map(|&known| (known, known)));
    let keys = nearest(name, KEYS.iter().map(|key| (key.name(), key.path)));
    let near = if keys.distance < sections.distance { keys.offers } else { sections.offers };
    let advice = did_you_mean(&near).unwrap_or_else(|| format!("the sections are {}", list(SECTIONS, "and")));
    format!("there is no section {}, {advice}", quoted_path(&[name]))
}

/// What to say of a section without a switch where `--set` wants a key.
pub(super) fn section_alone(section: &str) -> String {
    let keys: Vec<_> = KEYS.iter().filter(|key| key.section() == section).map(|key| key.path).collect();
    format!("{section} is a section, name one of its keys: {}", list(&keys, "or"))
}

/// What to say of a profile that does not exist.
pub(super) fn unknown_profile(name: &str) -> String {
    let names: Vec<_> = built_in().iter().map(|profile| profile.name).collect();
    let other_names = built_in().iter().flat_map(|profile| profile.also.iter().map(|&also| (also, profile.name)));
    let near = nearest(name, names.iter().map(|&known| (known, known)).chain(other_names));
    let advice = did_you_mean(&near.offers).map_or_else(String::new, |advice| format!(", {advice}"));
    format!(
        "there is no built-in profile {} (the built-in profiles are {}){advice}",
        quoted_path(&[name]),
        list(&names, "and")
    )
}

/// What lies nearest to a wrong name.
struct Nearest<'a> {
    /// Slips between the wrong name and these; `usize::MAX` when nothing is near.
    distance: usize,
    offers: Vec<&'a str>,
}

/// Of pairs (name, what to offer for it), those nearest to `wrong`, if any is near at all.
fn nearest<'a>(wrong: &str, names: impl Iterator<Item = (&'a str, &'a str)>) -> Nearest<'a> {
    let wrong = wrong.chars().take(LONGEST).collect::<String>().to_lowercase().replace('-', "_");
    let sorted_wrong = sorted_words(&wrong);
    let mut near = Nearest { distance: usize::MAX, offers: Vec::new() };
    for (name, offer) in names {
        let known = name.replace('-', "_");
        // The same words in another order (max_width) are one slip, however many letters moved.
        let distance =
            strsim::osa_distance(&wrong, &known).min(1 + strsim::osa_distance(&sorted_wrong, &sorted_words(&known)));
        // A third of the letters wrong is about as far as a slip goes.
        if distance > known.chars().count().div_ceil(3).min(3) || distance > near.distance {
            continue;
        }
        if distance < near.distance {
            near = Nearest { distance, offers: Vec::new() };
        }
        near.offers.push(offer);
    }
    near
}

fn sorted_words(name: &str) -> String {
    let mut words: Vec<_> = name.split('_').collect();
    words.sort_unstable();
    words.join("_")
}

fn did_you_mean(near: &[&str]) -> Option<String> {
    let near = &near[..near.len().min(MOST)];
    (!near.is_empty()).then(|| format!("did you mean {}?", list(near, "or")))
}
