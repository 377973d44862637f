//! Tests of `bases`.

use super::super::lengthen;
use super::super::tests::{PARAMS, line};
use super::*;

/// A number line, the middle of which lies under an interval of another colour: that parts the ticks which it crosses.
#[test]
fn ticks_of_an_axis_in_pieces_are_one_scale() {
    let mut lines = vec![
        line((5.0, 50.0), (30.0, 50.0)),
        line((30.0, 50.0), (70.0, 50.0)),
        line((70.0, 50.0), (95.0, 50.0)),
        line((20.0, 47.0), (20.0, 53.0)),
        line((80.0, 47.0), (80.0, 53.0)),
    ];
    for x in [40.0, 60.0] {
        lines.extend([line((x, 47.0), (x, 49.3)), line((x, 53.0), (x, 50.7))]);
    }
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    lengthen(&mut lines, &[], area, &PARAMS);
    let ticks: Vec<f32> = lines[3..].iter().map(|line| (10.0 * line.length()).round() / 10.0).collect();
    assert_eq!(ticks, [8.2; 4], "two of them of halves");
    let pieces = first_pieces(0..3, &lines, area);
    assert_eq!(pieces.into_values().collect::<Vec<_>>(), [0, 0, 0]);
}

#[test]
fn lines_that_meet_at_a_corner_or_lie_side_by_side_are_no_pieces_of_one() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let lines = [
        line((10.0, 50.0), (50.0, 50.0)),
        line((50.0, 50.0), (50.0, 10.0)),
        line((10.0, 52.0), (50.0, 52.0)),
        line((56.0, 50.0), (90.0, 50.0)),
    ];
    assert_eq!(first_pieces(0..4, &lines, area).into_values().collect::<Vec<_>>(), [0, 1, 2, 3]);
}

#[test]
fn halves_of_a_tick_are_joined_across_what_parts_them_whichever_way_they_run() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    // 2 mm are between their feet
    let joined = |turned: [bool; 2], gaps: [f32; 2]| {
        let mut lines = [line((40.0, 45.0), (40.0, 49.0)), line((40.0, 55.0), (40.0, 51.0))];
        let halves = [0, 1].map(|number| {
            if turned[number] {
                lines[number].reverse();
            }
            Half { line: number, foot: if turned[number] { Tip::First } else { Tip::Last }, gap: gaps[number] }
        });
        let is_any = join_halves(&halves, &mut lines, area);
        let heights = lines.map(|line| line.vertices.iter().map(|vertex| vertex.at.y).collect::<Vec<f32>>());
        (is_any, heights)
    };
    for turned in [[false, false], [true, false], [false, true], [true, true]] {
        let (is_any, [whole, rest]) = joined(turned, [0.6, 0.6]);
        assert!(is_any && rest.is_empty(), "{turned:?}");
        let ends = [whole[0], whole[whole.len() - 1]];
        assert!(whole.is_sorted() && (ends[0] - 45.0).abs() + (ends[1] - 55.0).abs() < 1e-3, "{turned:?}: {ends:?}");
    }
    for gaps in [[0.4, 0.4], [0.1, 0.6]] {
        let (is_any, [upper, lower]) = joined([false, false], gaps);
        assert!(!is_any && !upper.is_empty() && !lower.is_empty(), "{gaps:?}: a line is between them");
    }
}
