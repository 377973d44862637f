//! Tests of `sign_legend`.

use super::*;
use crate::units::MmPoint;

fn rect(x: f32, y: f32, width: f32, height: f32) -> MmRect {
    MmRect::new(MmPoint::new(x, y), MmPoint::new(x + width, y + height))
}

/// A sign of a kind around a place, with the word of this number.
fn sign(kind: u8, (x, y): (f32, f32), word: Option<usize>) -> PlacedSign {
    PlacedSign { chain: 0, kind, is_filled: kind == 0, place: rect(x - 1.0, y - 1.0, 2.0, 2.0), word, letters: vec![] }
}

/// A text of 4 mm that begins at a place, at its height.
fn text((x, y): (f32, f32)) -> Text {
    Text::of_test("Boys", rect(x, y - 2.0, 10.0, 4.0))
}

/// Five points of two kinds.
fn points() -> Vec<PlacedSign> {
    let places = [(40.0, 50.0), (52.0, 71.0), (61.0, 83.0), (75.0, 60.0), (88.0, 92.0)];
    (0..).zip(places).map(|(number, at)| sign(number % 2, at, None)).collect()
}

#[test]
fn the_word_of_a_sign_stands_beside_it() {
    let texts = [text((30.0, 20.0)), text((30.0, 40.0))];
    let word = |x: f32, y: f32| word_of(rect(x - 1.0, y - 1.0, 2.0, 2.0), &texts);
    assert_eq!([word(24.0, 20.5), word(46.0, 39.0)], [Some(0), Some(1)], "on its left and on its right");
    assert_eq!([word(15.0, 20.0), word(24.0, 30.0)], [None; 2], "too far, and at another height");
    let of_large_letters = [Text { size: 7.0, ..text((30.0, 20.0)) }];
    assert_eq!(word_of(rect(15.0, 19.0, 2.0, 2.0), &of_large_letters), Some(0));
}

#[test]
fn the_frame_of_a_legend_holds_samples_with_their_words_and_not_much_more() {
    let texts = [text((20.0, 12.0)), text((20.0, 18.0))];
    let samples = [sign(0, (14.0, 12.0), Some(0)), sign(0, (14.0, 18.0), Some(1))];
    let signs = [&points()[..], &samples].concat();
    let frame = rect(10.0, 8.0, 22.0, 14.0);
    assert_eq!(
        in_frame(&signs, &texts, &[rect(5.0, 5.0, 95.0, 95.0), frame], &[]),
        samples,
        "not the frame of the plot"
    );
    assert_eq!(in_frame(&signs, &texts, &[rect(0.0, 0.0, 60.0, 30.0)], &[]), [], "a room");
    let with_point = [&signs[..], &[sign(0, (28.0, 15.0), None)]].concat();
    assert_eq!(in_frame(&with_point, &texts, &[frame], &[]), [], "a point without a word is in it");
}

#[test]
fn in_a_frame_one_sign_of_each_kind_may_have_a_word_that_was_not_read() {
    let unread = |at| Text { string: String::new(), ..text(at) };
    let texts = [text((20.0, 12.0)), unread((20.0, 18.0))];
    let frame = rect(10.0, 8.0, 22.0, 14.0);
    let framed = |samples: &[PlacedSign], others: &[(usize, MmRect)]| {
        in_frame(&[&points()[..], samples].concat(), &texts, &[frame], others)
    };
    let told = |samples: &[PlacedSign]| legend_with(samples, &texts);
    let samples = [sign(0, (14.0, 12.0), Some(0)), sign(1, (14.0, 18.0), Some(1))];
    assert_eq!(framed(&samples, &[]), samples);
    assert_eq!(told(&samples), "the legend in the figure (\"Boys\", and 1 word that nobody has read)");
    assert_eq!(told(&samples[1..]), "the legend in the figure, whose words nobody has read");
    let without = [sign(0, (14.0, 12.0), None), samples[1].clone()];
    assert_eq!(framed(&without, &[(7, rect(40.0, 11.0, 2.0, 2.0))]), [], "a point that has no word");
    let found = framed(&without, &[(7, rect(20.0, 11.0, 2.0, 2.0)), (8, rect(20.0, 15.0, 9.0, 7.0))]);
    assert_eq!(found.iter().map(|of| of.letters.clone()).collect::<Vec<_>>(), [vec![7], vec![]], "letters");
    let of_one_kind = [samples[0].clone(), sign(0, (14.0, 18.0), Some(1))];
    assert_eq!(framed(&of_one_kind, &[]), [], "two of one kind");
    assert_eq!(framed(&[samples[0].clone(), sign(1, (17.0, 18.0), Some(1))], &[]), [], "not in a column");
}

#[test]
fn a_legend_without_a_frame_has_one_sign_of_each_kind_in_line() {
    let texts = [text((20.0, 12.0)), text((20.0, 18.0)), text((60.0, 12.0))];
    let of = |samples: &[PlacedSign]| in_line(&[&points()[..], samples].concat(), &texts);
    let column = [sign(0, (14.0, 12.0), Some(0)), sign(1, (14.0, 18.0), Some(1))];
    assert_eq!(of(&column), column);
    let row = [sign(0, (14.0, 12.0), Some(0)), sign(1, (54.0, 12.0), Some(2))];
    assert_eq!(of(&row), row);
    assert_eq!(of(&[column[0].clone(), sign(1, (17.0, 18.0), Some(1))]), [], "not in line");
    assert_eq!(of(&[column[0].clone(), sign(0, (14.0, 18.0), Some(1))]), [], "two of one kind");
    let named: Vec<PlacedSign> = points().into_iter().map(|point| PlacedSign { word: Some(2), ..point }).collect();
    assert_eq!(in_line(&[&named[..], &column].concat(), &texts), [], "all points have names");
}

#[test]
fn what_helps_is_said_once() {
    let told = |of_kinds: bool| helped("the legend".to_owned(), of_kinds).to_string();
    assert_eq!(told(false), "the legend; say in the title or a label what the points stand for");
    assert_eq!(told(true), "the legend", "what is told of points of several kinds says it");
}
