//! Tests of `job`.

use super::*;

#[test]
fn a_panic_of_a_decoder_becomes_its_message() {
    assert_eq!(guarded(|| 7), Ok(7));
    assert_eq!(guarded(|| -> u8 { panic!("on purpose,\n  with {} lines", 2) }), Err("on purpose, with 2 lines".into()));
    assert_eq!(guarded(|| -> u8 { std::panic::panic_any(3) }), Err("no reason given".into()));
}
