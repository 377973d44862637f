//! Tests of `rules`.

use super::super::limits::ROWS_BESIDE;
use super::*;

#[test]
fn what_is_asked_of_lines_among_rows_is_what_is_measured() {
    for text in [LINES_AMONG_ROWS.asks, LINES_AMONG_ROWS.source] {
        assert!(text.contains(&format!("{ROWS_BESIDE} mm")), "{text}");
    }
}
