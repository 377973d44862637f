//! Tests of `narrower_bars`.

use super::super::bars::Direction;
use super::*;
use crate::edges::{ChainKind, Edgel};
use crate::units::Size;

/// Bars 60 px wide, 40 px apart.
const BARS: [Bar; 3] = [
    Bar { from: 30.0, to: 90.0, top: 100.0 },
    Bar { from: 130.0, to: 190.0, top: 100.0 },
    Bar { from: 230.0, to: 290.0, top: 100.0 },
];
const NO_AXIS: f32 = f32::INFINITY;

#[test]
fn bars_are_narrower_by_what_is_missing_between_them_and_moved_by_what_is_missing_before_the_axis() {
    let of = |before: [f32; 2], gap: f32| {
        Narrowing::of(&BARS, before, gap, 15.0).map(|Narrowing { inwards, aside }| (inwards, aside))
    };
    assert_eq!(of([NO_AXIS; 2], 46.0), Some((3.0, 0.0)));
    assert_eq!(of([30.0, NO_AXIS], 46.0), Some((3.0, 13.0)));
    assert_eq!(of([NO_AXIS, 30.0], 46.0), Some((3.0, -13.0)));
    assert_eq!(of([28.0, NO_AXIS], 46.0), Some((3.0, 15.0)));
    assert_eq!(of([26.0, NO_AXIS], 46.0), Some((5.0, 15.0)), "they are narrower as they may not be moved by more");
    assert_eq!(of([40.0, 40.0], 46.0), Some((6.0, 0.0)));
    assert_eq!(of([NO_AXIS; 2], 40.0), None, "there is room");
    assert_eq!(of([NO_AXIS; 2], 52.0), None, "their sides would be too near to one another");
    assert_eq!(of([10.0, NO_AXIS], 46.0), None, "the axis is too near");
}

#[test]
fn the_outline_and_the_parts_of_a_bar_move_and_the_axes_stay() {
    let sides = BARS.iter().flat_map(|bar| [bar.from, bar.to]).chain([0.0]);
    let sides: Vec<BaseSpan> = sides.map(|at| BaseSpan { at, from: 0.0, to: 100.0 }).collect();
    let chart = Chart {
        direction: Direction::Up,
        base: 0.0,
        bars: BARS.to_vec(),
        sides,
        gridlines: Vec::new(),
        frame: None,
        is_divided: true,
    };
    let mut edges = Edges::none(Size::new(400, 200));
    let path = |places: &[(f32, f32)]| {
        let edgel = |&at: &(f32, f32)| Edgel { at: Direction::Up.point(at), strength: 30.0, contrast: [0.0; 3] };
        places.iter().map(edgel).collect::<Vec<_>>().into_iter()
    };
    edges.push_as(ChainKind::default(), path(&[(130., 0.), (130., 60.), (190., 60.), (190., 0.), (160., 0.)]), true);
    edges.push_as(ChainKind::default(), path(&[(0., 120.), (0., 0.), (160., 0.), (350., 0.)]), false);
    let (moved, narrower) = chart.with_room(&edges, [30.0, NO_AXIS], 46.0, 15.0).expect("there is room for them");
    let across: Vec<f32> = moved.edgels.iter().map(|edgel| Direction::Up.of(edgel.at).0.round()).collect();
    assert_eq!(across, [146.0, 146.0, 200.0, 200.0, 173.0, 0.0, 0.0, 160.0, 350.0]);
    assert_eq!(narrower.bars[1], Bar { from: 146.0, to: 200.0, top: 100.0 });
    assert!(narrower.sides.iter().any(|side| (side.at - 46.0).abs() < 0.1), "46 px before the first bar is the axis");
    assert_eq!(Chart { is_divided: false, ..chart }.with_room(&edges, [30.0, NO_AXIS], 46.0, 15.0), None);
}
