//! Tests of `glyph`.

use super::*;

#[test]
fn a_rhombus_lies_in_the_direction_that_a_reader_sees() {
    let green = Shape::Rhombus { length: 2.0, thickness: 1.0, degrees: 45.0 };
    let [tip, ..] = Glyph { at: MmPoint::new(10.0, 10.0), shape: green }.corners();
    assert!(tip.x > 10.5 && tip.y < 9.5, "the tip of a green rhombus points up and right, not to {tip:?}");
}

#[test]
fn the_distance_is_from_the_outline() {
    let shape = Shape::Rhombus { length: 2.0, thickness: 1.0, degrees: 0.0 };
    let glyph = Glyph { at: MmPoint::new(0.0, 0.0), shape };
    let wall = (MmPoint::new(4.0, -5.0), MmPoint::new(4.0, 5.0));
    assert!((glyph.distance_to(wall, &glyph.corners()) - 3.0).abs() < 1e-5);
    let through = (MmPoint::new(-5.0, 0.1), MmPoint::new(5.0, 0.1));
    assert!(glyph.distance_to(through, &glyph.corners()) < 1e-6);
}

#[test]
fn the_distance_of_two_glyphs_is_from_outline_to_outline() {
    let dot = |x: f32| Glyph { at: MmPoint::new(x, 0.0), shape: Shape::Dot { diameter: 1.0 } };
    let shape = Shape::Rhombus { length: 2.0, thickness: 1.0, degrees: 0.0 };
    let rhombus = |x: f32| Glyph { at: MmPoint::new(x, 0.0), shape };
    let near = |found: f32, wanted: f32| assert!((found - wanted).abs() < 1e-5, "{found} mm, not {wanted}");
    near(dot(0.0).distance_to_glyph(&dot(3.0)), 2.0);
    near(rhombus(0.0).distance_to_glyph(&rhombus(3.0)), 1.0);
    near(dot(0.0).distance_to_glyph(&rhombus(3.0)), 1.5);
    near(rhombus(3.0).distance_to_glyph(&dot(0.0)), 1.5);
}
