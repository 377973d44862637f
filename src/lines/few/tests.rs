//! Tests of `few`.

use super::*;
use crate::lines::outlines::Rank;
use crate::units::MmPoint;

fn line(rank: Rank, length: f32) -> Cleared {
    let vertex = |x: f32| Vertex { at: MmPoint::new(x, 10.0), ..Vertex::TEST };
    let polyline = Polyline::open(vec![vertex(10.0), vertex(10.0 + length)]);
    Cleared { polyline, saliency: 1.0, rank, anchored: vec![false; 2] }
}

#[test]
fn beside_outlines_stay_the_first_lines_that_are_long_enough() {
    let kept = |lines: &[(Rank, f32)], others| {
        let outlines = Outlines { outlines: Vec::new(), subjects: 0, shapes: 0, others };
        let mut cleared: Vec<Cleared> = lines.iter().map(|&(rank, length)| line(rank, length)).collect();
        keep_beside_outlines(&mut cleared, &outlines);
        cleared.iter().map(|line| line.polyline.length()).collect::<Vec<_>>()
    };
    let (outline, other) = (Rank::Outline, Rank::Ordinary);
    let lines = [(outline, 3.0), (other, 30.0), (other, 2.0), (other, 20.0), (other, 25.0), (outline, 4.0)];
    assert_eq!(kept(&lines, Some((2, 10.0))), [3.0, 30.0, 20.0, 4.0]);
    assert_eq!(kept(&lines, None), lines.map(|(_, length)| length));
    assert_eq!(kept(&lines[1..5], Some((2, 10.0))), [30.0, 2.0, 20.0, 25.0], "there are no outlines");
}
