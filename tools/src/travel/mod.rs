//! A machine that presses dots one by one, sets of dots for it, simple orders and a bound to compare with; for
//! `bin/travel` and for the project's tests.

pub mod bound;
pub mod machine;
pub mod orders;
pub mod sets;
