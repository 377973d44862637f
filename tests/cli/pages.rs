//! Pages of PDF documents.

use std::fs;
use std::path::Path;

use crate::cli::common::*;

/// A place with the worksheet of two pages.
fn place() -> Place {
    let place = Place::new();
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/worksheet.pdf");
    place.put("worksheet.pdf", &fs::read(sample).expect("a sample"));
    place
}

#[test]
fn the_first_page_is_converted_and_the_others_are_told() {
    let place = place();
    let run = place.run(&["convert", "worksheet.pdf"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let lines: Vec<_> = run.err.lines().collect();
    assert_eq!(
        lines[0],
        "tactograph: worksheet.pdf: note: this is page 1 of 2; take another with --page 2, or all with --page 1-2"
    );
    assert!(
        lines[1].contains("12 texts left out") && lines[1].contains("\"Triangles: measure and name\""),
        "{lines:?}"
    );
    assert_eq!(lines.last(), Some(&"wrote worksheet.svg"));
    place.has_page("worksheet.svg");
}

#[test]
fn a_page_is_called_as_the_document_and_pages_have_numbers() {
    let place = place();
    let run = place.run(&["convert", "worksheet.pdf", "--page", "2"]);
    assert!(run.code == 0 && run.err.ends_with("wrote worksheet.svg\n"), "{}", run.err);
    let second = place.text("worksheet.svg");
    assert!(second.contains("worksheet.pdf, page 2") && second.contains("page of the document"), "{second}");
    let run = place.run(&["convert", "worksheet.pdf", "--page", "1-2", "--out-dir", "pages"]);
    assert_eq!(run.code, 0, "{}", run.err);
    for line in ["1 of 2: worksheet.pdf, page 1: wrote", "2 of 2: worksheet.pdf, page 2: wrote"] {
        assert!(run.err.contains(line), "{}", run.err);
    }
    place.has_page("pages/worksheet-1.svg");
    assert_eq!(place.text("pages/worksheet-2.svg"), second, "the same page");
    assert_eq!(fs::read_dir(place.path("pages")).expect("the directory").count(), 2);
    let run = place.run(&["trace", "worksheet.pdf", "--page", "1-2", "-o", "t.json", "-q"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(place.path("t-1.json").is_file() && place.path("t-2.json").is_file());
}

#[test]
fn pages_that_are_not_there_are_told_and_the_others_written() {
    let place = place();
    let told = "worksheet.pdf, page 3: there is no page 3: the document has 2 pages; give a number from 1 to 2";
    place.refuses(&["convert", "worksheet.pdf", "--page", "3"], 1, &[told]);
    let run = place.run(&["convert", "worksheet.pdf", "--page", "2-3", "-q"]);
    assert_eq!(run.code, 1);
    assert!(run.err.starts_with(&format!("tactograph: {told}\n")), "{}", run.err);
    place.has_page("worksheet-2.svg");
    assert_eq!(place.names(), ["worksheet-2.svg", "worksheet.pdf"]);
}

#[test]
fn what_does_not_go_with_several_pages_is_told_at_once() {
    let place = place();
    let args = |more: &[&'static str]| [&["convert", "worksheet.pdf"], more].concat();
    for (args, line) in [
        (
            args(&["--page", "1-2", "-o", "-"]),
            "several pages do not go to standard output; name them with -o or --out-dir",
        ),
        (
            vec!["convert", "-", "--page", "1-2", "-o", "a.svg"],
            "several pages are read one by one, so not from standard input (-); give a file",
        ),
        (
            args(&["--page", "1-2", "--alt", "Triangles"]),
            "--alt: these words are for one picture, but there are 2 pages; convert them one by one",
        ),
    ] {
        place.refuses(&args, 2, &[line]);
    }
    for (page, told) in
        [("0", "the first is 1"), ("x", "give a page such as 3"), ("2-1", "give the lower page first: 1-2")]
    {
        let run = place.run(&args(&["--page", page]));
        assert!(run.code == 2 && run.err.contains(told) && run.err.lines().count() == 1, "{}", run.err);
    }
    assert_eq!(place.names(), ["worksheet.pdf"]);
}
