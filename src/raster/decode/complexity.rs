//! Complexity of a drawing: how deep and how large it is once its references are followed, found before usvg and resvg
//! follow them. Both are recursive, and run out of stack (which ends the program) where a drawing is a few hundred
//! levels deep. And a pattern of ten shapes that are filled with a pattern of ten shapes and so on is a small file that
//! takes years to draw. usvg also makes so many curves of an arc with a radius of 1e38 that it takes for ever.

use std::collections::HashMap;

use usvg::roxmltree::{Document, Node, NodeId};

/// Most levels. On a thread's usual stack of 2 MB usvg and resvg 0.49 end at 528 levels of patterns in patterns, 548 of
/// tspan in tspan, 551 of svg in svg, 751 of groups in groups (release, x86-64); WebAssembly has half that stack.
/// Drawings by people and their programs have 30 at most.
pub(super) const MOST_LEVELS: u32 = 200;

/// Most elements with each reference counted as often as it is drawn; usvg has the same limit for elements.
const MOST_ELEMENTS: u64 = 1_000_000;

/// Most elements, texts and comments of a file: between elements there is text.
pub(super) const MOST_NODES: u32 = 3_000_000;

/// Most attributes of a file, by the signs that stand between their names and values. In memory each takes ten times
/// its least length in the file.
const MOST_ATTRIBUTES: usize = 5_000_000;

/// Most octaves of a turbulence filter: each is half as strong as the one before, so the ninth is under a step of 8
/// bits. Each costs as much as the first.
const MOST_OCTAVES: f64 = 16.0;

/// Largest radius of a dilation or an erosion, as a share of the drawing's longest side. resvg looks at the whole
/// square of it for each pixel, which takes some seconds at this share.
const MOST_RADIUS: f64 = 0.02;

/// Most rules of style sheets. usvg's parser keeps them sorted as they come: 10 000 take 2 s, 20 000 7 s. Drawings of
/// programs have some hundred.
const MOST_RULES: usize = 8000;

/// Most letters of one text. usvg's shaping grows with their square: 50 000 take 2 s, 100 000 7 s. A page has 3000.
const MOST_LETTERS: usize = 30_000;

/// Most comparisons of elements with rules of a style sheet that have references.
const MOST_COMPARISONS: usize = 10_000_000;

/// Most levels of a drawing inside a drawing, which come on top of those around it.
pub(super) const MOST_LEVELS_INSIDE: u32 = 50;

/// Attributes that hold places and lengths of shapes.
const LENGTHS: &[&str] = &["d", "r", "rx", "ry", "cx", "cy", "x", "y", "width", "height", "points", "stroke-width"];

/// Most digits of these before the point. Maps in metres have 8; usvg and resvg compute in f32, which of numbers of 10
/// digits knows only every 512th, and tiny-skia 0.12 panics on some.
const MOST_DIGITS: usize = 9;

/// Refuses a text that would take too much memory to be parsed: 40 MB of elements without attributes take 2 GB.
///
/// # Errors
/// What there is too much of.
pub(super) fn check_text(text: &str) -> Result<(), String> {
    let count = |sign: u8| text.as_bytes().iter().filter(|byte| **byte == sign).count();
    // each element begins, and most end
    if count(b'<') > 2 * MOST_ELEMENTS as usize {
        return Err(too_many_elements());
    }
    if count(b'=') > MOST_ATTRIBUTES {
        return Err(format!("it has more than {MOST_ATTRIBUTES} attributes"));
    }
    Ok(())
}

pub(super) fn too_many_elements() -> String {
    format!("it has more than {MOST_ELEMENTS} elements")
}

/// # Errors
/// What there is too much of.
pub(super) fn check(document: &Document<'_>, most_levels: u32) -> Result<(), String> {
    let elements: Vec<Node<'_, '_>> = document.descendants().filter(Node::is_element).collect();
    let octaves = elements.iter().filter_map(|node| node.attribute("numOctaves")?.trim().parse::<f64>().ok());
    if octaves.fold(0.0, f64::max) > MOST_OCTAVES {
        return Err(format!("a turbulence filter has more than {MOST_OCTAVES} octaves"));
    }
    no_longer_than(document, MOST_DIGITS)?;
    if largest_radius(document, &elements) > MOST_RADIUS {
        return Err("a morphology filter has a radius of more than 2 % of the drawing's longest side".into());
    }
    let letters = |text: &Node<'_, '_>| {
        text.descendants().filter_map(|node| node.text()).map(|text| text.chars().count()).sum::<usize>()
    };
    if elements.iter().filter(|node| node.has_tag_name((SVG, "text"))).any(|text| letters(text) > MOST_LETTERS) {
        return Err(format!("a text has more than {MOST_LETTERS} letters"));
    }
    if style_sheets(&elements).map(|sheet| sheet.matches('{').count()).sum::<usize>() > MOST_RULES {
        return Err(format!("its style sheets have more than {MOST_RULES} rules"));
    }
    let total = Graph::new(document, &elements)?.total(document.root_element().id());
    if total.levels > most_levels {
        return Err(format!("it is more than {most_levels} elements deep, references included"));
    }
    if total.elements > MOST_ELEMENTS {
        return Err(format!("it has more than {MOST_ELEMENTS} elements, references included"));
    }
    Ok(())
}

