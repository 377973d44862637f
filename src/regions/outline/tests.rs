//! Outlines of regions: which are chosen, and that neighbours share one border.

use super::super::tree::Detail;
use super::*;
use crate::raster::plane::Plane;
use crate::regions::RegionGrid;

const PARAMS: Params =
    Params { most: 8, drawn: None, least_gain: 0.1, most_near: 0.3, spacing: 4.0, narrowest: 4.0, smoothing: 0.6 };

/// A trace through points, a pixel apart.
fn trace(points: &[(f32, f32)], closed: bool) -> TracedContour {
    let point = |&(x, y): &(f32, f32)| PxPoint::new(x, y);
    let corners: Vec<PxPoint> = points.iter().map(point).collect();
    let line = Polyline { vertices: corners, closed }.resampled(1.0);
    let point = |at| TracePoint { at, strength: 40.0 };
    Polyline { vertices: line.vertices.into_iter().map(point).collect(), closed }
}

/// The outlines in a picture of 120 x 90 pixels, half a millimetre each, that is light where `is_light`.
fn outlines(traces: &[TracedContour], lightness: impl Fn(f32, f32) -> f32) -> Vec<TracedContour> {
    let size = Size::new(120, 90);
    let at = |cell: usize| ((cell % 120) as f32 + 0.5, (cell / 120) as f32 + 0.5);
    let values = (0..size.len()).map(at).map(|(x, y)| lightness(x, y)).collect();
    let tree = Tree::new(traces, &[Plane { size, values }], RegionGrid::new(size), Detail::OUTLINES);
    contours(outlined(&tree, &PARAMS, &[], &[]).0)
}

/// The outlines of the regions that a tree chooses, half a millimetre for a pixel.
fn outlined(tree: &Tree, params: &Params, subjects: &[u32], preferred: &[u32]) -> (Vec<RegionOutline>, OutlineAreas) {
    tree.outlines(0.5, params, &tree.chosen(0.5, params, subjects, preferred))
}

fn contours(outlines: Vec<RegionOutline>) -> Vec<TracedContour> {
    outlines.into_iter().map(|outline| outline.contour).collect()
}

fn circle(x: f32, y: f32, radius: f32) -> TracedContour {
    let count = (6.0 * radius) as usize;
    let angle = |i: usize| i as f32 * std::f32::consts::TAU / count as f32;
    let points: Vec<_> = (0..count).map(|i| (x + radius * angle(i).cos(), y + radius * angle(i).sin())).collect();
    trace(&points, true)
}

#[test]
fn a_disc_has_one_ring_where_its_trace_runs() {
    let outlines =
        outlines(&[circle(60.0, 45.0, 20.0)], |x, y| if (x - 60.0).hypot(y - 45.0) < 20.0 { 80.0 } else { 20.0 });
    let [ring] = &outlines[..] else { panic!("{} outlines", outlines.len()) };
    assert!(ring.closed && (ring.length() - 125.6).abs() < 3.0, "{}", ring.length());
    assert!(ring.vertices.iter().all(|v| ((v.at - PxPoint::new(60.0, 45.0)).length() - 20.0).abs() < 1.0));
    assert!(ring.vertices.iter().all(|v| (v.strength - 38.0).abs() < 3.0), "{:?}", ring.vertices[0]);
}

#[test]
fn a_gap_in_the_trace_does_not_open_the_outline() {
    let whole = circle(60.0, 45.0, 20.0);
    let broken = Polyline::open(whole.vertices[6..whole.vertices.len() - 6].to_vec());
    let outlines = outlines(&[broken], |x, y| if (x - 60.0).hypot(y - 45.0) < 20.0 { 60.0 } else { 40.0 });
    assert!(outlines.iter().any(|outline| outline.closed && outline.length() > 115.0));
}

