//! Tests of `told_labels`.

use super::*;
use crate::lines::Run;
use crate::units::Size;

#[test]
fn a_label_that_stands_at_what_another_names_is_told() {
    let place = |x: f32| MmRect::new(MmPoint::new(x, 10.0), MmPoint::new(x + 10.0, 16.0));
    let wanted = |text: &str, x: f32| Wanted {
        text: text.to_owned(),
        anchor: place(x),
        lost_leader: None,
        kept_leader: None,
        is_nameless: false,
    };
    let placed = |x: f32| Ok(Placed::of_test(place(x)));
    let all = [wanted("11", 20.0), wanted("6", 80.0)];
    let told = nearer_to_others(&all, &[placed(60.0), placed(80.0)]).expect("a note").to_string();
    assert!(told.contains("than to their own: \"11\" near \"6\"; make the figure larger"), "{told}");
    assert_eq!(nearer_to_others(&all, &[placed(25.0), placed(80.0)]), None);
}

#[test]
fn textures_that_labels_cut_by_a_third_are_told() {
    assert_eq!(with_less_texture(&[]), None);
    let told = with_less_texture(&[vec!["North"]]).expect("a note").to_string();
    let expected = "more than a third of the texture of 1 area (under \"North\"), where the label stands";
    assert!(told.contains(expected), "{told}");
    let told = with_less_texture(&[vec!["North"], vec!["South", "Town"]]).expect("a note").to_string();
    assert!(told.contains("more than a third of each of the textures of 2 areas"), "{told}");
    assert!(told.contains("(under \"North\", under \"South\" and \"Town\")"), "{told}");
    let told = with_less_texture(&[vec!["1", "2", "3", "4", "5", "6", "7"]]).expect("a note").to_string();
    assert!(told.contains("(under \"1\", \"2\", \"3\", \"4\", \"5\" and 2 more)"), "{told}");
}

#[test]
fn a_heading_that_is_abbreviated_is_told_and_what_stands_beside_others_is_none() {
    let run = Run::stroke(1.5, vec![MmPoint::new(0.0, 30.0), MmPoint::new(90.0, 30.0)]);
    let line = Line { strength: 50.0, runs: vec![run] };
    let place = MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(100.0, 80.0));
    let figure = Figure { place, source: Size::new(100, 80), textures: Vec::new(), lines: vec![line] };
    let wanted = |text: &str, x: f32, y: f32| Wanted {
        text: text.to_owned(),
        anchor: MmRect::new(MmPoint::new(x, y), MmPoint::new(x + 30.0, y + 5.0)),
        lost_leader: None,
        kept_leader: None,
        is_nameless: false,
    };
    let short = || Ok(Placed { abbreviation: Some("rim".to_owned()), ..Placed::of_test(place) });
    let told = |wanted: &[Wanted], results: &[Result<Placed, Unplaced>]| {
        of_headings(wanted, results, &figure).map(|note| note.to_string()).unwrap_or_default()
    };
    let above = [wanted("Rain in March", 20.0, 10.0), wanted("Mon", 20.0, 60.0)];
    let heading = told(&above, &[short(), short()]);
    assert!(heading.contains("the full text of \"Rain in March\" above the drawing, as"), "{heading}");
    assert!(!told(&above, &[Err(Unplaced::NoRoom), short()]).is_empty());
    assert_eq!(told(&above, &[Ok(Placed::of_test(place)), short()]), "", "it is there");
    let below = [wanted("Rain in March", 20.0, 60.0), wanted("Mon", 20.0, 70.0)];
    assert_eq!(told(&below, &[short(), short()]), "", "below a line");
    let columns = [wanted("Rain in March", 20.0, 10.0), wanted("Sun in March", 60.0, 11.0)];
    assert_eq!(told(&columns, &[short(), short()]), "", "headings of columns");
    let name = [wanted("Rain", 20.0, 10.0), wanted("Mon", 20.0, 60.0)];
    assert_eq!(told(&name, &[short(), short()]), "", "too short for a heading");
}

#[test]
fn labels_are_counted_as_they_are_told() {
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(20.0, 16.0));
    let short = |brief: &str| Ok(Placed { abbreviation: Some(brief.to_owned()), ..Placed::of_test(place) });
    let all = [
        ("North", short("n")),
        ("North", short("n")),
        ("South", Ok(Placed::of_test(place))),
        ("East", Err(Unplaced::NoRoom)),
        ("West", Err(Unplaced::NoRoom)),
        ("10", Err(Unplaced::Thinned(2))),
        ("Town", Err(Unplaced::TooMany)),
    ];
    let wanted = |text: &str| Wanted {
        text: text.to_owned(),
        anchor: place,
        lost_leader: None,
        kept_leader: None,
        is_nameless: false,
    };
    let (texts, results): (Vec<Wanted>, Vec<Result<Placed, Unplaced>>) =
        all.into_iter().map(|(text, result)| (wanted(text), result)).unzip();
    let (notes, counts) = told(&texts, &results);
    assert_eq!(counts, LabelCounts { left_out: 4, without_room: 2, abbreviated: 1 });
    let told_of = |note: &Note| if let Note::LabelsLeftOut { texts, .. } = note { texts.len() } else { 0 };
    assert_eq!(notes.iter().map(told_of).sum::<usize>(), counts.left_out);
}
