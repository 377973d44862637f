#![doc = include_str!("ARCHITECTURE.md")]

pub mod calibration;
pub mod classes;
pub mod contours;
pub mod devices;
pub mod dots;
pub mod edges;
pub mod error;
pub mod frame;
pub mod geom;
pub mod lines;
pub mod note;
pub mod output;
pub mod page;
pub mod pipeline;
pub mod profile;
pub mod raster;
pub mod textures;
pub mod touch;
pub mod units;

pub use contours::Trace;
pub use error::Error;
pub use note::Note;
pub use page::Page;
pub use pipeline::trace::trace;
pub use pipeline::{Drawing, convert};
