//! Tests of `fill`.

use super::*;
use crate::textures::glyph::Shape;

#[test]
fn three_glyphs_apart_from_the_rest_go() {
    let glyph = |(x, y)| Glyph { at: MmPoint::new(x, y), shape: Shape::Dot { diameter: 1.0 } };
    let field = (0..8).map(|i| (10.0 + 3.0 * i as f32, 20.0));
    let few = [(40.0, 20.0), (40.0, 24.0), (42.0, 22.0)].into_iter();
    let all: Vec<Glyph> = field.chain(few).map(glyph).collect();
    let left = |mut glyphs: Vec<Glyph>| {
        remove_small_components(&mut glyphs, &Params::TEST);
        glyphs
    };
    let edge = 31.0 + 2.0 * Params::TEST.across;
    assert!(edge < 40.0, "the field ends at 31, out of reach of the three");
    assert_eq!(left(all.clone()), all[..8]);
    assert_eq!(left(all[..3].to_vec()), []);
}