/// Refuses a drawing in which a place or a length has more than `most` digits before the point.
///
/// # Errors
/// That there is one.
pub(crate) fn no_longer_than(document: &Document<'_>, most: usize) -> Result<(), String> {
    let beyond = |node: Node<'_, '_>| {
        let is_beyond = |name: &str, value: &str| LENGTHS.contains(&name) && digits_in(value) > most;
        let of = node.attributes().find(|of| is_beyond(of.name(), of.value()))?;
        let tag = || format!("a {}", node.tag_name().name());
        let object = node.attribute("id").map_or_else(tag, |id| format!("\"{id}\""));
        let (at, name) = (document.text_pos_at(node.range().start), of.name());
        Some(format!(
            "line {}, column {}: {name} of {object} has a place or size too large to compute with, of more than {most} \
             digits before the point",
            at.row, at.col
        ))
    };
    document.descendants().find_map(beyond).map_or(Ok(()), Err)
}

/// Most digits before the point of any number in a text; those of an exponent count as what they stand for.
fn digits_in(text: &str) -> usize {
    let numbers = text.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '+')));
    let digits = |number: &str| {
        let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, ""));
        let whole = mantissa.split('+').map(|one| one.split('.').next().unwrap_or_default());
        let whole = whole.map(|digits| digits.trim_start_matches('0').len()).max().unwrap_or_default();
        let exponent = exponent.trim_start_matches('+').split(['.', '+', 'e', 'E']).next().unwrap_or_default();
        let exponent = if exponent.is_empty() { 0 } else { exponent.parse().unwrap_or(usize::MAX) };
        whole.saturating_add(exponent)
    };
    numbers.map(digits).max().unwrap_or_default()
}

const SVG: &str = "http://www.w3.org/2000/svg";

/// The largest radius of all morphology filters, as a share of the drawing's longest side.
fn largest_radius(document: &Document<'_>, elements: &[Node<'_, '_>]) -> f64 {
    fn numbers(text: &str) -> impl Iterator<Item = f64> {
        let parts = text.split(|c: char| c.is_whitespace() || c == ',');
        parts.filter_map(|part| part.trim_end_matches(|c: char| c.is_alphabetic() || c == '%').parse().ok())
    }
    let root = document.root_element();
    let attribute = |name: &str| root.attribute(name).and_then(|text| numbers(text).next());
    let of_box = root.attribute("viewBox").map(|text| numbers(text).skip(2).fold(0.0, f64::max));
    let side = of_box.or_else(|| Some(attribute("width")?.max(attribute("height")?))).filter(|side| *side > 0.0);
    let share = |filter: &Node<'_, '_>| {
        let radius = filter.attribute("radius").map_or(0.0, |text| numbers(text).fold(0.0, f64::max));
        let is_of_box = filter.parent().and_then(|all| all.attribute("primitiveUnits")) == Some("objectBoundingBox");
        if is_of_box { radius } else { radius / side.unwrap_or(100.0) }
    };
    elements.iter().filter(|node| node.has_tag_name((SVG, "feMorphology"))).map(share).fold(0.0, f64::max)
}

/// Levels and elements from an element on down.
#[derive(Debug, Clone, Copy, Default)]
struct Total {
    levels: u32,
    elements: u64,
}

/// For each element those that are drawn with it: its children, and what it refers to.
struct Graph {
    below: HashMap<NodeId, Vec<NodeId>>,
}

impl Graph {
    fn new(document: &Document<'_>, elements: &[Node<'_, '_>]) -> Result<Self, String> {
        let ids = Ids::of(elements);
        let rules = Rules::of(elements);
        if rules.0.len().saturating_mul(elements.len()) > MOST_COMPARISONS {
            return Err(format!(
                "its style sheets are too long for so many elements: rules with references times elements are more \
                 than {MOST_COMPARISONS}"
            ));
        }
        let mut below = HashMap::<NodeId, Vec<NodeId>>::with_capacity(elements.len());
        // The patterns and markers that hold for what is inside an element.
        let mut passed = HashMap::<NodeId, Vec<NodeId>>::new();
        for node in elements {
            let mut here = node.parent().and_then(|parent| passed.get(&parent.id())).cloned().unwrap_or_default();
            let mut all: Vec<NodeId> = node.children().filter(Node::is_element).map(|child| child.id()).collect();
            all.extend(ids.link(*node));
            for target in references(*node).chain(rules.references(*node)).filter_map(|id| ids.drawn.get(id)) {
                let list = if target.passes_down { &mut here } else { &mut all };
                if !list.contains(&target.node) {
                    list.push(target.node);
                }
            }
            if here.len() > MOST_LEVELS as usize {
                return Err(format!("more than {MOST_LEVELS} patterns and markers hold for one element"));
            }
            all.extend(&here);
            below.insert(node.id(), all);
            if !here.is_empty() && node.has_children() {
                passed.insert(node.id(), here);
            }
        }
        debug_assert!(below.contains_key(&document.root_element().id()));
        Ok(Self { below })
    }

