//! Tests of `origin`.

use super::*;
use crate::page::{Figure, Parts};
use crate::units::{MmPoint, MmRect};

/// A page that says this of itself.
fn page(origin: Vec<(String, String)>) -> Page {
    let place = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(80.0, 80.0));
    let figure = Figure { place, source: Size::new(60, 60), textures: Vec::new(), lines: Vec::new() };
    Page::new(Parts { origin, ..Parts::of([100.0, 100.0], figure) }).expect("a page")
}

#[test]
fn what_was_left_out_is_read_as_it_was_said() {
    for left_out in [
        LeftOut { millimetres: 120, of: 400, of_photograph: true, ..LeftOut::default() },
        LeftOut { millimetres: 45, of: 90, by_place: Some([0, 1, 2, 3, 4, 5, 6, 7, 17]), ..LeftOut::default() },
        LeftOut { shapes: 3, ..LeftOut::default() },
        LeftOut { areas: 2, texts: 9, labels: 1, ..LeftOut::default() },
    ] {
        assert_eq!(LeftOut::of(&page(left_out.to_origin())), left_out);
    }
    let whole = LeftOut { of: 400, of_photograph: true, ..LeftOut::default() };
    assert!(LeftOut::of(&page(whole.to_origin())).of_photograph, "one that lacks nothing is a photograph, too");
    assert_eq!(LeftOut::default().to_origin(), [], "nothing of nothing");
}

#[test]
fn what_a_key_tells_is_read_as_it_was_said() {
    let told = ToldInKey {
        colours: vec![(Class::Red, None), (Class::Blue, Some("the sea".into()))],
        abbreviations: vec![("ab".into(), "a long word: two".into())],
        blank: vec![(Class::Green, Some("woods".into())), (Class::Blue, None)],
        title: Some("Where people live: 2024".into()),
    };
    let page = page(told.to_origin());
    assert_eq!(ToldInKey::of(&page), Some(told));
    assert_eq!(ToldInKey::of(&self::page(Vec::new())), None);
}

#[test]
fn a_page_says_what_it_is_made_for_once() {
    let whole = page(Vec::new()).whole_origin();
    assert!(!whole.is_empty());
    assert_eq!(page(whole.clone()).whole_origin(), whole);
}
