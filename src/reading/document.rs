//! The elements of a page's SVG: under limits, and each with an id.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::fmt::Write;

use usvg::roxmltree::{Document, Node};

use super::{cuts, entities};
use crate::Error;
use crate::output::layer::Layer;
use crate::raster::decode::{checked_document, no_longer_than};

/// Namespace of Inkscape's attributes.
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
const SODIPODI: &str = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";

/// Id of the layer in which a check marks what it found, which is no part of a page.
pub const FINDINGS: &str = "findings";

/// Longest page that is read, bytes: the fullest page of the samples has a quarter of a megabyte.
const MOST_BYTES: usize = 100_000_000;

/// Most clones of clones.
const MOST_CLONES: usize = 20;

/// Most digits before the point of a place or a length on a page: ten kilometres in mm.
const MOST_DIGITS: usize = 7;

/// What is told of what is no page, for this reason.
pub(super) fn not_a_page(why: &'static str) -> Error {
    Error::NotAPage { why, remedy: "give the SVG of a page that tactograph made" }
}

/// The text of an SVG, without what a check marked in it.
///
/// # Errors
/// [`Error::NotAPage`] if the bytes are plainly something else, which is called by its name.
pub fn text_of(bytes: &[u8]) -> Result<Cow<'_, str>, Error> {
    if bytes.len() > MOST_BYTES {
        return Err(not_a_page("it is longer than 100 MB"));
    }
    const OF_A_PICTURE: &str = "give the SVG of the page, or convert the picture to a page.svg";
    const OTHERS: [(&[u8], &str, &str); 6] = [
        (b"%PDF-", "it is a PDF, and pages are read from their SVG", OF_A_PICTURE),
        (b"\x89PNG\r\n\x1a\n", "it is a PNG picture, and pages are read from their SVG", OF_A_PICTURE),
        (b"\xff\xd8\xff", "it is a JPEG picture", OF_A_PICTURE),
        (b"RIFF", "it is a WebP picture", OF_A_PICTURE),
        (b"GIF8", "it is a GIF picture", OF_A_PICTURE),
        (b"\x1f\x8b", "it is compressed with gzip", "unpack it first"),
    ];
    if let Some((_, why, remedy)) = OTHERS.iter().find(|(magic, ..)| bytes.starts_with(magic)) {
        return Err(Error::NotAPage { why, remedy });
    }
    let text = std::str::from_utf8(bytes).map_err(|_| not_a_page("it is no text in UTF-8"))?;
    let text = text.trim_start_matches('\u{feff}');
    if text.trim_start().starts_with('<') { Ok(without_findings(text)) } else { Err(not_a_page("it is no SVG")) }
}

/// The same text as it was before a check marked it, to the byte, if nobody has saved it since.
fn without_findings(text: &str) -> Cow<'_, str> {
    let has_layer = text.contains(&format!("\"{FINDINGS}\"")) || text.contains(&format!("'{FINDINGS}'"));
    // what cannot be parsed is told later
    let Some(document) = has_layer.then(|| parse(text).ok()).flatten() else { return text.into() };
    let is_layer = |node: &Node<'_, '_>| node.tag_name().name() == "g" && node.attribute("id") == Some(FINDINGS);
    let mut out = String::with_capacity(text.len());
    let mut done = 0;
    for layer in document.descendants().filter(is_layer).map(|layer| layer.range()) {
        if layer.start >= done {
            out.push_str(&text[done..layer.start]);
            done = layer.end + usize::from(text[layer.end..].starts_with('\n'));
        }
    }
    out.push_str(&text[done..]);
    out.into()
}

/// What the format is called in errors.
pub(super) const FORMAT: &str = "SVG";

/// The elements, no deeper and no more than usvg can take.
///
/// # Errors
/// What is wrong, and where.
pub(super) fn parse(text: &str) -> Result<Document<'_>, Error> {
    let document = checked_document(text)?;
    no_longer_than(&document, MOST_DIGITS).map_err(|why| Error::too_complex(FORMAT, why))?;
    Ok(document)
}

