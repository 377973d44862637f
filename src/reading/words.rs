//! What a page says in words: title, description, how it was made.

use usvg::roxmltree::{Document, Node};

use crate::page::{LANGUAGE, MIRRORED};

const XML: &str = "http://www.w3.org/XML/1998/namespace";

/// The words of a page.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct PageWords {
    pub(super) title: String,
    pub(super) language: String,
    pub(super) description: String,
    pub(super) description_language: String,
    /// Lines `name = value` of the metadata.
    pub(super) origin: Vec<(String, String)>,
}

pub(super) fn of(document: &Document<'_>) -> PageWords {
    let own = |name: &str| document.root_element().children().find(|node| node.tag_name().name() == name);
    let (title, description) = (own("title"), own("desc"));
    let origin = own("metadata").map(|node| text(node)).unwrap_or_default();
    PageWords {
        title: title.map(|node| text(node).trim().to_owned()).unwrap_or_default(),
        language: language(title),
        description: description.map(|node| text(node).trim().to_owned()).unwrap_or_default(),
        description_language: language(description),
        origin: origin.lines().filter_map(pair).collect(),
    }
}

fn pair(line: &str) -> Option<(String, String)> {
    let (name, value) = line.split_once(" = ")?;
    Some((name.trim().to_owned(), value.trim_end().to_owned()))
}

/// The text right in an element: editors put elements of their own beside it.
fn text(node: Node<'_, '_>) -> String {
    node.children().filter(Node::is_text).filter_map(|node| node.text()).collect()
}

/// The language of an element; that of generated words if it says none.
pub(super) fn language(node: Option<Node<'_, '_>>) -> String {
    node.and_then(|node| node.attribute((XML, "lang"))).unwrap_or(LANGUAGE).to_owned()
}

impl PageWords {
    /// A value of how the page was made, without its quotes.
    pub(super) fn value(&self, name: &str) -> Option<&str> {
        let value = self.origin.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str());
        value.map(|value| value.trim_matches('"'))
    }

    /// Whether it is a page for the back of the sheet.
    pub(super) fn is_mirrored(&self) -> bool {
        self.value(MIRRORED) == Some("true")
    }

    /// A number of how the page was made.
    pub(super) fn number(&self, name: &str) -> Option<f32> {
        self.value(name)?.parse().ok().filter(|number: &f32| number.is_finite())
    }
}
