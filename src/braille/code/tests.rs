//! Tests of `code`.

use super::*;
use crate::classes::Class;

#[test]
fn every_table_of_the_program_can_be_read() {
    for code in Code::all() {
        let table = parse::table(code.text).unwrap_or_else(|fault| panic!("{}: {fault}", code.language));
        let alphabet = ('a'..='z').all(|letter| table.letters.contains_key(&letter));
        assert!(alphabet && !table.name.is_empty(), "{}", code.language);
        let mut words = ["key", "blank"].into_iter().chain(Class::ALL.map(Class::name));
        assert!(words.all(|word| table.words.contains_key(word)), "{}", code.language);
        for (sign, rules) in &table.signs {
            // a point in the middle of the line is one of times beside numbers; elsewhere it may be an ornament
            let is_general = sign == "\u{b7}" || rules.last().is_some_and(|rule| (rule.left, rule.right) == ('*', '*'));
            assert!(is_general, "{}: {sign}", code.language);
        }
    }
}
