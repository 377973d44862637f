//! PDF files are what they claim to be: the true size, the marks of the SVG, its layers, words for those who cannot see it.
//! What other people's programs say to them is in `tests/clients.sh`.

pub(crate) mod reader;

use crate::common::{page, samples};
use reader::{Mark, Reader, string_of};
use roxmltree::{Document, Node};
use tactograph::internals::output::{pdf, svg};
use tactograph::{Options, Page, Profile};

const SVG: &str = "http://www.w3.org/2000/svg";
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
const POINTS_PER_MM: f32 = 72.0 / 25.4;

fn sample(name: &str, settings: &[(&str, &str)]) -> Page {
    if settings.is_empty() {
        return page::of_sample(name, "swell-a4").page.clone();
    }
    page::page_of(&samples::read(name), name, settings, &mut |_| ()).page
}

/// A page with a title in braille.
fn titled() -> Page {
    let options = Options::new(Profile::named("swell-a4").expect("it is built in")).title(TITLE);
    tactograph::convert(&samples::read("bars.svg"), &options).expect("a page").page
}

const TITLE: &str = "Bars, two of them";

/// A document of one page.
fn written(page: &Page) -> Vec<u8> {
    pdf::write(&page.title, std::slice::from_ref(page))
}

/// Pages with everything, with nothing, and without some of the layers.
fn pages() -> Vec<Page> {
    vec![
        sample("landscape.svg", &[]),
        sample("empty.png", &[]),
        sample("coffee.png", &[("frame", "false"), ("figure.textures", "false"), ("page.width", "215.9")]),
        titled(),
    ]
}

fn numbers(text: &str) -> Vec<f32> {
    let bare = text.replace(['[', ']'], " ");
    bare.split_ascii_whitespace().map(|number| number.parse().expect("a number")).collect()
}

fn boxes(dict: &str, key: &str) -> Vec<f32> {
    let (_, rest) = dict.split_once(&format!("/{key}[")).unwrap_or_else(|| panic!("no {key}: {dict}"));
    numbers(rest.split(']').next().expect("an end"))
}

#[test]
fn a_sheet_has_its_true_size_and_no_other_box() {
    for page in pages() {
        let bytes = written(&page);
        let reader = Reader::new(&bytes);
        let leaf = reader.only("/Type/Page/");
        let want = [0.0, 0.0, page.sheet[0] * POINTS_PER_MM, page.sheet[1] * POINTS_PER_MM];
        for key in ["MediaBox", "TrimBox"] {
            let found = boxes(leaf, key);
            assert!(found.iter().zip(want).all(|(a, b)| (a - b).abs() < 0.001), "{key} {found:?}, want {want:?}");
        }
        for key in ["CropBox", "BleedBox", "UserUnit", "Rotate"] {
            assert!(!leaf.contains(key), "{key} would change the size");
        }
        let stream = String::from_utf8_lossy(&reader.streams[&reader.follow(leaf, "Contents")]).into_owned();
        let matrix = numbers(stream.split("cm").next().expect("a matrix"));
        // Hundredths of a millimetre, y down from the top of the sheet.
        let scale = POINTS_PER_MM / 100.0;
        let want = [scale, 0.0, 0.0, -scale, 0.0, want[3]];
        assert!(matrix.iter().zip(want).all(|(a, b)| (a - b).abs() <= 1e-4 * b.abs()), "{matrix:?}, want {want:?}");
        assert!(reader.only("/Type/Catalog").contains("/PrintScaling/None"), "printers would fit it to their margins");
    }
}

/// The marks of an SVG page as the PDF should have them.
fn marks_of_svg(page: &Page) -> Vec<Mark> {
    let text = svg::write(page);
    let document = Document::parse(&text).expect("XML");
    let paths = document.descendants().filter(|node| node.has_tag_name((SVG, "path")));
    paths.map(mark_of_svg).collect()
}

