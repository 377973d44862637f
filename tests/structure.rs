//! The ids, layers and data that other programs rely on are in every page (the shape is in `src/output/svg.rs`).

use crate::common::{page, samples};
use roxmltree::{Document, Node};
use tactograph::internals::profile::Profile;

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

/// Every region is one path that can be found, deleted and changed as one object, glyphs and all.
fn regions_say_what_they_are(document: &Document<'_>, page: &tactograph::Page, name: &str) {
    let paths = document.descendants().filter(|node| node.attribute("data-class").is_some());
    let paths: Vec<_> = paths.collect();
    assert_eq!(paths.len(), page.figure.textures.len(), "{name}");
    for (number, (path, texture)) in paths.into_iter().zip(&page.figure.textures).enumerate() {
        let class = texture.class.name();
        assert_eq!(path.attribute("id"), Some(format!("region-{}", number + 1).as_str()), "{name}");
        assert_eq!(path.attribute("data-class"), Some(class), "{name}");
        let layer = path.parent_element().expect("it lies in a layer");
        assert_eq!(layer.attribute("id"), Some(format!("texture-{class}").as_str()), "{name}");
        assert_eq!(layer.attribute("data-sign"), Some(texture.sign.to_string().as_str()), "{name}");
        let glyphs = path.attribute("d").unwrap_or_default().matches('M').count();
        assert_eq!(glyphs, texture.glyphs.len(), "{name}: all of a region's glyphs are in its path");
        assert_eq!(numbers(path, "data-colour"), texture.colour.map(f32::from), "{name}");
        let area = numbers(path, "data-area")[0];
        assert!((area - texture.area).abs() <= 0.0051 && area <= page.figure.place.area(), "{name}: {area} mm2");
    }
}

/// Figure and overview each say where they lie on the sheet, so that what they draw can be laid on the picture.
fn parts_say_where_they_lie(document: &Document<'_>, page: &tactograph::Page, name: &str) {
    let overview = page.overview.as_ref().map(|overview| ("overview", overview.place));
    assert_eq!(by_id(document, "overview").is_some(), overview.is_some(), "{name}");
    for (id, place) in [("figure", page.figure.place)].into_iter().chain(overview) {
        let group = by_id(document, id).expect("the part has a group");
        let place = [place.min.x, place.min.y, place.width(), place.height()];
        let said = numbers(group, "data-box");
        let is_near = |(said, place): (&f32, f32)| (said - place).abs() <= 0.0051;
        assert!(said.len() == 4 && said.iter().zip(place).all(is_near), "{name}: {id} lies at {place:?}, not {said:?}");
    }
}

#[test]
fn pages_have_the_structure_that_others_rely_on() {
    for name in samples::names() {
        let page = &page::of_sample(&name, "swell-a4").page;
        let svg = tactograph::internals::output::svg::write(page);
        let document = Document::parse(&svg).expect("a page is well-formed");
        let root = document.root_element();
        let root_values = ["width", "height", "viewBox"].map(|attribute| root.attribute(attribute));
        assert_eq!(root_values, [Some("210mm"), Some("297mm"), Some("0 0 210 297")], "{name}");

        parts_say_where_they_lie(&document, page, &name);
        let figure = by_id(&document, "figure").expect("there is a figure");
        assert_eq!(numbers(figure, "data-source"), [page.figure.source.width as f32, page.figure.source.height as f32]);
        assert_eq!(by_id(&document, "lines").is_some(), !page.figure.lines.is_empty(), "{name}");
        for (id, parent) in [("textures", "figure"), ("lines", "figure"), ("texture-blue", "textures")] {
            assert!(by_id(&document, id).is_none_or(|node| parent_id(node) == Some(parent)), "{name}: {id}");
        }
        for layer in document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "g"))) {
            let is_layer = layer.attribute((INKSCAPE, "groupmode")) == Some("layer");
            let is_contour = layer.attribute("data-strength").is_some();
            assert!(is_layer != is_contour, "{name}: a group is a layer or a contour");
            let (id, label) = (layer.attribute("id"), layer.attribute((INKSCAPE, "label")));
            assert!(id.is_some() && label.is_some(), "{name}: a group without a name");
            let white = layer.attribute("id") == Some("figure") && page.is_empty();
            assert!(white || layer.has_children(), "{name}: an empty group");
        }
        regions_say_what_they_are(&document, page, &name);
        if let Some(lines) = by_id(&document, "lines") {
            let contours: Vec<_> = lines.children().filter(Node::is_element).collect();
            assert_eq!(contours.len(), page.figure.lines.len(), "{name}");
            for (number, contour) in (1..).zip(contours) {
                assert!(numbers(contour, "data-strength")[0] > 0.0);
                assert_eq!(contour.attribute("id"), Some(format!("line-{number}").as_str()), "{name}");
                assert_eq!(contour.attribute((INKSCAPE, "label")), Some(format!("line {number}").as_str()), "{name}");
                let paths: Vec<_> = contour.descendants().filter(|node| node.has_attribute("d")).collect();
                assert!(!paths.is_empty() && paths.len() == page.figure.lines[number - 1].runs.len(), "{name}");
                assert!(paths.into_iter().all(|path| numbers(path, "stroke-width")[0] >= 0.75), "{name}");
            }
        }
        let parameter = |key: &str| {
            let metadata = document.descendants().find(|node| node.has_tag_name("metadata"));
            let lines = metadata.and_then(|node| node.text()).unwrap_or_default().lines();
            lines.filter_map(|line| line.split_once(" = ")).find(|(name, _)| *name == key).map(|(_, value)| value)
        };
        // those of dots but for the device do not count on a printed page
        let of_dots = ["dots.pitch", "dots.line_gap", "dots.texture_gap", "dots.texture_rows", "dots.heavy_from"];
        for key in Profile::keys() {
            // ... nor do those of braille where nothing is written
            let unused = of_dots.contains(&key.path) || key.section() == "braille";
            assert_eq!(parameter(key.path).is_none(), unused, "{name}: {}", key.path);
        }
        assert_eq!(parameter("profile"), Some("swell-a4"), "{name}");
        let text = |tag: &str| document.descendants().find(|node| node.has_tag_name(tag)).and_then(|node| node.text());
        assert_eq!(text("title").map(str::trim), Some(name.as_str()));
        assert!(text("desc").is_some_and(|text| text.starts_with("A sheet upright, 210 by 297 mm, ")), "{name}");
        let colours = svg.matches("#").count();
        assert_eq!(colours, svg.matches("#000000").count(), "{name}: a colour that is not black");
    }
}
