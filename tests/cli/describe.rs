//! `tactograph describe`: what is said of a page, and of what is none.

use crate::cli::common::*;

const SEA: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\">\
                   <rect width=\"300\" height=\"200\" fill=\"#fff\"/><circle cx=\"60\" cy=\"60\" r=\"50\" fill=\"#24c\"/></svg>";

#[test]
fn a_page_is_told_in_sentences_and_as_data() {
    let place = Place::new();
    place.put("sea.svg", SEA.as_bytes());
    let run = place.run(&["convert", "sea.svg", "-o", "page.svg", "-q"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let run = place.run(&["describe", "page.svg"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let lines: Vec<&str> = run.out.lines().collect();
    assert_eq!(lines[0], "The page is called \"sea.svg\".");
    assert!(lines[1].starts_with("A sheet upright, 210 by 297 mm, with a figure of "), "{}", run.out);
    assert!(lines[1].ends_with("has 1 line and 1 textured area."), "{}", run.out);
    assert!(lines[2].starts_with("A closed round outline in the upper left, "), "{}", run.out);
    assert!(lines[3].starts_with("The colour blue covers "), "{}", run.out);
    assert!(lines[4].ends_with(" of the figure has no texture."), "{}", run.out);
    assert!(lines.last().is_some_and(|line| line.starts_with("Verdict: 0 errors")), "{}", run.out);
    let run = place.run(&["describe", "page.svg", "--json"]);
    let list: serde_json::Value = serde_json::from_str(&run.out).expect("JSON");
    assert_eq!(list.as_array().map(Vec::len), Some(lines.len()));
    assert_eq!(list[2]["about"], "shape");
    // the page itself says the same of its marks
    let marks = lines[1..lines.len() - 1].join(" ");
    assert!(place.text("page.svg").contains(&format!("<desc xml:lang=\"en\">{marks}</desc>")), "{marks}");
    let run = place.run(&["describe", "sea.svg"]);
    assert_eq!((run.code, run.err.lines().count(), run.out.as_str()), (1, 1, ""), "{}", run.err);
}

#[test]
fn a_page_is_told_in_other_languages() {
    let place = Place::new();
    place.put("sea.svg", SEA.as_bytes());
    let run = place.run(&["convert", "sea.svg", "-o", "page.svg", "-q", "--lang", "de"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let told = |lang: &[&str]| place.run(&[&["describe", "page.svg"], lang].concat()).out;
    // a page in German is told in German unless another language is asked for
    let german = told(&[]);
    assert!(german.contains("\nEin geschlossener runder Umriss oben links, "), "{german}");
    assert!(german.contains("\nDie Farbe Blau bedeckt ") && german.contains("\nUrteil: 0 Fehler"), "{german}");
    assert_eq!(told(&["--lang", "de-CH"]), german);
    assert!(place.text("page.svg").contains("<desc xml:lang=\"de\">Ein Blatt im Hochformat, "));
    for (language, colour) in [("en", "blue"), ("es", "azul"), ("fr", "bleu"), ("pl", "niebieski")] {
        let text = told(&["--lang", language]);
        assert!(text.contains(colour) && text.lines().count() == german.lines().count(), "{text}");
    }
    place.refuses(
        &["describe", "page.svg", "--lang", "tlh"],
        2,
        &["--lang: there is no language of descriptions called \"tlh\"; take one of en, de, es, fr, pl"],
    );
}

#[test]
fn pages_are_told_while_they_are_made() {
    let place = Place::new();
    place.put("sea.svg", SEA.as_bytes());
    place.put("lake.svg", SEA.as_bytes());
    let run = place.run(&["convert", "sea.svg", "lake.svg", "--out-dir", "pages", "--describe", "-q"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.err);
    let told = |page: &str| place.run(&["describe", page]).out;
    assert_eq!(run.out, format!("{}\n{}", told("pages/sea.svg"), told("pages/lake.svg")));
    place.refuses(
        &["convert", "sea.svg", "-o", "-", "--describe"],
        2,
        &["--describe writes to standard output, and so does -o -; name a file with -o"],
    );
}

#[test]
fn texts_that_are_left_out_are_told() {
    let place = Place::new();
    place.put("chart.svg", &crate::common::samples::read("chart.svg"));
    let told = |labels: &str| {
        let run = place.run(&["convert", "chart.svg", "-o", "page.svg", "-q", "--force", "--labels", labels]);
        assert_eq!(run.code, 0, "{}", run.err);
        place.run(&["describe", "page.svg"]).out
    };
    place.put("none.csv", b"20%,35%,rain\n");
    let without = told("none.csv");
    assert!(without.contains("\n9 texts of the picture were left out when the page was made.\n"), "{without}");
    assert!(!told("texts").contains("texts of the picture were left out"));
}
