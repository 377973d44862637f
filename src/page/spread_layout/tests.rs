//! Tests of `spread_layout`.

use super::*;
use crate::page::{MediumParams, Print};

#[test]
fn grids_are_read_and_written() {
    for text in ["2x2", "1x9", "3X1", " 2 x 4 "] {
        let grid: SheetGrid = text.parse().expect(text);
        assert_eq!(grid.to_string(), text.replace(' ', "").to_lowercase());
    }
    for text in ["1x1", "0x3", "10x2", "2", "x", "2x", "2x2x2", "-1x2"] {
        assert_eq!(text.parse::<SheetGrid>(), Err(Error::NotASheetGrid), "{text}");
    }
}

#[test]
fn a_window_begins_below_the_highest_of_what_stands_above_it() {
    let mark = MarkParams { length: 12.0, width: 2.0, gap: 5.0 };
    let params = |mark| Params {
        sheet: [210.0, 297.0],
        orientation: sheet::Orientation::Portrait,
        margin: 10.0,
        frame: None,
        overview: None,
        mark,
        heading: None,
        medium: MediumParams::Print(Print::default()),
    };
    let found =
        [(Some(mark), 0.0), (Some(mark), 30.0), (None, 7.0)].map(|(mark, label)| above(&params(mark), label, None));
    let gap = mark.gap.max(GAP);
    assert_eq!(found.to_vec(), [sheet::reach(mark) + gap, 30.0 + gap, 7.0 + GAP]);
}
