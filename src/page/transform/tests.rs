//! Tests of `transform`.

use super::*;
use crate::geom::nearest_on_segment;

/// Every corner of the narrow rhombus lies half of the swelling from the sides of the wide one, so that swelling
/// by that much on each side gives the wide one.
#[test]
fn a_rhombus_is_narrowed_evenly_on_its_four_sides() {
    for (length, thickness, degrees) in [(2.2, 1.2, 0.0), (1.65, 0.6, 45.0), (3.0, 3.0, 135.0)] {
        let glyph = |shape| Glyph { at: MmPoint::new(10.0, 10.0), shape };
        let wide = Shape::Rhombus { length, thickness, degrees };
        let (outer, inner) = (glyph(wide).corners(), glyph(wide.narrowed(0.2)).corners());
        for i in 0..4 {
            let middle = inner[i].lerp(inner[(i + 1) % 4], 0.5);
            let (distance, _) = nearest_on_segment(middle, outer[i], outer[(i + 1) % 4]);
            assert!((distance - 0.1).abs() < 1e-5, "{length} x {thickness}: {distance}");
        }
    }
}
