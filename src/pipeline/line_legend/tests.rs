//! Tests of `line_legend`.

use super::*;

fn at(x: f32, y: f32) -> MmPoint {
    MmPoint::new(x, y)
}

/// The numbers of the words of samples that stand in line: each from x, at y, so long.
fn words(samples: &[(f32, f32, f32)]) -> Vec<usize> {
    let sample = |(text, &(x, y, length)): (usize, &(f32, f32, f32))| Sample {
        text,
        place: MmRect::new(at(x, y), at(x + length, y)),
        colour: [1.0, 0.0, 0.0],
        ink: None,
    };
    in_line(samples.iter().enumerate().map(sample).collect()).iter().map(|sample| sample.text).collect()
}

#[test]
fn samples_stand_in_a_column_or_a_row_and_are_alike() {
    assert_eq!(words(&[(60.0, 10.0, 5.0), (60.0, 14.0, 4.5), (60.0, 18.0, 5.0)]), [0, 1, 2]);
    assert_eq!(words(&[(60.0, 10.0, 5.0), (90.0, 10.0, 5.0)]), [0, 1]);
    assert_eq!(words(&[(60.0, 10.0, 5.0), (63.0, 14.0, 5.0)]), [] as [usize; 0]);
    assert_eq!(words(&[(60.0, 10.0, 5.0), (20.0, 40.0, 5.0), (60.0, 14.0, 5.0), (60.0, 18.0, 15.0)]), [0, 2]);
}

#[test]
fn a_word_stands_at_the_right_end_of_its_curve_unless_others_are_near() {
    let bent = |left: f32, middle: f32, right: f32| -> Vec<MmPoint> {
        let half = |from: MmPoint, to: MmPoint| (0..50).map(move |k| from.lerp(to, k as f32 / 50.0));
        let [left, middle, right] = [at(0.0, left), at(50.0, middle), at(100.0, right)];
        half(left, middle).chain(half(middle, right)).chain([right]).collect()
    };
    let curve = bent(50.0, 10.0, 50.0);
    let best = |others: &[Vec<MmPoint>]| {
        let others: Vec<&[MmPoint]> = others.iter().map(|other| &other[..]).collect();
        best_place(&curve, &others, &[])
    };
    assert_eq!(best(&[]), Some(at(100.0, 50.0)));
    assert_eq!(best(&[bent(80.0, 70.0, 51.0)]), Some(at(0.0, 50.0)), "another one ends there");
    let middle = best(&[bent(51.0, 70.0, 51.0)]).expect("there is room in the middle");
    assert!((middle.x - 50.0).abs() < 35.0, "{middle:?}");
    assert_eq!(best(&[bent(52.0, 12.0, 52.0)]), None, "it runs beside another one");
}

#[test]
fn the_word_of_a_straight_line_stands_at_its_side() {
    let line: Vec<MmPoint> = (0..=100).map(|k| at(k as f32, 40.0)).collect();
    let place = best_place(&line, &[], &[]).expect("there is room");
    assert!((25.0..=75.0).contains(&place.x), "at its end it would be a leader line: {place:?}");
}

#[test]
fn the_name_of_a_bus_line_stands_between_two_stops() {
    let line: Vec<MmPoint> = (0..=100).map(|k| at(k as f32, if k < 50 { 40.0 } else { k as f32 - 10.0 })).collect();
    let stops = [0, 20, 50, 80, 100].map(|k: usize| line[k]);
    let place = best_place(&line, &[], &stops).expect("there is room");
    let nearest = stops.iter().map(|stop| (*stop - place).length()).fold(f32::INFINITY, f32::min);
    assert!(nearest > 12.0, "at its end it would be the name of the last stop: {place:?}");
    let everywhere: Vec<MmPoint> = line.iter().step_by(4).copied().collect();
    assert_eq!(best_place(&line, &[], &everywhere), Some(line[100]));
}
