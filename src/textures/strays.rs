//! Single glyphs that stand apart, in a tongue of their region or between two lines, have no direction: they are only felt as
//! dirt.

use std::collections::BTreeMap;

use super::{Glyph, Params};

/// Fewer glyphs than this together are no texture.
pub(super) const LEAST_GROUP: usize = 4;

/// Leaves out groups of fewer than [`LEAST_GROUP`] glyphs. Glyphs belong together if they are no further apart than rows of the
/// sparsest texture, which are two rows of the dense one.
pub(super) fn leave_out(glyphs: &mut Vec<Glyph>, params: &Params) {
    let reach = 1.01 * (2.0 * params.across).max(3.0_f32.sqrt() * params.dot_pitch);
    let square = |glyph: &Glyph| ((glyph.at.y / reach).floor() as i32, (glyph.at.x / reach).floor() as i32);
    let mut by_square: BTreeMap<(i32, i32), Vec<usize>> = BTreeMap::new();
    for (number, glyph) in glyphs.iter().enumerate() {
        by_square.entry(square(glyph)).or_default().push(number);
    }
    let near = |number: usize| {
        let (glyphs, by_square) = (&glyphs[..], &by_square);
        let glyph = &glyphs[number];
        let (row, column) = square(glyph);
        let squares = (-1..=1).flat_map(move |dy| (-1..=1).map(move |dx| (row + dy, column + dx)));
        let around = squares.filter_map(move |square| by_square.get(&square)).flatten().copied();
        around.filter(move |&other| (glyphs[other].at - glyph.at).length() <= reach)
    };
    let mut stays = vec![None; glyphs.len()];
    for start in 0..glyphs.len() {
        if stays[start].is_some() {
            continue;
        }
        stays[start] = Some(true);
        let mut group = vec![start];
        let mut next = 0;
        while next < group.len() {
            for other in near(group[next]) {
                if stays[other].is_none() {
                    stays[other] = Some(true);
                    group.push(other);
                }
            }
            next += 1;
        }
        if group.len() < LEAST_GROUP {
            group.iter().for_each(|&number| stays[number] = Some(false));
        }
    }
    let mut stays = stays.into_iter();
    glyphs.retain(|_| stays.next() == Some(Some(true)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::textures::Shape;
    use crate::textures::tests_support::PARAMS;
    use crate::units::MmPoint;

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
