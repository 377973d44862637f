//! `tactograph feel`: what is said of a page, and of what is none.

use crate::cli::common::*;

/// The percentage that follows `word` in a line of the report.
fn percent(line: &str, word: &str) -> u32 {
    let number = line.split_once(&format!("{word} ")).and_then(|(_, rest)| rest.split_once(" %"));
    number.and_then(|(number, _)| number.parse().ok()).unwrap_or_else(|| panic!("{word} is not in {line:?}"))
}

#[test]
fn a_page_is_told_in_sentences() {
    let place = Place::with_sea();
    let run = place.run(&["feel", "page.svg"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let lines: Vec<&str> = run.out.lines().collect();
    assert_eq!(lines[0], "What a fingertip of 1 mm feels, in shares of the textured area of each colour:");
    let (judged, not_judged) = (percent(lines[1], "right"), percent(lines[1], "not judged"));
    assert!(lines[1].starts_with("blue, 100 % of all textures: right "), "{}", run.out);
    assert!(judged > 50 && (99..=101).contains(&(judged + not_judged)), "the border is not judged: {}", run.out);
    let of_total = |word| percent(lines[2], word) == percent(lines[1], word);
    assert!(lines[2].starts_with("All textures: ") && of_total("right") && of_total("not judged"), "{}", run.out);
    assert!(lines[3].starts_with("What lies nearer than 7 mm to a line or a border is not judged"), "{}", run.out);
    assert!(lines.iter().all(|line| !line.contains(['|', '\t', '\u{1b}'])), "nothing for eyes only: {}", run.out);
    assert_eq!(place.names(), ["page.svg", "sea.svg"], "nothing is written that was not asked for");
}

#[test]
fn a_page_comes_from_standard_input_too_and_the_fingertip_is_chosen() {
    let place = Place::with_sea();
    let page = place.text("page.svg");
    let run = place.run_with_input(&["feel", "-", "--finger", "1.5"], page.as_bytes());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.starts_with("What a fingertip of 1.5 mm feels"), "{}", run.out);
}

#[test]
fn several_pages_are_felt_one_after_another() {
    let place = Place::with_sea();
    place.put("other.svg", place.text("page.svg").as_bytes());
    let run = place.run(&["feel", "page.svg", "missing.svg", "other.svg"]);
    assert_eq!(run.code, 1, "the worst of all counts");
    assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    let names: Vec<&str> = run.out.lines().filter(|line| line.ends_with(".svg:")).collect();
    assert_eq!(names, ["page.svg:", "other.svg:"], "{}", run.out);
    assert_eq!(run.out.lines().filter(|line| line.starts_with("All textures: ")).count(), 2);
    let line = "-o takes one page; feel them one by one";
    place.refuses(&["feel", "page.svg", "other.svg", "-o", "felt.png"], 2, &[line]);
}

#[test]
fn a_map_is_written_where_it_is_asked_for() {
    let place = Place::with_sea();
    let run = place.run(&["feel", "page.svg", "-o", "felt.png"]);
    assert_eq!((run.code, run.err.as_str()), (0, "page.svg: wrote felt.png\n"));
    let map = std::fs::read(place.path("felt.png")).expect("there is a map");
    assert!(map.starts_with(b"\x89PNG"));
    assert_eq!(place.names(), ["felt.png", "page.svg", "sea.svg"]);
}

#[test]
fn what_cannot_be_felt_is_refused_in_one_line() {
    let place = Place::with_sea();
    place.put("photo.svg", b"\xff\xd8\xff\xe0");
    let no_page = "this cannot be read as a page: it has no group with the id figure or texture-blue (-green, -yellow, -red, \
                   -grey); give a page that tactograph made";
    place.refuses(&["feel", "sea.svg"], 1, &[&format!("sea.svg: {no_page}")]);
    place.refuses(&["feel", "none.svg"], 1, &["none.svg: there is no such file; check the name"]);
    place.refuses(
        &["feel", "photo.svg"],
        1,
        &["photo.svg: this cannot be read as a page: it is a JPEG picture; give the SVG of the page, or convert the picture to a page.svg"],
    );
    let see = "see tactograph feel --help";
    place.refuses(&["feel"], 2, &[&format!("name a page to feel; {see}")]);
    place.refuses(
        &["feel", "page.svg", "--finger", "9"],
        2,
        &[&format!("invalid value '9' for '--finger <MM>': give a number of millimetres from 0.3 to 2.5; {see}")],
    );
    place.refuses(
        &["feel", "page.svg", "-o", "page.svg"],
        2,
        &["page.svg: a map is written only to a .png file; name it page.png"],
    );
}
