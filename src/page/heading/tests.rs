//! Tests of `heading`.

use super::*;
use crate::braille::Code;
use crate::page::medium::Print;

const MARGIN: f32 = 10.0;

fn title(text: &str) -> Braille {
    Code::of_language("en").and_then(Code::table).expect("a table").translate(text)
}

/// A title in the middle, and from where to where each of its lines has dots.
fn in_the_middle(text: &str, number: usize, width: f32) -> Option<(Heading, Vec<[f32; 2]>)> {
    let (title, medium) = (title(text), Medium::Print(Print::default()));
    let params = HeadingParams::of(&title, number, CellSize::MARBURG, Align::Centre)?;
    let cells = CellGrid::printed(CellSize::MARBURG);
    let heading = Heading::aligned(&params, &cells, [width, 297.0], MARGIN, 0.0).filter(|heading| heading.lines > 0)?;
    let dots = heading.dots(&title, &medium);
    let of_line = |line: usize| {
        let top = MARGIN + line as f32 * CellSize::MARBURG.line;
        let own = || dots.iter().filter(move |at| (top..top + CellSize::MARBURG.line).contains(&at.y)).map(|at| at.x);
        [own().fold(f32::MAX, f32::min), own().fold(0.0, f32::max)]
    };
    let spans = (0..heading.lines(&title).len()).map(of_line).collect();
    Some((heading, spans))
}

/// Only the first line stands beside the number: a word that has no room there has it below, whole and in the middle.
#[test]
fn lines_below_the_page_number_may_be_wider() {
    let text = "A map of electromagneticinduction";
    let (heading, spans) = in_the_middle(text, 3, 210.0).expect("there is room in the middle");
    let lengths: Vec<usize> = heading.lines(&title(text)).iter().map(Vec::len).collect();
    assert_eq!((lengths, heading.divide), (vec![9, 24], Divide::Never));
    for [from, to] in spans {
        assert!((0.5 * (from + to) - 105.0).abs() < CellSize::MARBURG.cell, "{from} to {to}");
    }
}

#[test]
fn lines_keep_clear_of_the_page_number_and_of_the_margins() {
    for text in ["A cup", "A cup of coffee on a table", "Electromagneticinduction in a coil, and what it is for"] {
        for (number, width) in (0..5).flat_map(|number| (6..40).map(move |width| (number, 10.0 * width as f32))) {
            let Some((heading, spans)) = in_the_middle(text, number, width) else { continue };
            assert!(spans.len() <= heading.lines, "{text}, {number} cells, {width} mm");
            for (line, [from, to]) in spans.into_iter().enumerate() {
                let beside = if line == 0 && number > 0 { (number + BEFORE_NUMBER - 1) as f32 } else { 0.0 };
                let least = MARGIN + beside * CellSize::MARBURG.cell;
                assert!(from >= least && to <= width - least, "{text}, {number} cells, {width} mm: {from} to {to}");
            }
        }
    }
}

#[test]
fn a_page_number_without_a_title_takes_one_line_and_ends_at_the_right_margin() {
    const BESIDE: f32 = 5.0;
    let (none, medium) = (title(""), Medium::Print(Print::default()));
    let cells = CellGrid::printed(CellSize::MARBURG);
    assert!(HeadingParams::of(&none, 0, CellSize::MARBURG, Align::Centre).is_none());
    for align in Align::ALL {
        let params = HeadingParams::of(&none, 3, CellSize::MARBURG, align).expect("there is a number");
        let on = |size: [f32; 2]| Heading::on(&params, &cells, size, MARGIN, BESIDE);
        let heading = on([210.0, 297.0]).expect("there is room");
        assert!(heading.lines == 0 && heading.dots(&none, &medium).is_empty());
        assert!((heading.height() - cells.extent(1, 1).y - GAP).abs() < 1e-3, "{}", heading.height());
        // one of two cells ends where those of three end
        for count in [2, 3] {
            let dots = heading.dots_of_number(&vec![0b11_1111; count], &medium);
            let last = dots.iter().map(|at| at.x).fold(0.0, f32::max) + 0.5 * cells.diameter;
            assert!(dots.len() == 6 * count && (last - (210.0 - MARGIN - BESIDE)).abs() < 0.1, "{last}");
        }
        assert!(on([2.0 * MARGIN + BESIDE + 5.0, 297.0]).is_none(), "three cells are wider than that");
        assert!(on([210.0, 50.0]).is_none(), "it would take more than a fifth of the height");
    }
}
