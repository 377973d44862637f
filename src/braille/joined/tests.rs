//! Tests of `joined`.

use super::*;

/// The text with an underscore at each blank at which no line ends.
fn joined(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let joined = spaces(&letters);
    letters.iter().enumerate().map(|(at, letter)| if joined.contains(&at) { '_' } else { *letter }).collect()
}

#[test]
fn equations_and_measures_stay_on_one_line() {
    for (text, want) in [
        ("x = ?", "x_=_?"),
        ("c = 12 cm", "c_=_12_cm"),
        ("speed 12 km/h", "speed 12_km/h"),
        ("area 20 m\u{b2}, wet", "area 20_m\u{b2}, wet"),
        ("20 \u{b0}C at noon", "20_\u{b0}C at noon"),
        ("5 - 3 is 2", "5_-_3 is 2"),
        ("AB - CD", "AB_-_CD"),
        ("Leeds - Bradford - York", "Leeds - Bradford - York"),
        ("12 000 people", "12_000 people"),
        ("map 1:25 000", "map 1:25_000"),
        ("1789 100 men", "1789 100 men"),
        ("\u{20ac} 5 or 5 \u{20ac}", "\u{20ac}_5 or 5_\u{20ac}"),
        ("3 apples", "3 apples"),
        ("Area 12", "Area 12"),
        ("History, 14 July 1789", "History, 14_July 1789"),
        ("on the 1st May, Paris", "on the 1st_May, Paris"),
        ("am 14. Juli 1789", "am 14._Juli 1789"),
        ("9. M\u{e4}rz", "9._M\u{e4}rz"),
        ("el 14 de julio de 1789", "el 14_de_julio de 1789"),
        ("1er mai", "1er_mai"),
        ("Room 114 July", "Room 114 July"),
        ("14 de 20", "14 de 20"),
        ("3 Mayors", "3 Mayors"),
        ("height = length \u{d7} width", "height =_length_\u{d7}_width"),
    ] {
        assert_eq!(joined(text), want);
    }
}

#[test]
fn of_braille_by_another_program_the_blanks_are_found_by_their_words() {
    assert_eq!(blanks("x = 5 cm or so", &[1, 0, 2, 0, 3, 4, 0, 5, 0, 6, 0, 7]), [1, 3, 6]);
    assert!(blanks("x = 5", &[1, 2, 3]).is_empty(), "it left its blanks out");
}
