//! The elements of a page's SVG: under limits, and each with an id.

use std::borrow::Cow;
use std::collections::HashMap;
use std::ops::Range;

use usvg::roxmltree::{Document, Node};

use super::style::{is_definition, is_shown};
use super::{cuts, entities, sized, texts};
use crate::Error;
use crate::output::layer::Layer;
use crate::page::Class;
use crate::raster::decode::{checked_document, edited, no_longer_than};

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

/// The text of an SVG, without what a check marked in it, and of a page with its size.
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
    if !text.trim_start().starts_with('<') {
        return Err(not_a_page("it is no SVG"));
    }
    let text = without_findings(text);
    let edits = sized::edits(&text);
    Ok(if edits.is_empty() { text } else { edited(&text, edits).into() })
}

/// Whether a text is that of a page of which the file does not say how large its sheet is, but [`text_of`] does.
pub(super) fn says_no_size(bytes: &[u8]) -> bool {
    std::str::from_utf8(bytes).is_ok_and(|text| !sized::edits(text.trim_start_matches('\u{feff}')).is_empty())
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
pub(super) const FORMAT: &str = "page";

/// The elements, no deeper and no more than usvg can take.
///
/// # Errors
/// What is wrong, and where.
pub(super) fn parse(text: &str) -> Result<Document<'_>, Error> {
    let document = checked_document(text).map_err(|why| match why {
        Error::TooComplex { why, .. } => Error::too_complex(FORMAT, why),
        other => other,
    })?;
    no_longer_than(&document, MOST_DIGITS).map_err(|why| Error::too_complex(FORMAT, why))?;
    Ok(document)
}

/// Begins the id that an element gets that has none.
pub(super) const UNNAMED: &str = "unnamed-";

/// The letters of a part of a text, and a blank before each line: a part that has a place of its own, or is a line of
/// Inkscape's. Other parts, such as an index, belong to the word that they stand in.
fn letters<'a>(part: Node<'a, 'a>, text: Node<'a, 'a>) -> Option<&'a str> {
    match part.is_text() {
        true => part.text(),
        false => begins_line(part, text).then_some(" "),
    }
}

/// Whether a part of a text begins a line of it, or has a place of its own.
fn begins_line(part: Node<'_, '_>, text: Node<'_, '_>) -> bool {
    let is_line = || {
        let has_place = part.attribute("x").or(part.attribute("y")).is_some();
        has_place || part.attribute((SODIPODI, "role")) == Some("line") || part.tag_name().name() == "flowPara"
    };
    part != text && is_line()
}

/// How many lines a text has, and how many letters the longest of them.
pub(super) fn lines_of(text: Node<'_, '_>) -> (usize, usize) {
    let (mut lines, mut letters, mut longest) = (1, 0_usize, 0);
    for part in text.descendants() {
        if part.is_text() {
            // with a blank behind each word
            let words = part.text().unwrap_or_default().split_whitespace();
            letters += words.map(|word| word.chars().count() + 1).sum::<usize>();
            longest = longest.max(letters.saturating_sub(1));
        } else if letters > 0 && begins_line(part, text) {
            (lines, letters) = (lines + 1, 0);
        }
    }
    (lines, longest)
}

/// A text as it is shown, by itself or by a clone.
pub(super) struct TypedElement<'a> {
    /// The key of its place.
    pub(super) key: String,
    pub(super) node: Node<'a, 'a>,
    /// What shows it: itself, or its clone.
    pub(super) shown_by: Node<'a, 'a>,
    pub(super) string: String,
    /// Whether it lies in the layer of texts that are labels.
    pub(super) is_label: bool,
}

/// The layer in which texts are labels to be written in braille.
const LABELS: &str = "labels-text";

