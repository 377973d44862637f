//! What there is to know of every key, as a page to read. Made from the table of keys and from the profile that the
//! others inherit, so that it says what the program does.

use super::built_in::built_in;
use super::keys::{KEYS, Key, Profile, section_docs};
use super::unused;

/// What holds for all keys.
const HEAD: &str = "\
Lengths are in millimetres on the sheet. The defaults are those of the profile `swell-a4`, which the others inherit;
what they change is listed at the end. A section with a key `on` can be switched as a whole: `overview = false`.

\"Chosen by us\" marks a number for which no source was found that we could read: a starting point, to be judged by
blind readers.
";

impl Profile {
    /// A text to read, as Markdown, with a section for each of a profile: of every key its unit, range, default,
    /// meaning and the reason of its default; which keys do not count on every page; and what the built-in profiles
    /// change.
    pub fn manual() -> String {
        write()
    }
}

fn write() -> String {
    let default = &built_in()[0];
    let reasons = reasons(default.text);
    let values = Profile::named(default.name).ok();
    let value = |key: &Key| values.as_ref().map_or_else(String::new, |profile| key.value(profile).to_string());
    let mut page = HEAD.to_owned();
    for (section, doc) in section_docs() {
        page += &format!(
            "\n## `[{section}]`\n\n{doc}\n\n| key | unit | range | default | what it is |\n|---|---|---|---|---|\n"
        );
        let keys = || KEYS.iter().filter(|key| key.section() == section);
        for key in keys() {
            let (name, (unit, range), value, doc) = (key.name(), unit_and_range(key), value(key), key.doc);
            page += &format!("| `{name}` | {unit} | {range} | `{value}` | {doc} |\n");
        }
        page.push('\n');
        for key in keys() {
            if let Some((_, reason)) = reasons.iter().find(|(path, _)| path == key.path) {
                page += &format!("* `{}` - {}\n", key.name(), without_unit(reason, key));
            }
        }
    }
    page += "\n## Keys that do not count on every page\n\n\
             Who sets one of these is told so.\n";
    page += &unused::listing();
    page + &differences(values.as_ref())
}

/// A reason begins with the unit, which the table has told already.
fn without_unit(reason: &str, key: &Key) -> String {
    let (unit, _) = unit_and_range(key);
    let rest = reason.strip_prefix(unit).unwrap_or(reason).trim_start_matches(['.', ',', ' ']);
    let mut letters = rest.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn unit_and_range(key: &Key) -> (&'static str, String) {
    key.limits.map_or_else(|| ("", key.range()), |limits| (limits.unit, format!("{} to {}", limits.low, limits.high)))
}

/// The comments of a profile: each key's path with what is said above it or beside it, as one line. Where nothing is
/// said of a switch, the comment at the top of its section is about it.
fn reasons(text: &str) -> Vec<(String, String)> {
    let (mut section, mut above, mut reasons) = ("", Vec::new(), Vec::new());
    for line in text.lines() {
        if let Some(comment) = line.strip_prefix('#') {
            above.push(comment.trim());
            continue;
        }
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            section = name;
        } else if let Some((name, rest)) = line.split_once(" = ").filter(|_| !section.is_empty()) {
            let beside = rest.split_once('#').map(|(_, comment)| comment.trim());
            let said = beside.map_or_else(|| above.join(" "), str::to_owned);
            if !said.is_empty() {
                reasons.push((format!("{section}.{}", name.trim()), said));
            }
        }
        above.clear();
    }
    reasons
}

/// What the other profiles change.
fn differences(default: Option<&Profile>) -> String {
    let mut text = "\n## What each profile changes\n\n| profile | paper | keys |\n|---|---|---|\n".to_owned();
    for file in built_in() {
        let Some((default, profile)) = default.zip(Profile::named(file.name).ok()) else { continue };
        let pairs = default.parameters().into_iter().zip(profile.parameters());
        let changed: Vec<String> =
            pairs.filter(|(a, b)| a != b).map(|(_, (path, value))| format!("`{path} = {value}`")).collect();
        let changed = if changed.is_empty() { "as above".to_owned() } else { changed.join(", ") };
        text += &format!("| `{}` | {} | {changed} |\n", file.name, file.description());
    }
    text
}
