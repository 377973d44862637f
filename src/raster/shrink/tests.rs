//! Pictures that are made smaller, against sums in f64.

use super::*;
use proptest::prelude::*;

fn extents(source: Size) -> (Extent, Extent) {
    (Extent::pixels(0, source.width), Extent::pixels(0, source.height))
}

/// In sums of 64 bits, as decoders do.
fn shrunk(source: Size, target: Size, plane: &[f32]) -> Vec<f32> {
    let (across, down) = extents(source);
    let rows = 0..target.height as usize;
    let mut shrink = Shrinker::<f64>::of_rows(source.width, across, down, target, rows);
    plane.chunks_exact(source.width as usize).for_each(|row| shrink.push(row));
    shrink.finish_whole().expect("all rows").values
}

fn mean(plane: &[f32]) -> f64 {
    plane.iter().map(|&value| f64::from(value)).sum::<f64>() / plane.len() as f64
}

/// A picture and a target that is not larger.
fn pictures() -> impl Strategy<Value = (Size, Size, Vec<f32>)> {
    (1..40u32, 1..40u32)
        .prop_flat_map(|(width, height)| {
            let plane = prop::collection::vec(0.0..=1.0f32, (width * height) as usize);
            (Just(Size::new(width, height)), 1..=width, 1..=height, plane)
        })
        .prop_map(|(source, width, height, plane)| (source, Size::new(width, height), plane))
}

proptest! {
    #[test]
    fn the_mean_is_kept((source, target, plane) in pictures()) {
        let small = shrunk(source, target, &plane);
        prop_assert!((mean(&small) - mean(&plane)).abs() < 1e-6);
    }

    #[test]
    fn the_same_size_is_the_same_picture((source, _, plane) in pictures()) {
        prop_assert_eq!(&shrunk(source, source, &plane), &plane);
        prop_assert_eq!(shrink(&plane, source, source).values, plane);
    }

    #[test]
    fn a_picture_turned_half_round_gives_the_page_turned_half_round((source, target, plane) in pictures()) {
        let turned: Vec<f32> = plane.iter().rev().copied().collect();
        let small = shrunk(source, target, &plane);
        let small_turned = shrunk(source, target, &turned);
        for (a, b) in small.iter().zip(small_turned.iter().rev()) {
            prop_assert!((a - b).abs() <= f32::EPSILON, "{a} {b}");
        }
    }

    #[test]
    fn one_colour_stays_exactly_that_colour((source, target, _) in pictures(), value in 0.0..=1.0f32) {
        let small = shrunk(source, target, &vec![value; source.len()]);
        prop_assert!(small.iter().all(|&v| (v - value).abs() <= f32::EPSILON), "{value} {small:?}");
    }

    #[test]
    fn sums_of_32_bits_are_nearly_those_of_64((source, target, plane) in pictures()) {
        let (short, long) = (shrink(&plane, source, target).values, shrunk(source, target, &plane));
        prop_assert!(short.iter().zip(&long).all(|(a, b)| (a - b).abs() < 1e-5));
    }

    #[test]
    fn rows_that_are_skipped_count_as_zero(
        (source, target, mut plane) in pictures(),
        skipped in prop::collection::vec(any::<bool>(), 40),
    ) {
        let width = source.width as usize;
        let last = source.height as usize - 1;
        let mut shrinker = Shrinker::new(source, target);
        for (y, row) in plane.chunks_exact_mut(width).enumerate() {
            if skipped[y] && y < last {
                row.fill(0.0);
            } else {
                shrinker.skip_to(y);
                shrinker.push(row);
            }
        }
        prop_assert_eq!(shrinker.finish(), shrink(&plane, source, target));
    }

    #[test]
    fn parts_put_together_are_the_whole((source, target, plane) in pictures(), cut in 0.0..1.0f32) {
        let cut = (cut * source.height as f32) as usize;
        let part = |begin: Range<usize>| {
            let mut part = Shrinker::part(source, target, begin);
            plane.chunks_exact(source.width as usize).for_each(|row| part.push(row));
            part
        };
        let mut whole = part(0..cut);
        whole.append(part(cut..source.height as usize));
        prop_assert_eq!(whole.finish(), shrink(&plane, source, target));
    }
}

#[test]
fn a_part_makes_the_rows_that_begin_in_it() {
    // 10 rows to 4 begin in the rows 0, 2, 5 and 7.
    let (from, to) = (Size::new(3, 10), Size::new(3, 4));
    let part = |begin| {
        let part = Shrinker::part(from, to, begin);
        (part.starts(), part.rows())
    };
    assert_eq!(part(0..10), (vec![0, 2, 5, 7], 0..10));
    assert_eq!(part(2..5), (vec![2], 2..5));
    assert_eq!(part(3..8), (vec![5, 7], 5..10));
    assert_eq!(part(8..10), (vec![], 0..0));
}

#[test]
fn a_pixel_cut_by_an_edge_counts_on_both_sides() {
    let small = shrunk(Size::new(5, 1), Size::new(2, 1), &[1.0, 1.0, 0.0, 1.0, 0.0]);
    assert_eq!(small, [2.0 / 2.5, 1.0 / 2.5]);
}

#[test]
fn a_part_of_a_pixel_beyond_the_picture_counts_as_little_as_there_is_of_it() {
    // 9 px at 1/8: one pixel and an eighth, of which the second is seen by its eighth only.
    let (across, down) = (Extent::scaled(0, 9, 1), Extent::pixels(0, 1));
    let mut shrink = Shrinker::<f64>::of_rows(2, across, down, Size::new(1, 1), 0..1);
    shrink.push(&[0.0, 1.0]);
    assert_eq!(shrink.finish().values, [(0.125 / 1.125) as f32]);
}

#[test]
fn a_strip_of_a_hundred_thousand_rows_keeps_its_mean() {
    let value = 0.1f32;
    let small = shrunk(Size::new(1, 100_000), Size::new(1, 1), &vec![value; 100_000]);
    assert_eq!(small, [value]);
}

#[test]
fn missing_rows_are_seen() {
    let (across, down) = extents(Size::new(2, 2));
    let mut shrink = Shrinker::<f64>::of_rows(2, across, down, Size::new(1, 1), 0..1);
    shrink.push(&[0.0, 1.0]);
    assert!(shrink.finish_whole().is_none());
}
