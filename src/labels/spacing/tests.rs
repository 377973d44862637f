//! Tests of `spacing`.

use super::*;

#[test]
fn the_signs_of_two_poles_may_be_nearer_than_other_labels() {
    let wide = Spacing { aside: 14.0, above: 7.0, in_line: 14.0 };
    let narrow = Spacing { aside: 8.0, ..wide };
    let [plus, minus, number, word] = ["+", "\u{2212}", "9 V", "Lamp"].map(Alone::of);
    assert_eq!(wide.between([plus, minus], narrow), (narrow, true));
    assert_eq!(wide.between([number, number], narrow), (wide, true));
    for kinds in [[plus, number], [plus, word], [word, word], [number, word]] {
        assert_eq!(wide.between(kinds, narrow), (wide, false), "{kinds:?}");
    }
    let least = Spacing { aside: 6.0, ..wide };
    assert_eq!(least.between([plus, plus], narrow), (least, true), "where there is room for no more");
}
