//! Tests of `tesseract`.

use super::*;

const HEADING: &str = "level\tpage_num\tblock_num\tpar_num\tline_num\tword_num\tleft\ttop\twidth\theight\tconf\ttext";

#[test]
fn words_of_each_picture_are_joined_if_they_are_sure() {
    let rows = ["1\t1\t0\t0\t0\t0\t0\t0\t90\t40\t-1\t", "5\t1\t1\t1\t1\t1\t1\t1\t9\t9\t96.1\tRain"];
    let more = ["5\t1\t1\t1\t1\t2\t1\t1\t9\t9\t91\tin mm", "5\t3\t1\t1\t1\t1\t1\t1\t9\t9\t12\t~|", "5\t9\t1"];
    let table = [&[HEADING][..], &rows, &more].concat().join("\n");
    assert_eq!(words(&table, 3).expect("a table"), ["Rain in mm", "", ""]);
    assert!(words("", 3).is_err() && words("Rain in mm\n", 1).is_err());
}

#[test]
fn a_language_of_two_letters_that_is_not_known_is_told() {
    let refused = language("xx").expect_err("no language");
    assert!(refused.starts_with("--ocr: it is not known what Tesseract calls the language xx"), "{refused}");
}
