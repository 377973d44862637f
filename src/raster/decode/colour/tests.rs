//! Tests of `colour`.

use super::*;

#[test]
fn messages_of_decoders_are_short_and_on_one_line() {
    assert_eq!(one_line(&"a\n b\u{1b}[31m c."), "a b [31m c");
    let long = one_line(&"2, ".repeat(1000));
    assert!(long.chars().count() <= LONGEST_MESSAGE + 3 && long.ends_with("..."), "{long}");
}

#[test]
fn the_curve_of_srgb_meets_known_values() {
    assert!(srgb_to_linear(0.0).abs() < f64::EPSILON);
    assert!((srgb_to_linear(1.0) - 1.0).abs() < f64::EPSILON);
    assert!((srgb_to_linear(188.0 / 255.0) - 0.502_886).abs() < 1e-6); // a grey of 188 is half of white's light
    assert!((srgb_to_linear(10.0 / 255.0) - 10.0 / 255.0 / 12.92).abs() < 1e-12);
}

#[test]
fn the_srgb_profile_is_known_as_such() {
    let icc = ColorProfile::new_srgb().encode().unwrap();
    assert!(matches!(Meaning::from_profile(&icc, ColourKind::Rgb), Ok(Meaning::Srgb)));
    assert!(matches!(Meaning::from_profile(&icc, ColourKind::Grey), Ok(Meaning::Srgb)));
    assert!(Meaning::from_profile(&icc, ColourKind::Cmyk).is_err());
}

#[test]
fn a_wide_profile_gets_a_matrix_that_keeps_white() {
    let icc = ColorProfile::new_display_p3().encode().unwrap();
    let Ok(Meaning::Curves(Planes::Colour(_), Some(matrix))) = Meaning::from_profile(&icc, ColourKind::Rgb) else {
        panic!("Display P3 is three curves and a matrix")
    };
    for row in matrix {
        assert!((row.iter().sum::<f32>() - 1.0).abs() < 1e-3, "{matrix:?}");
    }
    assert!(matrix[0][0] > 1.2 && matrix[0][1] < -0.2, "{matrix:?}"); // 1.2249, -0.2247 by CSS Color 4
}

#[test]
fn a_gamma_near_that_of_srgb_means_srgb() {
    assert!(matches!(Meaning::from_encoding_gamma(0.45455), Meaning::Srgb));
    assert!(matches!(Meaning::from_encoding_gamma(0.0), Meaning::Srgb));
    assert!(matches!(Meaning::from_encoding_gamma(f32::NAN), Meaning::Srgb));
    assert!(matches!(Meaning::from_encoding_gamma(1.0), Meaning::Curves(..)));
}
