//! The picture as numbers: linear light, working resolution, upright.

pub mod crop;
pub mod decode;
pub mod plane;
mod planes;
pub mod shrink;
pub mod vector;

pub use planes::{Planes, Raster};
