//! Tests of `transform`.

use super::*;
use crate::geom::nearest_on_segment;
use crate::page::{Figure, Overview};
use crate::units::Size;

/// Every corner of the narrow rhombus lies half of the swelling from the sides of the wide one, so that swelling
/// by that much on each side gives the wide one.
#[test]
fn a_rhombus_is_narrowed_evenly_on_its_four_sides() {
    for (length, thickness, degrees) in [(2.2, 1.2, 0.0), (1.65, 0.6, 45.0), (3.0, 3.0, 135.0)] {
        let glyph = |shape| Glyph { at: MmPoint::new(10.0, 10.0), shape };
        let wide = Shape::Rhombus { length, thickness, degrees };
        let (outer, inner) = (glyph(wide).corners(), glyph(wide.narrowed(0.2)).corners());
        for i in 0..4 {
            let middle = inner[i].lerp(inner[(i + 1) % 4], 0.5);
            let (distance, _) = nearest_on_segment(middle, outer[i], outer[(i + 1) % 4]);
            assert!((distance - 0.1).abs() < 1e-5, "{length} x {thickness}: {distance}");
        }
    }
}

/// A page with a mark of each kind on the left.
fn parts() -> Parts {
    let at = MmPoint::new(30.0, 50.0);
    let place = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(60.0, 80.0));
    let run = |width: f32| Run::stroke(width, vec![at, MmPoint::new(40.0, 55.0)]);
    let lines = || vec![Line { strength: 20.0, runs: vec![run(1.0)] }];
    let figure = Figure { place, source: Size::new(60, 60), textures: Vec::new(), lines: lines() };
    let dots = || Dots { diameter: 1.0, at: vec![at] };
    Parts {
        frame: dots(),
        orientation_mark: Some(run(2.0)),
        registration: vec![run(1.5), run(0.6)],
        overview: Some(Overview { place, frame: dots(), lines: lines() }),
        labels: vec![dots()],
        ..Parts::of([100.0, 100.0], figure)
    }
}

#[test]
fn every_mark_is_mirrored_and_mirrored_again_it_is_as_before() {
    let page = Page::new(parts()).expect("a page");
    let mirrored = page.clone().mirrored();
    let (at, end) = (MmPoint::new(70.0, 50.0), MmPoint::new(60.0, 55.0));
    let place = MmRect::new(MmPoint::new(40.0, 20.0), MmPoint::new(80.0, 80.0));
    let overview = mirrored.overview.as_ref().expect("there is one");
    assert_eq!([mirrored.figure.place, overview.place], [place; 2]);
    for run in mirrored.orientation_mark.iter().chain(&mirrored.registration) {
        assert_eq!(run.points, [at, end]);
    }
    for line in mirrored.figure.lines.iter().chain(&overview.lines) {
        assert_eq!(line.runs[0].points, [at, end]);
    }
    for dots in [&mirrored.frame, &overview.frame, &mirrored.labels[0]] {
        assert_eq!(dots.at, [at]);
    }
    assert!(mirrored.is_mirrored());
    assert_eq!(mirrored.mirrored(), page);
}

#[test]
fn every_mark_is_narrowed_and_a_thin_tick_only_as_far_as_it_stays() {
    let mut narrow = parts();
    narrow.narrowed(0.3);
    let width = |runs: &[Run]| runs.iter().map(|run| run.width).collect::<Vec<_>>();
    let near = |found: Vec<f32>, expected: &[f32]| {
        let same = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(same && found.len() == expected.len(), "{found:?}, not {expected:?}");
    };
    near(width(&narrow.registration), &[1.2, LEAST_TICK]);
    near(width(&narrow.figure.lines[0].runs), &[0.7]);
    near(width(narrow.orientation_mark.as_slice()), &[1.7]);
    let overview = narrow.overview.expect("there is one");
    near(width(&overview.lines[0].runs), &[0.7]);
    near(vec![narrow.frame.diameter, overview.frame.diameter, narrow.labels[0].diameter], &[0.7, 0.7, 1.0]);
}
