//! Tests of `legend_column`.

use super::*;
use crate::edges::Edgel;
use crate::units::{PxPoint, Size};

fn rect(x: f32, y: f32, width: f32, height: f32) -> MmRect {
    MmRect::new(MmPoint::new(x, y), MmPoint::new(x + width, y + height))
}

/// A word of 10 mm that begins at a place, at its height.
fn word(string: &str, (x, y): (f32, f32)) -> Text {
    Text::of_test(string, rect(x, y - 2.0, 10.0, 4.0))
}

/// A shape of a size around a place, with the word of this number; `middle` stands for its colour.
fn shape(text: usize, (x, y): (f32, f32), [width, height]: [f32; 2], middle: usize) -> Patch {
    Patch { text, place: rect(x - 0.5 * width, y - 0.5 * height, width, height), middle }
}

fn colour(patch: &Patch) -> [f32; 3] {
    [10.0 * patch.middle as f32, 0.0, 0.0]
}

const ROWS: [f32; 4] = [20.0, 28.0, 36.0, 44.0];

/// The words of a map: those of four patches, of a river and a town below them, and the name of a town.
fn words() -> Vec<Text> {
    let rows = ["Grass", "Hills", "Desert", "Sea"].into_iter().zip(ROWS).map(|(string, y)| word(string, (110.0, y)));
    rows.chain([word("River", (110.2, 52.0)), word("Town", (110.0, 58.0)), word("Norton", (54.0, 30.0))]).collect()
}

/// The patches, and the towns of one colour.
fn shapes() -> Vec<Patch> {
    let patches = (0..4).map(|row| shape(row, (100.0, ROWS[row]), [8.0, 5.0], row + 1));
    patches.chain([shape(5, (100.0, 58.0), [3.0, 3.0], 9), shape(6, (50.0, 30.0), [3.0, 3.0], 9)]).collect()
}

#[test]
fn the_column_of_a_legend_has_patches_of_one_size_and_different_colours() {
    let column = Column::of(&shapes(), &words(), colour).expect("a column");
    assert_eq!(column.patches, shapes()[..4]);
    assert!(column.is_sign(shapes()[5].place) && !column.is_sign(shapes()[0].place));
    assert_eq!(Column::of(&shapes()[..2], &words(), colour), None, "two of them");
    assert_eq!(Column::of(&shapes(), &words(), |_| [0.0; 3]), None, "bars of one colour");
    let aside = shapes().into_iter().enumerate().map(|(number, mut patch)| {
        patch.place = patch.place.translate(crate::units::MmVector::new(2.0 * number as f32, 0.0));
        patch
    });
    assert_eq!(Column::of(&aside.collect::<Vec<_>>(), &words(), colour), None, "steps of a stair");
}

#[test]
fn lines_and_signs_in_the_column_are_samples() {
    let size = Size::new(200, 100);
    let transform = PageTransform::new(size, rect(0.0, 0.0, 200.0, 100.0));
    let mut edges = Edges::none(size);
    let edgel = |(x, y): (f32, f32)| Edgel { at: PxPoint::new(x, y), strength: 1.0, contrast: [0.0; 3] };
    let mut push = |points: &[(f32, f32)], closed: bool| edges.push(points.iter().copied().map(edgel), closed);
    push(&[(96.0, 52.0), (104.0, 52.0)], false);
    push(&[(98.5, 56.5), (101.5, 56.5), (101.5, 59.5), (98.5, 59.5)], true);
    // a frame, a town on the map, and what is too far below
    push(&[(90.0, 10.0), (130.0, 10.0), (130.0, 90.0), (90.0, 90.0)], true);
    push(&[(48.5, 28.5), (51.5, 28.5), (51.5, 31.5), (48.5, 31.5)], true);
    push(&[(96.0, 78.0), (104.0, 78.0)], false);
    let texts: Vec<Text> = words().into_iter().chain([word("Scale", (110.0, 78.0))]).collect();
    let column = Column::of(&shapes(), &texts, colour).expect("a column").with_others(&edges, &texts, &transform);
    assert!(column.has_sample(4) && !column.has_sample(6) && !column.has_sample(7));
    let sample = |text: usize, is_line: bool, chain: usize| Sample { text, is_line, chains: vec![chain] };
    let samples = column.samples(&edges, &texts, &transform, &[true; 8]);
    assert_eq!(samples, [sample(4, true, 0), sample(5, false, 1)]);
    let notes: Vec<String> = told(&samples, &texts).iter().map(ToString::to_string).collect();
    assert!(notes[0].contains("samples of lines in the legend (\"River\")"), "{notes:?}");
    assert!(notes[1].contains("samples of signs in the legend (\"Town\")"), "{notes:?}");
    let mut at_curve = texts.clone();
    at_curve[4].place = rect(60.0, 40.0, 1.0, 1.0);
    assert_eq!(column.samples(&edges, &at_curve, &transform, &[true; 8]), samples[1..], "the label of its line");
    let labels: Vec<bool> = (0..8).map(|text| text != 5).collect();
    assert_eq!(column.samples(&edges, &texts, &transform, &labels), samples[..1], "what is no label stays");
}
