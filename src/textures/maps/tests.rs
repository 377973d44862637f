//! Tests of `maps`.

use super::*;
use crate::classes::Region;
use crate::lines::Run;

/// Ten by ten cells of 1 mm from (20, 30), the right half another region than the left.
fn halves() -> Classes {
    let size = Size::new(10, 10);
    let region = (0..100).map(|i| Some(u32::from(i % 10 >= 5))).collect();
    let regions = [Class::Blue, Class::Red].map(|class| Region { class, colour: [0; 3], cells: 50 }).into();
    Classes { size, region, regions, lightness: Plane::filled(size, 0.5), fringe: Vec::new() }
}

#[test]
fn a_glyph_keeps_its_gap_from_the_boundary_and_no_more() {
    let classes = halves();
    let regions = RegionMap::new(&classes, MmRect::new(MmPoint::new(20.0, 30.0), MmPoint::new(30.0, 40.0)));
    let rhombus = |degrees| Shape::Rhombus { length: 2.0, thickness: 1.0, degrees };
    for (shape, half) in [(rhombus(0.0), 1.0), (rhombus(90.0), 0.5), (Shape::Dot { diameter: 1.5 }, 0.75)] {
        let keeps = |x: f32, y: f32| {
            let glyph = Glyph { at: MmPoint::new(x, y), shape };
            regions.keeps_inside(&glyph, &glyph.corners(), 0, 0.3)
        };
        assert!(keeps(25.0 - half - 0.31, 35.0), "{shape:?} is far enough");
        assert!(!keeps(25.0 - half - 0.29, 35.0), "{shape:?} is too near to the other region");
        assert!(!keeps(25.0 - 0.1, 35.0), "{shape:?} lies across the boundary");
        assert!(keeps(20.0 + half + 0.31, 35.0) && !keeps(20.0 + half + 0.29, 35.0), "{shape:?} at the picture's edge");
    }
}

#[test]
fn a_lone_line_has_density_one_on_itself_and_half_at_1_18_sigma() {
    let area = MmRect::new(MmPoint::new(5.0, 5.0), MmPoint::new(105.0, 105.0));
    let points = vec![MmPoint::new(55.0, 5.0), MmPoint::new(55.0, 105.0)];
    let line = Line { strength: 50.0, runs: vec![Run::stroke(1.0, points)] };
    let map = line_density(&[line], area, 8.0);
    let at = |x: f32| map.at(x - 5.0, 50.0);
    assert!((at(55.0) - 1.0).abs() < 0.02, "{}", at(55.0));
    assert!((at(55.0 + 9.42) - 0.5).abs() < 0.04, "{}", at(64.42));
}
