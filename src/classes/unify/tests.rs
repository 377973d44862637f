//! Tests of `unify`.

use super::*;
use crate::raster::plane::Plane;

/// Classes of rows of letters: blue, red, white.
fn classes(rows: &[&str]) -> Classes {
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let label = |letter: u8| match letter {
        b'b' => Some(Class::Blue),
        b'r' => Some(Class::Red),
        _ => None,
    };
    let labels: Vec<AreaClass> = rows.iter().flat_map(|row| row.bytes()).map(label).collect();
    let lightness = labels.iter().map(|label| if label.is_none() { 1.0 } else { 0.4 }).collect();
    let lightness = Plane { size, values: lightness };
    let mut classes = Classes { size, region: Vec::new(), regions: Vec::new(), lightness, fringe: Vec::new() };
    let nothing = vec![None; labels.len()];
    classes.region = nothing.clone();
    relabel(&mut classes, &labels, &labels);
    classes
}

fn rows(classes: &Classes) -> Vec<String> {
    let letter = |region: &Option<u32>| match region.map(|region| classes.regions[region as usize].class) {
        Some(Class::Blue) => 'b',
        Some(_) => 'r',
        None => '.',
    };
    classes.region.chunks(classes.size.width as usize).map(|row| row.iter().map(letter).collect()).collect()
}

fn areas(rows: &[&str]) -> Vec<usize> {
    rows.iter().flat_map(|row| row.bytes()).map(|digit| usize::from(digit - b'0')).collect()
}

#[test]
fn an_outlined_area_is_of_the_class_that_holds_it() {
    let mut sorted = classes(&["bbbbbbbb", "bbrrr.bb", "bbrrrrbb", "bbbrrrrb", "bbbbbbbb"]);
    let mixed = unify_areas(
        &mut sorted,
        &areas(&["00000000", "00111100", "00111100", "00111100", "00000000"]),
        [2.0, 1.0],
        false,
    );
    assert_eq!(rows(&sorted), ["bbbbbbbb", "bbrrrrbb", "bbrrrrbb", "bbrrrrbb", "bbbbbbbb"]);
    assert_eq!(mixed, [0_usize; 0]);
    assert_eq!(sorted.regions.len(), 2);
    assert!(sorted.lightness.values.iter().all(|lightness| (lightness - 0.4).abs() < 1e-6), "of one boldness");
}

#[test]
fn an_area_of_two_classes_keeps_them_and_is_told() {
    let two = ["bbbbbb", "brrbbb", "brrbbb", "bbbbbb"];
    let mut sorted = classes(&two);
    let mixed = unify_areas(&mut sorted, &areas(&["000000", "011110", "011110", "000000"]), [2.0, 1.0], false);
    assert_eq!((rows(&sorted), mixed), (two.map(str::to_owned).to_vec(), vec![1]));
}

#[test]
fn a_part_with_room_for_a_texture_keeps_its_class_and_is_told() {
    // seven tenths blue
    let two = ["bbbbbbbrrr"; 4];
    let of = |min_cells: f32, narrowest: f32| {
        let mut sorted = classes(&two);
        let mixed = unify_areas(&mut sorted, &areas(&["1111111111"; 4]), [min_cells, narrowest], false);
        (rows(&sorted), mixed)
    };
    assert_eq!(of(10.0, 3.0), (two.map(str::to_owned).to_vec(), vec![1]));
    let one = vec!["bbbbbbbbbb".to_owned(); 4];
    assert_eq!(of(13.0, 3.0), (one.clone(), vec![]), "smaller than a texture");
    assert_eq!(of(10.0, 7.0), (one.clone(), vec![]), "too narrow for one");
    let mut sorted = classes(&two);
    let mixed = unify_areas(&mut sorted, &areas(&["1111111111"; 4]), [10.0, 3.0], true);
    assert_eq!((rows(&sorted), mixed), (one, vec![]), "on a field of pins");
}

#[test]
fn a_class_that_holds_an_area_and_is_narrow_all_over_still_has_it() {
    let ground = "..........";
    let (full, holed) = (".bbbbbbbb.", ".bbrrrrbb.");
    let mut sorted = classes(&[ground, full, full, holed, holed, holed, holed, full, full, ground]);
    let (outside, inside) = ("0000000000", "0111111110");
    let mut area = [inside; 10];
    (area[0], area[9]) = (outside, outside);
    assert_eq!(unify_areas(&mut sorted, &areas(&area), [10.0, 4.0], false), [0_usize; 0]);
    let mut all = [full; 10];
    (all[0], all[9]) = (ground, ground);
    assert_eq!(rows(&sorted), all);
}

#[test]
fn a_crumb_joins_its_own_side() {
    // three red cells beyond the outline, fewer than the least
    let mut sorted = classes(&["rrrr......", "rrrrrrr...", "rrrr......", "rrrr......"]);
    let area = areas(&["1111000000", "1111000000", "1111000000", "1111000000"]);
    assert_eq!(unify_areas(&mut sorted, &area, [4.0, 1.0], false), [0_usize; 0]);
    assert_eq!(rows(&sorted), ["rrrr......"; 4]);
}

#[test]
fn stripes_that_are_too_narrow_for_a_texture_become_one_area() {
    let of = |stripes: &str, area: &str, narrowest: f32| {
        let mut sorted = classes(&[stripes; 6]);
        assert_eq!(unify_areas(&mut sorted, &areas(&[area; 6]), [2.0, narrowest], false), [0_usize; 0]);
        let rows = rows(&sorted);
        assert!(rows.iter().all(|row| *row == rows[0]), "{rows:?}");
        rows[0].clone()
    };
    let stripes = "bbbrrbbbrrbbb";
    assert_eq!(of(stripes, "0000000000000", 4.0), "bbbbbbbbbbbbb", "the broader ones win");
    assert_eq!(of(stripes, "0000000000000", 2.0), stripes, "all have room");
    assert_eq!(of("bbbbbbbrrrrrr", "0000000000000", 4.0), "bbbbbbbrrrrrr", "two halves");
    assert_eq!(of("rrrrbbrrrr", "1111002222", 4.0), "rrrrbbrrrr", "between outlines it has no neighbour");
}
