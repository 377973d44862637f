//! Tests of `subject`.

use super::super::grid::RegionGrid;
use super::super::tree::Detail;
use super::*;
use crate::raster::plane::Plane;
use crate::units::Size;

/// Half a millimetre for a pixel.
const MM_PER_PX: f32 = 0.5;

/// A disc: its middle, its radius, px, and its lightness.
type Disc = (f32, f32, f32, f32);

/// The regions of a picture of 120 x 90 pixels, with discs on a dark ground, the last on top.
fn tree(discs: &[Disc]) -> Tree {
    let size = Size::new(120, 90);
    let lightness = |cell: usize| {
        let (x, y) = ((cell % 120) as f32 + 0.5, (cell / 120) as f32 + 0.5);
        let above = discs.iter().rev().find(|(a, b, radius, _)| (x - a).hypot(y - b) < *radius);
        above.map_or(20.0, |(.., lightness)| *lightness)
    };
    let traces: Vec<_> = discs.iter().map(|(x, y, radius, _)| ring(*x, *y, *radius)).collect();
    let plane = Plane { size, values: (0..size.len()).map(lightness).collect() };
    Tree::new(&traces, &[plane], RegionGrid::new(size), Detail::OUTLINES)
}

fn ring(x: f32, y: f32, radius: f32) -> crate::regions::TracedContour {
    let at = |i: u32| (i as f32 / radius).sin_cos();
    let count = (std::f32::consts::TAU * radius) as u32;
    let point = |(sin, cos): (f32, f32)| PxPoint::new(x + radius * cos, y + radius * sin);
    let vertices = (0..count).map(at).map(point).map(|at| crate::regions::TracePoint { at, strength: 40.0 });
    crate::regions::TracedContour { vertices: vertices.collect(), closed: true }
}

/// How many cells the subject at a place has, where these regions were chosen; none if nothing is there.
fn cells_at(tree: &Tree, at: (f32, f32), chosen: &[u32]) -> Option<usize> {
    let subject = tree.subject_at(PxPoint::new(at.0, at.1), MM_PER_PX, chosen)?;
    Some(tree.mask(&[subject]).cells())
}

/// Whether a disc of this radius has so many cells, but for some along its border.
fn is_disc(cells: usize, radius: f32) -> bool {
    (cells as f32 / (std::f32::consts::PI * radius * radius) - 1.0).abs() < 0.15
}

#[test]
fn a_place_names_the_smallest_clear_thing_around_it() {
    let tree = tree(&[(60.0, 45.0, 32.0, 60.0), (50.0, 45.0, 12.0, 95.0)]);
    let inner = cells_at(&tree, (50.0, 45.0), &[]).expect("the small disc");
    assert!(is_disc(inner, 12.0), "{inner} cells");
    let outer = cells_at(&tree, (80.0, 45.0), &[]).expect("the large disc");
    assert!(outer > 3 * inner, "{outer} cells");
}

#[test]
fn a_place_names_the_same_thing_as_if_all_regions_around_it_were_opened() {
    let tree = tree(&[(60.0, 45.0, 32.0, 60.0), (50.0, 45.0, 12.0, 95.0)]);
    let mm_per_cell = tree.mm_of_cell(MM_PER_PX);
    let plainly = |at: PxPoint| {
        let basin = tree.basin[tree.grid.cell_at(tree.grid.to_cells(at))?];
        let of = |node: u32| saliency(&tree.nodes[node as usize], tree.basin.len(), mm_per_cell);
        let may_be =
            |node: &u32| tree.has(*node, basin) && of(*node) > 0.0 && survives_opening(&tree, *node, mm_per_cell);
        let around: Vec<u32> = (0..tree.nodes.len() as u32).filter(may_be).collect();
        let best = around.iter().map(|node| of(*node)).fold(0.0, f64::max);
        around.into_iter().find(|node| of(*node) >= SALIENT * best)
    };
    let places: Vec<PxPoint> = (0..12_u8)
        .flat_map(|x| (0..9_u8).map(move |y| (x, y)))
        .map(|(x, y)| PxPoint::new(10.0 * f32::from(x), 10.0 * f32::from(y) + 5.0))
        .collect();
    let found: Vec<Option<u32>> = places.iter().map(|at| tree.subject_at(*at, MM_PER_PX, &[])).collect();
    assert_eq!(found, places.iter().map(|at| plainly(*at)).collect::<Vec<_>>());
    let named: std::collections::BTreeSet<u32> = found.into_iter().flatten().collect();
    assert!(named.len() > 1, "{named:?}: the small disc and the large one");
}

