//! The command line: files, clocks, threads and words. Everything that draws is in the library.

mod args;
mod batch;
mod calibrate;
mod check;
mod convert;
mod describe;
mod dots;
mod external;
mod feel;
mod input;
mod interrupt;
mod louis;
mod output;
mod panics;
mod places;
mod product;
mod profiles;
mod record;
mod remedies;
mod render;
mod report;
mod session;
mod settings;
mod sheets;
mod side_by_side;
mod temporary;
mod tesseract;
mod timings;
mod titles;
mod trace;
mod watch;

use std::process::ExitCode;

use args::{Command, Parsed, ProfilesCommand};
use report::Report;

/// Runs the program with the arguments it was started with.
pub(crate) fn run() -> ExitCode {
    panics::keep();
    match std::panic::catch_unwind(command) {
        Ok(exit) => exit,
        Err(_) => {
            Report::plain().usage(&panics::line());
            ExitCode::from(PANICKED)
        }
    }
}

/// How Rust ends a program that panics.
const PANICKED: u8 = 101;

/// Runs the command that the arguments name.
fn command() -> ExitCode {
    let command = match args::parse(std::env::args_os()) {
        Parsed::Command(command) => *command,
        Parsed::Shown(exit) => return ExitCode::from(exit as u8),
    };
    // a run that watches a directory has an ending of its own
    if !matches!(&command, Command::Convert(convert) if convert.running.watch.is_some()) {
        interrupt::listen();
    }
    let exit = match command {
        Command::Convert(convert) => convert::run(&convert),
        Command::Render(render) => render::run(&render),
        Command::Trace(trace) => trace::run(&trace),
        Command::Calibrate(calibrate) => calibrate::run(&calibrate),
        Command::Check(check) => check::run(&check),
        Command::Describe(describe) => describe::run(&describe),
        Command::Feel(feel) => feel::run(&feel),
        Command::Profiles(profiles) => match profiles.command {
            None => profiles::list(&Report::plain()),
            Some(ProfilesCommand::Keys) => profiles::keys(&Report::plain()),
            Some(ProfilesCommand::Show { name }) => profiles::show(&name, &Report::plain()),
        },
    };
    ExitCode::from(exit as u8)
}
