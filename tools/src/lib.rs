//! What the measuring programs share with one another and with the project's tests.

pub mod agreement;
pub mod bitmap;
pub mod blanks;
pub mod camera_scene;
pub mod cjpeg;
pub mod cores;
pub mod correction;
pub mod dot_reading;
pub mod drawn;
pub mod full_page;
pub mod fuzz;
pub mod killing;
pub mod marks;
pub mod median;
pub mod near;
pub mod photo;
pub mod plot;
pub mod reference;
pub mod rng;
pub mod scenes;
pub mod touch;
pub mod travel;
pub mod words;

/// The root of the project, where `samples`, `docs` and `target` are.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// A point of a scene, px.
pub type P = [f64; 2];