/// Begins the id that an element gets that has none.
pub(super) const UNNAMED: &str = "unnamed-";

/// Begins the id of the mark that stands before a text where it begins: without fonts usvg places no texts.
pub(super) const PLACE_OF: &str = "place-of-";

/// A mark at the place of a text, under the transforms that the text has.
fn place_mark(text: Node<'_, '_>, id: &str) -> String {
    let first = |name: &str| {
        let value = text.descendants().filter(Node::is_element).find_map(|part| part.attribute(name));
        let number = value.and_then(|value| value.split([' ', ',']).find(|number| !number.is_empty()));
        number.unwrap_or("0").to_owned()
    };
    let transform = text.attribute("transform").unwrap_or_default();
    let attributes = [
        ("id", format!("{PLACE_OF}{id}")),
        ("x", first("x")),
        ("y", first("y")),
        ("width", "0.01".into()),
        ("height", "0.01".into()),
        ("fill", "#000".into()),
        ("transform", transform.into()),
    ];
    let escaped = |value: &str| value.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let attributes = attributes.iter().map(|(name, value)| format!(" {name}=\"{}\"", escaped(value)));
    format!("<rect{}/>", attributes.collect::<String>())
}

/// Elements that are not drawn themselves, beside `defs`.
const NOT_DRAWN: [&str; 5] = ["clipPath", "mask", "symbol", "pattern", "marker"];

/// Whether an element is a text that is shown, and no part of a definition.
fn is_seen_text(node: Node<'_, '_>) -> bool {
    let hides = |above: Node<'_, '_>| {
        let style = above.attribute("style").unwrap_or_default().replace(' ', "");
        let name = above.tag_name().name();
        name == "defs"
            || NOT_DRAWN.contains(&name)
            || above.attribute("display") == Some("none")
            || style.contains("display:none")
    };
    node.tag_name().name() == "text" && !node.ancestors().any(hides) && is_visible(node)
}

/// What the nearest element that sets it says of an element's visibility.
fn is_visible(node: Node<'_, '_>) -> bool {
    let of = |above: Node<'_, '_>| {
        let style = above.attribute("style").unwrap_or_default().split(';');
        let declared = style.filter_map(|declared| declared.split_once(':'));
        let last = declared.rev().find(|(key, _)| key.trim() == "visibility");
        let set = last.map(|(_, value)| value.trim().to_owned());
        set.or_else(|| above.attribute("visibility").map(str::to_owned))
    };
    node.ancestors().find_map(of).is_none_or(|set| set != "hidden" && set != "collapse")
}

/// The letters of a part of a text, and a blank before each line: a part that has a place of its own, or is a line of
/// Inkscape's. Other parts, such as an index, belong to the word that they stand in.
fn letters<'a>(part: Node<'a, 'a>, text: Node<'a, 'a>) -> Option<&'a str> {
    let is_line =
        || part.attribute("x").or(part.attribute("y")).is_some() || part.attribute((SODIPODI, "role")) == Some("line");
    match part.is_text() {
        true => part.text(),
        false => (part != text && is_line()).then_some(" "),
    }
}

/// A text that is shown.
pub(super) struct TypedElement<'a> {
    pub(super) id: &'a str,
    pub(super) node: Node<'a, 'a>,
    pub(super) string: String,
    /// Whether it lies in the layer of texts that are labels.
    pub(super) is_label: bool,
}

/// The layer in which texts are labels to be written in braille.
const LABELS: &str = "labels-text";

