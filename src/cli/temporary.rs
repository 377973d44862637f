//! Files that have not taken their names yet. Each is locked while its run lives, so that the next run can tell those
//! of runs that were killed, and removes them.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;
use std::time::{Duration, Instant};

use tempfile::NamedTempFile;

/// How their names begin and end; in between are random letters.
const NAME: (&str, &str) = (".tactograph-", ".tmp");
/// How often a file is made anew that another run has just removed.
const ATTEMPTS: usize = 10;

/// Those of this run.
static LIVING: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
/// The directories in which those of other runs were looked for.
static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A file that is removed unless it takes a name.
#[derive(Debug)]
pub(super) struct Temporary(Option<NamedTempFile>);

impl Temporary {
    /// An empty file in a directory. What runs that were killed have left there is removed.
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn new_in(dir: &Path) -> io::Result<Self> {
        if locked(&SWEPT).insert(dir.to_path_buf()) {
            sweep(dir);
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(NAME.0).suffix(NAME.1);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666)); // less what the user's umask takes
        let mut living = locked(&LIVING);
        for _ in 0..ATTEMPTS {
            let file = builder.tempfile_in(dir)?;
            // Where files cannot be locked, as on some network disks, no run removes those of others either.
            let _ = file.as_file().lock();
            // between the two lines before, a run that sweeps may have taken it for left over
            if fs::symlink_metadata(file.path()).is_ok() {
                living.insert(file.path().to_path_buf());
                return Ok(Self(Some(file)));
            }
        }
        Err(io::Error::other("temporary files vanish here"))
    }

    /// The open file.
    ///
    /// # Errors
    /// None but when the file has taken its name, which nobody asks then.
    pub(super) fn file(&mut self) -> io::Result<&mut File> {
        self.0.as_mut().map(NamedTempFile::as_file_mut).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// It takes its name, in place of the file that has it.
    ///
    /// # Errors
    /// Those of the system; then it is removed.
    pub(super) fn persist(mut self, path: &Path) -> io::Result<()> {
        match self.0.take() {
            Some(file) => {
                let own = file.path().to_path_buf();
                let done = file.persist(path).map(drop).map_err(|error| error.error);
                locked(&LIVING).remove(&own);
                done
            }
            None => Err(io::ErrorKind::NotFound.into()),
        }
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(file) = self.0.take() {
            let own = file.path().to_path_buf();
            drop(file);
            locked(&LIVING).remove(&own);
        }
    }
}

/// Removes all files of this run that have not taken their names. While what is given back lives, none is begun. Where
/// the system is still busy with one after so long, they stay for the next run.
pub(super) fn remove_all(patience: Duration) -> impl Sized {
    let living = locked_within(&LIVING, patience);
    for path in living.iter().flat_map(|living| living.iter()) {
        // gone already: it has just taken its name
        let _ = fs::remove_file(path);
    }
    living
}

/// A lock that is waited for no longer than this.
pub(super) fn locked_within<T>(lock: &Mutex<T>, patience: Duration) -> Option<MutexGuard<'_, T>> {
    let asked = Instant::now();
    loop {
        match lock.try_lock() {
            Ok(guard) => return Some(guard),
            Err(TryLockError::Poisoned(poisoned)) => return Some(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) if asked.elapsed() < patience => thread::sleep(Duration::from_millis(5)),
            Err(TryLockError::WouldBlock) => return None,
        }
    }
}

/// Removes what runs that were killed have left in a directory. What cannot be removed stays: it is in nobody's way.
fn sweep(dir: &Path) {
    for entry in fs::read_dir(dir).into_iter().flatten().flatten() {
        if !is_temporary(&entry.file_name()) {
            continue;
        }
        let Ok(file) = File::open(entry.path()) else { continue };
        // the file of a run that lives is locked; this one stays so until it is removed
        if file.try_lock().is_ok() {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_temporary(name: &OsStr) -> bool {
    name.to_str().is_some_and(|name| name.starts_with(NAME.0) && name.ends_with(NAME.1))
}

fn locked<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests;
