//! The colours of a picture in which text is looked for.

use crate::raster::plane::Plane;
use crate::raster::{Raster, lab};

/// Lightness and twice a and b of a picture: of a drawing whole planes, all of which are looked at; of a photograph
/// lightness alone, and the rest where it is asked for.
pub(super) struct Colours<'a> {
    raster: &'a Raster,
    pub(super) planes: Vec<Plane>,
}

impl<'a> Colours<'a> {
    pub(super) fn new(raster: &'a Raster, is_drawing: bool) -> Self {
        let planes = if is_drawing { lab::whole(raster) } else { vec![lab::whole_lightness(raster)] };
        Self { raster, planes }
    }

    /// The colour of a pixel.
    pub(super) fn at(&self, cell: usize) -> [f32; 3] {
        match &self.planes[..] {
            [l, a, b] => [l.values[cell], a.values[cell], b.values[cell]],
            // of a photograph, or grey
            _ => lab::pixel(self.raster, cell),
        }
    }
}
