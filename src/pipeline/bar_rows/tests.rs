//! Tests of `bar_rows`.

use super::super::bars::Direction;
use super::*;
use crate::units::PxPoint;

/// Two bars of one row, and an axis before the first of them.
const BARS: [Bar; 2] = [Bar { from: 30.0, to: 90.0, top: 100.0 }, Bar { from: 110.0, to: 170.0, top: 120.0 }];
const ENDS: [RowEnd; 2] = [RowEnd { at: 10.0, is_axis: true }, RowEnd { at: 170.0, is_axis: false }];

fn led_on(direction: Direction, only_axes: bool, places: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let (base, sides, gridlines) = (0.0, Vec::new(), Vec::new());
    let chart = Chart { direction, base, bars: BARS.to_vec(), sides, gridlines, frame: None, is_divided: true };
    let edgel = |&at: &(f32, f32)| Edgel { at: direction.point(at), strength: 30.0, contrast: [0.0; 3] };
    let row = BarRow { bars: BARS.to_vec(), ends: ENDS };
    let piece = Polyline::open(places.iter().map(edgel).collect());
    let piece = chart.with_divider_led_on(piece, &[row], only_axes);
    let place = |at: PxPoint| direction.of(at);
    [0, piece.vertices.len() - 1].map(|end| place(piece.vertices[end].at)).to_vec()
}

#[test]
fn what_divides_a_bar_leads_to_where_its_sides_are_drawn() {
    for direction in [Direction::Up, Direction::Right] {
        let led_on = |places: &[(f32, f32)]| led_on(direction, false, places);
        assert_eq!(led_on(&[(31.0, 40.0), (60.0, 40.0), (89.0, 40.0)]), [(10.0, 40.0), (100.0, 40.0)]);
        assert_eq!(led_on(&[(90.0, 40.0), (30.0, 40.0)]), [(100.0, 40.0), (10.0, 40.0)], "the other way round");
        assert_eq!(led_on(&[(110.0, 40.0), (170.0, 40.0)]), [(100.0, 40.0), (170.0, 40.0)], "at one end");
        for (other, what) in [
            ([(30.0, 0.0), (90.0, 0.0)], "the base"),
            ([(30.0, 100.0), (90.0, 100.0)], "a top"),
            ([(20.0, 40.0), (29.0, 40.0)], "what ends before a bar"),
            ([(30.0, 40.0), (60.0, 80.0)], "what is aslant"),
            ([(31.0, 20.0), (31.0, 80.0)], "a side"),
        ] {
            assert_eq!(led_on(&other), other, "{what}");
        }
    }
}

#[test]
fn in_an_overview_it_leads_to_axes_only() {
    let led_on = |places: &[(f32, f32)]| led_on(Direction::Up, true, places);
    assert_eq!(led_on(&[(30.0, 40.0), (90.0, 40.0)]), [(10.0, 40.0), (90.0, 40.0)]);
    assert_eq!(led_on(&[(110.0, 40.0), (170.0, 40.0)]), [(110.0, 40.0), (170.0, 40.0)]);
}