/// The same text, in which each element has an id: usvg keeps ids and no other attributes, and plain editors give none.
/// Before each text stands a mark of its place, and nothing is cut off: says how many elements were.
///
/// # Errors
/// As [`parse`].
pub(super) fn with_ids(text: &str) -> Result<(String, usize), Error> {
    let mut document = parse(text)?;
    let replaced;
    let text = if text.contains("<!ENTITY") {
        replaced = entities::replaced(text).map_err(|why| Error::too_complex(FORMAT, why))?;
        document = parse(&replaced)?;
        &replaced
    } else {
        text
    };
    let all: HashSet<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    let mut out = String::with_capacity(text.len() + text.len() / 8);
    let (mut done, mut number, mut cut) = (0, 0, 0);
    for node in document.descendants().filter(Node::is_element) {
        let (own, is_text) = (node.attribute("id"), is_seen_text(node));
        let start = node.range().start;
        let id = own.map_or_else(
            || {
                number += 1;
                while all.contains(format!("{UNNAMED}{number}").as_str()) {
                    number += 1;
                }
                format!("{UNNAMED}{number}")
            },
            str::to_owned,
        );
        // Writing to a String cannot fail.
        if is_text {
            let _ = write!(out, "{}{}", &text[done..start], place_mark(node, &id));
            done = start;
        }
        if own.is_none() {
            let name = text[start + 1..].find(|c: char| c.is_whitespace() || c == '/' || c == '>').unwrap_or(0);
            let end = start + 1 + name;
            let _ = write!(out, "{} id=\"{id}\"", &text[done..end]);
            done = end;
        }
        let cuts = cuts::of_element(node, text);
        cut += usize::from(!cuts.is_empty() && is_cut(node));
        for range in cuts {
            let _ = write!(out, "{}{}", &text[done..range.start], cuts::NONE);
            done = range.end;
        }
    }
    out.push_str(&text[done..]);
    Ok((out, cut))
}

/// Whether an element is shown, and no part of what only others show.
fn is_drawn(node: Node<'_, '_>) -> bool {
    is_shown(&node) && !node.ancestors().any(|above| NOT_DRAWN.contains(&above.tag_name().name()))
}

/// Whether what an element has of clip paths, masks and filters would be seen: it is drawn, or it is a style sheet.
fn is_cut(node: Node<'_, '_>) -> bool {
    node.tag_name().name() == "style" || is_drawn(node)
}

/// Elements by their ids.
pub(super) struct Elements<'a> {
    by_id: HashMap<&'a str, Node<'a, 'a>>,
    /// The text in which they are written.
    pub(super) text: &'a str,
    /// Whether they are those of a page, of which something may be gone.
    pub(super) are_of_page: bool,
}

impl<'a> Elements<'a> {
    pub(super) fn of(document: &'a Document<'a>) -> Self {
        let mut by_id = HashMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                by_id.entry(id).or_insert(node);
            }
        }
        let are_of_page = document.descendants().any(is_of_page);
        Self { by_id, text: document.input_text(), are_of_page }
    }

    pub(super) fn get(&self, id: &str) -> Option<Node<'a, 'a>> {
        self.by_id.get(id).copied()
    }

    /// What an element shows: itself, or what it is a clone of.
    pub(super) fn shown_by(&self, element: Node<'a, 'a>) -> Option<Node<'a, 'a>> {
        let mut shown = element;
        for _ in 0..MOST_CLONES {
            if shown.tag_name().name() != "use" {
                return Some(shown);
            }
            let mut links = shown.attributes().filter(|attribute| attribute.name() == "href");
            shown = links.find_map(|link| self.get(link.value().trim().strip_prefix('#')?))?;
        }
        None
    }

    /// The element of a layer, by its id, or else by its name.
    pub(super) fn layer(&self, layer: Layer) -> Option<Node<'a, 'a>> {
        let is_it = |node: &Node<'a, 'a>| node.tag_name().name() == "g" && layer_of(*node) == Some(layer);
        let by_name = || self.by_id.values().copied().filter(is_it).min_by_key(|node| node.range().start);
        self.get(&layer.id()).or_else(by_name)
    }

    pub(super) fn has_layer(&self) -> bool {
        self.by_id.values().any(|node| node.tag_name().name() == "g" && layer_of(*node).is_some())
    }

    /// Whether an element that is drawn shows something that is not read: a clone of what is in another file or is not
    /// there, or content of another language than SVG.
    pub(super) fn is_elsewhere(&self, node: Node<'a, 'a>) -> bool {
        let is_lost = match node.tag_name().name() {
            "foreignObject" => true,
            "use" => self.shown_by(node).is_none(),
            _ => false,
        };
        is_lost && is_drawn(node)
    }

    /// The texts that are shown, in their order.
    pub(super) fn texts(&self) -> Vec<TypedElement<'a>> {
        let mut found: Vec<(usize, TypedElement<'a>)> = Vec::new();
        for (id, node) in self.by_id.iter().filter(|(_, node)| is_seen_text(**node)) {
            let string = string_of(*node);
            let is_label = is_in_labels(*node);
            if !string.is_empty() {
                found.push((node.range().start, TypedElement { id, node: *node, string, is_label }));
            }
        }
        found.sort_by_key(|(start, _)| *start);
        found.into_iter().map(|(_, text)| text).collect()
    }
}

