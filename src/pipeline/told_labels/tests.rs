//! Tests of `told_labels`.

use super::*;

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
}
