//! Traced contours, as they come in and as outlines go out.

use crate::geom::polyline::{Located, Polyline};
use crate::units::{Px, PxPoint};

/// A point of a traced contour, in pixels of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TracePoint {
    /// Where it is.
    pub at: PxPoint,
    /// Strength of the contour here.
    pub strength: f32,
}

impl Located for TracePoint {
    type Unit = Px;

    fn at(&self) -> PxPoint {
        self.at
    }
}

/// A traced contour.
pub type Trace = Polyline<TracePoint>;
