//! Tests of `next_cell`.

use super::*;
use crate::braille::CellSize;
use crate::devices::Device;
use crate::lines::{Height, Run};
use crate::page::{DotMedium, Medium};

/// Every second dot of a level row from so many steps left of the first column of a label on, and what is left of it
/// beside that label; `beyond` is the row that leads on behind a line, if one does.
fn steps_left(device: &str, sheet: [f32; 2], pitch: f32, [steps, beyond]: [&[usize]; 2]) -> Vec<usize> {
    let device = Device::named(device).expect("in the table");
    let medium = Medium::Dots(DotMedium::on(device, pitch, sheet).expect("its own sheet"));
    let cells = CellGrid::of(&medium, CellSize::MARBURG);
    let corner = cells.snapped(MmRect::new(MmPoint::new(70.0, 40.0), MmPoint::new(90.0, 46.0)));
    let column = MmPoint::new(corner.min.x + 0.5 * cells.diameter, corner.min.y + 0.5 * cells.diameter + pitch);
    let at = |step: &usize| MmPoint::new(column.x - pitch * *step as f32, column.y);
    let line = |steps: &[usize]| {
        let row: Vec<MmPoint> = steps.iter().map(at).collect();
        Line { strength: 20.0, runs: vec![Run::dots(cells.diameter, row, Height::High)] }
    };
    let mut lines = [line(steps), line(beyond)];
    let from = lines[0].runs[0].points[0];
    begin_off_labels(&mut lines, &[(from, corner)], &cells, (pitch, 12.0));
    assert_eq!(lines[1], line(beyond), "it is not beside the label");
    let left = |at: &MmPoint| ((column.x - at.x) / pitch).round() as usize;
    lines[0].runs[0].points.iter().map(left).collect()
}

/// Cells of pins are three columns apart, so that the columns 2 and 3 beside a label are those of the cell before it.
#[test]
fn a_leader_line_has_no_dots_in_the_cell_beside_its_label() {
    let of_pins = |steps: &[usize]| steps_left("monarch", [240.0, 100.0], 2.5, [steps, &[]]);
    assert_eq!(of_pins(&[3, 4, 6, 8, 10, 12]), [4, 6, 8, 10, 12]);
    assert_eq!(of_pins(&[2, 4, 6, 8, 10]), [4, 6, 8, 10]);
    assert_eq!(of_pins(&[4, 6, 8, 10]), [4, 6, 8, 10], "it is off that cell");
    assert_eq!(of_pins(&[2, 4, 6, 8]), [4, 6, 8], "12.5 mm from tip to tip");
    assert_eq!(of_pins(&[2, 4, 6]), [2, 4, 6], "too little would be left");
    assert_eq!(of_pins(&[2, 3, 4, 5, 6, 7]), [2, 3, 4, 5, 6, 7], "a line of all dots is no leader line");
    // dots that are nearer than those of letters
    let of_small = steps_left("index-basic-d-v5", [210.0, 297.0], 1.6, [&[3, 5, 7, 9, 11, 13], &[]]);
    assert_eq!(of_small, [3, 5, 7, 9, 11, 13]);
}

/// Beyond a line across it, as the outline of a cell, a short piece says where the rest leads.
#[test]
fn a_piece_up_to_a_line_that_is_crossed_is_off_that_cell_too() {
    let of_pins = |steps: &[usize], beyond: &[usize]| steps_left("monarch", [240.0, 100.0], 2.5, [steps, beyond]);
    let beyond = [7, 9, 11, 13, 15, 17];
    assert_eq!(of_pins(&[2, 3, 4, 5], &beyond), [4, 5], "it is too short for every second dot");
    assert_eq!(of_pins(&[2, 3, 4, 5], &[17, 15, 13, 11, 9, 7]), [4, 5], "whichever way that goes");
    assert_eq!(of_pins(&[2, 3, 5, 7], &[9, 11, 13, 15]), [5, 7]);
    assert_eq!(of_pins(&[2, 3, 4], &[6, 8, 10, 12]), [2, 3, 4], "a dot by itself is none");
    assert_eq!(of_pins(&[2, 3, 4, 5], &[]), [2, 3, 4, 5], "nothing leads on");
    assert_eq!(of_pins(&[2, 3, 4, 5], &[9, 11, 13, 15]), [2, 3, 4, 5], "a gap");
    assert_eq!(of_pins(&[2, 3, 4, 5], &[6, 7, 8, 9, 10, 11]), [2, 3, 4, 5], "a line of all dots");
}
