//! Tests of `quotes`.

use super::*;

#[test]
fn a_pair_of_straight_marks_opens_and_closes() {
    let of = |text: &str| -> String {
        let mut text: Vec<(char, usize)> = text.chars().zip(1..).collect();
        paired(&mut text);
        text.into_iter().map(|(character, _)| character).collect()
    };
    assert_eq!(of("'yes'"), "\u{2018}yes\u{2019}");
    assert_eq!(of("the 'big one', and 'no'."), "the \u{2018}big one\u{2019}, and \u{2018}no\u{2019}.");
    assert_eq!(of("('Don't!')"), "(\u{2018}Don't!\u{2019})");
    assert_eq!(of("'5'"), "\u{2018}5\u{2019}");
    assert_eq!(of("the '90s' and '90'"), "the \u{2018}90s\u{2019} and \u{2018}90\u{2019}");
    assert_eq!(of("'Twas the night', by N."), "\u{2018}Twas the night\u{2019}, by N.");
    let both = of("'tis 'the boys' bike'");
    assert_eq!(both, "'tis \u{2018}the boys\u{2019} bike'");
    for apostrophes in ["don't", "'tis", "the boys' bike", "rock 'n' roll", "'90s", "5' 6'", "A'B'", "f'(x)", "'", ""] {
        assert_eq!(of(apostrophes), apostrophes);
    }
    for apostrophes in ["'tis the boys' bike", "'Twas James' idea", "give 'em the girls' ball", "'90s bands' songs"] {
        assert_eq!(of(apostrophes), apostrophes);
    }
}
