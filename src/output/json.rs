//! Contours as JSON:
//!
//! ```text
//! {"program":"tactograph 0.1.0","image":[width,height],"polylines":[
//! {"closed":true,"points":[[x,y],...],"strength":[one per point]},
//! ...
//! ]}
//! ```
//!
//! One polyline a line, so that tools of lines can count and choose. Lines of a page also have `width_mm`. Units are those
//! of [`crate::contours`]; points have at most 3 decimals (a thousandth of a pixel is below what can be measured), strengths
//! and widths at most 2.

use crate::contours::{Polyline, Trace};

/// How a file begins that was written here.
pub const MARK: &str = concat!("{\"program\":\"", env!("CARGO_PKG_NAME"), " ");

/// The file.
pub fn write(trace: &Trace) -> String {
    let points = trace.polylines.iter().map(|line| line.points.len()).sum::<usize>();
    // Most points take some 24 bytes with their strength; more room is made when it is needed.
    let mut out = Vec::with_capacity(200 + 64 * trace.polylines.len() + 24 * points);
    let (width, height) = (trace.size.width, trace.size.height);
    out.extend_from_slice(MARK.as_bytes());
    out.extend_from_slice(concat!(env!("CARGO_PKG_VERSION"), "\",\"image\":").as_bytes());
    out.extend_from_slice(format!("[{width},{height}],\"polylines\":[").as_bytes());
    list(&mut out, b",\n", b"\n", &trace.polylines, polyline);
    out.extend_from_slice(b"\n]}\n");
    String::from_utf8(out).unwrap_or_default() // all that is written is ASCII
}

fn polyline(out: &mut Vec<u8>, line: &Polyline) {
    out.extend_from_slice(if line.closed {
        b"{\"closed\":true,\"points\":["
    } else {
        b"{\"closed\":false,\"points\":["
    });
    list(out, b",", b"", &line.points, |out, at| {
        out.push(b'[');
        number::<3>(out, at.x);
        out.push(b',');
        number::<3>(out, at.y);
        out.push(b']');
    });
    out.extend_from_slice(b"],\"strength\":[");
    list(out, b",", b"", &line.strength, |out, &strength| number::<2>(out, strength));
    if let Some(width) = &line.width {
        out.extend_from_slice(b"],\"width_mm\":[");
        list(out, b",", b"", width, |out, &width| number::<2>(out, width));
    }
    out.extend_from_slice(b"]}");
}

fn list<T>(out: &mut Vec<u8>, between: &[u8], before: &[u8], items: &[T], mut item: impl FnMut(&mut Vec<u8>, &T)) {
    for (i, value) in items.iter().enumerate() {
        out.extend_from_slice(if i > 0 { between } else { before });
        item(out, value);
    }
}

/// A number with at most `DECIMALS` decimals and no zeros at its end; from 2^64 of its last units on it is cut. What is no
/// finite number is `null`, as JSON has no other word for it.
fn number<const DECIMALS: u32>(out: &mut Vec<u8>, value: f32) {
    if !value.is_finite() {
        out.extend_from_slice(b"null");
        return;
    }
    let unit = 10_u64.pow(DECIMALS);
    let units = (f64::from(value.abs()) * unit as f64 + 0.5) as u64;
    if value < 0.0 && units > 0 {
        out.push(b'-');
    }
    digits(out, units / unit, 1);
    let (mut part, mut places) = (units % unit, DECIMALS as usize);
    if part > 0 {
        while part.is_multiple_of(10) {
            part /= 10;
            places -= 1;
        }
        out.push(b'.');
        digits(out, part, places);
    }
}

/// A whole number with zeros before it up to so many `places`.
fn digits(out: &mut Vec<u8>, mut rest: u64, places: usize) {
    let mut text = [b'0'; 20];
    let mut at = text.len();
    while rest > 0 || at + places > text.len() {
        at -= 1;
        text[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
    }
    out.extend_from_slice(&text[at..]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{PxPoint, Size};

    #[test]
    fn numbers_are_short_and_right() {
        let text = |value: f32| {
            let (mut three, mut two) = (Vec::new(), Vec::new());
            number::<3>(&mut three, value);
            number::<2>(&mut two, value);
            [three, two].map(|text| String::from_utf8(text).expect("ASCII"))
        };
        for (value, three, two) in [
            (0.0, "0", "0"),
            (-0.0, "0", "0"),
            (7.0, "7", "7"),
            (0.05, "0.05", "0.05"),
            (-0.25, "-0.25", "-0.25"),
            (100.5, "100.5", "100.5"),
            (1.0625, "1.063", "1.06"),
            (0.9996, "1", "1"),
            (-0.0004, "0", "0"),
            (12.345_6, "12.346", "12.35"),
            (16_777_216.0, "16777216", "16777216"),
            (f32::MAX, "18446744073709551.615", "184467440737095516.15"),
            (f32::NAN, "null", "null"),
            (f32::NEG_INFINITY, "null", "null"),
        ] {
            assert_eq!(text(value), [three, two], "{value}");
        }
    }

    #[test]
    fn the_file_is_as_promised() {
        let points = vec![PxPoint::new(0.5, 1.25), PxPoint::new(10.0, 2.0625)];
        let closed = Polyline { closed: true, points, strength: vec![100.0, 3.456], width: None };
        let line = Polyline { closed: false, width: Some(vec![0.8, 1.5]), ..closed.clone() };
        let trace = |polylines| Trace { size: Size::new(640, 480), polylines };
        let head =
            format!("{{\"program\":\"tactograph {}\",\"image\":[640,480],\"polylines\":[", env!("CARGO_PKG_VERSION"));
        let points = "\"points\":[[0.5,1.25],[10,2.063]],\"strength\":[100,3.46]";
        let lines = format!("\n{{\"closed\":true,{points}}},\n{{\"closed\":false,{points},\"width_mm\":[0.8,1.5]}}");
        assert_eq!(write(&trace(vec![closed, line])), format!("{head}{lines}\n]}}\n"));
        assert_eq!(write(&trace(vec![])), format!("{head}\n]}}\n"));
        assert!(head.starts_with(MARK));
    }
}
