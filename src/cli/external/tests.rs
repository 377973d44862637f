//! Tests of `external`.

use super::*;

const SHELL: Program = Program { name: "sh", remedy: "install a shell" };
const LONG: Duration = Duration::from_secs(60);

fn shell(script: &str, input: &[u8], limit: Duration) -> Result<Written, String> {
    SHELL.run(&["-c", script], input, limit)
}

#[test]
fn input_output_and_words_pass() {
    let written = shell("cat; echo so >&2", b"abc", LONG).expect("it runs");
    assert_eq!((&written.out[..], written.told.as_str()), (&b"abc"[..], "so\n"));
}

#[test]
fn more_than_pipes_hold_passes_both_ways() {
    let input = vec![b'x'; 1 << 20];
    assert_eq!(shell("cat | tee /dev/stderr", &input, LONG).expect("it runs").out, input);
}

#[test]
fn a_program_that_ends_without_reading_tells_why() {
    let input = vec![b'x'; 1 << 20];
    let refused = shell("exec <&-; echo >&2; echo no table >&2; exit 3", &input, LONG).expect_err("a fault");
    assert_eq!(refused, "sh says: no table");
    let refused = shell("exit 3", &[], LONG).expect_err("a fault");
    assert_eq!(refused, "sh fails without a word (exit status: 3)");
}

#[test]
fn what_takes_too_long_is_ended() {
    let refused = shell("sleep 60", &[], Duration::from_millis(50)).expect_err("too long");
    assert_eq!(refused, "sh has not ended after 0 s");
    let refused = shell("sleep 60 &", &[], LONG).expect_err("its child holds the pipe");
    assert_eq!(refused, "sh does not close its output");
}

#[test]
fn what_is_not_there_is_told_with_what_to_install() {
    let none = Program { name: "no-such-program", remedy: "install it" };
    let refused = none.run::<&str>(&[], &[], LONG).expect_err("no program");
    assert_eq!(refused, "there is no program no-such-program; install it");
}
