//! Tests of `pef`.

use super::*;

#[test]
fn long_lines_are_cut_at_blanks() {
    let rows = |line: &str, columns: usize| {
        let line = line.replace(' ', "\u{2800}");
        rows_of(&line, columns).iter().map(|row| row.replace('\u{2800}', " ")).collect::<Vec<_>>()
    };
    assert_eq!(rows("⠁⠃ ⠉⠙⠑ ⠋", 6), ["⠁⠃ ⠉⠙⠑", "⠋"]);
    assert_eq!(rows("⠁⠃ ⠉⠙⠑ ⠋", 5), ["⠁⠃", "⠉⠙⠑ ⠋"]);
    assert_eq!(rows("⠁⠃⠉⠙⠑", 2), ["⠁⠃", "⠉⠙", "⠑"]);
    assert_eq!(rows("", 2), [""]);
    assert_eq!(rows("  ⠁⠃", 3), ["  ⠁", "⠃"]);
}
