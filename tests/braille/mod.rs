//! Words in braille: the codes against liblouis, and pages read back dot by dot.

mod codes;
mod reading;
mod title;
