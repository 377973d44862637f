//! `tactograph describe`: what is said of a page, and of what is none.

use crate::cli::common::*;

#[test]
fn a_page_is_told_in_sentences_and_as_data() {
    let place = Place::new();
    let drawing = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\">\
                   <rect width=\"300\" height=\"200\" fill=\"#fff\"/><circle cx=\"60\" cy=\"60\" r=\"50\" fill=\"#24c\"/></svg>";
    place.put("sea.svg", drawing.as_bytes());
    let run = place.run(&["convert", "sea.svg", "-o", "page.svg", "-q"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let run = place.run(&["describe", "page.svg"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let lines: Vec<&str> = run.out.lines().collect();
    assert!(lines[0].starts_with("\"sea.svg\": a sheet upright, 210 by 297 mm, with a figure of "), "{}", run.out);
    assert!(lines[0].ends_with("has 1 line and 1 textured area."), "{}", run.out);
    assert!(lines[1].starts_with("In the upper left: a closed round outline, "), "{}", run.out);
    assert!(lines[2].starts_with("The colour blue covers "), "{}", run.out);
    assert!(lines.last().is_some_and(|line| line.starts_with("Verdict: 0 errors")), "{}", run.out);
    let run = place.run(&["describe", "page.svg", "--json"]);
    let list: serde_json::Value = serde_json::from_str(&run.out).expect("JSON");
    assert_eq!(list.as_array().map(Vec::len), Some(lines.len()));
    assert_eq!(list[1]["about"], "shape");
    let run = place.run(&["describe", "sea.svg"]);
    assert_eq!((run.code, run.err.lines().count(), run.out.as_str()), (1, 1, ""), "{}", run.err);
}
