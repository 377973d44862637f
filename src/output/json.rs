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
    let points = trace.polylines.iter().map(|polyline| polyline.points.len()).sum::<usize>();
    // Most points take some 24 bytes; that saves copying, and is no limit.
    let mut out = String::with_capacity(200 + 64 * trace.polylines.len() + 24 * points);
    out.push_str(MARK);
    out.push_str(concat!(env!("CARGO_PKG_VERSION"), "\",\"image\":"));
    let (width, height) = (trace.size.width, trace.size.height);
    out.push_str(&format!("[{width},{height}],\"polylines\":["));
    for (i, line) in trace.polylines.iter().enumerate() {
        out.push_str(if i > 0 { ",\n" } else { "\n" });
        polyline(&mut out, line);
    }
    out.push_str("\n]}\n");
    out
}

fn polyline(out: &mut String, line: &Polyline) {
    out.push_str(if line.closed { "{\"closed\":true,\"points\":[" } else { "{\"closed\":false,\"points\":[" });
    for (i, at) in line.points.iter().enumerate() {
        out.push_str(if i > 0 { ",[" } else { "[" });
        number(out, at.x, 3);
        out.push(',');
        number(out, at.y, 3);
        out.push(']');
    }
    out.push(']');
    numbers(out, "strength", &line.strength);
    if let Some(width) = &line.width {
        numbers(out, "width_mm", width);
    }
    out.push('}');
}

fn numbers(out: &mut String, name: &str, values: &[f32]) {
    out.push_str(",\"");
    out.push_str(name);
    out.push_str("\":[");
    for (i, &value) in values.iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        number(out, value, 2);
    }
    out.push(']');
}

/// A number with at most `decimals` decimals and no zeros at its end. JSON has no word for what is no number but `null`.
fn number(out: &mut String, value: f32, decimals: u32) {
    if !value.is_finite() {
        out.push_str("null");
        return;
    }
    let unit = 10_u64.pow(decimals);
    let units = (f64::from(value) * unit as f64).round(); // more than 10^19 units are cut to that
    if units <= -1.0 {
        out.push('-');
    }
    let units = units.abs() as u64;
    let (mut rest, mut digits, mut at) = (units, [b'0'; 24], 24);
    let mut seen = false; // a digit that is not a zero at the end
    for place in 0.. {
        let digit = (rest % 10) as u8;
        rest /= 10;
        seen |= digit > 0 || place >= decimals;
        if seen {
            at -= 1;
            digits[at] = b'0' + digit;
        }
        if place + 1 == decimals && seen {
            at -= 1;
            digits[at] = b'.';
        }
        if rest == 0 && place >= decimals {
            break;
        }
    }
    out.push_str(std::str::from_utf8(&digits[at..]).unwrap_or_default());
}
