//! `tactograph profiles`: which there are, and what is in them.

use tactograph::{BuiltIn, Profile};

use super::output;
use super::report::{Exit, Report};
use super::settings;

/// Lists the built-in profiles on standard output, one a line.
pub(super) fn list(report: &Report) -> Exit {
    print(&listing(Profile::built_in()), report)
}

fn listing(profiles: &[BuiltIn]) -> String {
    let width = profiles.iter().map(|profile| profile.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for (index, profile) in profiles.iter().enumerate() {
        let default = if index == 0 { " (default)" } else { "" };
        text += &format!("{:width$}  {}{default}\n", profile.name, profile.description());
    }
    text
}

/// How the page of all keys begins, before what the library says of them.
const HEAD: &str = "\
# Every key of a profile

A profile is a paper with all the numbers that a page for it needs. `tactograph profiles` lists those that come with the
program, and `tactograph profiles show NAME` prints one. One value can be changed on the command line, such as
`--set lines.width_max=1.2`. For [a profile of your own](own-profile.md), write a TOML file with what differs, and give
its name to `--profile`:

```toml
inherits = \"swell-a4\"
description = \"Thin lines\"

[lines]
width_max = 1.2
```

";

/// Where to read on, and who made the page, as its last lines.
const FOOT: &str = "\
[README](../README.md) · [A profile of your own](own-profile.md) · [Embossers and pin displays](embossers.md)

This page is what `tactograph profiles keys` prints. It is made from `src/profile/keys.rs` and `profiles/swell-a4.toml`.
";

/// Prints what there is to know of every key on standard output, as Markdown.
pub(super) fn keys(report: &Report) -> Exit {
    print(&format!("{HEAD}{}\n{FOOT}", Profile::manual()), report)
}

/// Prints a profile on standard output: a built-in one as it was written, with its comments and the range of every key;
/// a file with all that it inherits.
pub(super) fn show(name: &str, report: &Report) -> Exit {
    if let Some(profile) = Profile::built_in().iter().find(|profile| profile.name == name) {
        return print(&with_ranges(profile.text), report);
    }
    match settings::load(name) {
        Ok(profile) => print(&profile.to_toml_in_full(), report),
        Err(faults) => {
            faults.iter().for_each(|fault| report.error(&fault.place, &fault.what));
            Exit::Usage
        }
    }
}

/// Adds to each line `key = value` a comment with what the key takes.
fn with_ranges(text: &str) -> String {
    let (mut section, mut out) = ("", String::new());
    for line in text.lines() {
        out += line;
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            section = name;
        } else if let Some((name, _)) = line.split_once(" = ") {
            let path = format!("{section}.{name}");
            if let Some(key) = Profile::keys().iter().find(|key| key.path == path) {
                out += &format!(" # {}", key.range());
            }
        }
        out.push('\n');
    }
    out
}

fn print(text: &str, report: &Report) -> Exit {
    match output::to_stdout(text.as_bytes(), "text") {
        Ok(()) => Exit::Done,
        Err(error) => {
            report.error("standard output", &format!("{error:#}"));
            Exit::Failed
        }
    }
}

#[cfg(test)]
mod tests;
