//! What to say of a key, a section or a profile that does not exist.

use super::built_in::built_in;
use super::fault::quoted_path;
use super::keys::{KEYS, SECTIONS};
use super::nearest::{did_you_mean, is_misspelt, nearest};
use crate::Error;
use crate::listing::list;

/// What to say of a key that does not exist; `section` does.
pub(super) fn unknown_key(section: &str, name: &str) -> String {
    let own = || KEYS.iter().filter(|key| key.section() == section);
    let same_section = nearest(name, own().map(|key| (key.name(), key.path)));
    let any_section = nearest(name, KEYS.iter().map(|key| (key.name(), key.path)));
    let word: Vec<_> =
        own().filter(|key| key.name().split('_').any(|word| is_misspelt(word, name))).map(|key| key.path).collect();
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

/// What to say of a name at the top of a file, or alone where a key is set, that is neither a section nor one of
/// `others`.
pub(super) fn unknown_section(name: &str, others: &[&'static str]) -> String {
    let sections = nearest(name, SECTIONS.iter().chain(others).map(|&known| (known, known)));
    let keys = nearest(name, KEYS.iter().map(|key| (key.name(), key.path)));
    let near = if keys.distance < sections.distance { keys.offers } else { sections.offers };
    let advice = did_you_mean(&near).unwrap_or_else(|| format!("the sections are {}", list(SECTIONS, "and")));
    format!("there is no section {}, {advice}", quoted_path(&[name]))
}

/// What to say of a section without a switch where a key is asked for.
pub(super) fn section_alone(section: &str) -> String {
    let keys: Vec<_> = KEYS.iter().filter(|key| key.section() == section).map(|key| key.path).collect();
    format!("{section} is a section, name one of its keys: {}", list(&keys, "or"))
}

/// What to say of a profile that does not exist.
pub(super) fn unknown_profile(name: &str) -> Error {
    let names: Vec<_> = built_in().iter().map(|profile| profile.name).collect();
    let other_names = built_in().iter().flat_map(|profile| profile.also.iter().map(|&also| (also, profile.name)));
    let near = nearest(name, names.iter().map(|&known| (known, known)).chain(other_names));
    let parts: Vec<_> = name.split(['-', '_', ' ']).filter(|part| !part.is_empty()).collect();
    let with_parts = || names.iter().copied().filter(|known| !parts.is_empty() && has_all(known, &parts)).collect();
    let offers = if near.offers.is_empty() { with_parts() } else { near.offers };
    Error::no_such_name("built-in profile", name, &names, offers)
}

/// Whether each of these, in capitals or not, is a part of a profile's name between hyphens.
fn has_all(name: &str, parts: &[&str]) -> bool {
    parts.iter().all(|part| name.split('-').any(|own| own.eq_ignore_ascii_case(part)))
}
