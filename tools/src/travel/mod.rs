//! A machine that presses dots one by one, and sets of dots for it; for `bin/travel` and for the project's tests.

pub mod machine;
pub mod sets;
