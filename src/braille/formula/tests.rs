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
        "A = 6a\u{b2}",
        "A = 2\u{b7}a\u{b2}",
        "s = 5t\u{b2}",
        "X\u{2081} + X\u{2082} = 5",
        "P\u{2081}V\u{2081} = P\u{2082}V\u{2082}",
        "F\u{2081} = F\u{2082}",
        "V\u{2082} = 5 l",
        "x\u{207a} + 1",
        "v = v\u{2080} + at",
        "x\u{2081}\u{b7}x\u{2082}",
        "x\u{2081} \u{b7} x\u{2082}",
        "a\u{b2} - b\u{b2}",
        "a\u{b2}-b\u{b2}",
        "(a\u{b7}b)/2",
        "x^2",
        "E = mc^2",
        "A = 6a^2",
        "(a+b)^n",
        "10^-3",
    ] {
        assert!(is_formula(text), "{text}");
    }
}

#[test]
fn arithmetic_units_and_chemistry_are_none() {
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
        "5 m\u{b2}",
        "12 cm\u{b3}",
        "3-5 m\u{b2}",
        "5-m\u{b2}-Raum",
        "a = 9.81 m/s\u{b2}",
        "M = 5 N\u{b7}m\u{b2}",
        "Berlin \u{b7} Area in km\u{b2} \u{b7} 2020",
        "5 m^2",
        "12 cm^3",
        "a = 3 m/s^2",
        "^_^",
        "Smith^2",
        "A-B road",
        "e-mail",
        "H\u{2082}O",
        "v\u{2080}",
        "X\u{2081}",
        "2H\u{2082} + O\u{2082} = 2H\u{2082}O",
        "Ca(OH)\u{2082} + CO\u{2082} = CaCO\u{2083} + H\u{2082}O",
        "CuSO\u{2084}\u{b7}5H\u{2082}O",
        "CO\u{2082}-free, x = 5",
        "Na\u{207a} + Cl\u{207b}",
        "2Na \u{2192} 2Na\u{207a} + 2e\u{207b}",
        "Ca\u{b2}\u{207a} + SO\u{2084}\u{b2}\u{207b} = CaSO\u{2084}",
        "",
    ] {
        assert!(!is_formula(text), "{text}");
    }
}
