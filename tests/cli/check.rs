//! `tactograph check`: what it says, and how it ends.

use crate::cli::common::*;

fn with_page() -> Place {
    let place = Place::with_sea();
    let page = place.text("page.svg");
    place.put("thin.svg", page.replace("stroke-width=\"1.5\"", "stroke-width=\"0.15\"").as_bytes());
    let near =
        "<g id=\"lines\"><path d=\"M60,250h60\" stroke=\"#000\"/><path d=\"M60,252h60\" stroke=\"#000\"/></g></svg>";
    place.put("near.svg", page.replace("</svg>", near).as_bytes());
    place
}

#[test]
fn a_page_without_errors_ends_with_0_and_one_with_errors_with_1() {
    let place = with_page();
    let run = place.run(&["check", "page.svg"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.lines().last().is_some_and(|line| line.starts_with("Verdict: 0 errors")), "{}", run.out);
    let run = place.run(&["check", "near.svg"]);
    assert_eq!(run.code, 1, "{}", run.err);
    assert!(run.out.starts_with("error line-gap: "), "{}", run.out);
    // on paper lines are so many mm apart, whatever device is asked for
    let run_for_device = place.run(&["check", "near.svg", "--profile", "index-basic-d"]);
    let least = "mm apart along 60 mm; 2 empty dots of the device, 4.0 mm, are the least";
    assert!(run_for_device.out.contains(least), "{}", run_for_device.out);
    // what render mends
    let thin = place.run(&["check", "thin.svg"]);
    assert_eq!(thin.code, 0, "{}", thin.err);
    assert!(thin.out.contains("warning line-width: "), "{}", thin.out);
    assert_eq!(place.run(&["check", "thin.svg", "--strict"]).code, 1);
    assert!(run.out.contains(" mm from the left and ") && run.out.contains("What to do: "), "{}", run.out);
}

#[test]
fn several_pages_are_checked_one_after_another() {
    let place = with_page();
    let run = place.run(&["check", "page.svg", "near.svg", "page.svg"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""), "the worst of all counts");
    let names: Vec<&str> = run.out.lines().filter(|line| line.ends_with(".svg:")).collect();
    assert_eq!(names, ["page.svg:", "near.svg:", "page.svg:"], "{}", run.out);
    assert_eq!(run.out.lines().filter(|line| line.starts_with("Verdict: ")).count(), 3);
    let refused = place.run(&["check", "page.svg", "near.svg", "--format", "json"]);
    assert_eq!(refused.code, 2);
    assert!(refused.err.contains("--format json takes one page; check them one by one"), "{}", refused.err);
    place.put("page.idx", b"dots");
    let other = place.run(&["check", "page.idx"]);
    assert_eq!((other.code, other.err.lines().count()), (1, 1), "{}", other.err);
    assert!(
        other.err.contains("this is a page as IDX, which holds dots only, and check reads the SVG"),
        "{}",
        other.err
    );
}

#[test]
fn findings_are_drawn_where_it_is_asked_for_and_a_page_comes_from_standard_input_too() {
    let place = with_page();
    let run = place.run(&["check", "near.svg", "--mark", "marked.svg", "--format", "json"]);
    assert_eq!((run.code, run.err.as_str()), (1, "near.svg: wrote marked.svg\n"));
    assert!(run.out.starts_with('{') && place.text("marked.svg").contains("id=\"findings\""), "{}", run.out);
    let run = place.run_with_input(&["check", "-", "--format", "sarif"], place.text("page.svg").as_bytes());
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("\"version\": \"2.1.0\""), "{}", run.out);
}

#[test]
fn rules_are_listed_with_the_numbers_of_a_profile() {
    let place = Place::new();
    let run = place.run(&["check", "--rules"]);
    assert!(run.code == 0 && run.out.contains("line-gap, error (3.2 mm): "), "{}", run.out);
    let run = place.run(&["check", "--rules", "--profile", "index-basic-d"]);
    assert!(run.code == 0 && run.out.contains("line-gap, error (2 dots): "), "{}", run.out);
}

/// A page of several sheets has no file of the name that it was given, and those that it has are named.
#[test]
fn sheets_of_a_page_are_named_where_it_is_asked_for_as_one() {
    let place = with_page();
    let page = place.text("page.svg");
    place.put("rain-1.svg", page.as_bytes());
    place.refuses(&["check", "rain.svg"], 1, &["rain.svg: there is no such file, but rain-1.svg; name that"]);
    ["rain-2.svg", "rain-3.svg"].iter().for_each(|name| place.put(name, page.as_bytes()));
    let line = "rain.svg: there is no such file, but sheets of it, rain-1.svg to rain-3.svg; name one of them";
    place.refuses(&["check", "rain.svg"], 1, &[line]);
    place.refuses(&["render", "rain.svg", "-o", "rain.pdf"], 1, &[line]);
}

#[test]
fn what_cannot_be_checked_is_refused_in_one_line() {
    let place = with_page();
    for (args, code) in [
        (&["check", "missing.svg"][..], 1),
        (&["check"], 2),
        (&["check", "page.svg", "--profile", "nothing"], 2),
        (&["check", "page.svg", "--mark", "page.svg"], 2),
        (&["check", "page.svg", "--format", "xml"], 2),
    ] {
        let run = place.run(args);
        assert_eq!((run.code, run.err.lines().count()), (code, 1), "{args:?}: {}", run.err);
        assert!(run.out.is_empty(), "{args:?}: {}", run.out);
    }
}
