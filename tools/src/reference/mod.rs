//! The stages whose numbers decide something, once more in f64: slow and straightforward, by the formulas as they are
//! printed. What differs from the program's f32 is rounding, and its approximations of roots, logarithms and
//! exponentials.
//!
//! * [`edges`]: perceptual colours, the colour structure tensor, its maxima, their positions and heights.
//! * [`colours`]: the class of a colour.
//! * [`glyphs`]: how large a mark of a texture is.
//! * [`samples`]: the samples as they are worked on.
//! * [`scenes`]: pictures on which rounding may turn a decision.

pub mod colours;
pub mod edges;
pub mod glyphs;
pub mod samples;
pub mod scenes;
