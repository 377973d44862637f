//! Tests of `feeling`.

use super::*;

#[test]
fn what_is_no_svg_is_called_by_its_name() {
    for (bytes, what) in [
        (&b"%PDF-1.7"[..], "a PDF"),
        (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
        (b"\xc3\x28", "no text"),
        (b"dots", "no SVG"),
    ] {
        let told = feel(bytes, &PageOptions::new()).expect_err("it is no SVG").to_string();
        assert!(told.contains(what) && told.contains("SVG"), "{told}");
    }
}
