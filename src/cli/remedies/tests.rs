//! Tests of `remedies`.

use super::*;

#[test]
fn only_options_that_there_are_and_that_help_are_named() {
    let of = |name: &str| Making::of_picture(&Profile::named(name).expect("it is built in"));
    assert_eq!(["swell-a4", "index-basic-d", "monarch"].map(of), [Making::Print, Making::Embossing, Making::Pins]);
    let no_room = |making| of_note(&Note::NoRoomForOverview, making);
    for making in [Making::Print, Making::Embossing] {
        assert!(no_room(making).ends_with("(--sheets 2x2)"), "{}", no_room(making));
    }
    let lacks = |making| of_note(&Note::LinesNotInOverview { percent: 30, place: None }, making);
    for making in [Making::Pins, Making::PageAnew, Making::Other] {
        let told = [no_room(making), lacks(making)].concat();
        assert!(!told.contains("--sheets"), "{making:?}: {told}");
    }
    assert!(lacks(Making::Pins).ends_with("(--no-overview)"), "{}", lacks(Making::Pins));
    assert!(lacks(Making::PageAnew).ends_with("(--set overview.on=false)"), "render has no other option for it");
    let left_out = Note::LinesLeftOut { millimetres: 90, percent: 9, place: None, is_larger_turned: true };
    assert!(of_note(&left_out, Making::PageAnew).ends_with("(--set page.orientation=landscape)"));
    assert_eq!(of_note(&left_out, Making::Other), left_out.to_string());
    assert!(of_note(&Note::EmptyPage, Making::Pins).ends_with("(--crop)"));
    assert_eq!(of_note(&Note::EmptyPage, Making::PageAnew), Note::EmptyPage.to_string());
}
