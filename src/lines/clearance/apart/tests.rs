//! Tests of `apart`.

use super::super::tests::polyline;
use super::*;
use crate::lines::tests::area;

const PARAMS: Params = Params { of_drawing: true, ..Params::TEST };

/// Bars of this width on an axis, with gaps of this width between them.
fn chart(bars: usize, width: f32, gap: f32) -> Vec<Polyline<Vertex>> {
    let bar = |k: usize| {
        let (x, top) = (30.0 + k as f32 * (width + gap), 20.0 + 7.0 * (k % 4) as f32);
        polyline(&[(x, 80.0), (x, top), (x + width, top), (x + width, 80.0)], false)
    };
    let axis = polyline(&[(20.0, 10.0), (20.0, 80.0), (98.0, 80.0)], false);
    (0..bars).map(bar).chain([axis]).collect()
}

fn chart_moved_apart(bars: usize, width: f32, gap: f32) -> Option<Vec<Polyline<Vertex>>> {
    move_apart(&chart(bars, width, gap), area(), &PARAMS)
}

/// The least and the greatest x of the vertices of a bar's left or right leg.
fn leg(bar: &Polyline<Vertex>, own: &Polyline<Vertex>, x: f32) -> (f32, f32) {
    let legs = bar.vertices.iter().zip(&own.vertices).filter(|(_, own)| (own.at.x - x).abs() < 1e-3);
    legs.fold((f32::MAX, f32::MIN), |(low, high), (vertex, _)| (low.min(vertex.at.x), high.max(vertex.at.x)))
}

#[test]
fn bars_with_narrow_gaps_become_narrower_stay_straight_and_stand_on_their_axis() {
    // lines of 1.5 mm must be 4.88 mm apart: each leg at a gap gives way by 0.64 mm
    let (own, lines) = (chart(5, 6.5, 3.6), chart_moved_apart(5, 6.5, 3.6).expect("they are too near"));
    assert_eq!(lines[5], own[5], "nothing comes too near to the axis");
    for k in 0..5 {
        let (x, push) = (30.0 + 10.1 * k as f32, 0.65);
        let (left, right) = (if k > 0 { x + push } else { x }, if k < 4 { x + 6.5 - push } else { x + 6.5 });
        for (own_x, to) in [(x, left), (x + 6.5, right)] {
            let (low, high) = leg(&lines[k], &own[k], own_x);
            assert!((low - to).abs() < 0.02 && (high - to).abs() < 0.02, "bar {k}: {low}..{high} for {to}");
        }
        let ends = [lines[k].vertices.first(), lines[k].vertices.last()];
        assert!(ends.iter().flatten().all(|end| (end.at.y - 80.0).abs() < 1e-4));
    }
}

#[test]
fn a_bar_that_is_too_narrow_becomes_wider_and_lines_that_are_much_too_near_stay() {
    let (own, lines) = (chart(1, 3.8, 0.0), chart_moved_apart(1, 3.8, 0.0).expect("its legs are too near"));
    let [(left, _), (right, _)] = [30.0, 33.8].map(|x| leg(&lines[0], &own[0], x));
    assert!(right - left > 4.88 && (right + left - 63.8).abs() < 0.02, "{left} {right}");
    let near = [50.0, 51.0].map(|y| polyline(&[(10.0, y), (90.0, y)], false));
    assert!(move_apart(&near, area(), &PARAMS).is_none(), "each would have to give way by 1.9 mm");
}
