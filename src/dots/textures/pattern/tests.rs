//! Patterns of dots for textures, on all grids.

use super::*;
use crate::devices::{Device, Pitches};
use crate::units::{MmPoint, MmRect};

fn even(pitch: f32) -> GridSteps {
    let places: Vec<f32> = (0..61).map(|i| i as f32 * pitch).collect();
    GridSteps::of(&places, 0.0, 60.0 * pitch)
}

fn of(degrees: Option<f32>, pitch: f32) -> Pattern {
    let sign = degrees.map_or(Sign::Dot, |degrees| Sign::Rhombus { degrees });
    Pattern::of(sign, even(pitch), even(pitch)).expect("a grid of many dots")
}

fn drawn(pattern: Pattern, amount: f32) -> Vec<String> {
    let dot = |x, y| if pattern.needed_amount(x, y) <= amount { 'o' } else { '.' };
    (0..6).map(|y| (0..12).map(|x| dot(x, y)).collect()).collect()
}

#[test]
fn rows_run_as_a_reader_sees_them() {
    for (degrees, sparse, dense) in [
        (
            0.0,
            ["oooooooooooo", "............", "............", "............", "oooooooooooo", "............"],
            ["oooooooooooo", "............", "oooooooooooo", "............", "oooooooooooo", "............"],
        ),
        (
            45.0,
            ["o...o...o...", "...o...o...o", "..o...o...o.", ".o...o...o..", "o...o...o...", "...o...o...o"],
            ["oo..oo..oo..", "o..oo..oo..o", "..oo..oo..oo", ".oo..oo..oo.", "oo..oo..oo..", "o..oo..oo..o"],
        ),
        (90.0, ["o...o...o..."; 6], ["o.o.o.o.o.o."; 6]),
        (
            135.0,
            ["o...o...o...", ".o...o...o..", "..o...o...o.", "...o...o...o", "o...o...o...", ".o...o...o.."],
            ["o..oo..oo..o", "oo..oo..oo..", ".oo..oo..oo.", "..oo..oo..oo", "o..oo..oo..o", "oo..oo..oo.."],
        ),
    ] {
        assert_eq!(drawn(of(Some(degrees), 2.5), 0.0), sparse, "{degrees} degrees, sparse");
        assert_eq!(drawn(of(Some(degrees), 2.5), 1.0), dense, "{degrees} degrees, dense");
    }
}

#[test]
fn grey_is_the_same_after_a_quarter_turn_about_one_of_its_dots() {
    for pitch in [1.27, 1.6, 2.0, 2.5, 3.0] {
        for amount in [0.0, 1.0] {
            let pattern = of(None, pitch);
            let is_set = |x, y| pattern.needed_amount(x, y) <= amount;
            let dots = || (-9..9).flat_map(|y| (-9..9).map(move |x| (x, y)));
            let turns = |(x, y): (i32, i32)| dots().all(|(i, j)| is_set(x + i, y + j) == is_set(x - j, y + i));
            assert!(dots().any(|at| is_set(at.0, at.1) && turns(at)), "{pitch} mm at {amount}");
        }
    }
}

#[test]
fn rows_and_dots_lie_as_far_apart_as_was_measured() {
    for (pitch, straight, diagonal, grey) in
        [(1.27, 5.08, 4.49, 3.59), (1.6, 4.8, 4.53, 3.2), (2.0, 4.0, 4.24, 2.83), (2.5, 5.0, 7.07, 3.54)]
    {
        let rows = |degrees, unit: f32| match of(Some(degrees), pitch) {
            Pattern::Rows { period, second: 1, .. } => period as f32 * unit,
            Pattern::Rows { second, .. } => second as f32 * unit,
            Pattern::Spots { .. } => f32::NAN,
        };
        let slope = pitch * std::f32::consts::FRAC_1_SQRT_2;
        let Pattern::Spots { halvings } = of(None, pitch) else { unreachable!("grey has no rows") };
        let spots = pitch * 2.0_f32.powf(0.5 * halvings as f32);
        let found = [rows(0.0, pitch), rows(90.0, pitch), rows(45.0, slope), rows(135.0, slope), spots];
        let near = |(a, b): (&f32, f32)| (a - b).abs() < 0.01;
        assert!(found.iter().zip([straight, straight, diagonal, diagonal, grey]).all(near), "{pitch}: {found:?}");
    }
}

