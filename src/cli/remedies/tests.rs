//! Tests of `remedies`.

use super::*;
use tactograph::{About, Told};

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
    let heads = Note::NotOnPage(About::Lines, Reason::NoRoomForArrowhead, Told::from("1 arrowhead").or_larger());
    let told = of_note(&heads, print.beside_overview(true));
    assert!(
        told.ends_with("make the figure larger (--no-overview, --sheets 2x2, --profile swell-a3)"),
        "what helps most first: {told}"
    );
    for (making, options) in [(print, "(--sheets 2x2, --profile swell-a3)"), (embossing, "(--sheets 2x2)")] {
        let told = of_note(&heads, making.beside_overview(false));
        assert!(told.ends_with(&format!("make the figure larger {options}")), "no overview to do without: {told}");
    }
    for making in [Making::Pins, Making::PageAnew, print.of_width(true), embossing.of_width(true)] {
        assert_eq!(of_note(&heads, making), heads.to_string());
    }
    assert_eq!(no_room(print.of_width(true)), no_room(print), "the overview has a sheet of its own there");
    assert_eq!(embossing.beside_overview(true), embossing, "it has a sheet of its own");
    let labels = |is_larger| {
        let (texts, why) = (vec!["Rhine".to_owned()], "there is no room");
        let note = Note::LabelsLeftOut { texts, why, reason: Reason::NoRoomForLabel };
        of_note(&note, print.beside_overview(is_larger))
    };
    assert_eq!([true, false].map(|is_larger| labels(is_larger).contains("--no-overview")), [true, false]);
    let left_out = Note::LinesLeftOut { millimetres: 90, percent: 9, place: None, is_larger_turned: true };
    assert!(of_note(&left_out, Making::PageAnew).ends_with("(--set page.orientation=landscape)"));
    assert_eq!(of_note(&left_out, Making::Other), left_out.to_string());
    assert!(of_note(&Note::EmptyPage, Making::Pins).ends_with("(--crop)"));
    assert_eq!(of_note(&Note::EmptyPage, Making::PageAnew), Note::EmptyPage.to_string());
    let first = Note::NotOnPage(About::Overview, Reason::FirstNotInOverview, String::new().into());
    assert!(of_note(&first, print).ends_with("(--subject with this place, or --simplify 5)"));
    let other = Note::NotOnPage(About::Overview, Reason::ThingNotInOverview, String::new().into());
    assert!(of_note(&other, print).ends_with("(--subject X,Y, or --simplify 5)"));
    let ground = Note::NotOnPage(About::Areas, Reason::GroundBlank, String::new().into());
    assert!(of_note(&ground, Making::Pins).ends_with("(--set figure.ground=true)"));
    let among_rows = Note::Faulty(About::Lines, Reason::AmongRows, String::new());
    let told = |making| of_note(&among_rows, making);
    assert!(told(embossing).contains("--outlines") && told(Making::Pins).contains("--calm-background"));
    let scraps = Note::Faulty(About::Lines, Reason::LooseEnds, String::new());
    for making in [print, embossing, pins] {
        assert!(
            of_note(&scraps, making).ends_with("(--detail 0.2, --simplify 5, --subject X,Y --calm-background)"),
            "{making:?}"
        );
    }
    assert_eq!(of_note(&scraps, Making::PageAnew), scraps.to_string(), "render has none of them");
    assert!(told(Making::PageAnew).contains("figure.textures=false") && !told(Making::PageAnew).contains("--outlines"));
}

/// A drawing that is too dense has more room without the overview, where that takes height of the sheet.
#[test]
fn a_drawing_that_is_too_dense_may_do_without_its_overview() {
    let of = |name: &str| Making::of_picture(&Profile::named(name).expect("it is built in"), false);
    let dense = Note::TooDense { millimetres: 307, percent: 25, place: None, width: 174, is_larger_turned: false };
    let cases = [
        (of("swell-a4").beside_overview(true), "(--no-overview, --sheets 2x2, --crop)"),
        (of("swell-a4").beside_overview(false), "(--sheets 2x2, --crop)"),
        (of("index-basic-d").beside_overview(true), "(--sheets 2x2, --crop)"),
    ];
    for (making, options) in cases {
        let told = of_note(&dense, making);
        assert!(told.ends_with(&format!("so that it is larger {options}")), "{told}");
    }
}

