//! Tests of `cut_textures`.

use super::*;
use crate::page::{Class, Shape, Sign};

/// Distance of signs and of their rows, mm.
const STEP: f32 = 3.4;

/// So many rows of signs, all across 100 mm, the first at y = 20.
fn rows(count: u32) -> Texture {
    let at = |row: u32, column: u32| MmPoint::new(STEP * column as f32, 20.0 + STEP * row as f32);
    let glyphs = (0..count).flat_map(|row| (0..30).map(move |column| at(row, column)));
    let glyphs: Vec<Glyph> = glyphs.map(|at| Glyph { at, shape: Shape::Dot { diameter: 1.0 } }).collect();
    let area = STEP * STEP * glyphs.len() as f32;
    Texture { class: Class::Grey, sign: Sign::Dot, colour: [120; 3], area, glyphs }
}

/// What a label of 40 mm, or one as wide as the texture, leaves of it from y = `top` on; on dots, where the least
/// height is not 0.
fn left(mut texture: Texture, top: f32, is_wide: bool, least_texture: f32) -> Vec<MmPoint> {
    let (from, to) = if is_wide { (-5.0, 105.0) } else { (30.0, 70.0) };
    let label = Placed::of_test(MmRect::new(MmPoint::new(from, top), MmPoint::new(to, top + 6.0)));
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(110.0, 150.0));
    let dot_pitch = if least_texture > 0.0 { 2.5 } else { 0.0 };
    make_room(&mut texture, &[&label], &Params { least_texture, dot_pitch, ..Params::of_test(area) });
    texture.glyphs.iter().map(|glyph| glyph.at).collect()
}

/// How many signs are above a label, in its middle.
fn above(left: &[MmPoint], top: f32) -> usize {
    left.iter().filter(|at| at.y < top && (42.0..58.0).contains(&at.x)).count()
}

#[test]
fn strips_of_one_or_two_rows_beside_a_label_go_and_broader_parts_stay() {
    // the first two rows, at 20 and 23.4 mm, are left between the label and the edge of the texture
    let top = 27.5;
    let two = left(rows(30), top, false, 0.0);
    assert_eq!(above(&two, top), 0);
    assert!(two.iter().any(|at| at.y < top && at.x < 15.0), "far from the label they stay");
    assert!(two.iter().any(|at| at.y > top + 9.0 && (42.0..58.0).contains(&at.x)), "below it there are many rows");
    let top = 41.0;
    assert!(above(&left(rows(30), top, false, 0.0), top) > 0, "five rows above it stay");
}

#[test]
fn what_a_label_leaves_at_the_ends_of_rows_goes() {
    // the first sign of each row beside the label is left
    let mut texture = rows(30);
    let label = Placed::of_test(MmRect::new(MmPoint::new(5.0, 50.0), MmPoint::new(70.0, 56.0)));
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(110.0, 150.0));
    make_room(&mut texture, &[&label], &Params::of_test(area));
    let first = |from: f32, to: f32| {
        texture.glyphs.iter().filter(|glyph| glyph.at.x < 1.0 && (from..to).contains(&glyph.at.y)).count()
    };
    assert_eq!(first(50.0, 56.0), 0);
    assert_eq!(first(20.0, 45.0), 8, "above the label rows begin as before");
}

#[test]
fn a_texture_that_was_two_rows_before_stays_beside_a_label() {
    let top = 31.0;
    // a third row, which the label takes, is far from most of them
    let mut texture = rows(2);
    texture.glyphs.push(Glyph { at: MmPoint::new(50.0, top), ..texture.glyphs[0] });
    assert_eq!(above(&left(texture, top, false, 0.0), top), 10);
}

#[test]
fn rows_of_dots_that_are_far_apart_are_one_texture() {
    // rows of dots 2 mm apart, 8 mm from one to the next, as on an Index
    let at = |row: u32, dot: u32| MmPoint::new(2.0 * dot as f32, 20.0 + 8.0 * row as f32);
    let dots = (0..10).flat_map(|row| (0..50).map(move |dot| at(row, dot)));
    let glyphs: Vec<Glyph> = dots.map(|at| Glyph { at, shape: Shape::Dot { diameter: 1.6 } }).collect();
    let texture = Texture { area: 16.0 * glyphs.len() as f32, glyphs, ..rows(1) };
    let left = left(texture, 50.0, false, 12.0);
    let ends = left.iter().filter(|at| at.x < 20.0).count();
    assert_eq!(ends, 100, "rows beside the label are as long as they were, away from it");
}

#[test]
fn on_dots_parts_that_are_too_low_go_as_well() {
    // three rows above a label as wide as the texture
    let top = 33.0;
    let left = |least: f32| left(rows(14), top, true, least);
    assert!(above(&left(0.0), top) > 0);
    assert_eq!(above(&left(12.0), top), 0);
    assert!(left(12.0).iter().any(|at| at.y > top), "below it there are more rows");
}

#[test]
fn on_dots_pieces_of_rows_as_short_as_letters_go() {
    // a label leaves three dots at the left end of each row beside it
    let at = |row: u32, dot: u32| MmPoint::new(20.0 + 2.5 * dot as f32, 20.0 + 5.0 * row as f32);
    let all = || {
        let dots = (0..20).flat_map(|row| (0..40).map(move |dot| at(row, dot)));
        let glyphs: Vec<Glyph> = dots.map(|at| Glyph { at, shape: Shape::Dot { diameter: 1.6 } }).collect();
        Texture { area: 12.5 * glyphs.len() as f32, glyphs, ..rows(1) }
    };
    let beside = |least: f32| {
        let left = left(all(), 50.0, false, least);
        left.iter().filter(|at| at.x < 27.0 && (49.0..56.0).contains(&at.y)).count()
    };
    assert!(beside(0.0) > 0, "signs on paper are no letters");
    assert_eq!(beside(7.5), 0);
    // what was as short before is a part of the texture
    let mut texture = all();
    texture.glyphs.retain(|glyph| glyph.at.x < 26.0 || glyph.at.y > 100.0);
    let left = left(texture, 106.0, false, 7.5);
    assert!(left.iter().any(|at| at.x < 26.0 && at.y < 80.0), "{left:?}");
}

#[test]
fn an_area_is_told_by_the_labels_that_stand_in_it() {
    let texture = rows(30);
    let params = Params::of_test(MmRect::new(MmPoint::zero(), MmPoint::new(110.0, 150.0)));
    let label = |x: f32, y: f32, to: f32| Placed::of_test(MmRect::new(MmPoint::new(x, y), MmPoint::new(to, y + 6.0)));
    // the middle of the texture is at 49, 69
    let (town, name) = (label(5.0, 30.0, 25.0), label(5.0, 100.0, 35.0));
    let (beside, far) = (label(30.0, 12.0, 50.0), label(150.0, 66.0, 170.0));
    assert_eq!(labels_in(&texture, &[&town, &beside, &name, &far], &params), [2, 0]);
    assert_eq!(labels_in(&texture, &[&far], &params), [0], "the nearest, where none stands in it");
    assert!(labels_in(&texture, &[], &params).is_empty());
}
