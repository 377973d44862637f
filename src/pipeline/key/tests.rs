//! Tests of `key`.

use super::*;

fn label(text: &str, short: Option<&str>, at: [f32; 2]) -> BrailleText {
    BrailleText {
        role: TextRole::Label,
        text: text.to_owned(),
        language: "en".to_owned(),
        abbreviation: short.map(str::to_owned),
        lines: Vec::new(),
        dots: Dots { diameter: 1.6, at: vec![at.into(), MmPoint::from(at) + MmVector::new(2.5, 5.0)] },
        leader: None,
    }
}

fn shorts(braille: &[BrailleText]) -> Vec<String> {
    abbreviations(braille).into_iter().map(|(short, _)| short).collect()
}

#[test]
fn abbreviations_come_in_the_order_in_which_hands_come_to_them() {
    // as they are placed: the second row, then the first from the right, where one stands a little higher
    let braille = [
        label("March", Some("ma"), [20.0, 90.0]),
        label("February", Some("fe"), [80.0, 40.0]),
        label("height", None, [50.0, 41.0]),
        label("January", Some("ja"), [20.0, 42.5]),
        label("February", Some("fe"), [20.0, 120.0]),
    ];
    assert_eq!(shorts(&braille), ["ja", "fe", "ma"]);
    // steps down to the left, each less than a row below the one before
    let steps = ["aa", "bb", "cc", "dd", "ee"];
    let steps = (0_u8..)
        .zip(steps)
        .map(|(k, short)| label(short, Some(short), [90.0 - 15.0 * f32::from(k), 40.0 + 4.0 * f32::from(k)]));
    assert_eq!(shorts(&steps.collect::<Vec<_>>()), ["bb", "aa", "dd", "cc", "ee"]);
}

/// Months below their bars that stand in two lines by turns are read from the left, those of a table line by line.
#[test]
fn a_row_in_two_lines_by_turns_is_one() {
    let in_lines = |places: [f32; 6], down: f32| -> Vec<String> {
        let months = ["ja", "fe", "mr", "ap", "my", "jn"].into_iter().zip(places);
        let of = |(at, (short, x)): (usize, (&str, f32))| {
            label(short, Some(short), [x, if at % 2 == 0 { 100.0 } else { 100.0 + down }])
        };
        let mut braille: Vec<BrailleText> = months.enumerate().map(of).collect();
        braille.extend([label("above", Some("ab"), [90.0, 80.0]), label("below", Some("be"), [10.0, 125.0])]);
        shorts(&braille)
    };
    let (row, table) = ([20.0, 35.0, 50.0, 65.5, 80.0, 95.0], [20.0, 21.0, 50.0, 51.0, 80.0, 81.0]);
    assert_eq!(in_lines(row, 10.0), ["ab", "ja", "fe", "mr", "ap", "my", "jn", "be"]);
    let by_line = ["ab", "ja", "mr", "my", "fe", "ap", "jn", "be"];
    assert_eq!(in_lines(row, 20.0), by_line, "two rows far apart");
    assert_eq!(in_lines(table, 10.0), by_line, "one below the other");
}
