//! The fingertip model: what would be felt on a page, judged from the page alone.
//!
//! ```text
//! SVG -> Ink (resvg, 8 px/mm) -> measure (blur, structure tensor) -> FeltCells (class meant and class felt, each cell)
//!                                                                    `-> Report (shares, ink), map (a picture)
//! ```
//!
//! The input is the drawing and the ids of its layers with the sign that each states, never a record of how the page
//! was made. So a page that was changed in an editor is judged like a new one, and the textures of this program are
//! judged without knowing how they were placed.
//!
//! [`measure`] defines the model. It knows slopes of a blurred surface, not skin. It serves to compare textures and
//! to find areas whose class cannot be told.

mod felt;
mod ink;
mod letters;
pub mod map;
pub mod measure;
pub mod report;
mod signs;

pub use felt::{Cell, FeltCells, JUDGED_FROM, feel};
pub use ink::Ink;
pub use measure::{CELLS_PER_MM, FINGERS, Feel};
pub use report::{FeltAs, Report, report};
pub use signs::Signs;
