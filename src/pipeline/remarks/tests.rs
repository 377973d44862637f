//! Tests of `remarks`.

use super::*;
use crate::page::{Figure, Parts, ToldInKey};
use crate::profile::Profile;
use crate::units::{MmPoint, MmRect, Size};

#[test]
fn an_empty_page_is_told_with_why_it_is_empty() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it is right");
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(160.0, 160.0));
    let figure = Figure { place, source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
    let page = Page::new(Parts::of([210.0, 297.0], figure)).expect("it is on the sheet");
    let told = |all_erased: bool| {
        let sheets = FinishedSheets { of_picture: vec![&page], key: &[], has_lines: false, medium: &page.medium };
        Remarks::default().of_sheets(&sheets, PictureFacts { all_erased, ..PictureFacts::default() }, &plan)
    };
    assert_eq!(told(false), [Note::EmptyPage]);
    assert_eq!(told(true), [Note::AllErased]);
}

#[test]
fn of_a_title_without_room_it_is_told_whether_the_key_has_it() {
    let told = |title: Option<&str>| {
        let told = ToldInKey { title: title.map(str::to_owned), ..ToldInKey::default() };
        let mut remarks = Remarks::default();
        let above = NoRoomAbove { title: Some(90), number: false }.or(NoRoomAbove { title: None, number: true });
        let key = Key { told, ..Key::default() };
        remarks.add_words(&[Note::NotContracted], above, vec![Note::NoTexts { are_unread: false }], &key);
        remarks.0
    };
    let in_order = |in_key: bool| {
        let no_texts = Note::NoTexts { are_unread: false };
        [Note::NotContracted, Note::NoRoomForTitle { cells: 90, in_key }, Note::NoRoomForNumber, no_texts]
    };
    assert_eq!(told(None), in_order(false));
    assert_eq!(told(Some("Rain")), in_order(true));
}
