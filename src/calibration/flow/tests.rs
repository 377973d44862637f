//! Tests of `flow`.

use super::*;

fn block(width: f32, height: f32, starts_row: bool) -> Block {
    Block { size: MmVector::new(width, height), starts_row, ..Block::default() }
}

#[test]
fn rows_wrap_and_sheets_end() {
    let blocks = vec![
        block(50.0, 10.0, true),
        block(45.0, 20.0, false), // 50 + 5 + 45 just fits
        block(1.0, 10.0, false),  // the row is full
        block(10.0, 10.0, true),
        block(10.0, 60.0, true), // 20 + 8 + 10 + 8 + 10 + 8 + 60 is more than the sheet has
    ];
    let sheets = place(blocks, MmVector::new(100.0, 120.0)).expect("all fit");
    let corners = |sheet: &SheetOfSamples| sheet.iter().map(|(_, at)| (at.x, at.y)).collect::<Vec<_>>();
    assert_eq!(corners(&sheets[0]), [(0.0, 0.0), (55.0, 0.0), (0.0, 28.0), (0.0, 46.0)]);
    assert_eq!(corners(&sheets[1]), [(0.0, 0.0)]);
    let heading = Block { keeps: true, ..block(10.0, 10.0, true) };
    let kept = place(vec![block(1.0, 80.0, true), heading, block(1.0, 20.0, true)], MmVector::new(100.0, 120.0));
    let kept: Vec<usize> = kept.expect("all fit").iter().map(Vec::len).collect();
    assert_eq!(kept, [1, 2], "a heading stays with what it is of");
    assert!(place(vec![block(101.0, 1.0, true)], MmVector::new(100.0, 120.0)).is_err());
}
