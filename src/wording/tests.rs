//! Tests of `wording`.

use std::collections::{BTreeMap, BTreeSet};

use super::*;

/// Of each message, the values that it is filled with.
fn messages(text: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut all: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut current = String::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        if let Some((name, _)) = line.split_once(" = ").filter(|_| line.starts_with(|c: char| c.is_alphabetic())) {
            name.clone_into(&mut current);
            assert!(all.insert(current.clone(), BTreeSet::new()).is_none(), "{name} is there twice");
        }
        let name = |part: &str| part.chars().take_while(|c| c.is_alphanumeric() || *c == '-').collect::<String>();
        let values = line.split('$').skip(1).map(name);
        if let Some(all) = all.get_mut(&current) {
            all.extend(values);
        }
    }
    all
}

#[test]
fn every_language_has_every_message_with_the_same_values() {
    let english = messages(FILES[0].1);
    assert!(english.len() > 30);
    for (language, text) in FILES {
        assert!(FluentResource::try_new(text.to_owned()).is_ok(), "{language} cannot be read");
        assert_eq!(messages(text), english, "{language}");
    }
}

#[test]
fn every_message_can_be_filled_and_no_word_of_it_is_lost() {
    for language in Wording::languages() {
        let wording = Wording::of_language(language).expect("it is there");
        for (message, values) in messages(FILES[0].1) {
            let pattern = wording.bundle.get_message(&message).and_then(|message| message.value());
            let pattern = pattern.unwrap_or_else(|| panic!("{language}: {message}"));
            for number in [0, 1, 2, 5, 22] {
                let values: FluentArgs<'_> = values.iter().map(|name| (name.as_str(), Value::from(number))).collect();
                let mut faults = Vec::new();
                let text = wording.bundle.format_pattern(pattern, Some(&values), &mut faults);
                assert!(faults.is_empty() && !text.contains(['{', '$']), "{language}: {message}: {text}: {faults:?}");
            }
        }
    }
}

#[test]
fn languages_count_as_they_do() {
    let more = |language: &str, lines: i32| Wording::nearest(language).say("lines-more", &[("lines", lines.into())]);
    assert_eq!(more("en-GB", 1), "1 more line is shorter than these.");
    assert_eq!(more("de", 1), "1 weitere Linie ist kürzer als diese.");
    assert_eq!(more("pl", 3), "3 dalsze linie są krótsze od tych.");
    assert_eq!(more("pl", 12), "12 dalszych linii jest krótszych od tych.");
    assert_eq!(more("pl", 22), "22 dalsze linie są krótsze od tych.");
    assert_eq!(more("fr", 0), "0 autre ligne est plus courte.");
    assert_eq!(more("xx", 2), "2 more lines are shorter than these.");
}

#[test]
fn shares_are_rounded_but_not_to_nothing_or_all() {
    let percent = |share| Wording::english().percent(share);
    let told = [0.0, 0.001, 0.006, 0.25, 0.996, 0.99999].map(percent);
    assert_eq!(told, ["0 %", "under 1 %", "1 %", "25 %", "over 99 %", "100 %"]);
}

#[test]
fn places_are_named_as_everywhere() {
    for (number, name) in crate::geom::ninths::NAMES.iter().enumerate() {
        assert_eq!(Wording::english().place(number), format!("in the {name}"));
    }
}

#[test]
fn colours_are_written_as_the_language_does() {
    let area = |language: &str| {
        let wording = Wording::nearest(language);
        let values: [(&'static str, Value<'_>); 4] = [
            ("colour", wording.colour("green").into()),
            ("share", "5 %".into()),
            ("areas", 1.into()),
            ("place", wording.place(4).into()),
        ];
        wording.say("area", &values)
    };
    assert_eq!(area("de"), "Die Farbe Grün bedeckt 5 % der Abbildung, vor allem in der Mitte.");
    assert_eq!(area("en"), "The colour green covers 5 % of the figure, mainly in the middle.");
    assert_eq!(area("fr"), "La couleur vert couvre 5 % de la figure, surtout au milieu.");
}

#[test]
fn apostrophes_are_of_one_kind() {
    for (language, text) in FILES {
        let said = text.lines().filter(|line| !line.starts_with('#'));
        let straight: Vec<&str> = said.filter(|line| line.contains('\'')).collect();
        assert!(straight.is_empty() || language == "en", "{language}: {straight:?}");
    }
}
