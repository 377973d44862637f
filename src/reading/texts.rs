//! Where the texts of an SVG are shown: each in its place, and in those of its clones. Without fonts usvg places no
//! texts, so a small mark stands where each begins, under all that moves or hides it: a text is shown whose mark is.

use std::collections::HashMap;
use std::fmt::Write;

use usvg::roxmltree::Node;

use super::style::{NOT_DRAWN, is_definition, property};

/// Begins the id of the mark that stands where a text begins.
pub(super) const PLACE_OF: &str = "place-of-";
/// Side of a mark, in the units of its text.
const SIDE: f32 = 0.01;
/// What rounding may make of that.
const ROUNDING: f32 = 0.002;
/// What a text says of itself that moves or hides it.
const LOOKS: [&str; 6] = ["transform", "class", "style", "display", "visibility", "opacity"];
/// The mark itself is painted, and nothing cuts it off.
const PAINTED: &str = "fill:#000;fill-opacity:1;stroke:none;filter:none;clip-path:none;mask:none";
/// Most elements that are looked at to find the texts of one clone, and most texts that it shows.
const MOST_LOOKED_AT: usize = 100_000;
const MOST_TEXTS: usize = 1000;
/// Most clones of clones and groups around a text in them.
const MOST_DEEP: usize = 100;

/// The elements by which a text is shown, from the outermost to the text: of one that is no clone only itself.
pub(super) type NodePath<'a> = Vec<Node<'a, 'a>>;

/// Whether an element is a text, be it of SVG or one that flows as Inkscape wrote it for SVG 1.2.
fn is_text(element: Node<'_, '_>) -> bool {
    ["text", "flowRoot"].contains(&element.tag_name().name())
}

/// The texts that an element shows: a text shows itself, and a clone those of what it is a clone of.
pub(super) fn shown_by<'a>(element: Node<'a, 'a>, by_id: &HashMap<&'a str, Node<'a, 'a>>) -> Vec<NodePath<'a>> {
    if !(is_text(element) || element.tag_name().name() == "use") || is_definition(element) {
        return Vec::new();
    }
    let mut walk = Walk { by_id, found: Vec::new(), looked_at: 0 };
    walk.go_through(element, &mut Vec::new());
    walk.found
}

struct Walk<'a, 'm> {
    by_id: &'m HashMap<&'a str, Node<'a, 'a>>,
    found: Vec<NodePath<'a>>,
    looked_at: usize,
}

impl<'a> Walk<'a, '_> {
    fn go_through(&mut self, element: Node<'a, 'a>, path: &mut NodePath<'a>) {
        self.looked_at += 1;
        let is_too_much = self.looked_at > MOST_LOOKED_AT || self.found.len() >= MOST_TEXTS || path.len() > MOST_DEEP;
        if is_too_much || path.contains(&element) {
            return;
        }
        path.push(element);
        match element.tag_name().name() {
            _ if is_text(element) => self.found.push(path.clone()),
            "use" => target(element, self.by_id).into_iter().for_each(|of| self.go_through(of, path)),
            // a symbol is shown by its clones, other definitions are not
            name if name != "symbol" && NOT_DRAWN.contains(&name) => {}
            _ => element.children().filter(Node::is_element).for_each(|child| self.go_through(child, path)),
        }
        path.pop();
    }
}

/// What a clone is a clone of.
pub(super) fn target<'a>(clone: Node<'a, 'a>, by_id: &HashMap<&'a str, Node<'a, 'a>>) -> Option<Node<'a, 'a>> {
    let mut links = clone.attributes().filter(|attribute| attribute.name() == "href");
    links.find_map(|link| by_id.get(link.value().trim().strip_prefix('#')?).copied())
}

/// The key of the text that an element of this id shows as its `nth`.
pub(super) fn key(id: &str, nth: usize) -> String {
    format!("{id}/{nth}")
}

/// The mark of the place of a text, by its key. One that flows and says no place begins where its region does.
pub(super) fn mark<'a>(path: &[Node<'a, 'a>], key: &str, by_id: &HashMap<&'a str, Node<'a, 'a>>) -> String {
    let mut out = String::new();
    let Some((text, around)) = path.split_last() else { return out };
    // Writing to a String cannot fail.
    for node in around {
        let _ = write!(out, "<g{}>", looks(*node));
        let moved = |name: &str| node.attribute(name).filter(|_| node.tag_name().name() == "use").unwrap_or("0");
        let _ = write!(out, "<g transform=\"translate({} {})\">", escaped(moved("x")), escaped(moved("y")));
    }
    let first = |name: &str| {
        let id = property(*text, "shape-inside").and_then(|shape| shape.strip_prefix("url(#")?.strip_suffix(')'));
        let region = id.and_then(|id| by_id.get(id));
        let parts = || text.descendants().chain(region.copied()).filter(Node::is_element);
        // that of a path begins with the place of its first point
        let of_path = |path: Node<'a, 'a>| {
            let numbers = path.attribute("d")?.split(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)));
            numbers.filter(|number| !number.is_empty()).nth(usize::from(name == "y"))
        };
        let value = parts().find_map(|part| part.attribute(name)).or_else(|| parts().find_map(of_path));
        let number = value.and_then(|value| value.split([' ', ',']).find(|number| !number.is_empty()));
        escaped(number.unwrap_or("0"))
    };
    let (id, x, y) = (escaped(&format!("{PLACE_OF}{key}")), first("x"), first("y"));
    let _ = write!(out, "<rect id=\"{id}\" x=\"{x}\" y=\"{y}\" width=\"{SIDE}\" height=\"{SIDE}\"{}/>", looks(*text));
    out + &"</g></g>".repeat(around.len())
}

/// What moves or hides an element, as attributes.
pub(super) fn looks(node: Node<'_, '_>) -> String {
    let own = LOOKS.iter().filter(|name| **name != "style").filter_map(|name| Some((*name, node.attribute(*name)?)));
    let mut out: String = own.map(|(name, value)| format!(" {name}=\"{}\"", escaped(value))).collect();
    let style = node.attribute("style").unwrap_or_default();
    let _ = write!(out, " style=\"{};{PAINTED}\"", escaped(style));
    out
}

pub(super) fn escaped(value: &str) -> String {
    value.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// Whether a path of this size, in its own units, is the mark of a text: clones of what has one in it have it too.
pub(super) fn is_mark(width: f32, height: f32) -> bool {
    [width, height].iter().all(|side| (side - SIDE).abs() <= ROUNDING)
}
