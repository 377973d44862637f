//! Tests of `parse`.

use super::*;

#[test]
fn faults_have_their_line() {
    for (text, fault) in [
        ("number 3456\nletters a", "line 2: a letter without dots"),
        ("sign . * 3", "line 1: a sign without neighbours"),
        ("sign . ** 7", "line 1: no dots: 7"),
        ("sign . ** 3 nubmer", "line 1: no such thing as nubmer"),
        ("capitals 6", "line 1: no such word as capitals"),
        ("number 3456", "number, digits or letters are missing"),
    ] {
        assert_eq!(table(text).map(|table| table.name), Err(fault.to_owned()), "{text}");
    }
}
