//! Tests of `place_names`.

use resvg::tiny_skia::{PathBuilder, Rect};

use super::*;
use crate::raster::vector::PaintedPath;

fn text(string: &str, x: f32, y: f32) -> DrawnText {
    let (min, max) = (PxPoint::new(x, y), PxPoint::new(x + 12.0 * string.chars().count() as f32, y + 24.0));
    DrawnText { string: string.to_owned(), min, max, angle: 0.0, size: 20.0, hidden: false }
}

/// The texts with discs of 12 px in these middles.
fn strings(texts: &[DrawnText], discs: &[(f32, f32)]) -> Vec<String> {
    let disc = |&(x, y): &(f32, f32)| {
        let place = Rect::from_xywh(x - 6.0, y - 6.0, 12.0, 12.0).expect("a box");
        PaintedPath::filled(PathBuilder::from_oval(place).expect("a disc"))
    };
    let drawing = VectorDrawing { paths: discs.iter().map(disc).collect(), ..VectorDrawing::default() };
    joined(texts.to_vec(), || Some(drawing)).into_iter().map(|text| text.string).collect()
}

#[test]
fn two_lines_beside_one_sign_are_one_name() {
    let name = [text("Saint", 110.0, 100.0), text("Gallen", 110.0, 124.0)];
    let texts = [&[text("Bern", 300.0, 90.0)][..], &name, &[text("Chur", 110.0, 220.0)]].concat();
    assert_eq!(strings(&texts, &[(96.0, 120.0), (290.0, 100.0)]), ["Bern", "Saint Gallen", "Chur"]);
    assert_eq!(strings(&texts, &[]).len(), 4, "without a sign");
    assert_eq!(strings(&texts, &[(96.0, 110.0), (96.0, 136.0)]).len(), 4, "each has its own");
    assert_eq!(strings(&texts, &[(60.0, 120.0)]).len(), 4, "too far off");
    let hyphen = [text("Baden-", 110.0, 100.0), text("Baden", 110.0, 124.0)];
    assert_eq!(strings(&hyphen, &[(96.0, 120.0)]), ["Baden-Baden"]);
}

#[test]
fn lists_and_numbers_are_several_texts() {
    let discs = [(96.0, 120.0)];
    let three = [text("Saint", 110.0, 100.0), text("Gallen", 110.0, 124.0), text("Chur", 110.0, 148.0)];
    assert_eq!(strings(&three, &discs).len(), 3);
    let number = [text("Bern", 110.0, 100.0), text("134 000", 110.0, 124.0)];
    assert_eq!(strings(&number, &discs).len(), 2);
    let aside = [text("Saint", 110.0, 100.0), text("Gallen", 140.0, 124.0)];
    assert_eq!(strings(&aside, &discs).len(), 2);
    let nearer = [text("Saint", 110.0, 100.0), text("Gallen", 110.0, 124.0), text("Bern", 36.0, 108.0)];
    assert_eq!(strings(&nearer, &discs).len(), 3, "the sign is that of another");
    let country = [text("AUSTRIA", 110.0, 100.0), text("Vienna", 110.0, 124.0)];
    assert_eq!(strings(&country, &discs).len(), 2, "a town in a country");
}

#[test]
fn a_point_and_a_line_of_a_legend_are_two() {
    let texts = vec![text("Data", 110.0, 100.0), text("Model", 110.0, 124.0)];
    let disc = Rect::from_xywh(90.0, 106.0, 12.0, 12.0).and_then(PathBuilder::from_oval).expect("a disc");
    let sample = PathBuilder::from_rect(Rect::from_xywh(84.0, 135.0, 24.0, 2.0).expect("a box"));
    let paths = vec![PaintedPath::filled(disc), PaintedPath::filled(sample)];
    let drawing = VectorDrawing { paths, ..VectorDrawing::default() };
    assert_eq!(joined(texts, || Some(drawing)).len(), 2);
}

#[test]
fn of_more_pairs_than_a_page_has_labels_none_is_joined() {
    let count = |pairs: usize| {
        let x = |pair: usize| 300.0 * pair as f32;
        let name = |pair: usize| [text("Saint", x(pair), 100.0), text("Gallen", x(pair), 124.0)];
        let texts: Vec<DrawnText> = (0..pairs).flat_map(name).collect();
        let discs: Vec<(f32, f32)> = (0..pairs).map(|pair| (x(pair) - 14.0, 120.0)).collect();
        strings(&texts, &discs).len()
    };
    assert_eq!([count(MOST_PAIRS), count(MOST_PAIRS + 1)], [MOST_PAIRS, 2 * (MOST_PAIRS + 1)]);
}
