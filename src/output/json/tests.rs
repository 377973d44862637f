//! Tests of `json`.

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
