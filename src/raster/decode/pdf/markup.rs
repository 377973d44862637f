//! The SVG text that hayro writes of a page, made acceptable to the decoder of drawings.
//!
//! hayro-svg 0.9 writes one element a line. Letters are `<use xlink:href="#g7"/>` of outlines, or `#e7` where the
//! font's letters are drawings of their own (Type 3). Each path that is clipped stands in a group of its own, so that
//! a page of a thousand paths under one clip has a thousand clipped groups.

use std::collections::HashSet;

use super::words::PX_PER_POINT;

/// The text with its size in CSS pixels, and with neighbours that are clipped alike in one group. Unless letters are
/// kept, it has none, and no element whose name and first attribute are one of `letters`.
pub(super) fn prepared(svg: &str, (width, height): (f32, f32), letters: Option<&[String]>) -> String {
    let forms: HashSet<&str> = letters.unwrap_or_default().iter().map(String::as_str).collect();
    let is_form = |element: &str| !forms.is_empty() && first_attribute(element).is_some_and(|own| forms.contains(own));
    let mut out = String::with_capacity(svg.len());
    let mut lines = svg.lines();
    out.push_str(&sized(lines.next().unwrap_or_default(), width, height));
    // The lines that opened the elements around the place that is read.
    let mut open: Vec<&str> = Vec::new();
    // What opened a group of which the end is read but not written: it may go on.
    let mut ending: Option<&str> = None;
    for element in lines.map(str::trim_start) {
        if letters.is_some() && (is_letter(element) || is_form(element)) {
            continue;
        }
        if let Some(group) = ending.take() {
            if element == group {
                open.push(element);
                continue;
            }
            out.push_str("\n</g>");
        }
        if element.starts_with("</") {
            ending = open.pop().filter(|opening| only_clips(opening));
            if ending.is_some() {
                continue;
            }
        } else if element.starts_with('<') && !element.ends_with("/>") {
            open.push(element);
        }
        out.push('\n');
        out.push_str(element);
    }
    out
}

/// The first line, which says the size in points without a unit.
fn sized(line: &str, width: f32, height: f32) -> String {
    let with_unit = |line: &str, name: &str, points: f32| {
        line.replacen(&format!(" {name}=\"{points}\""), &format!(" {name}=\"{}\"", points * PX_PER_POINT), 1)
    };
    with_unit(&with_unit(line, "width", width), "height", height)
}

/// An element up to the end of its first attribute.
fn first_attribute(element: &str) -> Option<&str> {
    let (end, _) = element.match_indices('"').nth(1)?;
    element.get(..=end)
}

/// Whether an element draws a letter.
fn is_letter(element: &str) -> bool {
    let id = element.strip_prefix("<use xlink:href=\"#").and_then(|rest| rest.split_once('"')).map(|(id, _)| id);
    let number = id.and_then(|id| id.strip_prefix(['g', 'e']));
    number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()))
}

/// Whether an element opens a group that does nothing but clip.
fn only_clips(opening: &str) -> bool {
    let id = opening.strip_prefix("<g clip-path=\"url(#").and_then(|rest| rest.strip_suffix(")\">"));
    id.is_some_and(|id| !id.contains('"'))
}

#[cfg(test)]
mod tests;
