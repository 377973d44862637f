//! The elements of a page's SVG: under limits, and each with an id.

use std::collections::{HashMap, HashSet};
use std::fmt::Write;

use usvg::roxmltree::{Document, Node};

use crate::Error;
use crate::output::layer::Layer;
use crate::raster::decode::{checked_document, no_longer_than};

/// Namespace of Inkscape's attributes.
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

/// Most clones of clones.
const MOST_CLONES: usize = 20;

/// Most digits before the point of a place or a length on a page: ten kilometres in mm.
const MOST_DIGITS: usize = 7;

/// The text of an SVG.
///
/// # Errors
/// If the bytes are plainly something else, which is called by its name.
pub(super) fn text_of(bytes: &[u8]) -> Result<&str, Error> {
    const OTHERS: [(&[u8], &str); 6] = [
        (b"%PDF-", "it is a PDF, and pages are read from their SVG"),
        (b"\x89PNG\r\n\x1a\n", "it is a PNG picture, and pages are read from their SVG"),
        (b"\xff\xd8\xff", "it is a JPEG picture"),
        (b"RIFF", "it is a WebP picture"),
        (b"GIF8", "it is a GIF picture"),
        (b"\x1f\x8b", "it is compressed with gzip: unpack it first"),
    ];
    if let Some((_, what)) = OTHERS.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Err(Error::NotAPage(what));
    }
    let text = std::str::from_utf8(bytes).map_err(|_| Error::NotAPage("it is no text in UTF-8"))?;
    let text = text.trim_start_matches('\u{feff}');
    if text.trim_start().starts_with('<') { Ok(text) } else { Err(Error::NotAPage("it is no SVG")) }
}

pub(super) fn undecodable(why: String) -> Error {
    Error::Undecodable { format: "SVG", why: why.replace(['\n', '\r'], " ") }
}

/// The elements, no deeper and no more than usvg can take.
///
/// # Errors
/// What is wrong, and where.
pub(super) fn parse(text: &str) -> Result<Document<'_>, Error> {
    let document = checked_document(text).map_err(undecodable)?;
    no_longer_than(&document, MOST_DIGITS).map_err(undecodable)?;
    Ok(document)
}

/// The same text, in which each element has an id: usvg keeps ids and no other attributes, and plain editors give none.
///
/// # Errors
/// As [`parse`].
pub(super) fn with_ids(text: &str) -> Result<String, Error> {
    let document = parse(text)?;
    // an element may then come out of an entity, and has no place in the text
    if text.contains("<!ENTITY") {
        return Ok(text.to_owned());
    }
    let all: HashSet<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    let mut places: Vec<usize> = document
        .descendants()
        .filter(|node| node.is_element() && node.attribute("id").is_none())
        .map(|node| node.range().start)
        .collect();
    places.sort_unstable();
    let mut out = String::with_capacity(text.len() + 24 * places.len());
    let (mut done, mut number) = (0, 0);
    for place in places {
        let name = text[place + 1..].find(|c: char| c.is_whitespace() || c == '/' || c == '>').unwrap_or(0);
        let end = place + 1 + name;
        out.push_str(&text[done..end]);
        done = end;
        number += 1;
        while all.contains(format!("unnamed-{number}").as_str()) {
            number += 1;
        }
        // Writing to a String cannot fail.
        let _ = write!(out, " id=\"unnamed-{number}\"");
    }
    out.push_str(&text[done..]);
    Ok(out)
}

/// Elements by their ids.
pub(super) struct Elements<'a> {
    by_id: HashMap<&'a str, Node<'a, 'a>>,
}

impl<'a> Elements<'a> {
    pub(super) fn of(document: &'a Document<'a>) -> Self {
        let mut by_id = HashMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                by_id.entry(id).or_insert(node);
            }
        }
        Self { by_id }
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

    /// The element of a layer, by its id.
    pub(super) fn layer(&self, layer: Layer) -> Option<Node<'a, 'a>> {
        self.get(&layer.id())
    }

    pub(super) fn has_layer(&self) -> bool {
        self.by_id.values().any(|node| node.tag_name().name() == "g" && layer_of(*node).is_some())
    }

    /// How many elements of this name there are outside of definitions, or their contents where they are texts.
    pub(super) fn texts(&self) -> Vec<String> {
        let mut found: Vec<(usize, String)> = Vec::new();
        for node in self.by_id.values().filter(|node| node.tag_name().name() == "text") {
            let hidden = node.ancestors().any(|above| {
                let style = above.attribute("style").unwrap_or_default().replace(' ', "");
                above.tag_name().name() == "defs"
                    || above.attribute("display") == Some("none")
                    || style.contains("display:none")
            });
            let letters = node.descendants().filter(Node::is_text).filter_map(|node| node.text());
            let text = letters.collect::<Vec<_>>().join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
            if !hidden && !text.is_empty() {
                found.push((node.range().start, text));
            }
        }
        found.sort();
        found.into_iter().map(|(_, text)| text).collect()
    }
}

/// The layer that a group is, by its id, or by its name as Inkscape shows it.
pub(super) fn layer_of(node: Node<'_, '_>) -> Option<Layer> {
    let label = || node.attribute((INKSCAPE, "label")).and_then(Layer::named);
    node.attribute("id").and_then(Layer::named).or_else(label)
}
