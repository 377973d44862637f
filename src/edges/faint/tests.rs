//! Tests of `faint`.

use super::*;

/// Whether the first of two strokes, each with its width in px and its contrast, is faint beside the second.
fn is_faint(strokes: [(f32, f32); 2]) -> bool {
    is_faint_of(strokes, false)
}

/// [`is_faint`] where the first may be closed.
fn is_faint_of(strokes: [(f32, f32); 2], closed: bool) -> bool {
    let line = |y: f32, strength: f32| -> Vec<Edgel> {
        let edgel = |x: u8| Edgel { at: PxPoint::new(f32::from(x), y), strength, contrast: [0.0; 3] };
        (0..200).map(edgel).collect()
    };
    let lines = [line(10.0, strokes[0].1), line(50.0, strokes[1].1)];
    let view = |number: usize| PolylineRef { vertices: &lines[number][..], closed: closed && number == 0 };
    let mut all = [0, 1].map(|number| WeighedStroke::of(strokes[number].0, 0.0, view(number)));
    let faint = FaintStrokes::among(all.iter_mut().collect());
    faint.holds(&all[0])
}

#[test]
fn a_stroke_is_faint_that_is_thin_and_pale_beside_others() {
    assert!(is_faint([(1.0, 25.0), (5.0, 90.0)]));
    assert!(!is_faint([(2.0, 90.0), (5.0, 90.0)]), "only thin");
    assert!(!is_faint([(5.0, 30.0), (5.0, 90.0)]), "only pale");
    assert!(!is_faint([(1.0, 40.0), (1.0, 40.0)]), "of one kind all are strong");
}

#[test]
fn a_dark_closed_stroke_is_no_faint_one() {
    // a table beside thick walls, and a ring of a polar grid
    assert!(!is_faint_of([(1.5, 80.0), (9.0, 100.0)], true));
    assert!(is_faint_of([(1.5, 80.0), (9.0, 100.0)], false), "open");
    assert!(is_faint_of([(1.5, 30.0), (9.0, 100.0)], true), "pale");
}
