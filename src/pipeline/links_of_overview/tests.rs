//! Tests of `links_of_overview`.

use super::*;
use crate::lines::Run;

#[test]
fn arrows_between_boxes_that_an_overview_lacks_are_counted() {
    let from = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let to = MmRect::new(MmPoint::new(20.0, 120.0), MmPoint::new(60.0, 160.0));
    let line = |path: &[(f32, f32)], part: MmRect| {
        let at = |&(x, y): &(f32, f32)| part.min + MmPoint::new(x, y).to_vector() * (part.width() / 100.0);
        Line { strength: 90.0, runs: vec![Run::stroke(1.0, path.iter().map(at).collect())] }
    };
    let upper: &[(f32, f32)] = &[(10.0, 10.0), (90.0, 10.0), (90.0, 30.0), (10.0, 30.0), (10.0, 10.0)];
    let lower: &[(f32, f32)] = &[(10.0, 44.0), (90.0, 44.0), (90.0, 64.0), (10.0, 64.0), (10.0, 44.0)];
    let arrow: &[(f32, f32)] = &[(50.0, 30.0), (50.0, 44.0)];
    // one end of a tick is free
    let tick: &[(f32, f32)] = &[(30.0, 64.0), (30.0, 76.0)];
    let count = |figure: &[&[(f32, f32)]], overview: &[&[(f32, f32)]]| {
        let lines =
            |paths: &[&[(f32, f32)]], part: MmRect| paths.iter().map(|path| line(path, part)).collect::<Vec<_>>();
        lacking(&lines(figure, from), from, &lines(overview, to), to, (8.0, 7.0))
    };
    assert_eq!(count(&[upper, lower, arrow, tick], &[upper, lower]), 1);
    assert_eq!(count(&[upper, lower, arrow, tick], &[upper, lower, arrow]), 0);
    let far: &[(f32, f32)] = &[(10.0, 74.0), (90.0, 74.0), (90.0, 94.0), (10.0, 94.0), (10.0, 74.0)];
    let long: &[(f32, f32)] = &[(50.0, 30.0), (50.0, 74.0)];
    assert_eq!(count(&[upper, far, long], &[upper, far]), 0, "it is told with the lines that are left out");
}
