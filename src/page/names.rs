//! What lines and areas are called: in an editor's list of objects, and where somebody is told of them.

use std::collections::{BTreeMap, BTreeSet};

use super::parts::{BrailleText, Class, Page, TextRole};

/// The names of a page's objects, in the order of the page.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Names {
    /// Those of the lines of the figure, such as "line 7".
    pub lines: Vec<String>,
    /// Those of the lines of the overview, such as "overview line 7".
    pub overview_lines: Vec<String>,
    /// Those of the areas, such as "red area 2".
    pub areas: Vec<String>,
    /// In which line of its file each of them and each text begins, by its name, counted from 1; of a page that was
    /// read.
    pub rows: BTreeMap<String, u32>,
    /// Those of the lines of the figure that a person drew, on a page that was read.
    pub by_hand: BTreeSet<String>,
}

impl Names {
    /// The names that a page's objects have when it is written.
    pub fn of(page: &Page) -> Self {
        let mut counts: BTreeMap<Class, usize> = BTreeMap::new();
        let mut area = |class: Class| {
            let nth = counts.entry(class).or_default();
            *nth += 1;
            area_name(class, *nth)
        };
        let overview = page.overview.as_ref().map_or(0, |overview| overview.lines.len());
        Self {
            lines: (1..=page.figure.lines.len()).map(line_name).collect(),
            overview_lines: (1..=overview).map(overview_line_name).collect(),
            areas: page.figure.textures.iter().map(|texture| area(texture.class)).collect(),
            rows: BTreeMap::new(),
            by_hand: BTreeSet::new(),
        }
    }
}

/// The name of a line of the figure; they count from 1.
pub fn line_name(number: usize) -> String {
    format!("line {number}")
}

/// The name of a line of the overview.
pub fn overview_line_name(number: usize) -> String {
    format!("overview line {number}")
}

/// What a text in braille is called.
pub fn text_name(text: &BrailleText) -> String {
    match text.role {
        TextRole::Title => "the title".into(),
        TextRole::Number => "the page number".into(),
        TextRole::Label | TextRole::Key => format!("\"{}\"", text.text),
    }
}

/// The name of an area: each class counts its own.
pub fn area_name(class: Class, nth: usize) -> String {
    format!("{} area {nth}", class.name())
}
