//! Tests of the main thing of a picture.

use super::super::Params;
use super::super::grid::RegionGrid;
use super::super::trace::{TracePoint, TracedContour};
use super::super::tree::Detail;
use super::*;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, Size};

/// A disc: its middle and radius, px, and its lightness.
pub(in crate::regions) type Disc = (f32, f32, f32, f32);

pub(in crate::regions) const PARAMS: Params =
    Params { most: 8, drawn: None, least_gain: 0.2, most_near: 0.3, spacing: 4.0, narrowest: 4.0, smoothing: 0.6 };

/// The regions of a picture of 180 x 120 pixels, with discs on a dark ground.
pub(in crate::regions) fn tree(discs: &[Disc]) -> Tree {
    let size = Size::new(180, 120);
    let lightness = |cell: usize| {
        let (x, y) = ((cell % 180) as f32 + 0.5, (cell / 180) as f32 + 0.5);
        let above = discs.iter().find(|(a, b, radius, _)| (x - a).hypot(y - b) < *radius);
        above.map_or(20.0, |(.., lightness)| *lightness)
    };
    let ring = |&(x, y, radius, lightness): &Disc| {
        let points = (0..(std::f32::consts::TAU * radius) as u32).map(|i| (i as f32 / radius).sin_cos());
        let point = |(sin, cos): (f32, f32)| PxPoint::new(x + radius * cos, y + radius * sin);
        let vertices = points.map(point).map(|at| TracePoint { at, strength: lightness - 20.0 });
        TracedContour { vertices: vertices.collect(), closed: true }
    };
    let traces: Vec<TracedContour> = discs.iter().map(ring).collect();
    let plane = Plane { size, values: (0..size.len()).map(lightness).collect() };
    Tree::new(&traces, &[plane], RegionGrid::new(size), Detail::OUTLINES)
}

/// Whether a region has most of the cells of a disc, and few others.
fn is_disc(tree: &Tree, region: u32, (x, y, radius, _): Disc) -> bool {
    let mask = tree.mask(&[region]);
    let area = std::f32::consts::PI * radius * radius;
    mask.contains(PxPoint::new(x, y)) && (mask.cells() as f32 / area - 1.0).abs() < 0.2
}

const IN_THE_MIDDLE: Disc = (85.0, 62.0, 20.0, 45.0);
const AT_THE_EDGE: Disc = (0.0, 60.0, 36.0, 95.0);
const IN_A_CORNER: Disc = (150.0, 26.0, 18.0, 95.0);

#[test]
fn what_is_in_the_middle_is_the_main_thing_though_others_tell_more() {
    let tree = tree(&[AT_THE_EDGE, IN_A_CORNER, IN_THE_MIDDLE]);
    let main = tree.main_thing(0.5, &PARAMS).expect("there is one");
    assert!(is_disc(&tree, main, IN_THE_MIDDLE));
    let most_salient = tree.chosen(0.5, &PARAMS, &[], &[]).regions[0];
    assert!(!is_disc(&tree, most_salient, IN_THE_MIDDLE), "the others are lighter");
}

#[test]
fn it_comes_first_where_there_are_to_be_few() {
    let tree = tree(&[AT_THE_EDGE, IN_A_CORNER, IN_THE_MIDDLE]);
    let main = tree.main_thing(0.5, &PARAMS).expect("there is one");
    let chosen = tree.chosen(0.5, &Params { drawn: Some(1), ..PARAMS }, &[main], &[]);
    assert_eq!((chosen.regions, chosen.beyond), (vec![main], 2));
}

#[test]
fn what_the_frame_cuts_off_is_not_the_main_thing() {
    assert_eq!(tree(&[AT_THE_EDGE]).main_thing(0.5, &PARAMS), None);
}

#[test]
fn what_tells_little_beside_others_is_not_the_main_thing() {
    let faint = (85.0, 62.0, 8.0, 26.0);
    let tree = tree(&[AT_THE_EDGE, IN_A_CORNER, faint]);
    let main = tree.main_thing(0.5, &PARAMS).expect("there is one");
    assert!(is_disc(&tree, main, IN_A_CORNER));
}
