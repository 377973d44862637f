//! Dots on a device's grid, and the files that embossers, braille programs and pin displays take.
//!
//! Every writer takes the pages of a document, in order, and gives the same bytes for the same dots.

mod matrix;

pub use matrix::Matrix;