fn mark_of_svg(path: Node<'_, '_>) -> Mark {
    let groups = path.ancestors().filter(|node| node.attribute((INKSCAPE, "groupmode")).is_some());
    let mut layers: Vec<String> =
        groups.filter_map(|node| node.attribute((INKSCAPE, "label"))).map(String::from).collect();
    layers.reverse();
    let hundredths = |text: &str| -> i64 { (text.parse::<f64>().expect("a number") * 100.0).round() as i64 };
    let d = path.attribute("d").expect("a path");
    let points = |text: &str| -> Vec<[i64; 2]> {
        let pairs = text.split(['L', ' ']).map(|pair| pair.split_once(',').expect("x,y"));
        pairs.map(|(x, y)| [hundredths(x), hundredths(y)]).collect()
    };
    let subpaths = d.split('M').skip(1);
    match path.attribute("stroke-width") {
        Some(width) => {
            let closed = d.ends_with('Z');
            let points = points(d.trim_start_matches('M').trim_end_matches('Z'));
            Mark::Stroke { layers, width: hundredths(width), points, closed }
        }
        None => {
            let subpaths = subpaths.map(|subpath| match subpath.split_once('a') {
                // A disc: its leftmost point and its radius.
                Some((left, arc)) => {
                    let [left] = points(left)[..] else { panic!("{left}") };
                    let across = hundredths(arc.split(' ').nth(5).expect("the way across"));
                    vec![left, [left[0] + across, left[1]]]
                }
                None => points(subpath.trim_end_matches('Z')),
            });
            Mark::Fill { layers, subpaths: subpaths.collect() }
        }
    }
}

/// Whether a subpath of the PDF is the one of the SVG: a disc has other points on it there.
fn is_same(pdf: &[[i64; 2]], svg: &[[i64; 2]]) -> bool {
    match (pdf, svg) {
        (&[right, bottom, left, top, end], &[svg_left, svg_right]) => {
            let radius = (svg_right[0] - svg_left[0]) / 2;
            let at = |x, y| [svg_left[0] + radius + radius * x, svg_left[1] + radius * y];
            [right, bottom, left, top, end] == [at(1, 0), at(0, 1), at(-1, 0), at(0, -1), at(1, 0)]
        }
        _ => pdf == svg,
    }
}

#[test]
fn marks_are_those_of_the_svg_in_the_same_layers() {
    let mut compared = 0;
    for page in pages() {
        let bytes = written(&page);
        let reader = Reader::new(&bytes);
        let (here, there) = (reader.marks(reader.only("/Type/Page/")), marks_of_svg(&page));
        assert_eq!(here.len(), there.len(), "{}", page.title);
        for (here, there) in here.iter().zip(&there) {
            match (here, there) {
                (Mark::Fill { layers, subpaths }, Mark::Fill { layers: svg_layers, subpaths: svg_subpaths }) => {
                    assert_eq!((layers, subpaths.len()), (svg_layers, svg_subpaths.len()));
                    for (pdf, svg) in subpaths.iter().zip(svg_subpaths) {
                        assert!(is_same(pdf, svg), "{pdf:?} is not {svg:?}");
                    }
                    compared += subpaths.len();
                }
                _ => assert_eq!(here, there),
            }
        }
        compared += here.len();
    }
    assert!(compared > 2000, "only {compared} marks compared");
}

#[test]
fn layers_have_the_names_of_the_svg_and_lie_in_one_another_alike() {
    for page in pages() {
        let bytes = written(&page);
        let reader = Reader::new(&bytes);
        let text = svg::write(&page);
        let document = Document::parse(&text).expect("XML");
        let groups = document.descendants().filter(|node| node.attribute((INKSCAPE, "groupmode")).is_some());
        let groups = groups.filter_map(|node| node.attribute((INKSCAPE, "label")));
        let in_file: Vec<String> = reader.with("/Type/OCG").iter().map(|(_, layer)| string_of(layer, "Name")).collect();
        assert_eq!(in_file, groups.collect::<Vec<_>>(), "{}", page.title);
        // As a viewer lists them: every layer by name, a list in brackets after the layer that it lies in.
        let catalog = reader.only("/Type/Catalog");
        let (_, order) = catalog.split_once("/Order").expect("an order");
        let order = order.split(">>").next().expect("an end").replace('[', " [ ").replace(']', " ] ");
        let words: Vec<String> = order
            .replace(" 0 R", "")
            .split_ascii_whitespace()
            .map(|word| word.parse().map_or_else(|_| word.into(), |number| string_of(&reader.objects[&number], "Name")))
            .collect();
        assert_eq!(words.join(" "), format!("[ {} ]", listed(document.root_element())), "{}", page.title);
    }
}

