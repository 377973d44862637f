//! From a colour picture to a page that fingers can read: `src/ARCHITECTURE.md` tells how.

mod calibration;
mod classes;
mod contours;
mod devices;
mod dots;
mod edges;
mod error;
mod frame;
mod geom;
mod lines;
mod note;
mod output;
mod page;
mod pipeline;
mod profile;
mod raster;
mod textures;
mod touch;
mod units;

pub use contours::Trace;
pub use error::Error;
pub use note::Note;
pub use page::Page;
pub use pipeline::trace::trace;
pub use pipeline::{Drawing, convert};

/// The stages, for this project's own tests, benchmarks and measuring programs. No part of the public interface: anything in
/// here may change with any release.
#[doc(hidden)]
pub mod internals {
    pub mod calibration {
        pub use crate::calibration::*;
    }
    pub mod classes {
        pub use crate::classes::*;
    }
    pub mod contours {
        pub use crate::contours::*;
    }
    pub mod devices {
        pub use crate::devices::*;
    }
    pub mod dots {
        pub use crate::dots::*;
    }
    pub mod edges {
        pub use crate::edges::*;
    }
    pub mod error {
        pub use crate::error::*;
    }
    pub mod frame {
        pub use crate::frame::*;
    }
    pub mod geom {
        pub use crate::geom::*;
    }
    pub mod lines {
        pub use crate::lines::*;
    }
    pub mod note {
        pub use crate::note::*;
    }
    pub mod output {
        pub use crate::output::*;
    }
    pub mod page {
        pub use crate::page::*;
    }
    pub mod pipeline {
        pub use crate::pipeline::*;
    }
    pub mod profile {
        pub use crate::profile::*;
    }
    pub mod raster {
        pub use crate::raster::*;
    }
    pub mod textures {
        pub use crate::textures::*;
    }
    pub mod touch {
        pub use crate::touch::*;
    }
    pub mod units {
        pub use crate::units::*;
    }
}
