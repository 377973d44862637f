//! Tests of `arms`.

use super::*;

/// Pixels from the junction at 0, 0 to a free end in a direction, x right and y down.
fn arm([dx, dy]: [f32; 2], pixels: usize) -> SkeletonPath {
    let points = (1..=pixels).map(|i| PxPoint::new(dx * i as f32, dy * i as f32)).collect();
    SkeletonPath { points, nodes: [Some(0), None], closed: false }
}

fn joined_at(arms: Vec<SkeletonPath>, depth: f32) -> Vec<Strand> {
    joined(arms, &[SkeletonNode { at: PxPoint::zero(), depth }])
}

/// The free ends of each line.
fn ends(strands: &[Strand]) -> Vec<[[i32; 2]; 2]> {
    let pixel = |at: PxPoint| [at.x.round() as i32, at.y.round() as i32];
    let of = |strand: &Strand| {
        let points = &strand.line.vertices;
        let mut ends = [pixel(points[0]), pixel(points[points.len() - 1])];
        ends.sort_unstable();
        ends
    };
    let mut all: Vec<_> = strands.iter().map(of).collect();
    all.sort_unstable();
    all
}

#[test]
fn straight_arms_go_on_through_a_junction_and_the_third_ends_there() {
    let strands = joined_at(vec![arm([1.0, 0.0], 20), arm([0.0, 1.0], 20), arm([-1.0, 0.0], 20)], 1.0);
    assert_eq!(ends(&strands), [[[-20, 0], [20, 0]], [[0, 0], [0, 20]]]);
    let through = strands.iter().find(|strand| !strand.junctions.is_empty()).expect("the straight one");
    assert_eq!((through.junctions.len(), through.free), (1, [true, true]));
    let branch = strands.iter().find(|strand| strand.junctions.is_empty()).expect("the third");
    assert_eq!(branch.free.iter().filter(|free| **free).count(), 1);
}

#[test]
fn a_crossing_is_two_lines() {
    let arms = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(|to| arm(to, 15)).to_vec();
    assert_eq!(ends(&joined_at(arms, 1.0)), [[[-15, 0], [15, 0]], [[0, -15], [0, 15]]]);
}

#[test]
fn a_spur_goes_and_what_is_longer_stays() {
    // 3 px and one and a half of the half width 2
    for (pixels, lines) in [(6, 1), (7, 2)] {
        let strands = joined_at(vec![arm([1.0, 0.0], 20), arm([-1.0, 0.0], 20), arm([0.0, 1.0], pixels)], 2.0);
        assert_eq!(strands.len(), lines, "{pixels} px");
    }
}

#[test]
fn a_spur_to_the_tip_of_a_sharp_corner_may_be_longer() {
    let sides = || vec![arm([0.966, 0.259], 30), arm([0.966, -0.259], 30)];
    // 2.5 half widths over the sine of 15 degrees, and 3 px: 22
    for (to, lines) in [([-1.0, 0.0], 1), ([0.0, -1.0], 3)] {
        let strands = joined_at([sides(), vec![arm(to, 20)]].concat(), 2.0);
        assert_eq!(strands.len(), lines, "to {to:?}");
    }
    assert_eq!(joined_at([sides(), vec![arm([-1.0, 0.0], 24)]].concat(), 2.0).len(), 2);
}

#[test]
fn a_ring_through_its_junction_is_closed() {
    let points = (1..32).map(|i| {
        let turn = std::f32::consts::TAU * i as f32 / 32.0;
        PxPoint::new(10.0 - 10.0 * turn.cos(), 10.0 * turn.sin())
    });
    let ring = SkeletonPath { points: points.collect(), nodes: [Some(0), Some(0)], closed: false };
    let strands = joined_at(vec![ring], 1.0);
    assert!(matches!(&strands[..], [strand] if strand.line.closed && strand.free == [false; 2]), "{strands:?}");
}
