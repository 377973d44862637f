//! What elements say of how they look, and which are hidden.

use usvg::roxmltree::Node;

/// Elements that are not drawn themselves, but by others that name them.
pub(super) const NOT_DRAWN: [&str; 6] = ["defs", "clipPath", "mask", "symbol", "pattern", "marker"];

/// What an element says of a property, in its style or as an attribute; the last that is declared counts.
pub(super) fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let in_style = node.attribute("style").and_then(|style| {
        let mut pairs = style.split(';').filter_map(|pair| pair.split_once(':'));
        pairs.rfind(|(key, _)| key.trim() == name).map(|(_, value)| value.trim())
    });
    in_style.or(node.attribute(name)).map(|value| value.trim_end_matches("!important").trim())
}

/// Whether an element is drawn: neither it nor what is around it is hidden.
pub(super) fn is_shown(node: &Node<'_, '_>) -> bool {
    let hides = |node: Node<'_, '_>| node.tag_name().name() == "defs" || property(node, "display") == Some("none");
    !node.ancestors().any(hides)
}

/// Whether an element is a part of what only others show.
pub(super) fn is_definition(node: Node<'_, '_>) -> bool {
    node.ancestors().any(|above| NOT_DRAWN.contains(&above.tag_name().name()))
}
