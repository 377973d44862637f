//! Tests of `tint`.

use super::*;

const GREY: [f32; 3] = [-30.0, 0.0, 0.0];
const BLUE: [f32; 3] = [-52.0, -8.0, -80.0];

/// A line with a vertex every pixel, and the tints of its vertices.
fn straight(colours: &[([f32; 3], usize)]) -> (Polyline<PxPoint>, Vec<Option<Tint>>) {
    let tints: Vec<Option<Tint>> =
        colours.iter().flat_map(|(colour, count)| std::iter::repeat_n(Tint::of(*colour), *count)).collect();
    let line = Polyline::open((0..tints.len()).map(|k| PxPoint::new(k as f32, 5.0)).collect());
    (line, tints)
}

/// First and last vertices of the parts, in order.
fn ends(colours: &[([f32; 3], usize)]) -> Vec<[usize; 2]> {
    let (line, tints) = straight(colours);
    let parts = parts(&line, &tints, 12.0).unwrap_or_default();
    let mut ends: Vec<[usize; 2]> = parts.iter().map(|part| [part[0], part[part.len() - 1]]).collect();
    ends.sort_unstable();
    ends
}

#[test]
fn a_paler_or_darker_colour_is_one_tint_and_another_hue_is_not() {
    let tint = |colour| Tint::of(colour).unwrap();
    assert!(!tint(GREY).differs_from(tint([-95.0, 1.0, -2.0])), "grey and black");
    assert!(!tint(BLUE).differs_from(tint([-22.0, -6.0, -20.0])), "mixed with white");
    assert!(tint(BLUE).differs_from(tint(GREY)));
    assert!(tint([-30.0, 80.0, 135.0]).differs_from(tint([-54.0, 132.0, 90.0])), "orange and red");
    assert!(tint(GREY).differs_from(tint([30.0, 0.0, 0.0])), "darker and lighter than the ground");
    assert_eq!(Tint::of([0.0; 3]), None);
    let [grey, blue] = [GREY, BLUE].map(Tint::of);
    assert!(Tint::are_two(grey, blue));
    assert!(!Tint::are_two(grey, None) && !Tint::are_two(None, blue) && !Tint::are_two(grey, grey));
}

#[test]
fn a_line_is_parted_where_its_tint_changes_and_what_is_of_both_is_in_no_part() {
    assert_eq!(ends(&[(GREY, 60), ([0.0; 3], 4), (BLUE, 36)]), [[0, 59], [64, 99]]);
    assert_eq!(ends(&[(BLUE, 30), (GREY, 40), ([-30.0, 80.0, 135.0], 30)]), [[0, 29], [30, 69], [70, 99]]);
    assert_eq!(ends(&[(GREY, 100)]), [[0; 2]; 0]);
    assert_eq!(ends(&[([0.0; 3], 100)]), [[0; 2]; 0]);
}

#[test]
fn what_crosses_a_line_parts_it_not_and_a_hook_at_its_end_is_cut_off() {
    assert_eq!(ends(&[(GREY, 40), (BLUE, 9), (GREY, 51)]), [[0; 2]; 0]);
    assert_eq!(ends(&[(GREY, 40), (BLUE, 20), (GREY, 40)]), [[0, 39], [40, 59], [60, 99]]);
    assert_eq!(ends(&[(GREY, 94), ([0.0; 3], 3), (BLUE, 3)]), [[0, 93], [97, 99]]);
    assert_eq!(ends(&[(BLUE, 4), (GREY, 96)]), [[0, 3], [4, 99]]);
    assert_eq!(ends(&[(GREY, 98), (BLUE, 2)]), [[0; 2]; 0], "the last pixel at what it ends on");
    assert_eq!(ends(&[(GREY, 60), ([0.0; 3], 38), (BLUE, 2)]), [[0; 2]; 0], "unknown for long");
}

#[test]
fn parts_of_a_line_do_not_depend_on_its_direction() {
    // each hue is one tint with those beside it alone, so that the two in the middle have as many alike to them
    let hue = |degrees: f32| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        ([0.0, cosine, sine], 20)
    };
    let mut hues = [0.0, 15.0, 30.0, 45.0].map(hue);
    let forwards = ends(&hues);
    hues.reverse();
    let mut backwards: Vec<[usize; 2]> = ends(&hues).iter().map(|[first, last]| [79 - last, 79 - first]).collect();
    backwards.sort_unstable();
    assert_eq!(forwards, backwards);
    assert_eq!(forwards.len(), 2, "{forwards:?}");
}

#[test]
fn parts_of_a_ring_do_not_depend_on_where_it_begins() {
    let (_, tints) = straight(&[(GREY, 50), (BLUE, 30)]);
    let at = |k: usize| {
        let angle = k as f32 * std::f32::consts::TAU / 80.0;
        PxPoint::new(50.0 + 12.7 * angle.cos(), 50.0 + 12.7 * angle.sin())
    };
    for turn in 0..80 {
        let line = Polyline { vertices: (0..80).map(|k| at((k + turn) % 80)).collect(), closed: true };
        let tints: Vec<Option<Tint>> = (0..80).map(|k| tints[(k + turn) % 80]).collect();
        let found = parts(&line, &tints, 12.0).unwrap_or_default();
        let mut counts: Vec<usize> = found.iter().map(Vec::len).collect();
        counts.sort_unstable();
        assert_eq!(counts, [30, 50], "from vertex {turn}");
        let is_run = |part: &Vec<usize>| part.windows(2).all(|pair| (pair[0] + 1) % 80 == pair[1]);
        assert!(found.iter().all(is_run), "from vertex {turn}: {found:?}");
    }
}
