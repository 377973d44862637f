//! One program run once, with its time and memory.
//!
//! A fresh, small process starts the program and reports on it: the system keeps the memory of children only as the most
//! that any of them ever held, and counts to a child what its parent held at the start.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use crate::usage;

/// First argument of the process in between, with `1` for one core or `0`; the program and its arguments follow.
pub(crate) const MODE: &str = "--measured";

/// A program with its arguments.
#[derive(Debug, Clone)]
pub(crate) struct Job {
    pub(crate) name: String,
    pub(crate) command: Vec<OsString>,
    /// What it writes; removed before it starts, so that each run does the same.
    pub(crate) writes: Option<PathBuf>,
    /// Kept to one core, also where the others of its rounds are not.
    pub(crate) one_core: bool,
}

impl Job {
    pub(crate) fn new<S: Into<OsString>>(name: &str, command: impl IntoIterator<Item = S>) -> Self {
        let command = command.into_iter().map(Into::into).collect();
        Self { name: name.into(), command, writes: None, one_core: false }
    }

    pub(crate) fn writes(mut self, file: impl Into<PathBuf>) -> Self {
        self.writes = Some(file.into());
        self
    }

    pub(crate) fn on_one_core(mut self) -> Self {
        self.one_core = true;
        self
    }
}

/// How one run went.
#[derive(Debug, Clone)]
pub(crate) struct Run {
    /// In which of its rounds; 0 is the one that warms up.
    pub(crate) round: usize,
    /// By the clock on the wall, ms.
    pub(crate) wall: f64,
    /// Working time of all cores, ms: other programs on the machine disturb it less.
    pub(crate) cpu: f64,
    /// Most memory held, MB (million bytes).
    pub(crate) peak: f64,
    /// What it wrote on standard error.
    pub(crate) said: String,
}

/// Runs a program through the process in between.
///
/// # Errors
/// The program is missing or fails.
pub(crate) fn run(job: &Job, one_core: bool) -> Result<Run, String> {
    if let Some(file) = &job.writes {
        match std::fs::remove_file(file) {
            Err(fault) if fault.kind() != std::io::ErrorKind::NotFound => {
                return Err(format!("{}: {fault}", file.display()));
            }
            _ => {}
        }
    }
    let this = std::env::current_exe().map_err(|fault| fault.to_string())?;
    let output = Command::new(this)
        .args([MODE, if one_core || job.one_core { "1" } else { "0" }])
        .args(&job.command)
        .stdin(Stdio::null())
        .output()
        .map_err(|fault| fault.to_string())?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let numbers: Vec<f64> =
        String::from_utf8_lossy(&output.stdout).split_whitespace().filter_map(|word| word.parse().ok()).collect();
    match numbers[..] {
        [wall, cpu, peak] if output.status.success() => {
            Ok(Run { round: 0, wall: wall / 1e3, cpu: cpu / 1e3, peak: peak * 1024.0 / 1e6, said })
        }
        _ => Err(said.lines().last().unwrap_or("it failed without a word").to_owned()),
    }
}

/// The process in between: runs the program, its output thrown away, and prints microseconds by the clock, microseconds of
/// work, and kB held at most.
pub(crate) fn report(mut arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let one_core = arguments.next().is_some_and(|word| word == "1");
    let measured = arguments.next().ok_or("no program was named".to_owned()).and_then(|program| {
        if one_core {
            usage::keep_to_one_core()?;
        }
        let mut command = Command::new(&program);
        command.args(arguments).stdout(Stdio::null());
        let start = Instant::now();
        let status = command.status().map_err(|fault| format!("{}: {fault}", program.display()))?;
        let wall = start.elapsed();
        let usage = usage::of_children()?;
        println!("{} {} {}", wall.as_micros(), usage.cpu.as_micros(), usage.peak_kb);
        Ok(status.success())
    });
    match measured {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}
