//! Tests of `abbreviate`.

use super::*;
use crate::braille::Code;

fn short(texts: &[&str], language: &str) -> Vec<String> {
    let translator = Translator::new(Code::of_language(language).and_then(Code::table), None).expect("a table");
    let known = texts.iter().map(|&text| (text, translator.translate(text))).collect();
    let all = all(texts, &[], &known, &translator);
    all.into_iter().map(|short| short.map_or_else(|| "-".to_owned(), |short| short.letters)).collect()
}

#[test]
fn abbreviations_are_short_readable_and_unique() {
    let texts = ["Apple", "Apricot", "North Hill", "apple tree", "Apple", "1995", "ap", "X", "Aps"];
    // "ap" is a label of its own, and "at" a word
    assert_eq!(short(&texts, "en"), ["al", "ar", "nh", "ae", "al", "-", "-", "-", "as"]);
}

#[test]
fn a_power_is_not_abbreviated_to_its_base() {
    assert_eq!(short(&["10\u{b2} m", "20\u{b2} m", "10\u{b3}"], "en"), ["-"; 3]);
}

/// No abbreviation of a month fits another one as well.
#[test]
fn texts_that_begin_alike_have_the_letter_that_tells_them_apart() {
    let months = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];
    assert_eq!(short(&months, "en"), ["ja", "fe", "mr", "ap", "my", "jn", "jl", "au", "se", "oc", "nv", "de"]);
    assert_eq!(short(&["June", "July"], "en"), ["jn", "jl"]);
    let months = ["Januar", "Februar", "März", "April", "Mai", "Juni", "Juli", "August"];
    assert_eq!(short(&months, "de"), ["ja", "fe", "mä", "ap", "ma", "jn", "jl", "au"]);
    // of several, the letter that tells it from the nearest
    assert_eq!(short(&["Julia", "Julie", "Jupiter", "Jo"], "en"), ["ja", "je", "jp", "-"]);
    // "nh" would fit both
    assert_eq!(short(&["North Hill", "North Hall", "North Hill"], "en"), ["ni", "na", "ni"]);
    // none tells a text that another one goes on from
    assert_eq!(short(&["Apr", "April"], "en"), ["ap", "ai"]);
}

#[test]
fn what_is_on_the_page_keeps_its_abbreviations() {
    let translator = Translator::new(Code::of_language("en").and_then(Code::table), None).expect("a table");
    let texts = ["kiosk", "kitchen"];
    let known = texts.iter().map(|&text| (text, translator.translate(text))).collect();
    let cells = translator.spell("ki").expect("two letters").cells;
    let written = WrittenLabel { text: "kitchen".to_owned(), abbreviation: Some("ki".to_owned()), cells };
    let all = all(&texts, &[written], &known, &translator);
    let letters: Vec<&str> = all.iter().flatten().map(|short| short.letters.as_str()).collect();
    assert_eq!(letters, ["ko", "ki"]);
}

#[test]
fn what_tells_numbered_things_apart_is_kept() {
    assert_eq!(short(&["cup 1", "cup 2", "cup 12", "cap 2"], "en"), ["c1", "c2", "c12", "ca"]);
    assert_eq!(short(&["glass 1", "cup 2"], "en"), ["gl", "cu"], "their words tell them apart");
    assert_eq!(short(&["Area 12", "Area 123", "Room 2007", "Room 2008"], "en"), ["a12", "a123", "r2007", "r2008"]);
    assert_eq!(short(&["Area 1.2", "Area 2.2", "Cup 1 of 3", "Cup 2 of 3"], "en"), ["a1.2", "a2.2", "c1", "c2"]);
    assert_eq!(short(&["Kante 1,5", "Kante 2,5"], "de"), ["k1,5", "k2,5"]);
    assert_eq!(short(&["Class 5a", "Class 5b", "Class 6a"], "en"), ["5a", "5b", "6a"]);
}

/// "km" for "100 km" would say nothing of the scale of a map.
#[test]
fn a_quantity_keeps_its_number() {
    assert_eq!(short(&["100 km", "Port Ann"], "en"), ["100", "pa"]);
    assert_eq!(short(&["100 km", "100"], "en"), ["k100", "-"], "the number is a label of its own");
    assert_eq!(short(&["2,5 km", "12 000 km", "15 °C", "12 m"], "de"), ["2,5", "12000", "-", "-"]);
    assert_eq!(short(&["50 km", "100 km"], "en"), ["50", "100"], "their numbers tell them apart");
    assert_eq!(short(&["667 m", "34 m", "12 s"], "en"), ["667", "34", "-"]);
    assert_eq!(short(&["667 m", "34 m", "667"], "en"), ["m667", "34", "-"], "the number is a label of its own");
    // a minus sign is never lost
    assert_eq!(short(&["-25 m", "-12 m", "25 m"], "en"), ["-25", "-12", "-"]);
}

