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
mod tests {
    use super::*;
    use crate::units::{PxPoint, Size};

    #[test]
    fn what_is_no_number_is_null() {
        for value in [f32::NAN, f32::NEG_INFINITY] {
            let mut text = String::new();
            number::<3>(&mut text, value);
            assert_eq!(text, "null");
        }
    }

    #[test]
    fn the_file_is_as_promised() {
        let points = vec![PxPoint::new(0.5, 1.25), PxPoint::new(10.0, 2.0625)];
        let closed = Polyline { closed: true, points, strength: vec![100.0, 3.456], width_mm: None };
        let line = Polyline { closed: false, width_mm: Some(vec![0.8, 1.5]), ..closed.clone() };
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
