//! Tests of `signs`.

use super::*;

fn signs(layers: &[(Class, &str)]) -> Signs {
    let said: Vec<_> = layers.iter().map(|(class, sign)| (*class, Sign::named(sign))).collect();
    Signs::of_layers(&said)
}

#[test]
fn directions_mean_the_nearest_class() {
    for (degrees, class) in [
        (0.0, Class::Blue),
        (22.0, Class::Blue),
        (23.0, Class::Green),
        (90.0, Class::Yellow),
        (135.0, Class::Red),
        (157.0, Class::Red),
        (158.0, Class::Blue),
        (179.9, Class::Blue),
    ] {
        assert_eq!(signs(&[]).along(degrees), Some(class), "{degrees}");
    }
}

#[test]
fn layers_say_their_signs_and_push_out_those_that_are_like_them() {
    let swapped = signs(&[(Class::Blue, "rhombus 90")]);
    assert_eq!(swapped.along(85.0), Some(Class::Blue));
    assert_eq!(swapped.sign(Class::Yellow), None, "nothing is known of it but that it is not blue's");
    assert_eq!(swapped.sign(Class::Red), Some(Sign::Rhombus { degrees: 135.0 }));
    let dots = signs(&[(Class::Red, "dot"), (Class::Green, "nonsense")]);
    assert_eq!((dots.sign(Class::Red), dots.sign(Class::Grey)), (Some(Sign::Dot), None));
    assert_eq!(dots.sign(Class::Green), Some(Sign::Rhombus { degrees: 45.0 }));
}

#[test]
fn a_direction_is_clear_away_from_the_middle_between_two_signs() {
    let feel = |degrees, coherence| Feel { ink: 0.1, coherence, degrees };
    let paper = signs(&[]);
    // the middles: 30 between blue and green, 80 between green and yellow
    let leaning = signs(&[(Class::Green, "rhombus 60"), (Class::Yellow, "rhombus 100")]);
    for (signs, degrees, class, clear) in [
        (paper, 18.0, Class::Blue, true),
        (paper, 19.0, Class::Blue, false),
        (paper, 26.0, Class::Green, false),
        (paper, 27.0, Class::Green, true),
        (leaning, 25.0, Class::Blue, true),
        (leaning, 27.0, Class::Blue, false),
        (leaning, 75.0, Class::Green, true),
        (leaning, 77.0, Class::Green, false),
        (leaning, 85.0, Class::Yellow, true),
    ] {
        assert_eq!(signs.read(&feel(degrees, 0.9), 1.0), (Some(class), clear), "{degrees}");
    }
    assert_eq!(paper.read(&feel(0.0, 0.1), 1.0), (Some(Class::Grey), true));
    assert_eq!(paper.read(&feel(0.0, 0.29), 1.0), (Some(Class::Grey), false));
}

#[test]
fn where_no_sign_fits_nothing_is_clear() {
    let feel = |coherence| Feel { ink: 0.1, coherence, degrees: 2.0 };
    let rows = ["0", "36", "72", "108", "144"].map(|degrees| format!("rhombus {degrees}"));
    let layers: Vec<_> = Class::ALL.into_iter().zip(rows.iter().map(String::as_str)).collect();
    assert_eq!(signs(&layers).read(&feel(0.1), 1.0), (Some(Class::Blue), false));
    assert_eq!(signs(&layers).read(&feel(0.9), 1.0), (Some(Class::Blue), true));
    let dots = signs(&Class::ALL.map(|class| (class, "dot")));
    assert!(!dots.read(&feel(0.9), 1.0).1);
    let alike = signs(&[(Class::Blue, "rhombus 0"), (Class::Red, "rhombus 0")]);
    assert!(!alike.read(&feel(0.9), 1.0).1, "either could be meant");
}
