//! Ctrl-C, and being told to end: no half file stays, and it is said how far the run came.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

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
    /// Whether something may have gone to standard output, from where nothing comes back.
    has_left: bool,
}

/// From now on Ctrl-C ends the program in good order. Where the system has no way to do so, it ends as any program
/// does.
pub(super) fn listen() {
    // refused: then the system's own way stays
    let _ = ctrlc::set_handler(stop);
}

/// The run begins: so many pictures are to be `how`.
pub(super) fn begin(of: usize, how: &'static str) {
    *progress() = Some(Progress { done: 0, of, how, has_left: false });
}

/// Gives files their names, with nothing in between; then they count as one picture.
pub(super) fn one_more<E>(name: impl FnOnce() -> Result<(), E>) -> Result<(), E> {
    let mut progress = progress();
    name()?;
    progress.iter_mut().for_each(|progress| progress.done += 1);
    Ok(())
}

/// Something is about to go to standard output.
pub(super) fn leaves() {
    progress().iter_mut().for_each(|progress| progress.has_left = true);
}

fn progress() -> MutexGuard<'static, Option<Progress>> {
    DONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs on a thread of its own, beside those at work.
fn stop() {
    let progress = temporary::locked_within(&DONE, PATIENCE);
    let how_far = match progress.as_deref().copied().flatten() {
        Some(Progress { done, of, how, .. }) if of > 1 => format!("stopped; {done} of {of} pictures {how}"),
        Some(Progress { done: 0, has_left: false, .. }) => "stopped; nothing was written".into(),
        _ => "stopped".into(),
    };
    // what could be locked stays so until the program has ended: no file takes its name and none is begun
    let _none_is_begun = temporary::remove_all(PATIENCE);
    Report::last_word(&how_far, Exit::Stopped)
}
