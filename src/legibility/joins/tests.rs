//! Tests of `joins`.

use super::*;
use crate::page::{Line, Run};

type Points<'a> = &'a [(f32, f32)];

/// The paths of strokes of 1 mm through these points.
fn paths(of: &[Points]) -> Paths {
    let line = |points: &Points| {
        let points = points.iter().map(|&(x, y)| MmPoint::new(x, y)).collect();
        Line { strength: 100.0, runs: vec![Run::stroke(1.0, points)] }
    };
    Paths::whole(&of.iter().map(line).collect::<Vec<_>>())
}

/// The joins of strokes that have to be 3 mm apart.
fn joins_of_strokes(of: &[Points]) -> Vec<Vec<Join>> {
    let paths = paths(of);
    joins(&paths, &paths.index(5.0), 3.0, 0.0)
}

/// Which others each of these strokes joins, each once.
fn joined(of: &[Points]) -> Vec<Vec<u32>> {
    let others = |joins: &Vec<Join>| {
        let mut others: Vec<u32> = joins.iter().map(|join| join.other).collect();
        others.sort_unstable();
        others.dedup();
        others
    };
    joins_of_strokes(of).iter().map(others).collect()
}

const BASE: Points<'static> = &[(0.0, 0.0), (60.0, 0.0)];
const STEM: Points<'static> = &[(28.0, 30.0), (28.0, 0.0)];

#[test]
fn a_line_that_ends_on_another_may_be_near_it_within_an_approach() {
    let joins = joins_of_strokes(&[BASE, STEM]);
    let is_near = |arc: f32| arrives(&joins[1], None, arc, 0, 4.0);
    assert!(is_near(30.0) && is_near(30.0 - 0.9 * APPROACH * 4.0) && !is_near(30.0 - 1.1 * APPROACH * 4.0));
    assert!(!arrives(&joins[1], None, 30.0, 2, 4.0), "it does not end on others");
    let stem = paths(&[BASE, STEM]).segments_of(1)[0];
    let [(from, to)] = free_parts(&joins[1], None, &stem, 0, 4.0)[..] else { panic!("one part") };
    assert!((from - 0.0).abs() < 0.01 && (to - (30.0 - APPROACH * 4.0)).abs() < 0.01, "{from} to {to}");
}

#[test]
fn lines_that_cross_join_one_another() {
    assert_eq!(joined(&[BASE, &[(28.0, 30.0), (28.0, -30.0)]]), [[1], [0]]);
    assert_eq!(joined(&[BASE, &[(28.0, 30.0), (28.0, 2.0)]]), [[0; 0]; 2], "it ends before the other");
}

#[test]
fn lines_that_wind_round_one_another_do_not_join() {
    let wave = |high: f32| [(10.0, -high), (30.0, high), (50.0, -high)];
    assert_eq!(joined(&[BASE, &wave(1.5)]), [[0; 0]; 2]);
    assert_eq!(joined(&[BASE, &wave(9.0)]), [[1], [0]], "they are apart between the two crossings");
}

#[test]
fn a_ring_joins_the_line_on_which_its_corner_stands() {
    let ring = |low: f32| [(20.0, 12.0), (30.0, low), (40.0, 12.0), (20.0, 12.0)];
    assert_eq!(joined(&[BASE, &ring(0.4)]), [vec![], vec![0]]);
    assert_eq!(joined(&[BASE, &ring(2.0)]), [[0; 0]; 2]);
}

#[test]
fn lines_that_end_on_a_third_at_nearly_one_place_join_one_another() {
    let below = |x: f32| [(x, 0.0), (x + 18.0, -30.0)];
    assert_eq!(joined(&[BASE, STEM, &below(31.0)]), [vec![1, 2], vec![0, 2], vec![0, 1]]);
    assert_eq!(joined(&[BASE, STEM, &below(34.0)]), [vec![1, 2], vec![0], vec![0]], "too far along it");
    let beside = [(31.0, 0.0), (32.0, 30.0)];
    assert_eq!(joined(&[BASE, STEM, &beside]), [vec![1, 2], vec![0], vec![0]], "they run beside one another");
}

