//! How many glyphs there are in ink: patches that hang together.

use crate::geom::components::{components, eight_neighbours};
use crate::raster::plane::Plane;

/// Share of the blackest ink from which a pixel belongs to a patch: dots that are pressed low are drawn grey.
const BLACK: f32 = 0.5;

/// The number of patches of ink, corners counting as contact.
pub(super) fn patches(ink: &Plane) -> usize {
    let blackest = ink.values.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    let is_ink = |at: usize| ink.values[at] >= BLACK * blackest;
    components(ink.values.len(), is_ink, |at| eight_neighbours(at, ink.size).filter(|&near| is_ink(near))).len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Size;

    #[test]
    fn patches_hang_together_by_sides_and_corners() {
        let picture = ["#..#", ".#.#", "....", "#..#"];
        let values = picture.iter().flat_map(|row| row.chars().map(|c| f32::from(u8::from(c == '#')))).collect();
        assert_eq!(patches(&Plane { size: Size::new(4, 4), values }), 4);
    }
}
