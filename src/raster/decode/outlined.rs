//! Texts of a drawing whose letters are paths, as matplotlib writes them if it is not told to do otherwise. A comment
//! says the text, and the group behind it has a copy of an outline for each letter, in hundredths of the font size:
//!
//! ```text
//! <!-- Pears -->
//! <g transform="translate(95 270) scale(0.1 -0.1)">
//!  <defs><path id="DejaVuSans-50" d="..."/> ... </defs>
//!  <use xlink:href="#DejaVuSans-50"/> ...
//! </g>
//! ```

use std::collections::HashMap;
use std::ops::Range;

use resvg::tiny_skia::{Rect, Transform};
use usvg::roxmltree::{Document, Node};
use usvg::{Group, Tree};

use super::edited::edited;
use super::mathtext;
use super::texts::{ASCENT, DESCENT};
use crate::raster::vector::{DrawnText, PixelArea};
use crate::units::{PxPoint, Size};

/// Size of a font in the group of its letters.
const EM: f32 = 100.0;

/// How the ids begin that groups of letters get here if they have none.
const FRESH: &str = "letters-as-paths-";

/// A drawing that has texts whose letters are paths.
pub(super) struct LettersAsPaths {
    /// What they say, by the ids of their groups.
    texts: HashMap<String, String>,
    /// The drawing, in which each of these groups has its id.
    pub(super) marked: String,
    /// The same without their letters.
    pub(super) bare: String,
}

/// A drawing with its texts whose letters are paths, if it has such. What is not sure to be one is none.
pub(super) fn of_document(text: &str, document: &Document<'_>) -> Option<LettersAsPaths> {
    // what comes from an entity has no place of its own in the file
    if text.contains("<!ENTITY") || text.contains(FRESH) {
        return None;
    }
    let comments = document.descendants().filter(Node::is_comment);
    let groups: Vec<_> = comments.filter_map(|comment| Some((comment.text()?, group_behind(comment)?))).collect();
    let outlines = if groups.is_empty() { HashMap::new() } else { outlines(document) };
    let mut texts = HashMap::new();
    let (mut marks, mut removed) = (Vec::new(), Vec::new());
    for (comment, group) in groups {
        let Some(copies) = copies(group, &outlines) else { continue };
        let has_outline = |glyph: &&str| outlines.get(*glyph) == Some(&true);
        let seen: Vec<&str> = copies.iter().map(|(glyph, _)| *glyph).filter(has_outline).collect();
        let Some(string) = said(comment, &seen) else { continue };
        let Some((id, mark)) = identified(group, texts.len(), text) else { continue };
        if texts.contains_key(&id) {
            continue;
        }
        texts.insert(id, string);
        marks.extend(mark);
        removed.extend(copies.into_iter().map(|(_, range)| (range, String::new())));
    }
    let has_any = !texts.is_empty();
    has_any.then(|| {
        let marked = edited(text, marks);
        LettersAsPaths { texts, marked, bare: edited(text, removed) }
    })
}

/// The group that is the next element behind a comment, if it is drawn at its own place, and turned upside down, as
/// outlines of letters are.
fn group_behind<'a, 'i>(comment: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
    // within a symbol or a pattern, or where it is drawn by a <use>, its letters would be gone and no text found
    let mut around = comment.ancestors().filter(Node::is_element);
    if around.any(|element| !matches!(element.tag_name().name(), "svg" | "g" | "a" | "switch")) {
        return None;
    }
    let behind = comment.next_siblings().skip(1).find(|node| !node.is_text())?;
    let scale = behind.attribute("transform")?.trim_end().strip_suffix(')')?.rsplit_once("scale(")?.1;
    let mut factors = scale.split([' ', ',']).filter(|factor| !factor.is_empty()).map(str::parse::<f32>);
    let (x, y) = (factors.next()?.ok()?, factors.next()?.ok()?);
    let is_flipped = factors.next().is_none() && x > 0.0 && (x + y).abs() <= 1e-3 * x;
    (behind.tag_name().name() == "g" && is_flipped).then_some(behind)
}

/// The ids of all paths, and whether each has an outline: that of a blank has none.
fn outlines<'a>(document: &'a Document<'_>) -> HashMap<&'a str, bool> {
    let mut found = HashMap::new();
    for path in document.descendants().filter(|node| node.tag_name().name() == "path") {
        if let Some(id) = path.attribute("id") {
            found.entry(id).or_insert(path.attribute("d").is_some_and(|data| !data.trim().is_empty()));
        }
    }
    found
}

