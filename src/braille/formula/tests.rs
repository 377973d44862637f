//! Tests of `formula`.

use super::*;

#[test]
fn formulas_are_more_than_arithmetic() {
    for text in [
        "\u{221a}(x+1) \u{2265} 2",
        "x\u{b2} + \u{bd} = (a+b)/2",
        "a\u{b2} + b\u{b2} = c\u{b2}",
        "E=mc\u{b2}",
        "x\u{2081} + x\u{2082} = 5",
        "5 \u{d7} 10\u{207b}\u{b3}",
        "2x\u{207f} = 8",
        "(a-b) / 2",
        "1/(x + 1)",
        "((a+b)\u{b7}h)/2",
        "up to \u{221e}",
        "\u{2211} = 12",
        "A \u{2229} B",
    ] {
        assert!(is_formula(text), "{text}");
    }
    for text in [
        "F = m \u{b7} a",
        "12 : 4 = 3",
        "x \u{2265} 5",
        "Area = 12 cm\u{b2}",
        "A=5m\u{b2}",
        "density = 1.2 kg/m\u{b3}",
        "Area in km\u{b2}",
        "CO\u{2082} + H\u{2082}O",
        "CO\u{2082} > 400 ppm",
        "10\u{b3}",
        "\u{2205} 5 mm",
        "price (semi-annual)/kg",
        "km/h (at most)",
        "1/2 + 3/4",
        "\u{bd} + \u{bc}",
        "20 \u{b1} 2 m\u{b2}",
        "",
    ] {
        assert!(!is_formula(text), "{text}");
    }
}
