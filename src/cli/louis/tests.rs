//! Tests of `louis`.

use super::*;

#[test]
fn names_of_tables_are_checked_before_they_are_run() {
    for name in ["-x", "a,b", "$(x)", "a b"] {
        let refused = table(name, "en", "--braille-table").expect_err("no name");
        assert!(refused.contains("name a table of liblouis"), "{refused}");
    }
    let refused = table("contracted", "cs", "braille.grade = 2").expect_err("no table");
    assert!(
        refused.starts_with("braille.grade = 2: no contracted table is known for the language cs, only for de"),
        "{refused}"
    );
}
