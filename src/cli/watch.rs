//! `--watch`: what is saved into a directory is converted, until somebody stops it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant, SystemTime};

use notify::event::{AccessKind, AccessMode};
use notify::{Event, EventKind, RecommendedWatcher, RecursiveMode, Watcher};

use super::report::{Exit, Report};
use super::session::Session;

/// How long a file must be left alone before it is looked at: programs write a file in several steps.
const SETTLED: Duration = Duration::from_millis(400);
/// How often it is looked whether files have settled, and whether the directory is still there.
const TICK: Duration = Duration::from_millis(100);
/// How names of pictures and pages end.
const ENDINGS: [&str; 16] = [
    "jpg", "jpeg", "png", "webp", "tif", "tiff", "bmp", "gif", "pnm", "pbm", "pgm", "ppm", "pam", "svg", "svgz", "pdf",
];

/// How names of files end that are not complete, or that editors leave.
const UNFINISHED: [&str; 6] = ["tmp", "part", "crdownload", "download", "swp", "lock"];

/// What comes from the system.
enum Told {
    Of(notify::Result<Event>),
    Stop,
}

/// Calls `convert` with the pictures that are saved into `dir`, until Ctrl-C is pressed or the program is told to end.
/// Before the first, it is called without pictures, to look whether the command line is right. At the end it counts as
/// failed if there is a picture that failed when it was last tried.
pub(super) fn run(dir: &Path, quiet: bool, convert: &dyn Fn(&[PathBuf], &Session) -> Exit) -> Exit {
    let report = Report::of_pictures(1, quiet);
    let name = dir.display().to_string();
    let session = Session::default();
    let whole = match directory(dir) {
        Ok(whole) => whole,
        Err(why) => {
            report.error(&name, why);
            return Exit::Usage;
        }
    };
    let exit = convert(&[], &session);
    if exit != Exit::Done {
        return exit;
    }
    let since = SystemTime::now();
    let (_watcher, receive) = match watch(&whole, &session) {
        Ok(watching) => watching,
        Err(Refused::Watching(error)) => {
            let why = format!("the system does not tell what is saved here ({error}); choose another directory");
            report.error(&name, &why);
            return Exit::Failed;
        }
        Err(Refused::Stopping(error)) => {
            report.usage(&format!("the program could not be stopped with Ctrl-C ({error}), so it does not begin"));
            return Exit::Failed;
        }
    };
    report.done(&format!("watching {name} for pictures and pages that are saved; stop with Ctrl-C"));
    let mut waiting = Waiting::default();
    let ended = loop {
        match receive.recv_timeout(TICK) {
            Ok(Told::Stop) | Err(RecvTimeoutError::Disconnected) => break Exit::Done,
            Ok(Told::Of(Ok(event))) if event.need_rescan() => waiting.add_all(&whole, since),
            Ok(Told::Of(Ok(event))) => waiting.add(&event),
            Ok(Told::Of(Err(error))) => report.error(&name, &format!("the system could not tell everything ({error})")),
            Err(RecvTimeoutError::Timeout) => {}
        }
        if session.stop.load(Ordering::Relaxed) {
            break Exit::Done;
        }
        if !whole.is_dir() {
            report.error(&name, "this directory is gone; make it, and begin again");
            break Exit::Failed;
        }
        let pictures = waiting.take_pictures(dir, &session, &report);
        if !pictures.is_empty() {
            convert(&pictures, &session);
        }
    };
    let (done, failed) = session.counts();
    let not =
        if failed > 0 { format!(", {} could not be converted", counted(failed, "picture")) } else { String::new() };
    report.done(&format!("stopped; {} written{not}", counted(done, "page")));
    if failed > 0 { Exit::Failed } else { ended }
}

/// The whole path of a directory, or what to do where it is none.
fn directory(dir: &Path) -> Result<PathBuf, &'static str> {
    match fs::canonicalize(dir) {
        Ok(whole) if whole.is_dir() => Ok(whole),
        Ok(_) => Err("this is no directory; name the one into which pictures are saved"),
        Err(_) => Err("there is no such directory; make it, or check the name"),
    }
}