fn listed(group: Node<'_, '_>) -> String {
    let groups = group.children().filter(|node| node.has_tag_name((SVG, "g")));
    let groups = groups.filter(|node| node.attribute((INKSCAPE, "groupmode")).is_some());
    let layers = groups.filter_map(|node| Some((node, node.attribute((INKSCAPE, "label"))?)));
    let told = layers.map(|(node, label)| match listed(node) {
        // Only the figure and its textures can hold layers; a figure without any still has its list.
        inner if inner.is_empty() && label != "Figure" => label.into(),
        inner => format!("{label} [ {inner} ]").replace("  ", " "),
    });
    told.collect::<Vec<_>>().join(" ")
}

#[test]
fn words_are_where_a_screen_reader_looks_for_them() {
    let plain = sample("empty.png", &[]);
    let odd = plain.clone().called(Some("Tee (grün) \\ \u{1F375}"), Some("Ein <Becher> & ein Löffel"), Some("de-AT"));
    for (page, language) in [(plain, "en"), (odd, "de-AT")] {
        let bytes = written(&page);
        let reader = Reader::new(&bytes);
        let catalog = reader.only("/Type/Catalog");
        assert_eq!(string_of(catalog, "Lang"), language);
        assert!(catalog.contains("/MarkInfo<</Marked true") && catalog.contains("/DisplayDocTitle true"), "{catalog}");
        assert_eq!(string_of(&reader.objects[&reader.follow(&reader.trailer, "Info")], "Title"), page.title);
        let figure = reader.only("/S/Figure");
        assert_eq!(string_of(figure, "Alt"), page.description);
        assert_eq!(string_of(figure, "Lang"), language);
        // From the page's number and the number of its content back to the tag, and from the tag up to the root.
        let root = &reader.objects[&reader.follow(catalog, "StructTreeRoot")];
        let leaf = reader.with("/Type/Page/")[0];
        let tag = reader.with("/S/Figure")[0].0;
        assert!(root.contains(&format!("/ParentTree<</Nums[0[{tag} 0 R]]>>")), "{root}");
        assert!(leaf.1.contains("/StructParents 0") && figure.contains(&format!("/Pg {} 0 R", leaf.0)), "{figure}");
        assert!(figure.contains("/K 0"), "{figure}");
        let document = reader.follow(root, "K");
        assert!(reader.objects[&document].contains(&format!("/K[{tag} 0 R]")));
        assert_eq!(reader.follow(figure, "P"), document);
        assert_eq!(reader.follow(&reader.objects[&document], "P"), reader.follow(catalog, "StructTreeRoot"));
        // The same words as XML, with the number of the standard for accessible PDF.
        let metadata = &reader.streams[&reader.follow(catalog, "Metadata")];
        let xmp = Document::parse(std::str::from_utf8(metadata).expect("UTF-8")).expect("XML");
        let text = |name: &str| {
            let node = xmp.descendants().find(|node| node.tag_name().name() == name).expect("the element is there");
            node.descendants()
                .filter(Node::is_text)
                .filter_map(|node| node.text())
                .collect::<String>()
                .trim()
                .to_owned()
        };
        assert_eq!((text("title"), text("description")), (page.title.clone(), page.description.clone()));
        assert_eq!((text("language"), text("part")), (language.into(), "1".into()));
        assert!(text("made").lines().any(|line| line == "lines.width_max = 1.5"), "how it was made is missing");
    }
}

