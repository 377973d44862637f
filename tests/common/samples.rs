//! The sample pictures as they lie in `samples/`.

use std::path::{Path, PathBuf};

/// The sample pictures, sorted by name.
pub(crate) fn samples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples");
    let mut pictures: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("there is a folder of samples")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|ending| ending != "md"))
        .collect();
    pictures.sort();
    pictures
}
