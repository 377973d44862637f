//! The picture as numbers: linear light, working resolution, upright.

pub mod crop;
pub mod decode;
pub mod plane;
mod planes;

pub use planes::Raster;
