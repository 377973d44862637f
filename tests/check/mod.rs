//! Pages are held against the rules: those of this program pass, others are found faulty.

mod exact;
mod faults;
mod own;
mod rules;