    /// Walks without calling itself. A reference back to what is being walked counts nothing: usvg breaks such rings.
    fn total(&self, root: NodeId) -> Total {
        enum State {
            Open,
            Done(Total),
        }
        let mut states = HashMap::with_capacity(self.below.len());
        states.insert(root, State::Open);
        let mut open = vec![(root, 0, Total::default())];
        while let Some((node, next, sum)) = open.last_mut() {
            let below = self.below.get(node).map_or(&[][..], Vec::as_slice);
            let Some(child) = below.get(*next) else {
                let done = Total { levels: sum.levels + 1, elements: sum.elements.saturating_add(1) };
                states.insert(*node, State::Done(done));
                open.pop();
                continue;
            };
            match states.get(child) {
                Some(State::Done(total)) => {
                    sum.levels = sum.levels.max(total.levels);
                    sum.elements = sum.elements.saturating_add(total.elements);
                    *next += 1;
                }
                Some(State::Open) => *next += 1,
                None => {
                    states.insert(*child, State::Open);
                    open.push((*child, 0, Total::default()));
                }
            }
        }
        match states.get(&root) {
            Some(State::Done(total)) => *total,
            _ => Total::default(),
        }
    }
}

/// Elements by their ids.
struct Ids<'a> {
    all: HashMap<&'a str, NodeId>,
    /// Those that draw what they hold where they are referred to; gradients do not.
    drawn: HashMap<&'a str, Target>,
}

struct Target {
    node: NodeId,
    /// Whether a reference to it holds for all that is inside an element, as fills and markers do.
    passes_down: bool,
}

impl<'a> Ids<'a> {
    fn of(elements: &[Node<'a, '_>]) -> Self {
        let mut ids = Self { all: HashMap::new(), drawn: HashMap::new() };
        for element in elements {
            let Some(id) = element.attribute("id") else { continue };
            let node = element.id();
            ids.all.insert(id, node);
            match element.tag_name().name() {
                "pattern" | "marker" => ids.drawn.insert(id, Target { node, passes_down: true }),
                "clipPath" | "mask" | "filter" => ids.drawn.insert(id, Target { node, passes_down: false }),
                _ => None,
            };
        }
        ids
    }

    /// What an element is a copy or a continuation of; a hyperlink draws nothing.
    fn link(&self, node: Node<'_, '_>) -> Option<NodeId> {
        if node.tag_name().name() == "a" {
            return None;
        }
        let mut links = node.attributes().filter(|attribute| attribute.name() == "href");
        links.find_map(|attribute| self.all.get(attribute.value().trim().strip_prefix('#')?).copied())
    }
}

/// The texts of all style sheets.
fn style_sheets<'a>(elements: &[Node<'a, '_>]) -> impl Iterator<Item = &'a str> {
    let sheets = elements.iter().filter(|node| node.tag_name().name() == "style").flat_map(Node::children);
    sheets.filter_map(|node| node.text())
}

/// The ids that the attributes of an element name as `url(#id)`.
fn references<'a>(node: Node<'a, '_>) -> impl Iterator<Item = &'a str> {
    node.attributes().flat_map(|attribute| urls(attribute.value()))
}

/// The ids in `url(#id)`, with quotes or without.
fn urls(text: &str) -> impl Iterator<Item = &str> {
    text.split("url(").skip(1).filter_map(|rest| {
        let inside = rest.split(')').next()?.trim_matches(|c: char| c.is_whitespace() || c == '"' || c == '\'');
        inside.strip_prefix('#')
    })
}

/// Rules of style sheets that have references: selectors and what they refer to.
struct Rules<'a>(Vec<(&'a str, Vec<&'a str>)>);

impl<'a> Rules<'a> {
    fn of(elements: &[Node<'a, '_>]) -> Self {
        let rules = style_sheets(elements).flat_map(|sheet| sheet.split('}'));
        Self(
            rules
                .filter_map(|rule| rule.rsplit_once('{'))
                .map(|(selector, style)| (selector, urls(style).collect::<Vec<_>>()))
                .filter(|(_, references)| !references.is_empty())
                .collect(),
        )
    }

    /// Selectors are not understood here; one that has the element's class, id or name in it may mean it.
    fn references(&self, node: Node<'a, '_>) -> impl Iterator<Item = &'a str> {
        let id = node.attribute("id").unwrap_or_default();
        let name = node.tag_name().name();
        let classes: Vec<&str> = node.attribute("class").unwrap_or_default().split_whitespace().collect();
        let hit = move |selector: &str| {
            let mut words = selector.split(|c: char| !(c.is_alphanumeric() || c == '-' || c == '_'));
            selector.contains(['*', '[', ':'])
                || words.any(|word| word == name || word == id || classes.contains(&word))
        };
        self.0.iter().filter(move |(selector, _)| hit(selector)).flat_map(|(_, references)| references.iter().copied())
    }
}

#[cfg(test)]
mod tests;