/// Its first segment in reach was taken, which was another one on another page, so that lines that end on a third one
/// joined there or did not.
#[test]
fn a_join_is_at_the_nearest_place_of_the_other_line_whatever_lies_elsewhere() {
    let base: Vec<(f32, f32)> = (0..=120).map(|k| (0.5 * k as f32, 0.0)).collect();
    for shift in 0..10 {
        let far = [(-20.0 - 0.7 * shift as f32, -40.0), (-20.0, -60.0)];
        let joins = joins_of_strokes(&[&base[..], STEM, &far]);
        let there: Vec<f32> = joins[1].iter().map(|join| join.there).collect();
        assert!(matches!(there[..], [there] if (there - 28.0).abs() < 0.01), "{there:?}");
    }
}

/// Of many joins with one line each asks of the next on either side only.
#[test]
fn a_join_asks_of_its_neighbours_only() {
    let join = |k: u32| Join { arc: 2.0 * k as f32, other: 1, there: 0.0, line: 1, by_third: None };
    let mut list: Vec<Join> = (0..300).map(join).collect();
    let asked = std::cell::Cell::new(0);
    keep_straight(0, &mut list, 1.0, |(from, to), _| {
        asked.set(asked.get() + 1);
        from >= 100.0 && to <= 110.0
    });
    let left: Vec<f32> = list.iter().map(|join| join.arc).filter(|arc| (95.0..115.0).contains(arc)).collect();
    assert_eq!((list.len(), left), (294, vec![96.0, 98.0, 112.0, 114.0]));
    assert!(asked.get() <= 600, "{} questions", asked.get());
}

/// Hundreds of crossings of two lines are as many joins of both.
#[test]
fn a_zigzag_joins_a_line_at_each_crossing() {
    let zigzag: Vec<(f32, f32)> = (0..=500).map(|k| (10.0 * k as f32, if k % 2 == 0 { -30.0 } else { 30.0 })).collect();
    let joins = joins_of_strokes(&[&[(0.0, 0.0), (5000.0, 0.0)], &zigzag]);
    assert_eq!(joins.iter().map(Vec::len).collect::<Vec<_>>(), [500, 500]);
    let clear = free_parts(&joins[0], None, &paths(&[&[(0.0, 0.0), (5000.0, 0.0)]]).segments_of(0)[0], 1, 0.25);
    assert_eq!(clear.len(), 501, "what is left between the joins");
}

/// Rows of dots 2.5 mm apart through these points, broken at holes.
fn rows(of: &[Points]) -> Paths {
    let line = |points: &Points| {
        let mut dots: Vec<MmPoint> = Vec::new();
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|(x, y)| MmPoint::new(x, y));
            let steps = ((b - a).length() / 2.5).round() as usize;
            dots.extend((0..steps).map(|k| a.lerp(b, k as f32 / steps as f32)));
        }
        Line { strength: 100.0, runs: vec![Run::dots(1.6, dots, crate::page::Height::High)] }
    };
    Paths::broken(&of.iter().map(line).collect::<Vec<_>>(), 3.75)
}

#[test]
fn rows_of_dots_join_at_corners_and_not_where_they_run_beside_one_another() {
    let of = |rows: &Paths| joins(rows, &rows.index(5.0), 4.65, 4.375);
    let level: Points<'_> = &[(0.0, 0.0), (60.0, 0.0)];
    let beside = rows(&[level, &[(0.0, 5.0), (60.0, 5.0)]]);
    let is_end = |join: &Join| join.arc < VERTEX || join.arc > beside.paths[0].length - VERTEX;
    assert!(of(&beside).iter().flatten().all(is_end), "one empty dot lies between them");
    // the corner of the second has lost its dot on the first
    let corner: Points<'_> = &[(10.0, 30.0), (30.0, 2.5), (50.0, 30.0)];
    assert!(!of(&rows(&[level, corner]))[1].is_empty());
}

#[test]
fn a_ring_that_touches_a_line_joins_it_where_it_soon_is_apart() {
    let joined_by = |radius: f32, above: f32| {
        let turn = |k: u32| std::f32::consts::TAU * k as f32 / 60.0;
        let at = |k: u32| (28.0 + radius * turn(k).cos(), above + radius + radius * turn(k).sin());
        let ring: Vec<(f32, f32)> = (0..=60).map(at).collect();
        !joined(&[BASE, &ring])[1].is_empty()
    };
    assert!(joined_by(10.0, 0.0) && joined_by(10.0, 0.7), "a wheel on a road");
    assert!(!joined_by(10.0, 1.5), "their ink does not touch");
    assert!(!joined_by(1.5, 0.5), "no part of it is apart");
}
