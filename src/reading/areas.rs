//! Filled shapes that a person drew to be areas of a colour: they have no signs yet, so a page cannot hold them.

use super::marks::PaintedShape;
use crate::geom::polygon::area;
use crate::output::layer::Layer;
use crate::page::Class;
use crate::units::MmPoint;

/// A shape is an area from so much on, mm2: smaller ones are marks. No profile has textures for less.
pub(super) const LEAST: f32 = 25.0;

/// A filled shape that stands for an area.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnArea {
    /// The class of the layer in which it lies; none if its colour decides.
    pub class: Option<Class>,
    /// Its colour, sRGB.
    pub colour: [u8; 3],
    /// Its outlines; what lies in an even number of them is outside.
    pub outlines: Vec<Vec<MmPoint>>,
}

/// Whether areas of a colour may lie in a layer, besides those of textures.
pub(super) fn may_lie_in(layer: Option<Layer>) -> bool {
    matches!(layer, None | Some(Layer::Figure | Layer::Textures | Layer::Lines))
}

/// The area that a mark is. One in a layer of textures has the class of that; elsewhere it must have a colour, or be
/// grey: what is black is ink.
pub(super) fn of(mark: &PaintedShape<'_>) -> Option<DrawnArea> {
    let tone = mark.fill?;
    let is_own = ["data-class", "data-braille", "data-strength"].iter().any(|name| mark.element.has_attribute(*name));
    let class = match mark.layer {
        Some(Layer::Texture(class)) => Some(class),
        layer if may_lie_in(layer) => None,
        _ => return None,
    };
    if is_own || (class.is_none() && !tone.is_shaded()) {
        return None;
    }
    let outlines: Vec<Vec<MmPoint>> = mark.subpaths.iter().map(|subpath| subpath.points.clone()).collect();
    let is_large = |outline: &Vec<MmPoint>| area(outline) >= LEAST;
    // a hole may be small
    let is_area = outlines.iter().any(is_large);
    is_area.then_some(DrawnArea { class, colour: mark.colour, outlines })
}
