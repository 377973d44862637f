//! Tests of `confirm`.

use super::*;

const WHITE: [f32; 3] = [100.0, 0.0, 0.0];
const BLACK: [f32; 3] = [0.0; 3];

/// A stroke of a width whose middle is at `at`, on white.
fn stroke(width: f32, at: f32) -> impl Fn(f32) -> [f32; 3] {
    move |distance| if (distance - at).abs() <= 0.5 * width { BLACK } else { WHITE }
}

#[test]
fn a_stroke_has_the_contrast_of_its_colour_to_its_ground() {
    for width in [2.0, 4.0, 7.0] {
        let found = stroke_contrast(width, [WHITE; 2], stroke(width, 0.0));
        assert!((found / 100.0 - 1.0).abs() < 0.15, "{found} of a stroke {width} px wide");
    }
    let grey = |distance: f32| if distance.abs() <= 2.0 { [50.0, 0.0, 0.0] } else { WHITE };
    let found = stroke_contrast(4.0, [WHITE; 2], grey);
    assert!((found / 50.0 - 1.0).abs() < 0.15, "{found} of a grey one");
    assert!(stroke_contrast(4.0, [WHITE; 2], stroke(4.0, 3.0)) < 1e-3, "it is beside");
    assert!(stroke_contrast(4.0, [WHITE; 2], |_| WHITE) < 1e-3, "there is none");
}

#[test]
fn a_stroke_between_two_grounds_has_at_least_their_step() {
    let between = |distance: f32| if distance < 0.0 { BLACK } else { WHITE };
    assert!(stroke_contrast(2.0, [BLACK, WHITE], between) >= 100.0);
}

#[test]
fn a_vertex_of_a_part_has_the_mean_of_the_segments_beside_it() {
    let square = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)].map(|(x, y)| PxPoint::new(x, y));
    let line = Polyline { vertices: square.to_vec(), closed: true };
    let step = |strength: f32| SegmentStep { strength, contrast: [strength, 0.0, 0.0], is_on_border: false };
    let seen = [10.0, 30.0, 50.0, 70.0].map(step);
    let of = |first, count, whole_ring| part(&line, &seen, &SegmentRun { first, count, whole_ring }, 20.0);
    let strengths = |part: &Polyline<Edgel>| part.vertices.iter().map(|edgel| edgel.strength).collect::<Vec<_>>();
    // what is hidden has the least strength
    let ring = of(0, 4, true);
    assert!(ring.closed);
    assert_eq!(strengths(&ring), [45.0, 25.0, 40.0, 60.0]);
    // over the first vertex
    let open = of(3, 2, false);
    assert_eq!(open.vertices.iter().map(|edgel| edgel.at).collect::<Vec<_>>(), [square[3], square[0], square[1]]);
    assert_eq!(strengths(&open), [70.0, 45.0, 20.0]);
    assert!((open.vertices[0].contrast[0] - 70.0).abs() < 1e-3);
}

#[test]
fn nothing_is_seen_beyond_the_picture_and_an_outline_has_two_grounds() {
    // black on the left of white
    let size = Size::new(40, 40);
    let picture = Lab::of(&Raster::grey(size, (0..size.len()).map(|i| f32::from(i % 40 >= 20)).collect()));
    let look = |from: (f32, f32), to: (f32, f32), stroke| {
        look(PxPoint::new(from.0, from.1), PxPoint::new(to.0, to.1), stroke, &picture)
    };
    let edge = look((20.0, 10.0), (20.0, 20.0), None);
    assert!(edge.strength > 90.0 && !edge.is_on_border, "{edge:?}");
    for beyond in [((20.0, -9.0), (20.0, -4.0)), ((20.0, 44.0), (20.0, 49.0))] {
        assert!(look(beyond.0, beyond.1, None).strength < 1e-3);
    }
    assert!(look((20.0, 10.0), (20.0, 20.0), Some(2.0)).is_on_border, "a dark area ends there");
    let blank = look((30.0, 10.0), (30.0, 20.0), Some(2.0));
    assert!(blank.strength < 1e-3 && !blank.is_on_border, "{blank:?}");
}

#[test]
fn the_end_of_a_stroke_on_a_border_that_nobody_sees_is_no_contour() {
    // a stroke 2 px wide from the upper border of a white square down, on white
    let size = Size::new(80, 80);
    let on_stroke = |i: usize| (39..41).contains(&(i % 80)) && (20..60).contains(&(i / 80));
    let params = Params { low: 3.0, high: 7.0, ..Params::default() };
    let of_border = |is_area: &dyn Fn(usize) -> bool| {
        let light = (0..size.len()).map(|i| if on_stroke(i) || is_area(i) { 0.0 } else { 1.0 });
        let picture = Lab::of(&Raster::grey(size, light.collect()));
        let corners = [(10.0, 20.0), (70.0, 20.0), (70.0, 60.0), (10.0, 60.0)].map(|(x, y)| PxPoint::new(x, y));
        let mut line = Polyline { vertices: corners.to_vec(), closed: true };
        line.subdivide(1.0);
        let proposal = Proposal { line, stroke: None, dashed: false };
        confirmed(&proposal, &picture, &params).iter().map(|found| found.line.length()).sum::<f32>()
    };
    assert!(of_border(&|_| false).abs() < 1e-3, "{}", of_border(&|_| false));
    let seen = of_border(&|i| (10..30).contains(&(i % 80)) && (20..60).contains(&(i / 80)));
    assert!((78.0..86.0).contains(&seen), "the border of what is dark there: {seen}");
}
