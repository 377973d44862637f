//! A run that goes on until it is stopped: what it knows of files, and how many pages it has written.

use std::collections::hash_map::DefaultHasher;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::hash::Hasher;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::places::identity;

/// What a run that goes on remembers.
#[derive(Debug, Default)]
pub(super) struct Session {
    /// Whether it shall stop.
    pub(super) stop: Arc<AtomicBool>,
    files: Mutex<BTreeMap<PathBuf, Known>>,
    done: AtomicUsize,
    failed: Mutex<BTreeSet<PathBuf>>,
}

/// A file that was looked at, or written.
#[derive(Debug, Clone)]
struct Known {
    content: u64,
    /// The picture that it is the page or the preview of.
    made_of: Option<PathBuf>,
}

impl Session {
    /// Takes note of what stands in a picture. Returns whether that is new: neither was it looked at before, nor did
    /// this run write it.
    ///
    /// # Errors
    /// If it cannot be read.
    pub(super) fn is_news(&self, picture: &Path) -> io::Result<bool> {
        let content = content_of(File::open(picture)?)?;
        let before = self.files().insert(identity(picture), Known { content, made_of: None });
        let is_news = before.as_ref().is_none_or(|known| known.content != content);
        if let Some(known) = before.filter(|_| !is_news) {
            self.files().insert(identity(picture), known);
        }
        Ok(is_news)
    }

    /// A file is as this run wrote it.
    pub(super) fn is_own(&self, path: &Path) -> bool {
        let known =
            self.files().get(&identity(path)).filter(|known| known.made_of.is_some()).map(|known| known.content);
        known.is_some_and(|known| File::open(path).and_then(content_of).is_ok_and(|content| content == known))
    }

    /// Takes note of a file that was written. Returns the picture that it was made of before, if that is another
    /// one.
    pub(super) fn writes(&self, path: &Path, bytes: &[u8], picture: &Path) -> Option<PathBuf> {
        let mut hasher = DefaultHasher::new();
        hasher.write(bytes);
        let known = Known { content: hasher.finish(), made_of: Some(picture.to_path_buf()) };
        let before = self.files().insert(identity(path), known)?;
        before.made_of.filter(|other| other != picture)
    }

    /// One more page is written.
    pub(super) fn count_page(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    /// A picture was worked on. One that failed is forgotten, so that it is tried again when it is saved again, also
    /// with the same bytes: what stood in its way may be gone.
    pub(super) fn settle(&self, picture: &Path, failed: bool) {
        let place = identity(picture);
        if failed {
            self.files().remove(&place);
            self.failed().insert(place);
        } else {
            self.failed().remove(&place);
        }
    }

    /// How many pages were written, and how many pictures have failed and not been mended since.
    pub(super) fn counts(&self) -> (usize, usize) {
        (self.done.load(Ordering::Relaxed), self.failed().len())
    }

    fn files(&self) -> MutexGuard<'_, BTreeMap<PathBuf, Known>> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn failed(&self) -> MutexGuard<'_, BTreeSet<PathBuf>> {
        self.failed.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A number that stands for all that can be read. Within one run it is the same for the same bytes.
fn content_of(mut from: impl Read) -> io::Result<u64> {
    let (mut hasher, mut part) = (DefaultHasher::new(), vec![0; 1 << 16]);
    loop {
        match from.read(&mut part) {
            Ok(0) => return Ok(hasher.finish()),
            Ok(count) => hasher.write(&part[..count]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

#[cfg(test)]
mod tests;
