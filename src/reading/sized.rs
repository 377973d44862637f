//! The size of a sheet, where the root of a page's SVG does not say it: tools that make files small or fit for the web
//! leave it out, and without it a page of so many mm would be one of so many pixels.

use std::ops::Range;

use usvg::roxmltree::{Document, Node};

use crate::raster::decode::checked_document;

/// Two shapes of sheets are one up to this share of a side: sides are written in whole mm, or tenths of inches.
const SAME: f32 = 0.02;

/// What is to be written into the text of a page so that its root says its size in mm; nothing where it says it, and of
/// other drawings.
pub(super) fn edits(text: &str) -> Vec<(Range<usize>, String)> {
    let is_page = text.contains("data-box=") && text.contains("data-source=");
    if !is_page || is_sized(text) {
        return Vec::new();
    }
    checked_document(text).ok().and_then(|document| edits_of(&document)).unwrap_or_default()
}

/// Whether the first tag of a drawing plainly says a size; only a hint, by which most texts need not be parsed.
fn is_sized(text: &str) -> bool {
    let tag = text.find("<svg").and_then(|start| text[start..].split('>').next()).unwrap_or_default();
    let says = |name: &str| tag.split_whitespace().any(|part| part.starts_with(name) && !part.contains('%'));
    says("width=") && says("height=")
}

fn edits_of(document: &Document<'_>) -> Option<Vec<(Range<usize>, String)>> {
    let (root, text) = (document.root_element(), document.input_text());
    let own = |name: &str| root.attributes().find(|own| own.namespace().is_none() && own.name() == name);
    let is_said = |name: &str| own(name).is_some_and(|said| !said.value().trim().ends_with('%'));
    if is_said("width") && is_said("height") {
        return None;
    }
    let [width, height] = size(root)?;
    // behind the name of the element
    let start = root.range().start + 1;
    let end = start + text[start..].find(|c: char| c.is_whitespace() || c == '/' || c == '>')?;
    let edit = |(name, mm): (&str, f32)| match own(name) {
        Some(said) => (said.range(), format!("{name}=\"{mm}mm\"")),
        None => (end..end, format!(" {name}=\"{mm}mm\"")),
    };
    let unsaid = [("width", width), ("height", height)].into_iter().filter(|(name, _)| !is_said(name));
    Some(unsaid.map(edit).collect())
}

/// The size of a page in mm, as its metadata say it, or else its view box, whose units are mm.
fn size(root: Node<'_, '_>) -> Option<[f32; 2]> {
    let view: Result<Vec<f32>, _> =
        root.attribute("viewBox")?.split([' ', ',']).filter(|part| !part.is_empty()).map(str::parse).collect();
    let [width, height]: [f32; 2] = view.ok()?.get(2..4)?.try_into().ok()?;
    let metadata = root.children().find(|node| node.tag_name().name() == "metadata").and_then(|node| node.text());
    let said = |name: &str| -> Option<f32> {
        let value = metadata?.lines().find_map(|line| line.trim().strip_prefix(name)?.strip_prefix(" = "))?;
        value.trim().parse().ok()
    };
    let said = said("page.width").zip(said("page.height"));
    // a profile has the sheet upright
    let said = said.map(|(a, b)| if (a > b) == (width > height) { [a, b] } else { [b, a] });
    let is_like = |[a, b]: &[f32; 2]| (a * height - b * width).abs() <= SAME * a.abs() * height;
    Some(said.filter(is_like).unwrap_or([width, height])).filter(|size| size.iter().all(|side| *side > 0.0))
}