/// What makes a figure larger, of a label that has no room, and what does not: what is done already, and paper that
/// there is not.
#[test]
fn only_what_makes_this_figure_larger_is_named() {
    let told_of = |name: &str, is_larger_without: bool, is_spread: bool, has_width: bool| {
        let profile = Profile::named(name).expect("it is built in");
        let note =
            Note::LabelsLeftOut { texts: vec!["rain".to_owned()], reason: Reason::NoRoomForLabel, why: "no room" };
        let making = Making::of_picture(&profile, is_spread).of_width(has_width).beside_overview(is_larger_without);
        let told = of_note(&note, making);
        told.strip_prefix(&note.to_string()).expect("the note first").to_owned()
    };
    let told =
        |name: &str, is_larger_without: bool, is_spread: bool| told_of(name, is_larger_without, is_spread, false);
    let more = |options: &str| format!("; a larger figure has more ({options})");
    assert_eq!(told("swell-a4", true, false), more("--no-overview, --sheets 2x2, --profile swell-a3"));
    assert_eq!(told("swell-letter", false, false), more("--sheets 2x2, --profile swell-11x17"));
    assert_eq!(told("swell-a3", false, true), "");
    assert_eq!(told("index-basic-d", true, false), more("--sheets 2x2"));
    assert_eq!(told("index-basic-d", true, true), "");
    assert_eq!(told("monarch", true, false), "");
    // as the cells of a table, which are higher than a line of braille there
    let across = |name: &str| {
        let making = Making::of_picture(&Profile::named(name).expect("it is built in"), false).turned(true);
        let note = Note::LabelsLeftOut { texts: Vec::new(), reason: Reason::NoRoomForLabel, why: "no room" };
        of_note(&note, making)
    };
    assert!(across("index-basic-d").ends_with("(--set page.orientation=landscape, --sheets 2x2)"));
    assert!(!across("monarch").contains("landscape"), "a display has one sheet");
    for name in ["swell-a4", "index-basic-d"] {
        assert_eq!(told_of(name, false, false, true), "", "as wide as asked on larger paper, too");
    }
}

#[test]
fn letters_that_are_pixels_can_be_read_by_tesseract() {
    let making = Making::of_picture(&Profile::named("swell-a4").expect("it is built in"), false);
    let told = |are_unread: bool| of_note(&Note::NoTexts { are_unread }, making);
    assert!(told(true).ends_with("have Tesseract read them, or write a list of labels (--ocr, --labels FILE)"));
    assert!(told(false).ends_with("write a list of labels (--labels FILE)") && !told(false).contains("Tesseract"));
}

#[test]
fn words_are_written_in_full_without_the_overview() {
    let making = Making::of_picture(&Profile::named("swell-a4").expect("it is built in"), false);
    let brief = Note::Abbreviated(vec![("ca".to_owned(), "Capital".to_owned())]);
    let lines = Note::NotOnPage(About::Lines, Reason::NoRoomForLine, Told::from("1 line").or_larger());
    let told = |making: Making| of_notes(std::slice::from_ref(&brief), making).concat();
    assert!(told(making.beside_overview(true)).ends_with("there is more room for them (--no-overview)"));
    for other in [making, making.beside_overview(true).of_width(true), Making::PageAnew] {
        assert_eq!(told(other), brief.to_string(), "it would be as large: {other:?}");
    }
    let both = of_notes(&[lines, brief.clone()], making.beside_overview(true));
    assert!(both[0].contains("(--no-overview, ") && both[1] == brief.to_string(), "once: {both:?}");
}

#[test]
fn what_makes_the_figure_larger_is_told_once() {
    let making = Making::of_picture(&Profile::named("swell-a4").expect("it is built in"), false);
    let lost = |about: About| Note::NotOnPage(about, Reason::NoRoomForLine, Told::from("1 line").or_larger());
    let labels = Note::LabelsLeftOut { texts: vec!["rain".to_owned()], reason: Reason::NoRoomForLabel, why: "no room" };
    let told = of_notes(
        &[Note::NoTexts { are_unread: false }, lost(About::Areas), lost(About::Lines), labels.clone()],
        making,
    );
    assert!(told[1].ends_with("make the figure larger (--sheets 2x2, --profile swell-a3)"), "{told:?}");
    assert_eq!(told[2..], [lost(About::Lines).to_string(), labels.to_string()]);
    let or_else = Note::NotOnPage(About::Lines, Reason::NoRoomForLine, Told::from("1").or_larger().or("crop"));
    assert!(of_notes(&[or_else], making)[0].ends_with("larger (--sheets 2x2, --profile swell-a3), or crop"));
    let lines = Note::LinesNotInOverview { percent: 30, place: None };
    let told = of_notes(&[labels, lines], making);
    assert!(told[0].contains("--sheets 2x2") && told[1].ends_with("(--no-overview, --sheets 2x2)"), "{told:?}");
}
