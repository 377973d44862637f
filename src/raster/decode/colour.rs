//! From the numbers in a file to light: transfer curves, and ICC profiles through moxcms.
//!
//! Nearly every profile of an RGB or grey picture is three curves and a matrix. Averaging and a matrix may change
//! places, so only the curves are applied to the many pixels of the file (as tables, which the sRGB curve needs as
//! well), and the matrix to the few of the working picture: such a profile costs nothing. Profiles made of a table of
//! colours (CMYK, some scanners) go through moxcms row by row.

use std::sync::Arc;

use moxcms::{ColorProfile, DataColorSpace, Layout, ToneReprCurve, Transform16BitExecutor, TransformOptions};

use crate::raster::planes::Planes;

/// A table from a sample to linear light 0..=1.
pub(super) type ToneTable = Arc<[f32]>;

/// Red, green and blue of the profile to those of sRGB, both in linear light.
pub(super) type Matrix = [[f32; 3]; 3];

/// What kind of numbers a pixel is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ColourKind {
    Grey,
    Rgb,
    Cmyk,
}

/// How the samples of a picture become light.
pub(super) enum Meaning {
    /// By the curve of sRGB; for CMYK by the plain formula.
    Srgb,
    /// By one curve or one for each of red, green and blue, and then a matrix if there is one.
    Curves(Planes<Curve>, Option<Matrix>),
    /// By moxcms to 16-bit sRGB.
    Transform(Arc<Transform16BitExecutor>),
}

/// A curve from a sample 0..=1 to linear light.
pub(super) type Curve = Box<dyn Fn(f32) -> f32>;

/// The transfer curve of sRGB (IEC 61966-2-1): an encoded value to linear light, both 0..=1.
pub(super) fn srgb_to_linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// Linear light for each whole number 0..=`last`, by the sRGB curve.
pub(super) fn srgb_table(last: u32) -> ToneTable {
    (0..=last).map(|i| srgb_to_linear(f64::from(i) / f64::from(last)) as f32).collect()
}

/// Linear light for each whole number 0..=`last`, by a curve.
pub(super) fn curve_table(curve: &Curve, last: u32) -> ToneTable {
    (0..=last).map(|i| sane(curve(i as f32 / last as f32))).collect()
}

/// Into 0..=1, and not a number to 0.
fn sane(value: f32) -> f32 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}

impl Meaning {
    /// What the samples of a picture of this kind mean under an ICC profile.
    ///
    /// # Errors
    /// Why the profile cannot be used.
    pub(super) fn from_profile(icc: &[u8], kind: ColourKind) -> Result<Self, String> {
        let profile = ColorProfile::new_from_slice(icc).map_err(|fault| one_line(&fault))?;
        match (kind, profile.color_space) {
            (ColourKind::Grey, DataColorSpace::Gray) => {
                grey(profile.gray_trc.as_ref().ok_or("it is a grey profile without a curve")?)
            }
            // A colour photo that was made grey and kept its profile: equal red, green and blue are grey by their
            // curve.
            (ColourKind::Grey, DataColorSpace::Rgb) if profile.is_matrix_shaper() => {
                grey(profile.green_trc.as_ref().ok_or("it is a profile without curves")?)
            }
            (ColourKind::Rgb, DataColorSpace::Rgb) if profile.is_matrix_shaper() && !has_colour_table(&profile) => {
                curves_and_matrix(&profile)
            }
            (ColourKind::Rgb, DataColorSpace::Rgb) => transform(&profile, Layout::Rgb),
            // moxcms takes four inks in the layout of four channels.
            (ColourKind::Cmyk, DataColorSpace::Cmyk) => transform(&profile, Layout::Rgba),
            (_, space) => Err(format!("it is for another kind of picture ({space:?})")),
        }
    }

