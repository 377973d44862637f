//! What the objects of a page that was read are called: as an editor lists them.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use usvg::roxmltree::Node;

use super::document::{UNNAMED, label_of, own_id};
use crate::page::{Class, Names};

/// Most characters of a name.
const MOST: usize = 40;

/// How an object is called, and by which element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Name {
    kind: &'static str,
    /// None if it has neither a label nor an id of its own.
    shown: Option<String>,
    id: String,
    /// Whether it has one in the file.
    has_id: bool,
    /// Where its element begins in the text of the file.
    pub(super) begins: usize,
    /// Whether it is a line that a person drew: those that we write say how strong they are.
    pub(super) by_hand: bool,
}

/// The name of a line, or of a clone of it, which a person made.
pub(super) fn of_line(element: Node<'_, '_>, clone: Option<Node<'_, '_>>) -> Name {
    let is_ours = |name: &str| is_numbered(name, "line ") || is_numbered(name, "overview line ");
    let name = of_clone(named(element, "line", is_ours), clone, is_ours);
    Name { by_hand: clone.is_some() || !element.has_attribute("data-strength"), ..name }
}

/// The name of what a clone shows as the clone's: by its own label, or as a copy of that.
fn of_clone(name: Name, clone: Option<Node<'_, '_>>, is_ours: impl Fn(&str) -> bool) -> Name {
    let Some(clone) = clone else { return name };
    let own = named(clone, name.kind, is_ours);
    let shown = if label_of(clone).is_some() { own.shown } else { name.shown };
    Name { shown, ..own }
}

/// The name of an area; one that was moved to another texture keeps its old name in the list, so its class is said too.
pub(super) fn of_area(element: Node<'_, '_>, clone: Option<Node<'_, '_>>, class: Class) -> Name {
    let is_ours = |name: &str| name.split_once(" area ").is_some_and(|(_, number)| is_number(number));
    let name = of_clone(named(element, "area", is_ours), clone, is_ours);
    let shown = name.shown.map(|shown| match shown.starts_with(class.name()) {
        true => shown,
        false => format!("{shown} ({})", class.name()),
    });
    Name { shown, ..name }
}

/// By its label, or else by its id: "line 7" as it is, other names in quotation marks.
fn named(element: Node<'_, '_>, kind: &'static str, is_ours: impl Fn(&str) -> bool) -> Name {
    let id = element.attribute("id").unwrap_or_default();
    let own = own_id(element).filter(|id| !id.is_empty());
    let label = label_of(element).map(|label| label.split_whitespace().collect::<Vec<_>>().join(" "));
    let ours = |id: &str| Some(id.replace('-', " ")).filter(|name| is_ours(name));
    let name =
        label.filter(|label| !label.is_empty()).or_else(|| own.and_then(ours)).or_else(|| own.map(str::to_owned));
    let shown = match name {
        Some(name) if is_ours(&name) => Some(name),
        Some(name) => {
            let short: String = name.chars().filter(|c| !c.is_control()).take(MOST).collect();
            Some(format!("{kind} \"{short}\""))
        }
        None => None,
    };
    Name { kind, shown, id: id.to_owned(), has_id: own.is_some(), begins: element.range().start, by_hand: false }
}

fn is_numbered(name: &str, prefix: &str) -> bool {
    name.strip_prefix(prefix).is_some_and(is_number)
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// The names as they are told. Copies of an object have its label: they are told by their ids as well; objects without
/// a name are counted.
fn told(names: &[Name]) -> Vec<String> {
    // for each shown name the ids that have it, numbered in order
    let mut ids: HashMap<Option<&str>, HashMap<&str, usize>> = HashMap::new();
    for name in names {
        let of_name = ids.entry(name.shown.as_deref()).or_default();
        let next = of_name.len() + 1;
        of_name.entry(&name.id).or_insert(next);
    }
    let tell = |name: &Name| {
        let of_name = ids.get(&name.shown.as_deref());
        let all = of_name.map_or(0, HashMap::len);
        let nth = of_name.and_then(|ids| ids.get(name.id.as_str())).copied().unwrap_or(1);
        // what is called by its id needs it no second time
        let is_by_id = |shown: &str| shown.ends_with(&format!("\"{}\"", name.id));
        match &name.shown {
            None if all > 1 => format!("{} {nth} without a name", name.kind),
            None => format!("{} {} without a name", article(name.kind), name.kind),
            Some(shown) if all > 1 && name.id.starts_with(UNNAMED) => {
                let id = if name.has_id { "with the same id" } else { "without an id" };
                format!("{shown} (copy {nth}, {id})")
            }
            Some(shown) if all > 1 && !is_by_id(shown) => format!("{shown} (\"{}\")", name.id),
            Some(shown) => shown.clone(),
        }
    };
    names.iter().map(tell).collect()
}

/// The names of the lines of the figure, of those of the overview and of the areas of a page, and in which line of
/// its `text` each of them and of the texts in braille begins; these come with their names and where they begin.
pub(super) fn of_page(
    [lines, overview_lines, areas]: &[Vec<Name>; 3],
    texts: Vec<(String, usize)>,
    text: &str,
) -> Names {
    let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at).collect();
    let row = |begins: usize| 1 + ends.partition_point(|end| *end < begins) as u32;
    let [told_lines, told_overview, told_areas] = [lines, overview_lines, areas].map(|names| told(names));
    let mut rows: BTreeMap<String, u32> = BTreeMap::new();
    let of_names = |told: &[String], names: &[Name]| -> Vec<(String, usize)> {
        told.iter().cloned().zip(names.iter().map(|name| name.begins)).collect()
    };
    let of_lines = [of_names(&told_lines, lines), of_names(&told_overview, overview_lines)];
    for (name, begins) in of_lines.into_iter().flatten().chain(of_names(&told_areas, areas)).chain(texts) {
        rows.entry(name).or_insert_with(|| row(begins));
    }
    let by_hand = told_lines.iter().zip(lines).filter(|(_, line)| line.by_hand);
    let by_hand: BTreeSet<String> = by_hand.map(|(name, _)| name.clone()).collect();
    Names { lines: told_lines, overview_lines: told_overview, areas: told_areas, rows, by_hand }
}

fn article(noun: &str) -> &'static str {
    if noun.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" }
}

#[cfg(test)]
mod tests;
