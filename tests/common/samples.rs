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

/// Their names, sorted.
pub(crate) fn names() -> Vec<String> {
    let name = |path: &PathBuf| path.file_name().expect("a sample has a name").to_string_lossy().into_owned();
    samples().iter().map(name).collect()
}

/// A sample as a file's bytes.
pub(crate) fn read(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(name);
    std::fs::read(path).expect("the sample is there")
}
