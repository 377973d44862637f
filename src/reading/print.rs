//! Words in print beside braille: how large their letters are, and whether they are light enough not to rise.

use usvg::roxmltree::Node;

use super::document::layer_of;
use super::style::property;
use crate::output::layer::{Layer, PRINT_GREY};

/// Size of letters where none is said, mm.
const COMMON_SIZE: f32 = 3.0;
/// Units of CSS in CSS pixels, which are the units of an SVG (CSS Values and Units 3).
const UNITS: [(&str, f32); 7] = [
    ("px", 1.0),
    ("mm", 96.0 / 25.4),
    ("cm", 96.0 / 2.54),
    ("in", 96.0),
    ("pt", 96.0 / 72.0),
    ("pc", 16.0),
    ("q", 96.0 / 101.6),
];
/// Colours by name that are light enough; others are taken as dark.
const LIGHT: [&str; 8] = ["white", "whitesmoke", "gainsboro", "lightgray", "lightgrey", "none", "transparent", "snow"];

/// Whether a text is one of the words in print beside braille.
pub(super) fn is_print_words(text: Node<'_, '_>) -> bool {
    text.ancestors().any(|above| layer_of(above) == Some(Layer::PrintWords))
}

/// Parts of a text that have letters of their own.
fn with_letters<'a>(text: Node<'a, 'a>) -> impl Iterator<Item = Node<'a, 'a>> {
    let has_letters = |part: &Node<'_, '_>| {
        let of_part =
            |child: Node<'_, '_>| child.text().filter(|_| child.is_text()).is_some_and(|t| !t.trim().is_empty());
        part.is_element() && part.children().any(of_part)
    };
    text.descendants().filter(has_letters)
}

/// Size of the letters of a text in its own units, as its first part with letters says or what that lies in.
fn units_of(node: Node<'_, '_>) -> Option<f32> {
    let (value, at) = node.ancestors().find_map(|above| Some((property(above, "font-size")?, above)))?;
    let value = value.to_ascii_lowercase();
    let split = value.find(|c: char| !(c.is_ascii_digit() || ".+-".contains(c))).unwrap_or(value.len());
    let (number, unit) = value.split_at(split);
    let number: f32 = number.parse().ok()?;
    let relative = |share: f32| at.parent().and_then(units_of).map(|size| share * size);
    match unit.trim() {
        "" => Some(number),
        "em" => relative(number),
        "%" => relative(0.01 * number),
        unit => UNITS.iter().find(|(known, _)| *known == unit).map(|(_, px)| number * px),
    }
}

/// Size of the letters of a text, mm, where one of its units is `unit` mm on the sheet.
pub(super) fn font_size(text: Node<'_, '_>, unit: f32) -> f32 {
    let first = with_letters(text).next().unwrap_or(text);
    let size = units_of(first).map(|size| size * unit);
    size.filter(|size| size.is_finite() && *size > 0.0).unwrap_or(COMMON_SIZE)
}

/// The share of a text that lies before its place: none of one that begins there, half of one in the middle of which it
/// is. Of a clone, what is around `shown_by` counts too.
pub(super) fn anchor(text: Node<'_, '_>, shown_by: Node<'_, '_>) -> f32 {
    let first = with_letters(text).next().unwrap_or(text);
    let said = first.ancestors().chain(shown_by.ancestors()).find_map(|above| property(above, "text-anchor"));
    match said {
        Some("middle") => 0.5,
        Some("end") => 1.0,
        _ => 0.0,
    }
}

/// Whether words in print are light enough not to rise: by what fills and outlines each of their parts, as a person may
/// have changed it.
pub(super) fn is_light(text: Node<'_, '_>) -> bool {
    let paint = |part: Node<'_, '_>, name: &str, otherwise: &str| {
        let said = part.ancestors().find_map(|above| property(above, name)).unwrap_or(otherwise);
        is_light_paint(&said.to_ascii_lowercase())
    };
    with_letters(text).all(|part| paint(part, "fill", "black") && paint(part, "stroke", "none"))
}

/// Whether a colour as CSS writes it is as light as words in print are, or paints nothing.
fn is_light_paint(paint: &str) -> bool {
    let channels: Option<Vec<u8>> = if let Some(digits) = paint.strip_prefix('#') {
        let hex = |text: &str| u8::from_str_radix(text, 16).ok();
        match digits.len() {
            3 => digits.chars().map(|digit| hex(&digit.to_string()).map(|value| 17 * value)).collect(),
            6 => [0, 2, 4].into_iter().map(|at| hex(digits.get(at..at + 2)?)).collect(),
            _ => None,
        }
    } else if let Some(inside) = paint.strip_prefix("rgb(").and_then(|rest| rest.strip_suffix(')')) {
        inside.split([',', ' ']).filter(|part| !part.is_empty()).map(|part| part.parse().ok()).collect()
    } else {
        return LIGHT.contains(&paint);
    };
    channels.is_some_and(|all| all.len() == 3 && all.iter().all(|channel| *channel >= PRINT_GREY))
}

#[cfg(test)]
mod tests;