/// Why the program cannot begin.
enum Refused {
    Watching(notify::Error),
    Stopping(ctrlc::Error),
}

/// Has the system tell what is saved into a directory for as long as the watcher lives, and when the session is to end.
fn watch(whole: &Path, session: &Session) -> Result<(RecommendedWatcher, Receiver<Told>), Refused> {
    let (send, receive) = mpsc::channel();
    let (stop, stopped) = (Arc::clone(&session.stop), send.clone());
    let watcher = notify::recommended_watcher(move |event| drop(send.send(Told::Of(event))));
    let mut watcher = watcher.map_err(Refused::Watching)?;
    watcher.watch(whole, RecursiveMode::NonRecursive).map_err(Refused::Watching)?;
    let on_stop = ctrlc::set_handler(move || {
        stop.store(true, Ordering::Relaxed);
        let _ = stopped.send(Told::Stop); // nobody listens: it has ended already
    });
    on_stop.map_err(Refused::Stopping)?;
    Ok((watcher, receive))
}

fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// Files that were changed, with the last time that was heard.
#[derive(Debug, Default)]
struct Waiting(BTreeMap<PathBuf, Instant>);

impl Waiting {
    /// The pictures that have settled and are not the program's own; what else has settled is told.
    fn take_pictures(&mut self, dir: &Path, session: &Session, report: &Report) -> Vec<PathBuf> {
        // messages name files as the user would
        let short = |path: PathBuf| path.file_name().map_or_else(|| path.clone(), |name| dir.join(name));
        let settled = self.take_settled().into_iter().map(short);
        let (pictures, others): (Vec<PathBuf>, Vec<PathBuf>) =
            settled.filter(|path| is_news(path, session)).partition(|path| is_picture(path));
        for other in others {
            let what = "passed over, as its name does not end like that of a picture or a page";
            report.note(&other.display().to_string(), what);
        }
        pictures
    }

    fn add(&mut self, event: &Event) {
        let changes = match event.kind {
            EventKind::Access(kind) => kind == AccessKind::Close(AccessMode::Write),
            EventKind::Remove(_) => false,
            _ => true,
        };
        if changes {
            let now = Instant::now();
            self.0.extend(event.paths.iter().filter(|path| is_finished(path)).map(|path| (path.clone(), now)));
        }
    }

    /// Everything that was changed since then: for when more happened at once than the system can tell.
    fn add_all(&mut self, dir: &Path, since: SystemTime) {
        let now = Instant::now();
        for entry in fs::read_dir(dir).into_iter().flatten().flatten() {
            let is_later = entry.metadata().and_then(|found| found.modified()).is_ok_and(|modified| modified >= since);
            if is_later && is_finished(&entry.path()) {
                self.0.insert(entry.path(), now);
            }
        }
    }

    /// Those that have been left alone for a while.
    fn take_settled(&mut self) -> Vec<PathBuf> {
        let settled: Vec<PathBuf> =
            self.0.iter().filter(|(_, last)| last.elapsed() >= SETTLED).map(|(path, _)| path.clone()).collect();
        self.0.retain(|path, _| !settled.contains(path));
        settled
    }
}

/// Whether a name is that of a picture or a page.
fn is_picture(path: &Path) -> bool {
    ending(path).is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
}

/// Whether somebody gave a file its name: hidden files and the like are what programs write before they rename.
fn is_finished(path: &Path) -> bool {
    let name = path.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
    let is_left = name.is_empty() || name.starts_with(['.', '~']) || name.ends_with('~');
    !is_left && ending(path).is_none_or(|ending| !UNFINISHED.contains(&ending.as_str()))
}

fn ending(path: &Path) -> Option<String> {
    path.extension().map(|ending| ending.to_string_lossy().to_lowercase())
}

/// Whether there is something to do: the file is still there, and neither known nor made by this run.
fn is_news(path: &Path, session: &Session) -> bool {
    path.is_file() && session.is_news(path).unwrap_or(true)
}

#[cfg(test)]
mod tests;
