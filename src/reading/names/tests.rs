//! Tests of `names`.

use usvg::roxmltree::Document;

use super::*;

/// The names of the lines of a drawing.
fn lines(elements: &str) -> Vec<String> {
    let svg = format!("<svg xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\">{elements}</svg>");
    let document = Document::parse(&svg).expect("it is XML");
    told(&document.root_element().children().map(|line| of_line(line, None)).collect::<Vec<_>>())
}

#[test]
fn objects_are_called_as_an_editor_lists_them() {
    assert_eq!(lines("<path id=\"line-7\" inkscape:label=\"line 7\"/>"), ["line 7"]);
    assert_eq!(lines("<path id=\"line-7\"/><path id=\"path12\"/>"), ["line 7", "line \"path12\""]);
    assert_eq!(lines("<path id=\"a\" inkscape:label=\" the  roof \"/>"), ["line \"the roof\""]);
    assert_eq!(lines("<path/>"), ["a line without a name"]);
    assert_eq!(lines("<path/><path id=\"unnamed-4\"/>"), ["line 1 without a name", "line 2 without a name"]);
    assert_eq!(article("area"), "an");
    let copies = "<path id=\"line-7\" inkscape:label=\"line 7\"/><path id=\"b\" inkscape:label=\"line 7\"/>";
    assert_eq!(lines(copies), ["line 7 (\"line-7\")", "line 7 (\"b\")"]);
}
