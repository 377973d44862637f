//! The names that `lib.rs` shows to those who use the library.

use std::collections::BTreeSet;

use crate::scan::{Token, exports, scan};
use crate::{complain, root, sources};

/// How many names users see, by module of `lib.rs`.
const PUBLIC_NAMES: &[(&str, usize)] = &[("lib", 67), ("marks", 15), ("medium", 7), ("felt", 5)];

/// Every name of the face is a promise to those who use it: one more is a decision, which is written here.
#[test]
fn public_names_are_as_many_as_were_decided() {
    let found = public_names(&scan(&sources()["src/lib.rs"]));
    let found: Vec<(&str, usize)> = found.iter().map(|(module, names)| (module.as_str(), names.len())).collect();
    assert_eq!(found, PUBLIC_NAMES);
}

/// `tests/wrapping.rs` tries every public type as a part of a class of another language; `Picture` borrows its pixels.
#[test]
fn public_types_are_all_tried_as_parts_of_classes() {
    let wrapping = std::fs::read_to_string(root().join("tests/wrapping.rs")).expect("a test");
    let lists = wrapping.split("can_be_wrapped!(").skip(1).filter_map(|rest| rest.split(')').next());
    let tried: BTreeSet<&str> = lists.flat_map(|list| list.split(',')).map(str::trim).collect();
    let types = public_names(&scan(&sources()["src/lib.rs"])).into_iter().flat_map(|(module, names)| {
        let types = names.into_iter().filter(|name| name.starts_with(char::is_uppercase) && name != "Picture");
        types.map(|name| if module == "lib" { name } else { format!("{module}::{name}") }).collect::<Vec<_>>()
    });
    let missing = types.filter(|name| !tried.contains(name.as_str()));
    complain(missing.map(|name| format!("tests/wrapping.rs: {name} is not tried")).collect());
}

/// The names that `lib.rs` exports, by module; what is not documented is no part of the face.
fn public_names(lib: &[Token]) -> Vec<(String, BTreeSet<String>)> {
    let text = |at: usize| lib.get(at).map_or("", |token: &Token| token.text.as_str());
    let names = |part: &[Token]| exports(part).into_keys().collect();
    let mut found = vec![("lib".to_owned(), names(lib))];
    for at in (0..lib.len()).filter(|&at| text(at) == "mod" && text(at + 2) == "{") {
        if text(at + 1) == "internals" {
            break; // the last, with modules of its own
        }
        let end = (at..lib.len()).find(|&end| text(end) == "}" && text(end - 1) == ";").unwrap_or(lib.len());
        found.push((text(at + 1).to_owned(), names(&lib[at + 3..end])));
    }
    found
}

#[test]
fn public_names_are_told_apart_by_module() {
    let lib = "mod a; use a::Q; pub use a::{B, C as D}; pub use lyon::euclid;
        pub mod marks { pub use crate::a::{E, F}; pub use crate::b::G; } pub mod felt { pub use crate::a::H; }
        #[doc(hidden)] pub mod internals { pub mod a { pub use crate::a::*; } }";
    let expected = [("lib", vec!["B", "D", "euclid"]), ("marks", vec!["E", "F", "G"]), ("felt", vec!["H"])];
    let set = |names: Vec<&str>| names.into_iter().map(String::from).collect();
    assert_eq!(public_names(&scan(lib)), expected.map(|(module, names)| (module.to_owned(), set(names))));
}