/// The copies of outlines in a group, by the ids of these and with their places in the file, if it draws nothing else.
/// The outline of a letter is named after the font and a number, as `DejaVuSans-41`.
fn copies<'a>(group: Node<'a, '_>, outlines: &HashMap<&str, bool>) -> Option<Vec<(&'a str, Range<usize>)>> {
    let is_hex = |number: &str| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_hexdigit());
    let mut found = Vec::new();
    for node in group.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "defs" => {}
            "use" => {
                let link = node.attributes().find(|attribute| attribute.name() == "href")?;
                let glyph = link.value().strip_prefix('#').filter(|glyph| outlines.contains_key(*glyph))?;
                glyph.rsplit_once('-').filter(|(font, number)| !font.is_empty() && is_hex(number))?;
                found.push((glyph, node.range()));
            }
            _ => return None,
        }
    }
    Some(found)
}

/// What a comment says, if it has as many letters as are drawn behind it, and no outline is that of two letters; signs
/// of a formula may be drawn in another order.
fn said(comment: &str, drawn: &[&str]) -> Option<String> {
    let string = comment.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    let string = string.split_whitespace().collect::<Vec<_>>().join(" ");
    let agrees = |with_ligatures: bool| {
        let letters = letters(&string, with_ligatures);
        let mut known = HashMap::new();
        letters.len() == drawn.len()
            && letters.iter().zip(drawn).all(|(letter, glyph)| *known.entry(*glyph).or_insert(*letter) == *letter)
    };
    if drawn.is_empty() {
        return None;
    }
    if mathtext::is_formula(&string) {
        let formula = mathtext::read(&string)?;
        return (formula.signs == drawn.len()).then_some(formula.string);
    }
    (agrees(false) || agrees(true)).then_some(string)
}

/// Letters that fonts draw as one.
const LIGATURES: [&str; 5] = ["ffi", "ffl", "ff", "fi", "fl"];

/// The letters of a text one by one, without blanks.
fn letters(text: &str, with_ligatures: bool) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let ligature = LIGATURES.iter().find(|ligature| with_ligatures && rest.starts_with(**ligature));
        let (letter, behind) = rest.split_at(ligature.map_or(first.len_utf8(), |ligature| ligature.len()));
        found.push(letter);
        rest = behind.trim_start();
    }
    found
}

/// What is put in the place of a part of a file.
type Replacement = (Range<usize>, String);

/// The id of a group, and what gives it the one of this number, at its place in the file, if it has none.
fn identified(group: Node<'_, '_>, number: usize, text: &str) -> Option<(String, Option<Replacement>)> {
    if let Some(own) = group.attribute("id") {
        return (!own.is_empty()).then(|| (own.to_owned(), None));
    }
    let at = group.range().start + "<g".len();
    let is_clear = text.get(..at)?.ends_with("<g") && text[at..].starts_with(char::is_whitespace);
    let id = format!("{FRESH}{number}");
    let mark = format!(" id=\"{id}\"");
    is_clear.then_some((id, Some((at..at, mark))))
}

impl LettersAsPaths {
    /// The texts of a drawing which is rendered with `transform` at a size, by the drawing with their groups.
    pub(super) fn of_tree(&self, marked: &Tree, transform: Transform, size: Size) -> Vec<DrawnText> {
        let mut found = Vec::new();
        self.add_group(marked.root(), transform, size, &mut found);
        found
    }

    fn add_group(&self, group: &Group, transform: Transform, size: Size, found: &mut Vec<DrawnText>) {
        if let Some(string) = self.texts.get(group.id()) {
            found.extend(drawn(group, string, transform, size));
            return;
        }
        for node in group.children() {
            if let usvg::Node::Group(inner) = node {
                self.add_group(inner, transform, size, found);
            }
        }
    }
}

/// The text of a group of letters, if a part of it is in the picture.
fn drawn(group: &Group, string: &str, transform: Transform, size: Size) -> Option<DrawnText> {
    let ink = group.bounding_box();
    let (low, high) = (ink.top().min(-DESCENT as f32 * EM), ink.bottom().max(ASCENT as f32 * EM));
    let to_pixels = transform.pre_concat(group.abs_transform());
    let place = Rect::from_ltrb(ink.left(), low, ink.right(), high)?.transform(to_pixels)?;
    let (min, max) = (PxPoint::new(place.left(), place.top()), PxPoint::new(place.right(), place.bottom()));
    PixelArea { min, max }.is_seen(size).then(|| DrawnText {
        string: string.to_owned(),
        min,
        max,
        angle: -to_pixels.ky.atan2(to_pixels.sx).to_degrees(),
        size: EM * to_pixels.kx.hypot(to_pixels.sy),
        hidden: false,
    })
}

#[cfg(test)]
mod tests;
