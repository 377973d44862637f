//! Other people's programs: run with input, until they end or take too long.

use std::ffi::OsStr;
use std::io::{ErrorKind, Read, Write};
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// A program, and what to do without it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Program {
    /// As it is called.
    pub(super) name: &'static str,
    /// What to do where it is not there.
    pub(super) remedy: &'static str,
}

/// What a program wrote.
#[derive(Debug)]
pub(super) struct Written {
    /// On standard output.
    pub(super) out: Vec<u8>,
    /// On standard error.
    pub(super) told: String,
}

/// Most that is taken from a program, bytes: some hundred times what any of them has to say.
const MOST_BYTES: u64 = 16 << 20;
/// How often it is asked whether it has ended.
const STEP: Duration = Duration::from_millis(5);
/// How long what it wrote may take to arrive when it has ended: something that it has started may hold on to it.
const PATIENCE: Duration = Duration::from_secs(2);

impl Program {
    /// Runs the program and gives what it wrote.
    ///
    /// A program that does not read all of its input is no fault: it has often ended over a fault of its own, and that
    /// is what has to be told.
    ///
    /// # Errors
    /// In one line: it is not there or cannot be run, takes longer than `limit`, or ends with another status than 0;
    /// then with what it says.
    pub(super) fn run<A: AsRef<OsStr>>(self, args: &[A], input: &[u8], limit: Duration) -> Result<Written, String> {
        let Self { name, remedy } = self;
        let mut command = Command::new(name);
        command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut run = command.spawn().map_err(|error| match error.kind() {
            ErrorKind::NotFound => format!("there is no program {name}; {remedy}"),
            _ => format!("{name} cannot be run: {error}"),
        })?;
        if let Some(mut pipe) = run.stdin.take() {
            let input = input.to_vec();
            thread::spawn(move || pipe.write_all(&input));
        }
        let (out, told) = (run.stdout.take().map(read), run.stderr.take().map(read));
        let started = Instant::now();
        let status = loop {
            match run.try_wait() {
                Ok(Some(status)) => break status,
                Ok(None) if started.elapsed() < limit => thread::sleep(STEP),
                Ok(None) => {
                    // it may have ended just now
                    let _ = run.kill();
                    let _ = run.wait();
                    return Err(format!("{name} has not ended after {} s", limit.as_secs()));
                }
                Err(error) => return Err(format!("{name} fails: {error}")),
            }
        };
        let all = |from: Option<Receiver<Vec<u8>>>| from.and_then(|from| from.recv_timeout(PATIENCE).ok());
        let told = String::from_utf8_lossy(&all(told).unwrap_or_default()).into_owned();
        let out = all(out).ok_or_else(|| format!("{name} does not close its output"))?;
        if status.success() { Ok(Written { out, told }) } else { Err(fault(name, status, &told)) }
    }
}

/// What a program says of its fault: its first line; without one, how it ended.
fn fault(name: &str, status: ExitStatus, told: &str) -> String {
    match told.lines().map(str::trim).find(|line| !line.is_empty()) {
        Some(line) => format!("{name} says: {line}"),
        None => format!("{name} fails without a word ({status})"),
    }
}

/// All that comes out of a pipe, in time.
fn read(mut pipe: impl Read + Send + 'static) -> Receiver<Vec<u8>> {
    let (give, take) = channel();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // what came before a fault counts
        let _ = pipe.by_ref().take(MOST_BYTES).read_to_end(&mut bytes);
        // nobody waits for it any more if that took too long
        let _ = give.send(bytes);
    });
    take
}

#[cfg(all(test, unix))]
mod tests;