#[test]
fn cells_are_seen_as_such_and_even_grids_as_even() {
    let cells: Vec<f32> = (0..30).map(|i| 11.0 + (i / 3) as f32 * 10.0 + (i % 3) as f32 * 2.34).collect();
    let steps = GridSteps::of(&cells, 11.0, 105.0);
    assert_eq!((steps.count, steps.origin % 3), (3, 0));
    assert!(even(2.0).is_even() && even(2.0).origin == 30);
    let flat = Pattern::of(Sign::Rhombus { degrees: 0.0 }, steps, steps).expect("a grid of many dots");
    let set_at = |amount: f32| [0, 1, 2].map(|y| flat.needed_amount(7, y) <= amount);
    assert_eq!((set_at(0.0), set_at(1.0)), ([true, false, false], [true, false, true]));
    let few = GridSteps::of(&[3.0], 0.0, 9.0);
    assert!(few.is_even() && GridSteps::of(&[], 0.0, 9.0).is_even(), "a device with hardly a dot does no harm");
    assert_eq!(few.origin, 0);
}

#[test]
fn cells_are_seen_on_the_devices_that_have_them() {
    for device in Device::ALL {
        let sheet = device.field().unwrap_or([210.0, 297.0]);
        let Pitches::Listed(pitches) = device.pitches() else { continue };
        for &pitch in pitches {
            let Ok(DotArea::Grid(grid)) = device.dot_area(sheet, pitch) else { continue };
            let count = [&grid.columns, &grid.rows].map(|places| GridSteps::of(places, 0.0, 0.0).count as usize);
            assert_eq!(count, device.cell_dots().unwrap_or([1, 1]), "{} at {pitch} mm", device.id);
        }
    }
}

#[test]
fn one_column_or_row_has_no_pattern() {
    let of = |places: &[f32]| GridSteps::of(places, 0.0, 9.0);
    let signs = [0.0, 45.0, 90.0, 135.0].map(|degrees| Sign::Rhombus { degrees }).into_iter().chain([Sign::Dot]);
    for sign in signs {
        for few in [&[][..], &[3.0], &[3.0, 3.0], &[3.0, 3.0 + 1e-6], &[3.0, f32::NAN]] {
            assert_eq!(Pattern::of(sign, of(few), even(2.5)), None, "{sign:?}, columns at {few:?}");
            assert_eq!(Pattern::of(sign, even(2.5), of(few)), None, "{sign:?}, rows at {few:?}");
        }
        assert!(Pattern::of(sign, of(&[3.0, 5.5]), even(2.5)).is_some(), "{sign:?}, two columns");
    }
}

#[test]
fn palettes_that_a_device_cannot_carry_are_told() {
    let grid = |rows: Vec<f32>| DotArea::Grid(Grid { columns: (0..40).map(|i| i as f32 * 2.5).collect(), rows });
    let even = grid((0..40).map(|i| i as f32 * 2.5).collect());
    let cells = grid((0..30).map(|i| (i / 3) as f32 * 10.0 + (i % 3) as f32 * 2.5).collect());
    let free = DotArea::Free(MmRect::new(MmPoint::zero(), MmPoint::new(90.0, 90.0)));
    let mut leaning = Palette::PAPER;
    leaning.signs[0] = Sign::Rhombus { degrees: 30.0 };
    leaning.signs[1] = Sign::Rhombus { degrees: 60.0 };
    let (green, red, grey) = (Class::Green, Class::Red, Class::Grey);
    assert_eq!(carried(&Palette::PAPER, &even), Ok(()));
    assert_eq!(carried(&Palette::PAPER, &free), Ok(()));
    assert_eq!(carried(&Palette::PAPER, &cells), Err(vec![(green, red), (green, grey), (red, grey)]));
    let coarse: Vec<f32> = (0..40).map(|i| i as f32 * 3.0).collect();
    let coarse = DotArea::Grid(Grid { columns: coarse.clone(), rows: coarse });
    assert_eq!(carried(&Palette::PAPER, &coarse), Err(vec![(green, red), (green, grey), (red, grey)]));
    assert_eq!(carried(&leaning, &free), Ok(()));
    assert_eq!(carried(&leaning, &even), Err(vec![(Class::Blue, green)]));
}
