//! Words in braille: the codes against liblouis, and pages read back dot by dot.

mod anew;
mod back;
mod charts;
mod codes;
mod key;
mod labels;
mod leaders;
mod named;
mod outputs;
mod places;
mod reading;
mod rows;
mod title;
mod worksheets;

/// A place along a side of the picture.
fn percent(at: f32) -> tactograph::Position {
    tactograph::Position::percent(at.into()).expect("a number")
}
