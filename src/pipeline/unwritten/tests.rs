//! Tests of `unwritten`.

use super::*;

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
                  cells for them: 'α', 'β'; write them in words";
    assert!(told.starts_with(wanted), "{told}");
    assert_eq!(Lacks::default().note(), None);
}
