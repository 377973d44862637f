//! Tests of `remedies`.

use super::*;

#[test]
fn only_options_that_there_are_and_that_help_are_named() {
    let of = |name: &str| Making::of_picture(&Profile::named(name).expect("it is built in"), false);
    let [print, embossing, pins] = ["swell-a4", "index-basic-d", "monarch"].map(of);
    assert!(matches!((print, embossing, pins), (Making::Print(_), Making::Embossing(_), Making::Pins)));
    let no_room = |making| of_note(&Note::NoRoomForOverview, making);
    for making in [print, embossing] {
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

/// What makes a figure larger, of a label that has no room, and what does not: what is done already, and paper that
/// there is not.
#[test]
fn only_what_makes_this_figure_larger_is_named() {
    let told = |name: &str, settings: &[(&str, &str)], is_spread: bool| {
        let mut profile = Profile::named(name).expect("it is built in");
        settings.iter().for_each(|(key, value)| profile.set(key, value).expect("a key"));
        let note =
            Note::LabelsLeftOut { texts: vec!["rain".to_owned()], reason: Reason::NoRoomForLabel, why: "no room" };
        let told = of_note(&note, Making::of_picture(&profile, is_spread));
        told.strip_prefix(&note.to_string()).expect("the note first").to_owned()
    };
    let more = |options: &str| format!("; a larger figure has more ({options})");
    let no_overview = [("overview.on", "false")];
    assert_eq!(told("swell-a4", &[], false), more("--no-overview, --sheets 2x2, --profile swell-a3"));
    assert_eq!(told("swell-letter", &no_overview, false), more("--sheets 2x2, --profile swell-11x17"));
    assert_eq!(told("swell-a3", &[], true), more("--no-overview"));
    assert_eq!(told("swell-a3", &no_overview, true), "");
    assert_eq!(told("index-basic-d", &[], false), more("--sheets 2x2"));
    assert_eq!(told("index-basic-d", &[], true), "");
    assert_eq!(told("monarch", &[], false), "");
}
