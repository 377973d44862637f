//! `tactograph profiles`: which there are, and what is in them.

use tactograph::profile::{BuiltIn, Profile, built_in};

use super::Exit;
use super::output;
use super::report::Report;

/// Lists the built-in profiles on standard output, one a line.
pub(super) fn list(report: &Report) -> Exit {
    print(&listing(built_in()), report)
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

/// Prints a built-in profile on standard output as it was written, comments and all.
pub(super) fn show(name: &str, report: &Report) -> Exit {
    match (built_in().iter().find(|profile| profile.name == name), Profile::named(name)) {
        (Some(profile), _) => print(profile.text, report),
        (None, named) => {
            named.err().iter().flatten().for_each(|fault| report.error(&fault.place, &fault.what));
            Exit::Usage
        }
    }
}

fn print(text: &str, report: &Report) -> Exit {
    match output::to_stdout(text.as_bytes()) {
        Ok(()) => Exit::Done,
        Err(error) => {
            report.error("standard output", &format!("{error:#}"));
            Exit::Failed
        }
    }
}
