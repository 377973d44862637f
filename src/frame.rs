//! Pixels become millimetres here, once.

use crate::units::{MmPoint, MmRect, PxPoint, Size};

/// Where the working picture lies on the sheet: one scale for both axes and an offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    origin: MmPoint,
    mm_per_px: f32,
}

impl Frame {
    /// Lays a picture of `size` pixels into `place` with its top-left corner at the rectangle's own; the scale comes from
    /// the longer side, where rounding to whole pixels matters least.
    pub fn new(size: Size, place: MmRect) -> Self {
        let mm_per_px = if size.width >= size.height {
            place.width() / size.width as f32
        } else {
            place.height() / size.height as f32
        };
        Self { origin: place.min, mm_per_px }
    }

    /// Millimetres on the sheet for one pixel of the picture.
    pub fn mm_per_px(&self) -> f32 {
        self.mm_per_px
    }

    /// The place on the sheet of a place in the picture.
    pub fn to_mm(&self, at: PxPoint) -> MmPoint {
        MmPoint::new(self.origin.x + at.x * self.mm_per_px, self.origin.y + at.y * self.mm_per_px)
    }

    /// The place in the picture of a place on the sheet.
    pub fn to_px(&self, at: MmPoint) -> PxPoint {
        PxPoint::new((at.x - self.origin.x) / self.mm_per_px, (at.y - self.origin.y) / self.mm_per_px)
    }
}
