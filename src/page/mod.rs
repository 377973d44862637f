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
mod medium;
mod names;
mod origin;
mod parts;
mod sheet;
pub mod sheet_windows;
pub mod spread;
mod spread_layout;
mod text;
mod transform;

pub use medium::{DotMedium, Medium, MediumParams, Print};
pub use names::{Names, area_name, line_name, overview_line_name, text_name};
pub use origin::{InSet, LeftOut, PartShown, SAMPLES, ToldInKey};
pub use parts::*;

pub(crate) use crate::geom::gridlines::{which_are_gridlines, without_treads};
pub(crate) use crate::lines::{arrowhead, which_are_weak};
