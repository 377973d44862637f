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
mod tests {
    use super::*;

    const SHELL: Program = Program { name: "sh", remedy: "install a shell" };
    const LONG: Duration = Duration::from_secs(60);

    fn shell(script: &str, input: &[u8], limit: Duration) -> Result<Written, String> {
        SHELL.run(&["-c", script], input, limit)
    }

    #[test]
    fn input_output_and_words_pass() {
        let written = shell("cat; echo so >&2", b"abc", LONG).expect("it runs");
        assert_eq!((&written.out[..], written.told.as_str()), (&b"abc"[..], "so\n"));
    }

    #[test]
    fn more_than_pipes_hold_passes_both_ways() {
        let input = vec![b'x'; 1 << 20];
        assert_eq!(shell("cat | tee /dev/stderr", &input, LONG).expect("it runs").out, input);
    }

    #[test]
    fn a_program_that_ends_without_reading_tells_why() {
        let input = vec![b'x'; 1 << 20];
        let refused = shell("exec <&-; echo >&2; echo no table >&2; exit 3", &input, LONG).expect_err("a fault");
        assert_eq!(refused, "sh says: no table");
        let refused = shell("exit 3", &[], LONG).expect_err("a fault");
        assert_eq!(refused, "sh fails without a word (exit status: 3)");
    }

    #[test]
    fn what_takes_too_long_is_ended() {
        let refused = shell("sleep 60", &[], Duration::from_millis(50)).expect_err("too long");
        assert_eq!(refused, "sh has not ended after 0 s");
        let refused = shell("sleep 60 &", &[], LONG).expect_err("its child holds the pipe");
        assert_eq!(refused, "sh does not close its output");
    }

    #[test]
    fn what_is_not_there_is_told_with_what_to_install() {
        let none = Program { name: "no-such-program", remedy: "install it" };
        let refused = none.run::<&str>(&[], &[], LONG).expect_err("no program");
        assert_eq!(refused, "there is no program no-such-program; install it");
    }
}
