//! What the program says, on standard error: one line a message, in plain words, nothing told by colour or shape alone.

use std::io::{IsTerminal, Write};

use indicatif::{ProgressBar, ProgressStyle};

/// How the program ends; the numbers are promised in `--help`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Exit {
    /// Everything asked for is done.
    Done = 0,
    /// A picture could not be worked on, or a file not written.
    Failed = 1,
    /// The command line or the profile is wrong; nothing was done.
    Usage = 2,
    /// Ctrl-C, or the system told it to end: 128 and the number of that signal (SIGINT), as shells count.
    Stopped = 130,
}

/// The one place that writes to standard error.
///
/// On a terminal, several pictures have a progress bar below the messages; anywhere else (a file, a pipe, a terminal
/// that cannot move its cursor) each message is a line that counts for itself, such as "3 of 12: cat.jpg: wrote
/// cat.svg".
pub(super) struct Report {
    quiet: bool,
    bar: Option<ProgressBar>,
}

impl Report {
    /// For messages without progress.
    pub(super) fn plain() -> Self {
        Self { quiet: false, bar: None }
    }

    /// Says how the program ended and ends it, at once: threads that are at work say nothing after it.
    pub(super) fn last_word(what: &str, exit: Exit) -> ! {
        let mut messages = std::io::stderr().lock();
        let _ = writeln!(messages, "tactograph: {what}"); // nobody reads it: the exit code says it
        std::process::exit(exit as i32)
    }

    /// For the conversion of `pictures` pictures.
    pub(super) fn of_pictures(pictures: usize, quiet: bool) -> Self {
        let can_redraw = std::io::stderr().is_terminal() && std::env::var_os("TERM").is_none_or(|term| term != "dumb");
        let bar = (pictures > 1 && !quiet && can_redraw).then(|| {
            let bar = ProgressBar::new(pictures as u64);
            // The count in words comes first, for those who hear it; the bar has no colour and is plain ASCII.
            if let Ok(style) = ProgressStyle::with_template("{pos} of {len} pictures done [{bar:40}]") {
                bar.set_style(style.progress_chars("#>."));
            }
            bar.tick();
            bar
        });
        Self { quiet, bar }
    }

    /// One more picture is done, well or not.
    pub(super) fn advance(&self) {
        if let Some(bar) = &self.bar {
            bar.inc(1);
        }
    }

    /// No more pictures: takes the bar away.
    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    /// Something is wrong with `place` (a file, an option).
    pub(super) fn error(&self, place: &str, what: &str) {
        self.line(&format!("tactograph: {place}: {what}"));
    }

    /// The command line is wrong, or an error concerns no file.
    pub(super) fn usage(&self, what: &str) {
        self.line(&format!("tactograph: {what}"));
    }

    /// Something worth knowing about a page that was made all the same.
    pub(super) fn note(&self, file: &str, what: &str) {
        if !self.quiet {
            self.line(&format!("tactograph: {file}: note: {what}"));
        }
    }

    /// A step is done.
    pub(super) fn done(&self, what: &str) {
        if !self.quiet {
            self.line(what);
        }
    }

    /// Lines that were asked for by an option of their own, so that `--quiet` does not take them.
    pub(super) fn asked_for(&self, lines: &[String]) {
        for line in lines {
            self.line(line);
        }
    }

    fn line(&self, text: &str) {
        // Whoever closed standard error does not want to hear; that is no reason to stop working.
        let write = || drop(writeln!(std::io::stderr().lock(), "{}", one_line(text)));
        match &self.bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        }
    }
}

/// A message is one line, whatever a file is called and whatever a decoder says; control characters could also change
/// the terminal.
fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_one_line_without_control_characters() {
        assert_eq!(one_line("a\nb\u{1b}[31mc\u{9b}d"), "a b [31mc d");
        assert_eq!(one_line("naïve café 写真"), "naïve café 写真");
    }
}
