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
        remove_small_components(&mut glyphs, None, &Params::TEST);
        glyphs
    };
    let edge = 31.0 + 2.0 * Params::TEST.across;
    assert!(edge < 40.0, "the field ends at 31, out of reach of the three");
    assert_eq!(left(all.clone()), all[..8]);
    assert_eq!(left(all[..3].to_vec()), []);
}

/// Rows of rhombuses as the lattice has them, level: so many of them, with so many rhombuses each.
fn level_rows(rows: usize, each: usize) -> Vec<Glyph> {
    let Params { along, across, length, thickness, .. } = Params::TEST;
    let glyph = |(row, number): (usize, usize)| {
        let stagger = if row % 2 == 0 { 0.0 } else { 0.5 };
        let at = MmPoint::new((number as f32 + stagger) * along, row as f32 * across);
        Glyph { at, shape: Shape::Rhombus { length, thickness, degrees: 0.0 } }
    };
    (0..rows).flat_map(|row| (0..each).map(move |number| (row, number))).map(glyph).collect()
}

#[test]
fn rhombuses_one_above_the_other_are_no_level_rows() {
    let left = |mut glyphs: Vec<Glyph>, degrees: f32| {
        remove_small_components(&mut glyphs, Some(degrees), &Params::TEST);
        glyphs.len()
    };
    // one a row, in a strip with no room for two
    assert_eq!(left(level_rows(8, 1), 0.0), 0);
    assert_eq!(left(level_rows(1, 8), 0.0), 8, "a row alone runs as its colour says");
    assert_eq!(left(level_rows(2, 2), 0.0), 4);
    assert_eq!(left(level_rows(8, 2), 0.0), 16);
    // rows of two, and the rest one each
    let mut tapered = level_rows(8, 1);
    tapered.extend((0..3).map(|row| level_rows(8, 2)[2 * row + 1]));
    assert_eq!(left(tapered.clone(), 0.0), 11, "6 of 11");
    tapered.pop();
    assert_eq!(left(tapered, 0.0), 0, "4 of 10");
}

#[test]
fn rows_are_those_in_the_direction_of_the_texture() {
    let Params { along, across, length, thickness, .. } = Params::TEST;
    let upright = |columns: usize| -> Vec<Glyph> {
        let at = |(column, number): (usize, usize)| MmPoint::new(column as f32 * across, number as f32 * along);
        let shape = Shape::Rhombus { length, thickness, degrees: 90.0 };
        let places = (0..columns).flat_map(|column| (0..6).map(move |number| (column, number)));
        places.map(at).map(|at| Glyph { at, shape }).collect()
    };
    for (degrees, stays) in [(90.0, 6), (0.0, 0)] {
        let mut glyphs = upright(1);
        remove_small_components(&mut glyphs, Some(degrees), &Params::TEST);
        assert_eq!(glyphs.len(), stays, "one upright row, of rows at {degrees} degrees");
    }
}

/// A texture of these glyphs.
fn texture(class: Class, glyphs: Vec<Glyph>) -> Texture {
    Texture { class, sign: Params::TEST.palette.sign(class), colour: [0; 3], area: 400.0, glyphs }
}

#[test]
fn of_a_photograph_patches_of_fewer_than_six_go() {
    let left = |class: Class, glyphs: Vec<Glyph>| {
        let mut textures = vec![texture(class, glyphs)];
        leave_out_crumbs(&mut textures, &Params::TEST);
        textures.iter().map(|texture| texture.glyphs.len()).sum::<usize>()
    };
    assert_eq!(left(Class::Blue, level_rows(2, 3)), 6, "two rows of three");
    assert_eq!(left(Class::Blue, level_rows(1, 5)), 0);
    let far = |glyph: Glyph| Glyph { at: MmPoint::new(glyph.at.x + 60.0, glyph.at.y), ..glyph };
    let both = level_rows(5, 4).into_iter().chain(level_rows(2, 2).into_iter().map(far)).collect();
    assert_eq!(left(Class::Blue, both), 20, "the rest of the same texture stays");
    let dots = |places: &[(f32, f32)]| -> Vec<Glyph> {
        let dot = |&(x, y): &(f32, f32)| Glyph { at: MmPoint::new(x, y), shape: Shape::Dot { diameter: 1.5 } };
        places.iter().map(dot).collect()
    };
    let pitch = Params::TEST.dot_pitch;
    let ring = [(1.0, 0.0), (0.5, 0.87), (-0.5, 0.87), (-1.0, 0.0), (-0.5, -0.87), (0.5, -0.87)];
    let ring: Vec<(f32, f32)> = ring.iter().map(|(x, y)| (x * pitch, y * pitch)).collect();
    assert_eq!(left(Class::Grey, dots(&ring)), 6);
    assert_eq!(left(Class::Grey, dots(&ring[..4])), 0, "as a letter in braille");
    // a trail of single dots, twice as far apart as those of a dense texture
    let trail: Vec<(f32, f32)> = (0..9).map(|k| (2.0 * pitch * k as f32, 0.0)).collect();
    assert_eq!(left(Class::Grey, dots(&trail)), 0);
}

#[test]
fn on_a_page_with_labels_patches_of_dots_go_that_are_as_small_as_a_cell() {
    let left = |class: Class, glyphs: Vec<Glyph>| {
        let mut textures = vec![texture(class, glyphs)];
        leave_out_cells(&mut textures, &Params::TEST);
        textures.iter().map(|texture| texture.glyphs.len()).sum::<usize>()
    };
    let pitch = Params::TEST.dot_pitch;
    // in rows of two, every second one moved by half a pitch
    let dot = |k: usize| {
        let (column, row) = ((k % 2) as f32 + 0.5 * ((k / 2) % 2) as f32, 0.87 * (k / 2) as f32);
        Glyph { at: MmPoint::new(column * pitch, row * pitch), shape: Shape::Dot { diameter: 1.5 } }
    };
    for (count, stays) in [(4, 0), (7, 0), (8, 8), (12, 12)] {
        assert_eq!(left(Class::Grey, (0..count).map(dot).collect()), stays, "{count} dots");
    }
    assert_eq!(left(Class::Blue, level_rows(2, 2)), 4, "rhombuses are no braille");
}
