//! Single glyphs that stand apart, in a tongue of their region or between two lines, have no direction: they are only felt as
//! dirt.

use super::{Glyph, Params};
use crate::geom::components;
use crate::units::MmPoint;

/// Fewer glyphs than this together are no texture.
pub(super) const LEAST_GROUP: usize = 4;

/// Leaves out groups of fewer than [`LEAST_GROUP`] glyphs. Glyphs belong together if they are no further apart than rows of the
/// sparsest texture, which are two rows of the dense one.
pub(super) fn leave_out(glyphs: &mut Vec<Glyph>, params: &Params) {
    let reach = 1.01 * (2.0 * params.across).max(3.0_f32.sqrt() * params.dot_pitch);
    let centres: Vec<MmPoint> = glyphs.iter().map(|glyph| glyph.at).collect();
    let groups = components::of_points(&centres, reach, |between| between.length() <= reach);
    components::retain(glyphs, &groups, |_, group| group.len() >= LEAST_GROUP);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::textures::Shape;
    use crate::textures::tests_support::PARAMS;

    #[test]
    fn three_glyphs_apart_from_the_rest_go() {
        let glyph = |(x, y)| Glyph { at: MmPoint::new(x, y), shape: Shape::Dot { diameter: 1.0 } };
        let field = (0..8).map(|i| (10.0 + 3.0 * i as f32, 20.0));
        let strays = [(40.0, 20.0), (40.0, 24.0), (42.0, 22.0)].into_iter();
        let all: Vec<Glyph> = field.chain(strays).map(glyph).collect();
        let left = |mut glyphs: Vec<Glyph>| {
            leave_out(&mut glyphs, &PARAMS);
            glyphs
        };
        let edge = 31.0 + 2.0 * PARAMS.across;
        assert!(edge < 40.0, "the field ends at 31, out of reach of the strays");
        assert_eq!(left(all.clone()), all[..8]);
        assert_eq!(left(all[..3].to_vec()), []);
    }
}
