//! The picture as numbers: linear light, working resolution, upright.

pub mod contrast;
pub mod crop;
pub mod decode;
pub mod lab;
pub mod plane;
mod planes;
pub mod residue;
pub mod rim;
pub mod shrink;
pub mod vector;

pub use planes::{Planes, Raster};
