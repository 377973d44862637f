//! Tests of `finish`.

use super::*;
use crate::page::{Figure, Line, Run};
use crate::profile::Profile;
use crate::units::{MmPoint, MmRect};

/// A page of `count` lines 10 mm long, at least 10 mm apart, in a figure of 225 square cm.
fn scraps(count: usize, of_photograph: bool) -> Page {
    let line = |k: usize| {
        let at = MmPoint::new(25.0 + 20.0 * (k % 6) as f32, 25.0 + 20.0 * (k / 6) as f32);
        Line { strength: 50.0, runs: vec![Run::stroke(1.0, vec![at, MmPoint::new(at.x + 10.0, at.y)])] }
    };
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(160.0, 160.0));
    let lines = (0..count).map(line).collect();
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines };
    let origin = LeftOut { of: 400, of_photograph, ..LeftOut::default() }.to_origin();
    Page::new(Parts { origin, ..Parts::of([210.0, 297.0], figure) }).expect("it is on the sheet")
}

#[test]
fn a_photograph_in_scraps_is_told_with_its_ends_on_all_sheets() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it is right");
    let count = |pages: &[Page]| match told_of_scraps(pages.iter(), &plan)? {
        Note::Faulty(About::Lines, Reason::LooseEnds, what) => {
            what.split_whitespace().find_map(|word| word.parse::<usize>().ok())
        }
        other => panic!("{other:?}"),
    };
    assert_eq!(count(&[scraps(24, true)]), Some(48));
    assert_eq!(count(&[scraps(24, false)]), None, "in a drawing every line is meant");
    assert_eq!(count(&[scraps(22, true)]), None);
    assert_eq!(count(&[scraps(24, true), scraps(22, true), scraps(25, true)]), Some(98), "of the sheets with too many");
}
