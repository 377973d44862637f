//! The page: finished marks in millimetres. Everything before makes it, everything after reads it.
//!
//! A page has no options, no references and no pixels. Its constructor checks it once; writers need not check again.

pub mod cells;
mod check;
mod dot_layout;
mod dot_spread;
pub mod frame;
pub mod heading;
pub mod layout;
mod left_out;
mod medium;
mod names;
mod parts;
mod set;
mod sheet;
pub mod spread;
mod spread_layout;
mod text;
mod transform;

pub use left_out::LeftOut;
pub use medium::{DotMedium, Medium, MediumParams, Print};
pub use names::{Names, area_name, line_name, overview_line_name};
pub use parts::*;
pub use set::InSet;