/// The same text, in which each element has an id of its own: usvg keeps ids and no other attributes, and plain editors
/// give none, or copy them. A mark stands where each text is shown, and nothing is cut off: says how many elements
/// were.
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
    let by_id = by_id(&document);
    let (mut number, mut cut) = (0, 0);
    let mut edits: Vec<(Range<usize>, String)> = Vec::new();
    for node in document.descendants().filter(Node::is_element) {
        let id = match kept_id(node, &by_id) {
            Some(own) => own.to_owned(),
            None => {
                let fresh = fresh_id(node, &mut number, &by_id);
                edits.push(with_id(node, &fresh, text));
                fresh
            }
        };
        let start = node.range().start;
        let paths = texts::shown_by(node, &by_id);
        let marks = (0..).zip(&paths).map(|(nth, path)| texts::mark(path, &texts::key(&id, nth), &by_id));
        edits.push((start..start, marks.collect()));
        let cuts = cuts::of_element(node, text);
        cut += usize::from(!cuts.is_empty() && is_cut(node));
        edits.extend(cuts.into_iter().map(|range| (range, cuts::NONE.to_owned())));
    }
    Ok((edited(text, edits), cut))
}

/// The first element of each id.
fn by_id<'a>(document: &'a Document<'a>) -> HashMap<&'a str, Node<'a, 'a>> {
    let mut found = HashMap::new();
    for node in document.descendants() {
        if let Some(id) = node.attribute("id").filter(|id| !id.is_empty()) {
            found.entry(id).or_insert(node);
        }
    }
    found
}

/// The id that an element keeps: its own, if it is the first that has it. A layer may be in several groups.
fn kept_id<'a>(node: Node<'a, 'a>, by_id: &HashMap<&'a str, Node<'a, 'a>>) -> Option<&'a str> {
    let is_layer = |id: &str| node.tag_name().name() == "g" && Layer::named(id).is_some();
    node.attribute("id").filter(|id| by_id.get(id).is_some_and(|first| *first == node || is_layer(id)))
}

/// An id that no element has, with the one that it has in the file behind it.
fn fresh_id(node: Node<'_, '_>, number: &mut u32, known: &HashMap<&str, Node<'_, '_>>) -> String {
    let own = node.attribute("id").filter(|id| !id.is_empty()).map_or(String::new(), |id| format!("-{id}"));
    loop {
        *number += 1;
        let id = format!("{UNNAMED}{number}{own}");
        if !known.contains_key(id.as_str()) {
            return id;
        }
    }
}

/// What gives an element this id: in place of the one that it has, or behind its name.
fn with_id(node: Node<'_, '_>, id: &str, text: &str) -> (Range<usize>, String) {
    let id = id.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let start = node.range().start + 1;
    let own = node.attributes().find(|attribute| attribute.namespace().is_none() && attribute.name() == "id");
    match own {
        Some(own) => (own.range(), format!("id=\"{id}\"")),
        None => {
            let end = text[start..].find(|c: char| c.is_whitespace() || c == '/' || c == '>').unwrap_or(0);
            (start + end..start + end, format!(" id=\"{id}\""))
        }
    }
}

/// The id that an element has in the file, also one that another has before it; none of one that has none.
pub(super) fn own_id<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let id = node.attribute("id")?;
    let Some(fresh) = id.strip_prefix(UNNAMED) else { return Some(id) };
    let (number, own) = fresh.split_once('-')?;
    number.bytes().all(|byte| byte.is_ascii_digit()).then_some(own)
}

/// Whether an element is shown, and no part of what only others show.
fn is_drawn(node: Node<'_, '_>) -> bool {
    is_shown(&node) && !is_definition(node)
}

