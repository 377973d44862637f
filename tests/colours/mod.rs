//! Colours are sorted as a person would say, areas keep their own colour, and stay calm.
#![allow(clippy::print_stdout, reason = "the tables of what was measured; cargo test shows them with --nocapture")]

mod areas;
mod calm;
mod fringe;
mod named;
mod scenes;
mod stains;