#[test]
fn several_pages_are_one_document_with_one_set_of_layers() {
    let pages = pages();
    let bytes = pdf::write("Four pages", &pages);
    let reader = Reader::new(&bytes);
    let leaves = reader.with("/Type/Page/");
    assert_eq!(leaves.len(), pages.len());
    assert!(reader.only("/Type/Pages").contains("/Count 4"));
    assert_eq!(string_of(&reader.objects[&reader.follow(&reader.trailer, "Info")], "Title"), "Four pages");
    let mut names: Vec<String> = reader.with("/Type/OCG").iter().map(|(_, layer)| string_of(layer, "Name")).collect();
    assert_eq!(names.len(), 13, "{names:?}");
    names.dedup();
    assert_eq!(names.len(), 13, "a layer twice: {names:?}");
    let root = reader.only("/Type/StructTreeRoot");
    for (number, ((own, leaf), page)) in leaves.iter().zip(&pages).enumerate() {
        // Each page is the same as if it were alone.
        let alone = written(page);
        let alone = Reader::new(&alone);
        assert!(reader.marks(leaf) == alone.marks(alone.only("/Type/Page/")), "page {number}");
        assert!((boxes(leaf, "MediaBox")[2] - page.sheet[0] * POINTS_PER_MM).abs() < 0.001);
        let (tag, figure) =
            *reader.with("/S/Figure").iter().find(|(_, tag)| tag.contains(&format!("/Pg {own} 0 R"))).expect("a tag");
        assert_eq!(string_of(figure, "Alt"), page.description);
        assert!(leaf.contains(&format!("/StructParents {number}")) && root.contains(&format!("{number}[{tag} 0 R]")));
    }
}

#[test]
fn the_same_page_gives_the_same_bytes_and_no_date() {
    let page = sample("coffee.png", &[]);
    let bytes = written(&page);
    assert!(bytes == written(&page));
    let text = String::from_utf8_lossy(&bytes);
    assert!(!text.contains("Date"), "a clock was asked");
}

#[test]
fn a_change_by_anybody_is_seen() {
    let bytes = written(&sample("empty.png", &[]));
    assert!(pdf::is_as_written(&bytes));
    for at in (0..Reader::new(&bytes).table).step_by(97) {
        let mut changed = bytes.clone();
        changed[at] ^= 1;
        assert!(!pdf::is_as_written(&changed), "byte {at}");
    }
    // What a program adds that keeps the old file before its changes.
    let start = bytes.len() + 1;
    let added = format!(
        "\n9 0 obj<</Name(X)>>endobj\nxref\n0 0\ntrailer<</Size 20/Prev 9/ID[(0)(1)]>>\nstartxref\n{start}\n%%EOF"
    );
    assert!(!pdf::is_as_written(&[&bytes[..], added.as_bytes()].concat()));
    for other in [
        &b""[..],
        b"%PDF-1.7",
        b"startxref\n9\n%%EOF",
        b"startxref\n99999999999999999999\n%%EOF",
        &bytes[..bytes.len() / 2],
    ] {
        assert!(!pdf::is_as_written(other));
    }
}

#[test]
fn marks_have_layers_that_the_reader_of_this_test_tells_apart() {
    let page = sample("landscape.svg", &[]);
    let bytes = written(&page);
    let reader = Reader::new(&bytes);
    let marks = reader.marks(reader.only("/Type/Page/"));
    for layer in ["Frame", "Texture blue", "Texture green", "Lines", "Overview frame", "Overview"] {
        assert!(marks.iter().any(|mark| mark.layer() == layer), "nothing in {layer}");
    }
}

/// What fingers read in braille is text for those who listen.
#[test]
fn braille_is_marked_with_its_text() {
    let bytes = written(&titled());
    let reader = Reader::new(&bytes);
    assert_eq!(reader.words(reader.only("/Type/Page/")), [TITLE]);
}
