//! Tests of `key`.

use super::*;

#[test]
fn abbreviations_come_in_the_order_in_which_hands_come_to_them() {
    let label = |text: &str, short: Option<&str>, at: [f32; 2]| BrailleText {
        role: TextRole::Label,
        text: text.to_owned(),
        language: "en".to_owned(),
        abbreviation: short.map(str::to_owned),
        lines: Vec::new(),
        dots: Dots { diameter: 1.6, at: vec![at.into(), MmPoint::from(at) + MmVector::new(2.5, 5.0)] },
        leader: None,
    };
    // as they are placed: the second row, then the first from the right, where one stands a little higher
    let braille = [
        label("March", Some("ma"), [20.0, 90.0]),
        label("February", Some("fe"), [80.0, 40.0]),
        label("height", None, [50.0, 41.0]),
        label("January", Some("ja"), [20.0, 42.5]),
        label("February", Some("fe"), [20.0, 120.0]),
    ];
    let shorts: Vec<String> = abbreviations(&braille).into_iter().map(|(short, _)| short).collect();
    assert_eq!(shorts, ["ja", "fe", "ma"]);
    // steps down to the left, each less than a row below the one before
    let steps = ["aa", "bb", "cc", "dd", "ee"];
    let steps = (0_u8..)
        .zip(steps)
        .map(|(k, short)| label(short, Some(short), [90.0 - 15.0 * f32::from(k), 40.0 + 4.0 * f32::from(k)]));
    let shorts: Vec<String> = abbreviations(&steps.collect::<Vec<_>>()).into_iter().map(|(short, _)| short).collect();
    assert_eq!(shorts, ["bb", "aa", "dd", "cc", "ee"]);
}
