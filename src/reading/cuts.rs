//! Clip paths, masks and filters, of which a page has none: all that they would cut off is there. They are taken out
//! before anything is drawn, as a mark is not drawn at all whose filter is missing from the file, or is measured by the
//! height of a level line, which is none.

use std::ops::Range;

use usvg::roxmltree::Node;

/// The properties that cut off or change what is drawn.
const PROPERTIES: [&str; 3] = ["filter", "clip-path", "mask"];
/// What stands in place of them.
pub(super) const NONE: &str = "none";

/// Where the values of these properties stand in the text of an element's tag, or of a style sheet.
pub(super) fn of_element(node: Node<'_, '_>, text: &str) -> Vec<Range<usize>> {
    let of_text = |range: Range<usize>| {
        let begin = range.start;
        values(&text[range]).into_iter().map(move |value| value.start + begin..value.end + begin)
    };
    if node.tag_name().name() == "style" {
        return node.children().filter(Node::is_text).flat_map(|part| of_text(part.range())).collect();
    }
    let mut found: Vec<Range<usize>> = Vec::new();
    for attribute in node.attributes().filter(|attribute| attribute.namespace().is_none()) {
        let is_one = PROPERTIES.contains(&attribute.name());
        match attribute.name() {
            "style" => found.extend(of_text(attribute.range_value())),
            _ if is_one && attribute.value().trim() != NONE => found.push(attribute.range_value()),
            _ => {}
        }
    }
    found.sort_by_key(|range| range.start);
    found
}

/// Where the values of these properties stand in declarations of CSS.
fn values(css: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for (at, _) in css.match_indices(':') {
        let before = css[..at].trim_end();
        let begin = before.rfind(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_')).map_or(0, |i| {
            // the letter before a name may be longer than one byte
            i + css[i..].chars().next().map_or(1, char::len_utf8)
        });
        if !PROPERTIES.contains(&&before[begin..]) {
            continue;
        }
        let value = &css[at + 1..at + 1 + length(&css[at + 1..])];
        let from = at + 1 + value.len() - value.trim_start().len();
        let value = value.trim();
        if !value.is_empty() && value != NONE {
            found.push(from..from + value.len());
        }
    }
    found
}

/// How long the value of a declaration is that begins here, bytes. A semicolon in brackets does not end it, nor does
/// that of an entity.
fn length(css: &str) -> usize {
    let (mut depth, mut entity) = (0_u32, false);
    for (at, letter) in css.char_indices() {
        match letter {
            ';' if entity => entity = false,
            '&' => entity = true,
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ';' | '}' if depth == 0 => return at,
            letter if !(letter.is_ascii_alphanumeric() || letter == '#') => entity = false,
            _ => {}
        }
    }
    css.len()
}

#[cfg(test)]
mod tests;