#[test]
fn on_the_ground_there_is_no_subject() {
    let tree = tree(&[(30.0, 45.0, 16.0, 80.0)]);
    assert!(cells_at(&tree, (30.0, 45.0), &[]).is_some_and(|cells| is_disc(cells, 16.0)));
    assert_eq!(cells_at(&tree, (100.0, 45.0), &[]), None);
}

#[test]
fn what_was_chosen_for_an_outline_comes_before_a_smaller_thing() {
    let tree = tree(&[(60.0, 45.0, 32.0, 60.0), (50.0, 45.0, 12.0, 95.0)]);
    // whatever else it was merged from
    let large = (0..).zip(&tree.nodes).find(|(region, node)| {
        is_disc(node.area as usize, 32.0) && tree.mask(&[*region]).contains(PxPoint::new(50.0, 45.0))
    });
    let (large, _) = large.expect("the large disc");
    let cells = |chosen: &[u32]| cells_at(&tree, (50.0, 45.0), chosen).expect("one of them");
    assert!(is_disc(cells(&[]), 12.0) && is_disc(cells(&[large]), 32.0), "{} {}", cells(&[]), cells(&[large]));
}

#[test]
fn a_part_of_the_picture_in_another_size_is_like_the_region_that_it_is() {
    let tree = tree(&[(60.0, 45.0, 32.0, 60.0), (50.0, 45.0, 12.0, 95.0)]);
    let of_disc = |(x, y): (f32, f32), radius: f32| {
        let at = |i: u16| (f32::from(i) * 0.1).sin_cos();
        let ring: Vec<PxPoint> = (0..63)
            .map(at)
            .map(|(sin, cos)| PxPoint::new(3.0 * (x + radius * cos), 3.0 * (y + radius * sin)))
            .collect();
        // three times as large
        Mask::of_ring(RegionGrid::new(Size::new(360, 270)), &ring)
    };
    for (middle, radius) in [((60.0, 45.0), 32.0), ((50.0, 45.0), 12.0)] {
        let like = tree.most_like(&of_disc(middle, radius)).expect("a disc");
        assert!(is_disc(tree.mask(&[like]).cells(), radius), "{radius}: {} cells", tree.mask(&[like]).cells());
    }
    assert_eq!(tree.most_like(&of_disc((500.0, 500.0), 10.0)), None, "beside the picture");
}

#[test]
fn a_mask_of_two_regions_has_the_cells_of_both() {
    let tree = tree(&[(30.0, 45.0, 16.0, 80.0), (90.0, 45.0, 12.0, 80.0)]);
    let region = |x: f32| tree.subject_at(PxPoint::new(x, 45.0), MM_PER_PX, &[]).expect("a disc");
    let cells = |regions: &[u32]| tree.mask(regions).cells();
    let [a, b] = [region(30.0), region(90.0)];
    assert_eq!(cells(&[a, b]), cells(&[a]) + cells(&[b]));
    assert_eq!(cells(&[]), 0);
}

#[test]
fn a_thing_has_its_share_of_the_picture_and_lies_away_from_its_edge() {
    let tree = tree(&[(60.0, 45.0, 32.0, 60.0)]);
    let disc = tree.subject_at(PxPoint::new(60.0, 45.0), MM_PER_PX, &[]).expect("the disc");
    // three tenths of the picture
    assert_eq!([0.2, 0.4].map(|least| tree.is_thing(disc, [least, 0.0])), [true, false]);
    let whole = tree.nodes.len() as u32 - 1;
    assert_eq!([0.25, 1.01].map(|on_edge| tree.is_thing(whole, [0.2, on_edge])), [false, true]);
}
