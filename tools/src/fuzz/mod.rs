//! What a fuzzer does with bytes: one target for each kind of input. `tools/fuzz` runs them under libFuzzer, and the
//! tests replay the inputs that were kept (`tests/corpus`).
//!
//! A target panics where a promise is broken. What is refused with a reason is an answer. Decoders that panic are
//! caught by the library and told as faults of the file, so they break no promise; [`listen`] tells of them.

mod pages;
mod pictures;
mod plans;

use std::collections::BTreeSet;
use std::sync::{LazyLock, Mutex, PoisonError};

use tactograph::Error;

/// What is done with bytes.
pub type Target = fn(&[u8]);

/// All targets, by name.
pub const TARGETS: [(&str, Target); 18] = [
    ("png", pictures::png),
    ("jpeg", pictures::jpeg),
    ("webp", pictures::webp),
    ("tiff", pictures::tiff),
    ("bmp", pictures::bmp),
    ("gif", pictures::gif),
    ("pnm", pictures::pnm),
    ("svg", pictures::svg),
    ("pdf", pictures::pdf),
    ("convert", plans::convert),
    ("lines", pages::lines),
    ("page", pages::page),
    ("check", pages::check),
    ("profile", plans::profile),
    ("set", plans::set),
    ("labels", pages::labels),
    ("dots", pages::dots),
    ("words", pages::words),
];

/// The target of a name.
pub fn target(name: &str) -> Option<Target> {
    TARGETS.iter().find(|(known, _)| *known == name).map(|(_, target)| *target)
}

/// Where anything has panicked. Nothing before [`listen`] was called.
static HEARD: LazyLock<Mutex<BTreeSet<String>>> = LazyLock::new(Mutex::default);

/// From now on panics are kept, and each new place is told once on standard error. Panics that nobody catches still end
/// a fuzzer's run.
pub fn listen() {
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map_or_else(String::new, |place| format!("{}:{}", place.file(), place.line()));
        if HEARD.lock().unwrap_or_else(PoisonError::into_inner).insert(place) {
            let text = panic.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
            let _ = std::io::Write::write_all(&mut std::io::stderr(), format!("PANIC {text}\n").as_bytes());
        }
    }));
}

/// Longest line that somebody reads, letters; a list of all names that there are has some 600.
pub const LONGEST_LINE: usize = 1000;

/// A fault is said in words on one line. Those of a profile are told one by one.
fn is_clear(fault: &Error) {
    let texts = match fault {
        Error::Profile(faults) => faults.iter().map(|fault| format!("{}: {}", fault.place, fault.what)).collect(),
        other => vec![other.to_string()],
    };
    for text in texts {
        assert!(!text.trim().is_empty(), "a fault without words: {fault:?}");
        assert!(text.chars().count() <= LONGEST_LINE, "a line too long to be read: {text}");
        assert!(!text.chars().any(char::is_control), "a fault with control characters: {text:?}");
    }
}
