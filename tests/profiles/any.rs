//! Any text at all: it is answered, without a panic.

use proptest::prelude::*;
use tactograph::Error;
use tactograph::internals::profile::{Fault, Profile, built_in};

use crate::profiles::named;

/// Scraps of profiles, to come nearer to real mistakes than random letters do.
const SCRAPS: &[&str] = &[
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ".",
    ",",
    "\n",
    "\r\n",
    "\"",
    "\"\"\"",
    "'''",
    "#",
    " ",
    "page",
    "lines",
    "width_max",
    "on",
    "frame",
    "inherits",
    "swell-a3",
    "description",
    "true",
    "-1",
    "1e99",
    "0x",
    "1_0",
    "nan",
    "2004-04-08",
    "\\",
    "\u{feff}",
    "\u{e9}",
];

proptest! {
    /// Whatever the text: no panic, each fault on one line and with its place.
    #[test]
    fn any_text_is_answered(text in "\\PC*|(?s).{0,200}") {
        answered(&text);
    }

    #[test]
    fn any_scraps_are_answered(scraps in prop::collection::vec(prop::sample::select(SCRAPS), 0..60)) {
        answered(&scraps.concat());
    }

    #[test]
    fn any_damage_to_a_profile_is_answered(at in any::<prop::sample::Index>(), scrap in prop::sample::select(SCRAPS)) {
        let mut text = built_in()[0].text.to_owned();
        text.insert_str(at.index(text.len()), scrap);
        answered(&text);
    }

    #[test]
    fn any_set_is_answered(key in "[a-z_.]{0,20}|\\PC{0,10}", value in "[-0-9.e]{0,8}|\\PC{0,10}") {
        let mut profile = named("swell-a4");
        if let Err(fault) = profile.set(&key, &value) {
            prop_assert!(!fault.to_string().contains(char::is_control), "{fault}");
        }
    }
}

fn answered(text: &str) {
    match Profile::from_toml(text, "my.toml") {
        Ok(profile) => assert_eq!(profile.check(), Ok(())),
        Err(Error::Profile(faults)) => {
            assert!(!faults.is_empty());
            for Fault { place, what, .. } in faults {
                assert!(
                    place.starts_with("my.toml") && !what.is_empty() && !what.contains(char::is_control),
                    "{place} {what}"
                );
            }
        }
        Err(other) => panic!("no faults of a profile: {other}"),
    }
}
