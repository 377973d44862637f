//! How many names `lib.rs` shows to those who use the library.

use crate::scan::{Token, exports, scan};
use crate::sources;

/// How many names users see, by module of `lib.rs`.
const PUBLIC_NAMES: &[(&str, usize)] = &[("lib", 64), ("marks", 15), ("medium", 7), ("felt", 5)];

/// Every name of the face is a promise to those who use it: one more is a decision, which is written here.
#[test]
fn public_names_are_as_many_as_were_decided() {
    let found = public_names(&scan(&sources()["src/lib.rs"]));
    let found: Vec<(&str, usize)> = found.iter().map(|(module, count)| (module.as_str(), *count)).collect();
    assert_eq!(found, PUBLIC_NAMES);
}

/// How many names `lib.rs` exports, by module; what is not documented is no part of the face.
fn public_names(lib: &[Token]) -> Vec<(String, usize)> {
    let text = |at: usize| lib.get(at).map_or("", |token: &Token| token.text.as_str());
    let mut counts = vec![("lib".to_owned(), exports(lib).len())];
    for at in (0..lib.len()).filter(|&at| text(at) == "mod" && text(at + 2) == "{") {
        if text(at + 1) == "internals" {
            break; // the last, with modules of its own
        }
        let end = (at..lib.len()).find(|&end| text(end) == "}" && text(end - 1) == ";").unwrap_or(lib.len());
        counts.push((text(at + 1).to_owned(), exports(&lib[at + 3..end]).len()));
    }
    counts
}

#[test]
fn public_names_are_counted_by_module() {
    let lib = "mod a; use a::Q; pub use a::{B, C as D}; pub use lyon::euclid;
        pub mod marks { pub use crate::a::{E, F}; pub use crate::b::G; } pub mod felt { pub use crate::a::H; }
        #[doc(hidden)] pub mod internals { pub mod a { pub use crate::a::*; } }";
    let expected = [("lib", 3), ("marks", 3), ("felt", 1)].map(|(module, count)| (module.to_owned(), count));
    assert_eq!(public_names(&scan(lib)), expected);
}