    /// What the samples of a PNG without a profile mean by its gAMA chunk: the exponent by which light was encoded,
    /// such as 0.45455.
    pub(super) fn from_encoding_gamma(gamma: f32) -> Self {
        // sRGB pictures often declare 1/2.2 and mean the curve of sRGB. Below a twentieth of difference nobody sees
        // it.
        const NEAR: f32 = 0.05;
        let exponent = 1.0 / gamma;
        let near_srgb = (gamma * 2.2 - 1.0).abs() < NEAR;
        if near_srgb || !(0.1..=10.0).contains(&exponent) {
            return Self::Srgb;
        }
        Self::Curves(Planes::Grey(Box::new(move |value| value.powf(exponent))), None)
    }
}

fn grey(curve: &ToneReprCurve) -> Result<Meaning, String> {
    let curve = evaluator(curve)?;
    Ok(if is_srgb_curve(&curve) { Meaning::Srgb } else { Meaning::Curves(Planes::Grey(curve), None) })
}

fn curves_and_matrix(profile: &ColorProfile) -> Result<Meaning, String> {
    let curve = |curve: &Option<ToneReprCurve>| evaluator(curve.as_ref().ok_or("it is a profile without curves")?);
    let curves = Planes::Colour([curve(&profile.red_trc)?, curve(&profile.green_trc)?, curve(&profile.blue_trc)?]);
    let matrix = profile.transform_matrix(&ColorProfile::new_srgb()).to_f32().v;
    if matrix.iter().flatten().any(|value| !value.is_finite()) {
        return Err("its primary colours are no colours".into());
    }
    Ok(match (is_identity(&matrix), curves.iter().all(is_srgb_curve)) {
        (true, true) => Meaning::Srgb,
        (true, false) => Meaning::Curves(curves, None),
        (false, _) => Meaning::Curves(curves, Some(matrix)),
    })
}

fn transform(profile: &ColorProfile, layout: Layout) -> Result<Meaning, String> {
    profile
        .create_transform_16bit(layout, &ColorProfile::new_srgb(), Layout::Rgb, TransformOptions::default())
        .map(Meaning::Transform)
        .map_err(|fault| one_line(&fault))
}

fn evaluator(curve: &ToneReprCurve) -> Result<Curve, String> {
    let curve = curve.make_linear_evaluator().map_err(|fault| one_line(&fault))?;
    Ok(Box::new(move |value| curve.evaluate_value(value)))
}

fn has_colour_table(profile: &ColorProfile) -> bool {
    profile.lut_a_to_b_perceptual.is_some() || profile.lut_a_to_b_colorimetric.is_some()
}

/// The many sRGB profiles in use differ in the last digits of their curves and colours; half a step of an 8-bit picture
/// is taken as no difference.
const SRGB_TOLERANCE: f32 = 0.002;

fn is_srgb_curve(curve: &Curve) -> bool {
    (0..=32u8).all(|i| {
        let value = f32::from(i) / 32.0;
        (curve(value) - srgb_to_linear(f64::from(value)) as f32).abs() < SRGB_TOLERANCE
    })
}

fn is_identity(matrix: &Matrix) -> bool {
    matrix.iter().enumerate().all(|(i, row)| {
        row.iter().enumerate().all(|(k, value)| (value - f32::from(u8::from(i == k))).abs() < SRGB_TOLERANCE)
    })
}

/// Applies a matrix to three planes; colours outside the gamut of sRGB are clipped.
pub(super) fn apply_matrix([red, green, blue]: &mut [Vec<f32>; 3], matrix: &Matrix) {
    for ((r, g), b) in red.iter_mut().zip(green).zip(blue) {
        let from = [*r, *g, *b];
        let to = matrix.map(|row| sane(row[0] * from[0] + row[1] * from[1] + row[2] * from[2]));
        [*r, *g, *b] = to;
    }
}

/// Longest message of a decoder that is passed on, letters: their own sentences have up to 100, but some quote what
/// stands in the file, such as the bits of each of a thousand channels.
const LONGEST_MESSAGE: usize = 160;

/// A fault as words on one line.
pub(super) fn one_line(fault: &dyn std::fmt::Display) -> String {
    let text = fault.to_string();
    let plain = |c: char| if c.is_control() { ' ' } else { c };
    let text = text.chars().map(plain).collect::<String>();
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ").trim_end_matches('.').to_owned();
    match text.char_indices().nth(LONGEST_MESSAGE) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text,
    }
}

#[cfg(test)]
mod tests;
