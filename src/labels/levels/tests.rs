//! Tests of `levels`.

use super::*;
use crate::labels::Params;
use crate::page::{Line, Run};

/// By how much numbers from 0 in steps of 15 mm are moved that stand so far off these lines, each the off from
/// its own number's place.
fn moved(off: f32, lines: &[f32]) -> Vec<f32> {
    moved_at(off, (30.0, 90.0), lines)
}

/// The same of lines from one place to another.
fn moved_at(off: f32, (from, to): (f32, f32), lines: &[f32]) -> Vec<f32> {
    let line = |from: (f32, f32), to: (f32, f32)| Line {
        strength: 50.0,
        runs: vec![Run::stroke(1.0, vec![MmPoint::from(from), MmPoint::from(to)])],
    };
    let level = |&y: &f32| line((from, y), (to, y));
    let lines: Vec<Line> =
        lines.iter().map(level).chain([line((30.0, 5.0), (30.0, 80.0)), line((30.0, 90.0), (90.0, 90.0))]).collect();
    let area = MmRect::new(MmPoint::new(0.0, -10.0), MmPoint::new(130.0, 110.0));
    let room = Room::new(&lines, &[], &Params::of_test(area));
    let number = |i: u16| {
        let y = 80.0 - 15.0 * f32::from(i) + off;
        let anchor = MmRect::new(MmPoint::new(20.0, y - 2.0), MmPoint::new(25.0, y + 2.0));
        Wanted { text: (5 * i).to_string(), anchor, lost_leader: None, kept_leader: None, is_nameless: false }
    };
    let wanted: Vec<Wanted> = (0..5).map(number).collect();
    let all = at_their_lines(&wanted, &room);
    all.iter().zip(&wanted).map(|(to, from)| to.anchor.center().y - from.anchor.center().y).collect()
}

#[test]
fn numbers_above_or_below_their_lines_stand_at_them() {
    let grid = [80.0, 65.0, 50.0, 35.0, 20.0];
    for off in [-4.0, -2.5, 2.0, 4.5] {
        let moved = moved(off, &grid);
        assert!(moved.iter().all(|by| (by + off).abs() <= 0.5), "{off}: {moved:?}");
    }
    assert_eq!(moved(0.3, &grid), [0.0; 5], "those at their lines stay");
    // some have none, as where a bar is
    let some = moved(-3.0, &[80.0, 50.0, 20.0]);
    assert!(some.iter().all(|by| (by - 3.0).abs() <= 0.5), "{some:?}");
}

#[test]
fn numbers_between_lines_or_without_any_stay() {
    let between = [76.0, 84.0, 61.0, 69.0, 46.0, 54.0, 31.0, 39.0, 16.0, 24.0];
    assert_eq!(moved(0.0, &between), [0.0; 5], "the names of bars across");
    assert_eq!(moved(-3.0, &[50.0]), [0.0; 5], "one line is no scale");
    let tops = [80.0, 65.0, 50.0, 35.0, 20.0];
    assert_eq!(moved_at(-3.0, (60.0, 70.0), &tops), [0.0; 5], "tops of bars");
    assert!(moved_at(-3.0, (60.0, 90.0), &tops).iter().all(|by| *by > 2.0), "gridlines behind a bar");
}
