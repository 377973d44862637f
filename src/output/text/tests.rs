//! Tests of `text`.

use super::*;
use crate::page::Shape;

#[test]
fn a_rhombus_at_45_degrees_is_written_with_equal_sides_whatever_its_place() {
    for step in 0..4000 {
        let thickness = 1.0 + step as f32 * 1e-5;
        for at in [MmPoint::new(90.66, 35.35), MmPoint::new(12.34, 250.01)] {
            let shape = Shape::Rhombus { length: 2.0, thickness, degrees: 135.0 };
            for corner in written_corners(&Glyph { at, shape }) {
                let off = corner - at;
                assert!((off.x.abs() - off.y.abs()).abs() < 1e-4, "{thickness} mm: {off:?}");
            }
        }
    }
}

#[test]
fn numbers_are_short_and_right() {
    let text = |value: f32| {
        let (mut three, mut two) = (String::new(), String::new());
        push_number::<3>(&mut three, value);
        push_number::<2>(&mut two, value);
        [three, two]
    };
    for (value, three, two) in [
        (0.0, "0", "0"),
        (-0.0, "0", "0"),
        (7.0, "7", "7"),
        (0.05, "0.05", "0.05"),
        (-0.25, "-0.25", "-0.25"),
        (-3.25, "-3.25", "-3.25"),
        (10.05, "10.05", "10.05"),
        (100.5, "100.5", "100.5"),
        (1.0625, "1.063", "1.06"),
        (0.9996, "1", "1"),
        (0.999, "0.999", "1"),
        (-0.0004, "0", "0"),
        (12.345_6, "12.346", "12.35"),
        (16_777_216.0, "16777216", "16777216"),
        (f32::MAX, "18446744073709551.615", "184467440737095516.15"),
    ] {
        assert_eq!(text(value), [three, two], "{value}");
    }
}

#[test]
fn hundredths_have_two_decimals() {
    for (hundredths, want) in [(0, "0.00"), (5, "0.05"), (1240, "12.40"), (31_705, "317.05")] {
        let mut text = String::new();
        push_hundredths(&mut text, hundredths);
        assert_eq!(text, want);
    }
}

#[test]
fn control_characters_are_replaced() {
    assert_eq!(plain("a\tb\u{1}c\u{ffff}"), "a b\u{fffd}c\u{fffd}");
}
