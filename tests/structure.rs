//! The ids, layers and data that other programs rely on are in every page (the shape is in `src/output/svg.rs`).

#[path = "common/page.rs"]
mod page;
#[path = "common/samples.rs"]
mod samples;

use roxmltree::{Document, Node};
use tactograph::profile::Profile;

const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

fn by_id<'a>(document: &'a Document, id: &str) -> Option<Node<'a, 'a>> {
    document.descendants().find(|node| node.attribute("id") == Some(id))
}

fn parent_id<'a>(node: Node<'a, 'a>) -> Option<&'a str> {
    node.parent_element().and_then(|parent| parent.attribute("id"))
}

fn numbers(node: Node<'_, '_>, name: &str) -> Vec<f32> {
    let text = node.attribute(name).unwrap_or_default();
    text.split(' ').map(|number| number.parse().expect("a number")).collect()
}

#[test]
fn pages_have_the_structure_that_others_rely_on() {
    for sample in samples::samples() {
        let name = sample.file_name().expect("a sample has a name").to_string_lossy().into_owned();
        let bytes = std::fs::read(&sample).expect("a sample can be read");
        let page = page::page_of(&bytes, &name, &[], &mut |_| ()).page;
        let svg = tactograph::output::svg::write(&page);
        let document = Document::parse(&svg).expect("a page is well-formed");
        let root = document.root_element();
        let root_values = ["width", "height", "viewBox"].map(|attribute| root.attribute(attribute));
        assert_eq!(root_values, [Some("210mm"), Some("297mm"), Some("0 0 210 297")], "{name}");

        let figure = by_id(&document, "figure").expect("there is a figure");
        assert_eq!(numbers(figure, "data-box").len(), 4, "{name}");
        assert_eq!(numbers(figure, "data-source"), [page.figure.source.width as f32, page.figure.source.height as f32]);
        assert_eq!(by_id(&document, "lines").is_some(), !page.figure.lines.is_empty(), "{name}");
        for (id, parent) in [("textures", "figure"), ("lines", "figure"), ("texture-blue", "textures")] {
            assert!(by_id(&document, id).is_none_or(|node| parent_id(node) == Some(parent)), "{name}: {id}");
        }
        for layer in document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "g"))) {
            let is_layer = layer.attribute((INKSCAPE, "groupmode")) == Some("layer");
            assert_eq!(
                layer.attribute("id").is_some(),
                is_layer,
                "{name}: groups with an id are layers, others are not"
            );
            let white = layer.attribute("id") == Some("figure") && page.is_empty();
            assert!(white || layer.has_children(), "{name}: an empty group");
        }
        if let Some(lines) = by_id(&document, "lines") {
            let contours: Vec<_> = lines.children().filter(Node::is_element).collect();
            assert_eq!(contours.len(), page.figure.lines.len(), "{name}");
            for contour in contours {
                assert!(numbers(contour, "data-strength")[0] > 0.0);
                assert!(
                    contour.children().filter(Node::is_element).all(|path| numbers(path, "stroke-width")[0] >= 0.75)
                );
            }
        }
        let parameter = |key: &str| {
            let metadata = document.descendants().find(|node| node.has_tag_name("metadata"));
            let lines = metadata.and_then(|node| node.text()).unwrap_or_default().lines();
            lines.filter_map(|line| line.split_once(" = ")).find(|(name, _)| *name == key).map(|(_, value)| value)
        };
        for key in Profile::keys() {
            assert!(parameter(key.path).is_some(), "{name}: the metadata lack {}", key.path);
        }
        assert_eq!(parameter("profile"), Some("swell-a4"), "{name}");
        let text = |tag: &str| document.descendants().find(|node| node.has_tag_name(tag)).and_then(|node| node.text());
        assert_eq!(text("title").map(str::trim), Some(name.as_str()));
        assert!(text("desc").is_some_and(|text| text.contains("millimetres")), "{name}");
        let colours = svg.matches("#").count();
        assert_eq!(colours, svg.matches("#000000").count(), "{name}: a colour that is not black");
    }
}
