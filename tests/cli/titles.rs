//! Titles of several pictures, from a table.

use crate::cli::common::*;

const TABLE: &str = "file,title,alt\na.png,The red square,\"A square, red\"\nsub/b.png,Another,\nc.png,Nobody,\n";

/// What a page says it is called and what is on it, and how many dots of braille it has.
fn words(place: &Place, page: &str) -> (String, String, usize) {
    let text = place.text(page);
    let document = roxmltree::Document::parse(&text).expect("XML");
    let of =
        |tag| document.root_element().children().find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", tag)));
    let text_of = |tag| of(tag).and_then(|node| node.text()).unwrap_or_default().to_owned();
    let layer = |id| document.descendants().find(|node| node.attribute("id") == Some(id));
    let braille =
        layer("braille-title").into_iter().flat_map(|layer| layer.descendants()).filter_map(|node| node.attribute("d"));
    (text_of("title"), text_of("desc"), braille.map(|d| d.matches('M').count()).sum())
}

#[test]
fn a_table_gives_each_picture_its_title() {
    let place = Place::new();
    ["a.png", "sub/b.png", "d.png"].iter().for_each(|name| place.put(name, &picture()));
    place.put("titles.csv", TABLE.as_bytes());
    let run = place.run(&["convert", "a.png", "sub/b.png", "d.png", "--titles", "titles.csv", "--out-dir", "p"]);
    let told: Vec<&str> = run.err.lines().filter(|line| line.contains("titles.csv")).collect();
    let expected = [
        "tactograph: d.png: note: titles.csv has no row for it, so it gets no title from there",
        "tactograph: titles.csv, line 4: note: no picture that is given is called c.png",
    ];
    assert_eq!((run.code, told), (0, expected.to_vec()), "{}", run.err);
    let (title, alt, dots) = words(&place, "p/a.svg");
    assert_eq!((title.as_str(), alt.as_str()), ("The red square", "A square, red"));
    let (other, _, other_dots) = words(&place, "p/b.svg");
    assert_eq!(other, "Another");
    assert!(dots > other_dots && other_dots > 10, "titles in braille of {dots} and {other_dots} dots");
    assert_eq!(words(&place, "p/d.svg").2, 0, "a title was made up");
    // the words are the same as those given by hand
    assert_eq!(place.run(&["convert", "sub/b.png", "--title", "Another", "-o", "b.svg"]).code, 0);
    assert!(place.text("b.svg") == place.text("p/b.svg"), "a title from a table is another one");
}

#[test]
fn all_faults_of_a_table_are_told_at_once() {
    let place = Place::with_picture("a.png");
    place.put("t.csv", b"file;title\na.png;x\n;b\na.png;y\n");
    let lines = [
        "--titles t.csv, line 3: there is no name of a file",
        "--titles t.csv, line 4: a.png has a row already, line 2; keep one",
    ];
    place.refuses(&["convert", "a.png", "--titles", "t.csv"], 2, &lines);
    let line = "--titles none.csv: there is no such file; check the name";
    place.refuses(&["convert", "a.png", "--titles", "none.csv"], 2, &[line]);
    place.put("t.csv", b"file,title\na.png,x\n");
    let line = "--titles: a row is for one page, but there are 2 of each picture; convert them one by one";
    place.refuses(&["convert", "a.png", "--titles", "t.csv", "--page", "1-2"], 2, &[line]);
    place.put("sub/a.png", &picture());
    let line = "--titles t.csv, line 2: a.png is the name of both u/a.png and sub/a.png; write it with its directory";
    place.put("u/a.png", &picture());
    let args = ["convert", "u/a.png", "sub/a.png", "--titles", "t.csv"];
    place.refuses(&args, 2, &[line]);
    assert_eq!(place.names(), ["a.png", "sub", "t.csv", "u"]);
}
