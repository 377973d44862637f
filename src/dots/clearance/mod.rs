//! The clearance between lines of dots: a weaker line gives way to a stronger one.

mod anywhere;
mod junctions;
mod on_grid;
mod order;
mod second_rows;

pub(super) use anywhere::anywhere;
pub(super) use on_grid::on_grid;
pub use on_grid::{GOES_ON, STEPS, least_arc, longest_approach, longest_cut};
