//! Words in braille: the codes against liblouis, and pages read back dot by dot.

mod codes;
mod key;
mod labels;
mod reading;
mod title;
