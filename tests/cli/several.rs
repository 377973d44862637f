//! Several pictures in one run.

use crate::cli::common::*;

#[test]
fn several_pictures_go_to_a_directory_and_are_told_in_order() {
    let place = Place::new();
    let names = ["e", "d", "c", "b", "a"].map(|name| format!("{name}.png"));
    names.iter().for_each(|name| place.put(name, &picture()));
    let mut args = vec!["convert", "--out-dir", "pages/new"];
    args.extend(names.iter().map(String::as_str));
    let run = place.run(&args);
    let expected = (1..).zip(["e", "d", "c", "b", "a"]);
    let expected = expected.map(|(i, name)| format!("{i} of 5: {name}.png: wrote pages/new/{name}.svg\n"));
    assert_eq!((run.code, run.out.as_str(), run.err), (0, "", expected.collect::<String>()));
    ["e", "d", "c", "b", "a"].iter().for_each(|name| place.has_page(&format!("pages/new/{name}.svg")));
}

#[test]
fn a_bad_picture_does_not_stop_the_others() {
    let place = Place::with_picture("a.png");
    place.put("b.png", b"");
    place.put("d.png", &picture());
    let bad = "tactograph: b.png: the file is empty; give a picture\n\
        tactograph: c.png: there is no such file; check the name\n";
    let summary = "tactograph: 2 of 4 pictures could not be converted\n";
    let run = place.run(&["convert", "a.png", "b.png", "c.png", "d.png"]);
    let expected = format!("1 of 4: a.png: wrote a.svg\n{bad}4 of 4: d.png: wrote d.svg\n{summary}");
    assert_eq!((run.code, run.err), (1, expected));
    place.has_page("a.svg");
    place.has_page("d.svg");
    assert_eq!(place.names(), ["a.png", "a.svg", "b.png", "d.png", "d.svg"]);
    let quiet = place.run(&["convert", "--quiet", "a.png", "b.png", "c.png", "d.png"]);
    assert_eq!((quiet.code, quiet.err), (1, format!("{bad}{summary}")));
}

#[test]
fn several_pictures_do_not_fit_into_one_page() {
    let place = Place::with_picture("a.png");
    let line = "-o names one page, but there are 2 pictures; use --out-dir DIR for several";
    place.refuses(&["convert", "a.png", "b.png", "-o", "p.svg"], 2, &[line]);
    let line = "the argument '--output <PAGE>' cannot be used with '--out-dir <DIR>'; see tactograph convert --help";
    place.refuses(&["convert", "a.png", "-o", "p.svg", "--out-dir", "d"], 2, &[line]);
    assert_eq!(place.names(), ["a.png"]);
}

#[test]
fn two_pictures_for_one_page_are_refused() {
    let place = Place::with_picture("a.png");
    place.put("a.jpg", &picture());
    place.put("d/b.png", &picture());
    let both = |page, one, two| {
        format!("{page}: would be the page of both {one} and {two}; convert one of them alone, with -o")
    };
    place.refuses(&["convert", "a.png", "a.jpg"], 2, &[&both("a.svg", "a.png", "a.jpg")]);
    let args = ["convert", "a.png", "b.png", "d/b.png", "a.jpg", "--out-dir", "new"];
    let lines = [both("new/b.svg", "b.png", "d/b.png"), both("new/a.svg", "a.png", "a.jpg")];
    place.refuses(&args, 2, &[&lines[0], &lines[1]]);
    place.refuses(&["convert", "a.png", "a.png"], 2, &["a.png: this picture is given more than once; give it once"]);
    assert_eq!(place.names(), ["a.jpg", "a.png", "d"], "something was written");
}

#[test]
fn pictures_side_by_side_give_the_pages_that_each_gives_alone() {
    let place = Place::new();
    let samples = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("samples");
    let names = ["coffee.png", "rocket.jpg", "landscape.svg", "bars.svg"];
    for name in names {
        place.put(name, &std::fs::read(samples.join(name)).expect("a sample"));
    }
    let together = place.run(&[&["convert", "--quiet", "--out-dir", "together"], &names[..]].concat());
    assert_eq!((together.code, together.err.as_str()), (0, ""));
    for name in names {
        assert_eq!(place.run(&["convert", "--quiet", "--out-dir", "alone", name]).code, 0);
        let page = std::path::Path::new(name).with_extension("svg");
        let text = |folder: &str| place.text(&format!("{folder}/{}", page.display()));
        assert!(text("together") == text("alone"), "{name}: side by side the page is another one");
    }
}
