//! Tests of `names`.

use super::*;

#[test]
fn letters_have_names() {
    assert_eq!(["minus", "Euro", "odd", ""].map(letter_named), [Some('\u{2212}'), Some('\u{20ac}'), None, None]);
    assert_eq!(
        ["Ccaron", "ccaron", "OE", "oe"].map(letter_named),
        ['\u{10c}', '\u{10d}', '\u{152}', '\u{153}'].map(Some)
    );
    assert_eq!(["Alpha", "omega", "sigma"].map(letter_named), ['\u{391}', '\u{3c9}', '\u{3c3}'].map(Some));
    assert_eq!(["uni0416", "uni+416", "uni04161"].map(letter_named), [Some('\u{416}'), None, None]);
}
