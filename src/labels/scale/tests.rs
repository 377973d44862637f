//! Tests of `scale`.

use super::*;

fn of(texts: &[&str]) -> Option<Vec<i64>> {
    let positions: Vec<f32> = (0..texts.len()).map(|i| 10.0 * i as f32).collect();
    steps(texts, &positions)
}

#[test]
fn numbers_in_even_steps_are_a_scale() {
    assert_eq!(of(&["-2", "\u{2212}1", "0", "1"]), Some(vec![-2, -1, 0, 1]));
    assert_eq!(of(&["25 °C", "20 °C", "15 °C", "0"]), None, "15 and 0 are three steps apart, and stand as one");
    assert_eq!(of(&["10 °C", "5 °C", "0"]), Some(vec![2, 1, 0]));
    assert_eq!(of(&["0,5", "1,0", "1,5"]), Some(vec![1, 2, 3]));
    assert_eq!(of(&["1", "3", "5"]), Some(vec![0, 1, 2]), "zero is none of these steps");
    assert_eq!(of(&["1990", "1995", "2000"]), Some(vec![398, 399, 400]));
    assert_eq!(of(&["500", "1,000", "1,500"]), Some(vec![1, 2, 3]));
    assert_eq!(of(&["0 m", "1 000 m", "2 000 m"]), Some(vec![0, 1, 2]));
    assert_eq!(of(&["0,125", "0,250", "0,375"]), Some(vec![1, 2, 3]), "no thousands");
    assert_eq!(of(&["0", "1/4", "1/2", "3/4", "1"]), Some(vec![0, 1, 2, 3, 4]));
    assert_eq!(of(&["1/0", "1/2", "1"]), None);
    assert_eq!(of(&["10 km/h", "20 km/h", "30 km/h"]), Some(vec![1, 2, 3]));
    assert_eq!(of(&["1", "10", "100"]), None, "a scale of logarithms");
    assert_eq!(of(&["Jan", "Feb", "Mar"]), None);
    assert_eq!(of(&["1", "2", "2"]), None);
    assert_eq!(of(&["1 m", "2 s", "3 m"]), None);
}

#[test]
fn a_unit_may_stand_once_at_an_end_of_a_scale() {
    assert_eq!(of(&["150 h", "100", "50", "0"]), Some(vec![3, 2, 1, 0]));
    assert_eq!(of(&["10", "20", "30 cm"]), Some(vec![1, 2, 3]));
    assert_eq!(of(&["1", "2 a", "3"]), None, "in their middle it is that of one");
    assert_eq!(of(&["1", "2 m", "3 m"]), None, "and behind two of them it is theirs");
    assert_eq!(of(&["5", "10 cm"]), None, "two are too few");
    assert_eq!(of(&["10", "20", "45 cm"]), None, "uneven");
}

#[test]
fn a_unit_is_what_is_behind_a_number() {
    assert_eq!(without_unit("-25 °C"), Some("-25"));
    assert_eq!(without_unit("25%"), Some("25"));
    assert_eq!((without_unit("25"), without_unit("P 3")), (None, None));
    assert_eq!((without_unit("10\u{b2}"), without_unit("10 \u{2079}")), (None, None), "an exponent is none");
    assert_eq!(without_unit("10\u{b2} Hz"), Some("10\u{b2}"));
}

#[test]
fn exponents_in_even_steps_are_a_scale() {
    let powers = ["10\u{2070}", "10\u{b9}", "10\u{b2}", "10\u{b3}"];
    assert_eq!(of(&powers), Some(vec![0, 1, 2, 3]));
    assert_eq!(of(&["10\u{b3}", "10\u{b2}", "10\u{b9}"]), Some(vec![3, 2, 1]));
    assert_eq!(of(&["10\u{207b}\u{b2}", "10\u{2070}", "10\u{b2}"]), Some(vec![-1, 0, 1]));
    assert_eq!(of(&["1", "10", "10\u{b2}", "10\u{b3}"]), Some(vec![0, 1, 2, 3]));
    assert_eq!(of(&["10\u{b9} Hz", "10\u{b2} Hz", "10\u{b3} Hz"]), Some(vec![1, 2, 3]));
    assert_eq!(of(&["10\u{b9}", "10\u{b2}", "10\u{2076}"]), None, "they stand as if one step apart");
    assert_eq!(of(&["2\u{b2}", "10\u{b3}", "10\u{2074}"]), None, "powers of different numbers");
    assert_eq!(of(&["10\u{2080}", "10\u{2081}", "10\u{2082}"]), None, "what is lowered is no exponent");
    assert_eq!(of(&["0", "1", "10\u{b2}", "10\u{b3}"]), None);
    // what is squared steps evenly
    assert_eq!(of(&["1\u{b2}", "2\u{b2}", "3\u{b2}"]), Some(vec![1, 2, 3]));
}

#[test]
fn numbers_and_powers_of_a_row_stay_and_names_and_years_do_not() {
    assert_eq!(stay(&["0", "1", "10\u{b2}", "1000"]), [true; 4]);
    assert_eq!(stay(&["10\u{b2} m", "10\u{b3} m"]), [true; 2]);
    assert_eq!(stay(&["A", "5", "5 km"]), [false, true, false]);
    assert_eq!(stay(&["1990", "1995", "2003"]), [false; 3]);
    assert_eq!(stay(&["Mon", "Tue"]), [false; 2]);
}

#[test]
fn a_number_may_stand_a_little_aside() {
    let texts = ["-1", "0", "1"];
    assert_eq!(steps(&texts, &[0.0, 8.0, 20.0]), Some(vec![-1, 0, 1]));
    assert_eq!(steps(&texts, &[0.0, 4.0, 20.0]), None);
}

#[test]
fn a_length_has_a_number_and_its_unit() {
    assert!(["6 cm", "6cm", "7,5 cm", "h = 4 m", "12 km"].into_iter().all(is_length));
    assert!(!["6", "cm", "6 cm\u{b2}", "25 %", "h", "6 kg"].into_iter().any(is_length));
}

#[test]
fn a_sign_is_a_plus_or_a_minus_by_itself() {
    assert!(["+", "-", "\u{2212}", " \u{2013} "].into_iter().all(|text| Alone::of(text) == Some(Alone::Sign)));
    assert_eq!(["-1", "+2 m"].map(Alone::of), [Some(Alone::Number); 2]);
    assert_eq!(["", "a", "++", "+a", "Lamp"].map(Alone::of), [None; 5]);
}
