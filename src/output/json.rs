//! Contours as JSON:
//!
//! ```text
//! {"program":"tactograph 0.1.0","image":[width,height],"polylines":[
//! {"closed":true,"points":[[x,y],...],"strength":[one per point]},
//! ...
//! ]}
//! ```
//!
//! One polyline a line, so that tools of lines can count and choose. Lines of a page also have `width_mm`. Units are
//! those of `contours`; points have at most 3 decimals (a thousandth of a pixel is below what can be measured),
//! strengths and widths at most 2.

use super::text::push_number;
use crate::contours::{Polyline, Trace};

/// How a file begins that was written here.
pub const MARK: &str = concat!("{\"program\":\"", env!("CARGO_PKG_NAME"), " ");

/// The file.
pub fn write(trace: &Trace) -> String {
    let points = trace.polylines.iter().map(|line| line.points.len()).sum::<usize>();
    // Most points take some 24 bytes with their strength; more room is made when it is needed.
    let mut out = String::with_capacity(200 + 64 * trace.polylines.len() + 24 * points);
    let (width, height) = (trace.size.width, trace.size.height);
    out.push_str(MARK);
    out.push_str(concat!(env!("CARGO_PKG_VERSION"), "\",\"image\":"));
    out.push_str(&format!("[{width},{height}],\"polylines\":["));
    list(&mut out, ",\n", "\n", &trace.polylines, polyline);
    out.push_str("\n]}\n");
    out
}

fn polyline(out: &mut String, line: &Polyline) {
    out.push_str(if line.closed { "{\"closed\":true,\"points\":[" } else { "{\"closed\":false,\"points\":[" });
    list(out, ",", "", &line.points, |out, at| {
        out.push('[');
        number::<3>(out, at.x);
        out.push(',');
        number::<3>(out, at.y);
        out.push(']');
    });
    out.push_str("],\"strength\":[");
    list(out, ",", "", &line.strength, |out, &strength| number::<2>(out, strength));
    if let Some(width) = &line.width_mm {
        out.push_str("],\"width_mm\":[");
        list(out, ",", "", width, |out, &width| number::<2>(out, width));
    }
    out.push_str("]}");
}

fn list<T>(out: &mut String, between: &str, before: &str, items: &[T], mut item: impl FnMut(&mut String, &T)) {
    for (i, value) in items.iter().enumerate() {
        out.push_str(if i > 0 { between } else { before });
        item(out, value);
    }
}

/// What is no finite number is `null`, as JSON has no other word for it.
fn number<const DECIMALS: u32>(out: &mut String, value: f32) {
    if value.is_finite() {
        push_number::<DECIMALS>(out, value);
    } else {
        out.push_str("null");
    }
}

#[cfg(test)]
mod tests;