/// Whether an element is one of a page: an object or a place that the writer of pages marks, or its lines or textures
/// in its figure. Other drawings may have a group that is called "labels" too.
fn is_of_page(node: Node<'_, '_>) -> bool {
    let of_figure = |layer: Layer| matches!(layer, Layer::Lines | Layer::Textures | Layer::Texture(_));
    let is_part = || {
        let around = || node.ancestors().skip(1).any(|above| layer_of(above) == Some(Layer::Figure));
        node.tag_name().name() == "g" && layer_of(node).is_some_and(of_figure) && around()
    };
    is_object(node) || node.has_attribute("data-box") || is_part()
}

/// What a text says, its lines apart.
pub fn string_of(text: Node<'_, '_>) -> String {
    let letters: String = text.descendants().filter_map(|part| letters(part, text)).collect();
    letters.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The numbers of an attribute; none if one of them is no finite number.
pub(super) fn numbers(node: Node<'_, '_>, name: &str) -> Option<Vec<f32>> {
    let all: Result<Vec<f32>, _> = node.attribute(name)?.split_whitespace().map(str::parse).collect();
    all.ok().filter(|all| all.iter().all(|number| number.is_finite()))
}

/// Whether a text lies in the layer of texts that are labels.
pub(super) fn is_in_labels(text: Node<'_, '_>) -> bool {
    let named = |name: &str| name.trim().to_lowercase().replace([' ', '_'], "-") == LABELS;
    text.ancestors().any(|above| [above.attribute("id"), label_of(above)].into_iter().flatten().any(named))
}

/// The layer that a group is, by its id, or by its name as Inkscape shows it. The name of an object is its own: that of
/// a text is what it says, which may be the word "frame".
pub(super) fn layer_of(node: Node<'_, '_>) -> Option<Layer> {
    let label = || label_of(node).filter(|_| !is_object(node)).and_then(Layer::named);
    node.attribute("id").and_then(Layer::named).or_else(label)
}

/// Whether an element stands for one thing on the page: a contour, a region or a text.
pub(super) fn is_object(element: Node<'_, '_>) -> bool {
    ["data-strength", "data-class", "data-braille"].iter().any(|name| element.has_attribute(*name))
}

/// The name of an element as Inkscape shows it.
pub(super) fn label_of<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    node.attribute((INKSCAPE, "label"))
}
/// Whether an element is drawn: neither it nor what is around it is hidden.
pub(crate) fn is_shown(node: &Node<'_, '_>) -> bool {
    let hidden = |node: Node<'_, '_>| {
        let style = node.attribute("style").unwrap_or("").replace(' ', "");
        node.attribute("display") == Some("none") || style.contains("display:none") || node.tag_name().name() == "defs"
    };
    !node.ancestors().any(hidden)
}
