//! Tests of `thickness`.

use super::*;
use crate::edges::Edgel;
use crate::profile::Profile;
use crate::units::{PxPoint, Size};

#[test]
fn a_stroke_of_half_the_thickness_is_weaker_and_one_of_nearly_the_same_is_not() {
    let mut edges = Edges::none(Size::new(400, 400));
    for (number, width) in [Some(8.0), Some(7.0), Some(4.0), Some(1.0), None].into_iter().enumerate() {
        let at = |x: u8| PxPoint::new(f32::from(x), 20.0 * number as f32);
        let chain = (0..200).map(|x| Edgel { at: at(x), strength: 90.0, contrast: [90.0, 0.0, 0.0] });
        edges.push_as(ChainKind { stroke: width, ..ChainKind::default() }, chain, false);
    }
    let plan = Plan::new(&Profile::named("swell-a4").expect("it ships")).expect("it is right");
    weaken_thin_strokes(&mut edges, 8.5, &plan);
    let strengths: Vec<f32> = edges.chains.iter().map(|range| edges.edgels[range.edgels.start].strength).collect();
    assert_eq!((strengths[0], strengths[1], strengths[4]), (90.0, 90.0, 90.0));
    let params = plan.lines();
    assert!(strengths[2] < params.full_strength && strengths[2] > strengths[3]);
    assert!((strengths[3] - params.least_strength).abs() < 1e-3, "{strengths:?}");
}
