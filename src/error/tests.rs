//! Tests of `error`.

use std::collections::BTreeSet;

use super::*;
use crate::Note;

#[test]
fn ids_are_words_and_each_is_there_once() {
    for ids in [Error::ids(), Note::ids()] {
        let each: BTreeSet<&str> = ids.iter().copied().collect();
        assert_eq!(each.len(), ids.len());
        let is_word =
            |id: &&str| id.split('-').all(|part| !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase()));
        assert_eq!(ids.iter().find(|id| !is_word(id)), None);
    }
    assert!(Error::ids().contains(&Error::NoPages.id()) && Note::ids().contains(&Note::NoLines.id()));
}

#[test]
fn a_name_that_is_not_known_is_told_with_what_may_be_meant() {
    let refused = |name: &str| named(name, "colour", ["red", "green", "blue"], |one| one).expect_err("no such name");
    for (name, nearest, told) in [
        (
            "Gren",
            &["green"][..],
            r#"there is no colour called "Gren", did you mean green? Take one of red, green, blue"#,
        ),
        ("purple", &[], r#"there is no colour called "purple"; take one of red, green, blue"#),
        ("", &[], r#"there is no colour called ""; take one of red, green, blue"#),
    ] {
        let error = refused(name);
        assert_eq!(error.to_string(), told);
        let expected = nearest.iter().map(|&one| one.to_owned()).collect::<Vec<_>>();
        assert!(matches!(&error, Error::NoSuchName { nearest, .. } if *nearest == expected), "{error:?}");
    }
    let long = refused(&"x\n".repeat(1000)).to_string();
    assert!(long.len() < 150 && !long.contains('\n'), "{long}");
}
