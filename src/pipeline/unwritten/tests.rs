//! Tests of `unwritten`.

use super::*;

/// A letter that is lacking is left out of a title, and told; a formula that would say something else is not written.
#[test]
fn formulas_that_would_lose_signs_are_no_titles() {
    for (language, text, is_written) in [
        ("en", "Kaffee \u{65e5}", true),
        ("en", "x\u{b2} + y\u{b2} = 4", true),
        ("en", "CO\u{2082} and H\u{2082}O", true),
        ("en", "x\u{b2} = \u{222b} f(x) dx", false),
        ("en", "a\u{1d62} = 3", false),
        ("de", "U = 2 π r", false),
        ("de", "50 Ω", false),
        ("pl", "20 €", true),
        ("pl", "20 \u{20bd}", false),
        ("de", "Der Name Αθήνα", true),
        ("de", "Δλ = 5 nm", false),
        ("it", "a ≠ b", false),
        ("fr", "Škoda", true),
    ] {
        let translator =
            Translator::new(crate::braille::Code::named(language).and_then(crate::braille::Code::table), None);
        let translator = translator.expect("a table");
        let (braille, notes) = title(text, &translator);
        assert_eq!(braille.is_some(), is_written, "{text}: {notes:?}");
        let is_told = notes.iter().any(|note| matches!(note, Note::NotTranslated { .. }));
        let is_other = notes.iter().any(|note| note.to_string().contains("for ‘Š’: \"Škoda\""));
        assert_eq!(is_other, text == "Škoda", "{notes:?}");
        assert_eq!(is_told, !is_written, "{text}: {notes:?}");
    }
}

#[test]
fn lowered_numbers_on_the_line_are_told() {
    let of =
        |language| Translator::new(crate::braille::Code::named(language).and_then(crate::braille::Code::table), None);
    let texts = ["CO\u{2082}", "tree"];
    let told = on_line(&texts, &of("cs").expect("a table")).expect("a note").to_string();
    assert!(told.contains("stand on the line") && told.contains("\"CO\u{2082}\"") && !told.contains("tree"), "{told}");
    assert_eq!(on_line(&texts, &of("en").expect("a table")), None);
}

/// What is more than arithmetic is told where our table writes it; another translator may know a mathematical code.
#[test]
fn formulas_are_told_as_written_sign_by_sign() {
    let table = |language| crate::braille::Code::named(language).and_then(crate::braille::Code::table);
    let english = Translator::new(table("en"), None).expect("a table");
    for text in ["\u{221a}(x+1) \u{2265} 2", "x\u{b2} + \u{bd} = (a+b)/2"] {
        let (braille, notes) = title(text, &english);
        assert!(braille.is_some(), "{notes:?}");
        let told = notes.iter().map(Note::to_string).collect::<Vec<_>>();
        let wanted = format!("written in braille sign by sign, not by the rules of a mathematical code: \"{text}\"");
        assert_eq!(told, [wanted]);
    }
    assert!(title("F = m \u{b7} a, 12 cm\u{b2}", &english).1.is_empty());
    // a title that is not written at all is not written sign by sign
    let dutch = Translator::new(table("nl"), None).expect("a table");
    let notes = title("\u{221a}(x+1) \u{2265} 2", &dutch).1;
    assert!(!notes.iter().any(|note| note.to_string().contains("sign by sign")), "{notes:?}");
    let other = |text: &str| -> Result<Vec<u8>, String> { Ok(vec![1; text.len()]) };
    let other = Translator::new(table("en"), Some(&other)).expect("a translator");
    assert_eq!(sign_by_sign(&["x\u{b2} = 4"], &other), None);
    let told = sign_by_sign(&["x\u{b2} = 4", "tree", "x\u{b2} = 4"], &english).expect("a note").to_string();
    assert!(told.ends_with("code: \"x\u{b2} = 4\""), "{told}");
}

#[test]
fn what_several_texts_lack_is_told_once() {
    let lacking = |character: char| [Lacking { character, at: 1 }];
    let mut lacks = Lacks::default();
    lacks.add("α = 39", &lacking('α'));
    lacks.add("α = 39", &lacking('α'));
    let told = lacks.note().expect("a note").to_string();
    assert!(told.contains("no cells for it: 'α' (character 1); write it in words"), "one text: {told}");
    let mut lacks = Lacks::default();
    for (text, character) in [("α = 39", 'α'), ("β", 'β'), ("2α", 'α')] {
        lacks.add(text, &lacking(character));
    }
    lacks.add("apple", &[]);
    let told = lacks.note().expect("a note").to_string();
    let wanted = "left out of the braille of \"α = 39\", \"β\", \"2α\", as its code has no \
                  cells for them: 'α' (character 1 of \"α = 39\"), 'β' (character 1 of \"β\"); write them in words";
    assert!(told.starts_with(wanted), "{told}");
    assert_eq!(Lacks::default().note(), None);
}
