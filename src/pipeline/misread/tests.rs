//! Tests of `misread`.

use super::*;

fn odd(row: &[(&str, f32)]) -> Vec<usize> {
    let words: Vec<String> = row.iter().map(|(word, _)| (*word).to_owned()).collect();
    let at = |(_, x): &(&str, f32)| ReadAt { middle: PxPoint::new(*x, 440.0), height: 10.0 };
    off_their_scales(&words, &row.iter().map(at).collect::<Vec<_>>())
}

#[test]
fn a_number_that_breaks_the_scale_of_its_row_was_read_wrongly() {
    let row = [("0.6", 452.0), ("0", 383.0), ("0.4", 328.0), ("0.3", 266.0), ("g/cm", 550.0), ("0.2", 204.0)];
    assert_eq!(odd(&row), [1]);
    let whole = [("0.6", 452.0), ("0.5", 390.0), ("0.4", 328.0), ("0.3", 266.0), ("0.2", 204.0)];
    assert!(odd(&whole).is_empty());
    // the value of a bar that stands between two numbers is none of the axis
    let value = [("0.62", 421.0), ("0.6", 452.0), ("0.4", 328.0), ("0.3", 266.0), ("0.2", 204.0)];
    assert!(odd(&value).is_empty());
    let broken_off = [("0", 10.0), ("10", 50.0), ("20", 90.0), ("30", 130.0), ("100", 170.0)];
    assert!(odd(&broken_off).is_empty());
    assert!(odd(&[("5", 390.0), ("0.4", 328.0), ("0.3", 266.0)]).is_empty(), "two are no scale");
    assert!(odd(&[("7", 452.0), ("2", 390.0), ("4", 328.0), ("1", 266.0), ("9", 204.0)]).is_empty());
}

#[test]
fn rows_are_looked_at_one_by_one() {
    let words = ["1", "2", "8", "4", "5", "30", "20"].map(str::to_owned);
    let at = |x: f32, y: f32| ReadAt { middle: PxPoint::new(x, y), height: 10.0 };
    let row = [10.0, 50.0, 90.0, 130.0, 170.0].map(|x| at(x, 400.0));
    let places: Vec<ReadAt> = row.into_iter().chain([at(2.0, 100.0), at(2.0, 200.0)]).collect();
    assert_eq!(off_their_scales(&words, &places), [2]);
}

#[test]
fn columns_are_looked_at_as_rows_are() {
    // the axis of a chart, in line at its right end, of which 10 was read as 0
    let words = ["25", "20", "15", "0", "5", "0"].map(str::to_owned);
    let at = |(i, word): (usize, &String)| {
        let middle = PxPoint::new(40.0 - 3.0 * word.len() as f32, 50.0 + 60.0 * i as f32);
        ReadAt { middle, height: 10.0 }
    };
    assert_eq!(off_their_scales(&words, &words.iter().enumerate().map(at).collect::<Vec<_>>()), [3]);
}
