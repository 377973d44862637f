//! The command line: files, clocks, threads and words. Everything that draws is in the library.

mod args;
mod batch;
mod convert;
mod feel;
mod fonts;
mod input;
mod output;
mod places;
mod product;
mod profiles;
mod report;
mod settings;
mod side_by_side;
mod timings;
mod trace;

use std::process::ExitCode;

use args::{Command, Parsed, ProfilesCommand};
use report::Report;

/// How the program ends; the numbers are promised in `--help`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Exit {
    /// Everything asked for is done.
    Done = 0,
    /// A picture could not be worked on, or a file not written.
    Failed = 1,
    /// The command line or the profile is wrong; nothing was done.
    Usage = 2,
}

/// Runs the program with the arguments it was started with.
pub(crate) fn run() -> ExitCode {
    let exit = match args::parse(std::env::args_os()) {
        Parsed::Command(Command::Convert(convert)) => convert::run(&convert),
        Parsed::Command(Command::Trace(trace)) => trace::run(&trace),
        Parsed::Command(Command::Feel(feel)) => feel::run(&feel),
        Parsed::Command(Command::Profiles(profiles)) => match profiles.command {
            None => profiles::list(&Report::plain()),
            Some(ProfilesCommand::Show { name }) => profiles::show(&name, &Report::plain()),
        },
        Parsed::Shown(exit) => exit,
    };
    ExitCode::from(exit as u8)
}
