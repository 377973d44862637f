//! Ctrl-C, and being told to end: no half file stays, and it is said how far the run came.

use std::process;
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;
use std::time::{Duration, Instant};

use super::report::{Exit, Report};
use super::temporary;

/// How long a run that is stopped waits for files that are taking their names: they do so in less than a millisecond
/// each, but a disk can be slow, and standard output can be a pipe that nobody reads.
const PATIENCE: Duration = Duration::from_secs(2);

/// What a run of several pictures has done. Locked while files take their names, so that those which belong together do
/// so together.
static DONE: Mutex<Option<Progress>> = Mutex::new(None);

#[derive(Debug, Clone, Copy)]
struct Progress {
    done: usize,
    of: usize,
    /// What has been done to a picture: "converted".
    how: &'static str,
}

/// From now on Ctrl-C ends the program in good order. Where the system has no way to do so, it ends as any program
/// does.
pub(super) fn listen() {
    // refused: then the system's own way stays
    let _ = ctrlc::set_handler(stop);
}

/// The run begins: so many pictures are to be `how`.
pub(super) fn begin(of: usize, how: &'static str) {
    *progress() = Some(Progress { done: 0, of, how });
}

/// Gives files their names, with nothing in between; then they count as one picture.
pub(super) fn one_more<E>(name: impl FnOnce() -> Result<(), E>) -> Result<(), E> {
    let mut progress = progress();
    name()?;
    progress.iter_mut().for_each(|progress| progress.done += 1);
    Ok(())
}

fn progress() -> MutexGuard<'static, Option<Progress>> {
    DONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs on a thread of its own.
fn stop() {
    let asked = Instant::now();
    let progress = loop {
        match DONE.try_lock() {
            Ok(progress) => break Some(progress),
            Err(TryLockError::Poisoned(poisoned)) => break Some(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) if asked.elapsed() < PATIENCE => thread::sleep(Duration::from_millis(5)),
            Err(TryLockError::WouldBlock) => break None,
        }
    };
    let how_far = match progress.as_deref().copied().flatten() {
        Some(Progress { done, of, how }) if of > 1 => format!("stopped; {done} of {of} pictures {how}"),
        Some(Progress { done: 0, .. }) => "stopped; nothing was written".into(),
        _ => "stopped".into(),
    };
    // both stay locked until the program has ended: no file takes its name and none is begun
    let _none_is_begun = temporary::remove_all();
    Report::plain().usage(&how_far);
    process::exit(Exit::Stopped as i32);
}