#[test]
fn two_neighbours_share_a_border() {
    let traces = [
        trace(&[(20.0, 20.0), (100.0, 20.0), (100.0, 70.0), (20.0, 70.0)], true),
        trace(&[(60.0, 20.0), (60.0, 70.0)], false),
    ];
    let outlines = outlines(&traces, |x, y| match (x, y) {
        _ if !((20.0..100.0).contains(&x) && (20.0..70.0).contains(&y)) => 50.0,
        _ if x < 60.0 => 10.0,
        _ => 95.0,
    });
    let length: f32 = outlines.iter().map(Polyline::length).sum();
    assert!(outlines.len() == 2 && (length - 310.0).abs() < 14.0, "{} with {length} px", outlines.len());
    let closed: Vec<&TracedContour> = outlines.iter().filter(|outline| outline.closed).collect();
    let open: Vec<&TracedContour> = outlines.iter().filter(|outline| !outline.closed).collect();
    let ([ring], [rest]) = (&closed[..], &open[..]) else { panic!("a ring and what is left of the other") };
    for end in [rest.vertices[0].at, rest.vertices[rest.vertices.len() - 1].at] {
        let near = ring.vertices.iter().map(|v| (v.at - end).length()).fold(f32::MAX, f32::min);
        assert!(near < 0.6, "an end lies {near} px from the ring");
    }
}

#[test]
fn a_subject_is_the_smallest_salient_region_and_comes_first() {
    // a small square in a large one; the small one is paler than the large one is dark
    let (large, small) = ((20.0..100.0, 10.0..80.0), (30.0..50.0, 30.0..50.0));
    let square = |(x, y): &(std::ops::Range<f32>, std::ops::Range<f32>)| {
        trace(&[(x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end)], true)
    };
    let size = Size::new(120, 90);
    let lightness = |cell: usize| {
        let (x, y) = ((cell % 120) as f32 + 0.5, (cell / 120) as f32 + 0.5);
        let is_in =
            |(across, down): &(std::ops::Range<f32>, std::ops::Range<f32>)| across.contains(&x) && down.contains(&y);
        if is_in(&small) {
            60.0
        } else if is_in(&large) {
            10.0
        } else {
            95.0
        }
    };
    let plane = Plane { size, values: (0..size.len()).map(lightness).collect() };
    let tree = Tree::new(&[square(&large), square(&small)], &[plane], RegionGrid::new(size), Detail::OUTLINES);
    let one = Params { most: 1, ..PARAMS };
    let most_salient = tree.most_salient(0.5, &one);
    let cells = |x: f32, y: f32| {
        let subject = tree.subject_at(PxPoint::new(x, y), 0.5, &most_salient).expect("something is there");
        (subject, tree.mask(&[subject]).cells() as f32)
    };
    let (inner, area) = cells(40.0, 40.0);
    assert!((area / 400.0 - 1.0).abs() < 0.15, "{area}");
    let (_, area) = cells(80.0, 60.0);
    assert!(area > 4500.0, "{area}");
    assert_eq!(tree.subject_at(PxPoint::new(500.0, 40.0), 0.5, &most_salient), None, "beyond the picture");
    let area_of = |outlines: Vec<TracedContour>| outlines.iter().map(Polyline::length).sum::<f32>();
    assert!(area_of(contours(outlined(&tree, &one, &[], &[]).0)) > 250.0, "the large one tells most");
    let (outlines, _) = outlined(&tree, &one, &[inner], &[]);
    assert!((60.0..90.0).contains(&area_of(contours(outlines))), "the subject comes first");
}

