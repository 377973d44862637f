//! Can a fingertip tell the textures? Scenes whose colours are known, and measures of what is felt; for `bin/touch` and for
//! the project's tests.

pub mod boldness;
pub mod chart;
pub mod density;
pub mod dots;
pub mod gaps;
pub mod judge;
pub mod scenes;
