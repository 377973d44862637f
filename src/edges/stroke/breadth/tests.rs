//! Tests of `breadth`.

use super::*;
use crate::units::Size;

/// A wall that is 8 px broad up to 80 px, and from its end on a leaf that is 2 px broad, 50 px down; the line that
/// thinning made of both.
fn wall_and_leaf(broad: usize) -> (Plane, Strand) {
    let size = Size::new(120, 120);
    let is_ink = |x: usize, y: usize| {
        (10..80).contains(&x) && (20..20 + broad).contains(&y) || (76..78).contains(&x) && (20..78).contains(&y)
    };
    let values = (0..size.len()).map(|cell| if is_ink(cell % 120, cell / 120) { 60.0 } else { 0.0 }).collect();
    let middle = 20.0 + 0.5 * broad as f32;
    let along = (0..67).map(|k| PxPoint::new(10.0 + k as f32, middle));
    let down = (0..(78 - middle as usize)).map(|k| PxPoint::new(77.0, middle + k as f32));
    let line = Polyline::open(along.chain(down).collect());
    (Plane { size, values }, Strand { line, free: [true, true], junctions: vec![PxPoint::new(77.0, middle)] })
}

#[test]
fn the_leaf_of_a_door_is_no_part_of_the_wall_at_whose_end_it_stands() {
    let (plane, strand) = wall_and_leaf(8);
    let parts = parts(strand.clone(), &plane, 6);
    let [wall, leaf] = &parts[..] else { panic!("{} parts", parts.len()) };
    assert_eq!([wall.is_broad, leaf.is_broad], [true, false]);
    let (wall, leaf) = (&wall.strand, &leaf.strand);
    assert_eq!([wall.free, leaf.free], [[true, true], [false, true]]);
    let last = wall.line.vertices[wall.line.vertices.len() - 1];
    assert!(last.x > 60.0 && (last.y - 24.0).abs() < 1e-3, "the wall ends at {last:?}");
    let first = leaf.line.vertices[0];
    assert!((first.x - 77.0).abs() < 1e-3 && (26.0..36.0).contains(&first.y), "the leaf begins at {first:?}");
    // one wall is no plan
    assert_eq!(parted(vec![strand.clone()], &plane, 6), [strand]);
}

#[test]
fn walls_without_a_door_are_walls_beside_one_that_has_one() {
    let with_walls_of = |broad: usize| {
        let (mut plane, strand) = wall_and_leaf(8);
        for (x, y) in (0..120).flat_map(|y| (0..120).map(move |x| (x, y))) {
            if (100..100 + broad).contains(&x) && y < 100 || x < 100 && (105..105 + broad).contains(&y) {
                plane.values[120 * y + x] = 60.0;
            }
        }
        let middle = 0.5 * broad as f32;
        let right = (10..90).map(|y| PxPoint::new(100.0 + middle, y as f32 + 0.5));
        let below = (10..90).map(|x| PxPoint::new(x as f32 + 0.5, 105.0 + middle));
        let whole = |line| Strand { line, free: [true, true], junctions: Vec::new() };
        let others = [right.collect(), below.collect()].map(|vertices| whole(Polyline::open(vertices)));
        parted(others.into_iter().chain([strand]).collect(), &plane, 6)
    };
    assert_eq!(with_walls_of(8).len(), 4, "the leaf is a line of its own");
    assert_eq!(with_walls_of(3).len(), 3, "of one wall and thin lines");
}

#[test]
fn a_stroke_of_one_breadth_is_one() {
    for broad in [2, 3] {
        let (plane, strand) = wall_and_leaf(broad);
        let parts = parts(strand.clone(), &plane, 6);
        assert!(parts.len() == 1 && parts[0].strand == strand && !parts[0].is_broad, "{broad} px");
    }
}

#[test]
fn parts_have_to_be_long_and_even() {
    let number = |widths: &[f32], closed: bool| plateaus(widths, closed, 4.0).map_or(1, |parts| parts.len());
    let of = |parts: &[(usize, f32)]| parts.iter().flat_map(|&(count, width)| vec![width; count]).collect::<Vec<f32>>();
    assert_eq!(number(&of(&[(20, 8.0), (20, 2.0)]), false), 2);
    assert_eq!(number(&of(&[(20, 8.0), (20, 2.0), (20, 8.0)]), false), 3);
    assert_eq!(number(&of(&[(20, 8.0), (20, 2.0), (20, 8.0)]), true), 2, "round a ring");
    assert_eq!(number(&of(&[(40, 2.0), (3, 8.0), (40, 2.0)]), false), 1, "a blot where another one crosses");
    assert_eq!(number(&of(&[(40, 8.0), (3, 2.0), (40, 8.0)]), false), 1, "a notch");
    assert_eq!(number(&of(&[(20, 3.0), (20, 1.4)]), false), 1, "none is broad");
    let river: Vec<f32> = (0..40).map(|k| 2.0 + 0.2 * k as f32).collect();
    assert_eq!(number(&river, false), 1, "it becomes wider little by little");
}
