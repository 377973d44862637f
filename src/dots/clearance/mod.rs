//! The clearance between lines of dots: a weaker line gives way to a stronger one.

mod anywhere;
mod on_grid;

pub(super) use anywhere::anywhere;
pub(super) use on_grid::on_grid;

/// Fewer dots than this are no line, and no piece of a second row.
const LEAST_DOTS: usize = 3;
/// What rounding may take off a length, mm.
const ROUNDED_OFF: f32 = 1e-3;