#[test]
fn of_two_discs_the_larger_is_drawn_where_there_is_to_be_one() {
    let size = Size::new(120, 90);
    let discs = [(35.0, 45.0, 16.0), (90.0, 45.0, 10.0)];
    let is_in = |cell: usize| {
        let (x, y) = ((cell % 120) as f32 + 0.5, (cell / 120) as f32 + 0.5);
        discs.iter().any(|(a, b, radius)| (x - a).hypot(y - b) < *radius)
    };
    let plane = Plane { size, values: (0..size.len()).map(|cell| if is_in(cell) { 80.0 } else { 20.0 }).collect() };
    let tree =
        Tree::new(&discs.map(|(x, y, radius)| circle(x, y, radius)), &[plane], RegionGrid::new(size), Detail::OUTLINES);
    let places = [(35.0, 45.0), (90.0, 45.0), (5.0, 5.0)].map(|(x, y)| PxPoint::new(x, y));
    let (two, areas) = outlined(&tree, &PARAMS, &[], &[]);
    assert_eq!((two.len(), areas.count(), areas.beyond()), (2, 2, 0));
    assert_eq!(places.map(|at| areas.at(at)), [1, 2, 0]);
    let (one, areas) = outlined(&tree, &Params { drawn: Some(1), ..PARAMS }, &[], &[]);
    assert_eq!((one.len(), areas.count(), areas.beyond()), (1, 1, 1));
    assert_eq!(places.map(|at| areas.at(at)), [1, 0, 0]);
    let small = tree.subject_at(places[1], 0.5, &tree.most_salient(0.5, &PARAMS)).expect("a disc is there");
    let large = tree.subject_at(places[0], 0.5, &tree.most_salient(0.5, &PARAMS)).expect("a disc is there");
    let (both, areas) = outlined(&tree, &Params { drawn: Some(1), ..PARAMS }, &[small, large], &[]);
    assert_eq!((both.len(), areas.beyond()), (2, 0), "no subject is beyond the most");
    let (two, areas) = outlined(&tree, &PARAMS, &[], &[small]);
    assert_eq!((two.len(), places.map(|at| areas.at(at))), (2, [2, 1, 0]), "what the figure has comes first");
    assert_eq!(two.iter().map(|outline| outline.region).collect::<Vec<_>>(), [0, 1]);
}

#[test]
fn what_is_as_thin_as_a_stroke_is_no_region() {
    let strip = |width: f32| {
        let (left, right) = (60.0 - 0.5 * width, 60.0 + 0.5 * width);
        let traces = [trace(&[(left, 15.0), (right, 15.0), (right, 75.0), (left, 75.0)], true)];
        let is_light = |x: f32, y: f32| (left..right).contains(&x) && (15.0..75.0).contains(&y);
        outlines(&traces, |x, y| if is_light(x, y) { 90.0 } else { 20.0 })
    };
    assert_eq!(strip(4.0), [], "2 mm wide");
    assert!(strip(20.0).iter().any(|outline| outline.closed && outline.length() > 140.0), "10 mm wide");
}

#[test]
fn a_leap_from_one_trace_to_another_becomes_a_slope() {
    let at = |x: usize| PxPoint::new(x as f32, if x < 20 { 0.0 } else { 3.0 });
    let steepest = |vertices: Vec<PxPoint>, closed: bool| {
        let line = Polyline { vertices, closed };
        let smoothed = smoothed(&line, &vec![[1.0]; line.vertices.len()], 1.2);
        smoothed.windows(2).map(|pair| (pair[1].y - pair[0].y).abs()).fold(0.0, f32::max)
    };
    let leap: Vec<PxPoint> = (0..40).map(at).collect();
    assert!(steepest(leap.clone(), false) < 1.8, "{}", steepest(leap, false));
    // back along a line far below, so that it is a ring with leaps at its ends
    let ring: Vec<PxPoint> = (10..30).map(at).chain((10..30).rev().map(|x| PxPoint::new(x as f32, 5.0))).collect();
    assert!(steepest(ring.clone(), true) < 1.8, "{}", steepest(ring, true));
}

#[test]
fn only_leaps_count_as_shorter_than_they_are() {
    let are_near = |a: &[f32], b: &[f32]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5);
    let vertices: Vec<PxPoint> = (0..30).map(|i| PxPoint::new(0.7 * i as f32, (0.9 * i as f32).sin())).collect();
    let line = Polyline::open(vertices);
    assert!(are_near(&arcs_without_leaps(&line), &line.arc_lengths()));
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 4.0), (0.0, 4.0)].map(|(x, y)| PxPoint::new(x, y));
    let ring = Polyline { vertices: square.to_vec(), closed: true };
    assert!(are_near(&arcs_without_leaps(&ring), &[0.0, 1.0, 2.5, 3.5, 5.0]));
}