/// "co" for CO2 would be another substance.
#[test]
fn a_formula_keeps_its_digits_or_has_a_letter_twice() {
    assert_eq!(short(&["CO2", "H2O", "O2", "Air"], "en"), ["co2", "h2o", "-", "ai"]);
    assert_eq!(short(&["CO\u{2082}", "CO\u{2082} level"], "en"), ["co2", "cl"]);
    assert_eq!(short(&["C6H12O6", "C2H5OH", "SO2", "SO3"], "en"), ["cc", "aa", "so2", "so3"]);
    assert_eq!(short(&["Class5", "Room 12", "A4"], "en"), ["cl", "ro", "-"], "these are none");
    assert_eq!(short(&["AB12", "AB13"], "en"), ["a12", "a13"], "nor are numbers of rooms");
    assert_eq!(short(&["CO2", "co2"], "en")[0], "cc", "it is a label of its own");
}

/// In Polish braille a capital is not in the letter, in Spanish a w has the cell of no other letter; but a code may
/// write two letters alike, and cells of abbreviations are never the same.
#[test]
fn abbreviations_differ_in_their_cells() {
    for code in Code::all() {
        let letters = "aàáâãäåæbcçdeèéêëfghiìíîïjklmnñoòóôõöøpqrsßtuùúûüvwxyýząćęłńóśźżčďěňřšťůž";
        let texts: Vec<String> = letters.chars().map(|letter| format!("m{letter}n")).collect();
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let table = code.table().expect("a table");
        let mut seen = BTreeSet::new();
        for short in short(&texts, code.language).iter().filter(|short| *short != "-").collect::<BTreeSet<_>>() {
            let braille = table.translate(short);
            assert!(braille.lacking.is_empty() && braille.cells.len() <= MOST_CELLS, "{}: {short}", code.language);
            assert!(seen.insert(braille.cells), "{}: {short}", code.language);
        }
    }
}

/// "fr" is "friend" in contracted English, before which liblouis writes the sign of letters; what has a digit stays.
#[test]
fn words_of_a_contracted_code_are_no_abbreviations() {
    let table = || Code::of_language("en").and_then(Code::table).expect("a table");
    let short = |marked: &'static [&'static str], texts: &[&str]| -> Vec<String> {
        let spell = table();
        let other = move |text: &str| {
            let sign = marked.contains(&text).then_some(0b11_0000);
            Ok(sign.into_iter().chain(spell.translate(text).cells).collect())
        };
        let translator = Translator::new(Some(table()), Some(&other)).expect("there are two");
        let known = texts.iter().map(|&text| (text, translator.translate(text))).collect();
        let all = all(texts, &[], &known, &translator);
        all.into_iter().map(|short| short.map_or_else(|| "-".to_owned(), |short| short.letters)).collect()
    };
    let words = &["fr", "al", "ab", "bl", "c1"];
    assert_eq!(short(words, &["France", "Albania", "Abyssinia", "Blackland"]), ["fa", "aa", "ay", "ba"]);
    assert_eq!(short(&[], &["France", "Albania", "Abyssinia", "Blackland"]), ["fr", "al", "ab", "bl"]);
    assert_eq!(short(words, &["cup 1", "cup 2"]), ["c1", "c2"]);
    // rather one that may be misread than none
    assert_eq!(short(&["fo", "fx", "fox"], &["Fox"]), ["fo"]);
}

/// "of" for "Office" would be read as the word, also where nothing is contracted.
#[test]
fn short_words_of_the_language_are_no_abbreviations() {
    assert_eq!(short(&["Office", "Town", "Gym"], "en"), ["oi", "tw", "gy"]);
    assert_eq!(short(&["Insel", "Office"], "de"), ["is", "of"]);
    assert_eq!(short(&["Enero", "Lago"], "es"), ["ee", "lg"]);
    // rather one that is a word than none
    assert_eq!(short(&["Inn"], "en"), ["in"]);
}

/// Letters that the code lacks are in no abbreviation.
#[test]
fn letters_without_cells_are_passed_over() {
    assert_eq!(short(&["\u{65e5}\u{672c} Tokyo", "\u{65e5}\u{672c}"], "en"), ["tk", "-"]);
}