/// Whether an element lies in a switch that has something else, which programs show that do not know the first.
fn is_replaced(node: Node<'_, '_>) -> bool {
    let in_switch = node.parent().filter(|around| around.tag_name().name() == "switch");
    in_switch.is_some_and(|around| around.children().filter(Node::is_element).count() > 1)
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
        let are_of_page = document.descendants().any(is_of_page);
        Self { by_id: by_id(document), text: document.input_text(), are_of_page }
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
            shown = texts::target(shown, &self.by_id)?;
        }
        None
    }

    /// The element of a layer, by its id, or else by its name.
    pub(super) fn layer(&self, layer: Layer) -> Option<Node<'a, 'a>> {
        let is_it = |node: &Node<'a, 'a>| node.tag_name().name() == "g" && layer_of(*node) == Some(layer);
        let by_name = || self.by_id.values().copied().filter(is_it).min_by_key(|node| node.range().start);
        self.get(&layer.id()).or_else(by_name)
    }

    /// The layers of textures that were renamed to that of another class, each with the class before and the new one.
    pub(super) fn renamed_layers(&self) -> Vec<[Class; 2]> {
        let groups = self.by_id.values().filter(|node| node.tag_name().name() == "g");
        let mut found: Vec<(usize, [Class; 2])> =
            groups.filter_map(|node| Some((node.range().start, renamed(*node)?))).collect();
        found.sort_unstable_by_key(|(start, _)| *start);
        found.into_iter().map(|(_, classes)| classes).collect()
    }

    pub(super) fn has_layer(&self) -> bool {
        self.by_id.values().any(|node| node.tag_name().name() == "g" && layer_of(*node).is_some())
    }

    /// Whether an element that is drawn shows something that is not read: a clone of what is in another file or is not
    /// there, or content of another language than SVG.
    pub(super) fn is_elsewhere(&self, node: Node<'a, 'a>) -> bool {
        let is_lost = match node.tag_name().name() {
            // a switch shows what it has beside it in place of it
            "foreignObject" => !is_replaced(node),
            "use" => self.shown_by(node).is_none(),
            _ => false,
        };
        is_lost && is_drawn(node)
    }

    /// The texts, in the order of what shows them. Whether they are hidden say their marks.
    pub(super) fn texts(&self, document: &'a Document<'a>) -> Vec<TypedElement<'a>> {
        let mut found = Vec::new();
        for shown_by in document.descendants().filter(Node::is_element) {
            for (nth, path) in texts::shown_by(shown_by, &self.by_id).into_iter().enumerate() {
                let Some(&node) = path.last() else { continue };
                let (string, is_label) = (string_of(node), is_in_labels(shown_by));
                let key = texts::key(shown_by.attribute("id").unwrap_or_default(), nth);
                if !string.is_empty() {
                    found.push(TypedElement { key, node, shown_by, string, is_label });
                }
            }
        }
        found
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
pub(super) fn string_of(text: Node<'_, '_>) -> String {
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
/// a text is what it says, which may be the word "frame". Who renames the layer of a texture there, which keeps its id,
/// means another colour.
pub(super) fn layer_of(node: Node<'_, '_>) -> Option<Layer> {
    let label = || label_of(node).filter(|_| !is_object(node)).and_then(Layer::named);
    match node.attribute("id").and_then(Layer::named) {
        Some(own @ Layer::Texture(_)) => {
            Some(label().filter(|layer| matches!(layer, Layer::Texture(_))).unwrap_or(own))
        }
        own => own.or_else(label),
    }
}

/// The class that the layer of a texture had before it was renamed, and the one that it has.
pub(super) fn renamed(node: Node<'_, '_>) -> Option<[Class; 2]> {
    let class = |layer: Option<Layer>| match layer {
        Some(Layer::Texture(class)) => Some(class),
        _ => None,
    };
    let before = class(node.attribute("id").and_then(Layer::named))?;
    class(layer_of(node)).filter(|class| *class != before).map(|class| [before, class])
}

/// Whether an element stands for one thing on the page: a contour, a region or a text.
pub(super) fn is_object(element: Node<'_, '_>) -> bool {
    ["data-strength", "data-class", "data-braille"].iter().any(|name| element.has_attribute(*name))
}

/// The name of an element as Inkscape shows it.
pub(super) fn label_of<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    node.attribute((INKSCAPE, "label"))
}
