//! Tests of `paper_edge`.

use super::*;
use crate::edges::ChainKind;
use crate::units::Size;

/// A straight contour, of a stroke or of a border with this contrast of lightness to its right.
fn line(edges: &mut Edges, ends: [[f32; 2]; 2], stroke: Option<f32>, to_right: f32) {
    let [from, to] = ends.map(|[x, y]| PxPoint::new(x, y));
    let edgel = |step: u8| {
        let at = from.lerp(to, f32::from(step) / 100.0);
        Edgel { at, strength: 10.0, contrast: [to_right, 0.0, 0.0] }
    };
    edges.push_as(ChainKind { stroke, of_drawing: true, ..ChainKind::default() }, (0..=100).map(edgel), false);
}

/// A scan with a drawn line in it and these edges of its paper: on the left, above, on the right.
fn scan(sides: [bool; 3], to_right: f32) -> Edges {
    let mut edges = Edges::none(Size::new(800, 1000));
    line(&mut edges, [[100.0, 100.0], [700.0, 110.0]], Some(4.0), 0.0);
    // the picture lies to the right of one that goes up on its left, and so on around
    let all = [[[20.0, 980.0], [40.0, 20.0]], [[40.0, 20.0], [780.0, 35.0]], [[780.0, 35.0], [770.0, 500.0]]];
    for (ends, _) in all.into_iter().zip(sides).filter(|(_, is_there)| *is_there) {
        line(&mut edges, ends, None, to_right);
    }
    edges
}

fn left(mut edges: Edges) -> (usize, Option<String>) {
    let told = taken_out(&mut edges, &Given::default(), true);
    (edges.chains.len(), told.map(|note| note.to_string()))
}

#[test]
fn the_edges_of_the_paper_of_a_scan_are_no_lines() {
    let (chains, told) = left(scan([true; 3], 5.0));
    let told = told.expect("a note");
    assert!(chains == 1 && told.contains("the edges of the paper along the sides of the scan (3 lines)"), "{told}");
    assert_eq!(left(scan([true, true, false], 5.0)).0, 1);
    let mut edges = scan([true; 3], 5.0);
    assert_eq!((taken_out(&mut edges, &Given::default(), false), edges.chains.len()), (None, 4), "no scan on paper");
}

#[test]
fn what_is_no_edge_of_the_paper_stays() {
    assert_eq!(left(scan([true, false, true], 5.0)), (3, None), "two sides that are no neighbours");
    assert_eq!(left(scan([true; 3], -5.0)), (4, None), "an area that is darker than what is around it");
    let mut edges = scan([true; 3], 5.0);
    line(&mut edges, [[100.0, 5.0], [300.0, 5.0]], Some(4.0), 0.0);
    line(&mut edges, [[5.0, 200.0], [5.0, 300.0]], Some(4.0), 0.0);
    assert_eq!(left(edges), (6, None), "something is drawn beyond two of them");
}
