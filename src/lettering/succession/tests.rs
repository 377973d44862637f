//! Tests of `succession`.

use super::*;

/// Names of shapes: each looks like these characters, the first of them most.
fn names(of: &[&str]) -> Vec<Vec<Likeness>> {
    let like = |(rank, character): (usize, char)| Likeness { character, off: 0.001 * (1 + rank) as f32 };
    of.iter().map(|characters| characters.chars().enumerate().map(like).collect()).collect()
}

/// Which of shapes with these names are in a run.
fn in_run(of: &[&str]) -> Vec<usize> {
    let all: Vec<usize> = (0..of.len()).collect();
    run(&all, &names(of))
}

#[test]
fn three_in_a_row_are_a_run_and_two_are_none() {
    assert_eq!(in_run(&["3", "1", "2"]), [0, 1, 2]);
    assert_eq!(in_run(&["B", "X", "A", "C"]), [0, 2, 3]);
    for none in [&["1", "2"][..], &["1", "2", "4"], &["A", "B", "D", "F"], &["8", "9", "A"], &["X", "X", "X"]] {
        assert_eq!(in_run(none), [0_usize; 0], "{none:?}");
    }
}

#[test]
fn steps_of_two_are_four_at_least() {
    assert_eq!(in_run(&["0", "2", "4", "6", "8"]), [0, 1, 2, 3, 4]);
    assert_eq!(in_run(&["0", "2", "4"]), [0_usize; 0]);
}

#[test]
fn letters_that_are_hard_to_know_may_be_missing() {
    assert_eq!(in_run(&["P", "R", "S"]), [0, 1, 2]);
    assert_eq!(in_run(&["G", "H", "K"]), [0, 1, 2]);
    assert_eq!(in_run(&["B", "D", "E"]), [0_usize; 0]);
}

#[test]
fn a_shape_stands_for_one_character() {
    // the second may be either, but not both
    assert_eq!(in_run(&["5", "67", "8"]), [0_usize; 0]);
    assert_eq!(in_run(&["7", "68", "9"]), [0_usize; 0], "three of which one looks more like another");
    assert_eq!(in_run(&["7", "86", "9"]), [0, 1, 2]);
    assert_eq!(in_run(&["5", "67", "7", "8"]), [0, 1, 2, 3]);
    assert_eq!(in_run(&["5", "76", "7", "8"]), [0, 1, 2, 3], "the seventh is the one that looks like nothing else");
}

#[test]
fn many_of_one_shape_are_signs() {
    let crosses = |count: usize| [vec!["V", "W"], vec!["X"; count]].concat();
    assert_eq!(in_run(&crosses(4)).len(), 6);
    assert_eq!(in_run(&crosses(5)), [0_usize; 0]);
}
