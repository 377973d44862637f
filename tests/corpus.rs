//! Inputs that fuzzing kept because each reaches something that no other reaches, and those that once broke a promise,
//! given to their targets again (`tools/fuzz/README.md`). The latter have names that say what they are.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use tactograph_tools::fuzz::TARGETS;

#[test]
fn kept_inputs_break_no_promise() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    let mut faults = Vec::new();
    for (name, target) in TARGETS {
        let mut paths: Vec<_> = std::fs::read_dir(corpus.join(name))
            .unwrap_or_else(|error| panic!("tests/corpus/{name}: {error}"))
            .map(|entry| entry.expect("the folder can be read").path())
            .collect();
        paths.sort();
        assert!(!paths.is_empty(), "tests/corpus/{name} is empty");
        for path in paths {
            let bytes = std::fs::read(&path).expect("a file");
            if catch_unwind(AssertUnwindSafe(|| target(&bytes))).is_err() {
                faults.push(path.display().to_string());
            }
        }
    }
    assert!(faults.is_empty(), "these break a promise; what each says stands above: {faults:#?}");
}

#[test]
fn every_folder_of_inputs_has_a_target() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    for entry in std::fs::read_dir(corpus).expect("the folder") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        assert!(TARGETS.iter().any(|(known, _)| *known == name), "tests/corpus/{name} is nobody's");
    }
}
