//! Tests of `phrases`.

use super::*;

#[test]
fn a_place_without_a_subject_is_told_as_it_was_given_and_on_the_part_that_is_drawn() {
    let outside = no_subject(Reason::OutsidePart, "700 px, 440 px");
    assert!(outside.starts_with("700 px, 440 px is outside of the part that is drawn"), "{outside}");
    let off = no_subject(Reason::RegionsOff, "20 %, 20 %");
    assert!(off.contains("lines.regions = false") && !off.contains("nothing with a clear outline"), "{off}");
    let nothing = no_subject(Reason::NothingThere, "20 %, 20 %");
    assert!(nothing.starts_with("at 20 %, 20 % of the part that is drawn there is nothing"), "{nothing}");
}
