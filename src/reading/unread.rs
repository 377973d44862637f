//! What a file shows and no page has: pictures of pixels, clones of what is in another file, content that SVG does not
//! draw. Each has the box of its element: usvg draws none of them here, so a rectangle of its size stands for it, under
//! all that moves or hides it.

use std::collections::BTreeMap;

use usvg::roxmltree::{Document, Node};
use usvg::{Group, Tree};

use super::document::Elements;
use super::style::{is_definition, is_shown};
use super::texts::{escaped, looks};
use crate::raster::decode::edited;
use crate::units::{MM_PER_CSS_PX, MmPoint, MmRect};

/// Begins the id of the rectangle that stands for an object.
const BOX_OF: &str = "box-of-";

/// Side of what does not say how large it is, in its own units.
const UNSAID: &str = "1";

/// Something that a file shows and that is no mark.
#[derive(Debug, Clone, PartialEq)]
pub struct UnreadObject {
    /// What it is.
    pub kind: UnreadKind,
    /// The box around it, mm on the sheet; none of what only others show.
    pub extent: Option<MmRect>,
    /// The line of the file in which its element begins.
    pub row: u32,
}

/// What it is that is no mark.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UnreadKind {
    /// A picture of pixels.
    Picture,
    /// A clone of what is in another file or is not there, by the name of that.
    Clone(String),
    /// Content of another language than SVG, with its words.
    Foreign(String),
}

/// The elements of all such objects.
pub(super) fn elements_of<'a>(document: &'a Document<'a>, elements: &Elements<'a>) -> Vec<(Node<'a, 'a>, UnreadKind)> {
    document.descendants().filter_map(|node| Some((node, kind_of(node, elements)?))).collect()
}

fn kind_of<'a>(node: Node<'a, 'a>, elements: &Elements<'a>) -> Option<UnreadKind> {
    match node.tag_name().name() {
        "image" => is_shown(&node).then_some(UnreadKind::Picture),
        _ if !elements.is_elsewhere(node) => None,
        "use" => {
            let link = node.attributes().find(|attribute| attribute.name() == "href");
            Some(UnreadKind::Clone(link.map_or_else(String::new, |link| link.value().trim().to_owned())))
        }
        _ => Some(UnreadKind::Foreign(words_of(node))),
    }
}

/// All words within an element, whatever language its parts are of.
fn words_of(node: Node<'_, '_>) -> String {
    let texts = node.descendants().filter(Node::is_text).filter_map(|text| text.text());
    texts.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}

/// The text of a document in which a rectangle stands before each of these elements.
pub(super) fn with_boxes(document: &Document<'_>, found: &[(Node<'_, '_>, UnreadKind)]) -> String {
    let edit = |(number, (node, _)): (usize, &(Node<'_, '_>, UnreadKind))| {
        let start = node.range().start;
        (start..start, rectangle(*node, number))
    };
    edited(document.input_text(), found.iter().enumerate().map(edit).collect())
}

/// A rectangle where an element is, and as large.
fn rectangle(node: Node<'_, '_>, number: usize) -> String {
    let is_length = |said: &&str| said.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let said = |name: &str, otherwise: &str| {
        let said = node.attribute(name).map(str::trim).filter(is_length);
        format!("{name}=\"{}\"", escaped(said.unwrap_or(otherwise)))
    };
    let place = [said("x", "0"), said("y", "0"), said("width", UNSAID), said("height", UNSAID)].join(" ");
    format!("<rect xmlns=\"http://www.w3.org/2000/svg\" id=\"{BOX_OF}{number}\" {place}{}/>", looks(node))
}

/// The objects with their boxes, from what is drawn of the text [with boxes](with_boxes); without that they have none.
/// What is hidden is left out.
pub(super) fn placed(found: Vec<(Node<'_, '_>, UnreadKind)>, tree: Option<&Tree>) -> Vec<UnreadObject> {
    let mut boxes = BTreeMap::new();
    if let Some(tree) = tree {
        collect(tree.root(), 1.0, &mut boxes);
    }
    let object = |(number, (node, kind)): (usize, (Node<'_, '_>, UnreadKind))| {
        let extent = boxes.get(&number).copied();
        let row = node.document().text_pos_at(node.range().start).row;
        let is_there = extent.is_some() || tree.is_none() || is_definition(node);
        is_there.then_some(UnreadObject { kind, extent, row })
    };
    found.into_iter().enumerate().filter_map(object).collect()
}

fn collect(group: &Group, opacity: f32, boxes: &mut BTreeMap<usize, MmRect>) {
    let opacity = opacity * group.opacity().get();
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => collect(group, opacity, boxes),
            usvg::Node::Path(path) if path.is_visible() && opacity > 0.0 => {
                let number = path.id().strip_prefix(BOX_OF).and_then(|number| number.parse().ok());
                if let Some(number) = number {
                    boxes.insert(number, in_mm(path.abs_bounding_box()));
                }
            }
            usvg::Node::Path(_) | usvg::Node::Image(_) | usvg::Node::Text(_) => {}
        }
    }
}

/// A box on the sheet that usvg gives in CSS pixels.
pub fn in_mm(rect: usvg::Rect) -> MmRect {
    let at = |x: f32, y: f32| MmPoint::new(x * MM_PER_CSS_PX, y * MM_PER_CSS_PX);
    MmRect::new(at(rect.left(), rect.top()), at(rect.right(), rect.bottom()))
}

#[cfg(test)]
mod tests;
