//! The library and the program from outside. One program, so that the library is linked once: `cargo test --test suite
//! golden::` runs a part of it. Only `tests/tidy`, which needs no library, stands alone.

mod arrows;
mod bars;
mod bitmaps;
mod blank_pages;
mod braille;
mod calibration;
mod check;
#[cfg(feature = "cli")]
mod cli;
mod colours;
mod common;
mod corpus;
mod corrections;
mod crowded;
mod decode;
mod dots;
mod dotted;
mod edited;
mod few;
mod gcode;
mod golden;
mod gridlines;
mod legibility;
mod lettering;
mod lines;
mod metamorphic;
mod pdf;
mod plans;
mod png;
mod points;
mod profiles;
mod reading;
mod reference;
mod refused;
mod relations;
mod scenes;
mod sheet;
mod sheets;
mod skips;
mod spread;
mod structure;
mod threads;
mod touch;
mod trace;
mod wrapping;
