//! What was found: which rule is broken, where, by how much.

use std::collections::BTreeMap;

use super::rules::{self, RULES, Rule, Severity};
use crate::geom::ninths;
use crate::page::Page;
use crate::units::{MmPoint, MmRect};

/// A breach of a rule.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// The rule.
    pub rule: Rule,
    /// What is wrong, in words, with its size.
    pub what: String,
    /// Where the worst of it is; none if it is a matter of the whole page.
    pub at: Option<MmPoint>,
    /// The same in words, such as "upper left of the figure".
    pub place: String,
    /// The box around all of it.
    pub extent: Option<MmRect>,
    /// What was measured, in the unit that [`Checked::limit`](super::Checked::limit) gives for the rule; none where the
    /// breach is no matter of measure, as a leader line that ends in the blank.
    pub measured: Option<f32>,
    /// What `render` makes of it, where that puts it right: then it is a warning only.
    pub mended: Option<&'static str>,
    /// The name of the object that it is of, as on the page ("line 7"), where it is of one.
    pub object: Option<String>,
    /// The line of the file in which the element of the object begins, counted from 1, as far as that is known.
    pub line: Option<u32>,
}

/// What `render` makes of a page by the profile whose numbers count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Render {
    /// It would write the page otherwise, and puts some breaches right.
    Mends,
    /// It writes the page as it is, or is not asked.
    LeavesAsItIs,
}

/// A finding before its place has words.
pub(super) struct FoundBreach {
    pub(super) rule: Rule,
    pub(super) what: String,
    pub(super) at: Option<MmPoint>,
    pub(super) extent: Option<MmRect>,
    pub(super) measured: Option<f32>,
    /// Whether it is a text that `render` writes in braille; of all else the rule says what `render` makes of it.
    pub(super) becomes_braille: bool,
    /// Where to look for it in the file.
    pub(super) in_file: InFile,
}

/// Where something stands in the file of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum InFile {
    /// In the element of the object of this name.
    Object(String),
    /// In this line.
    Row(u32),
    /// In no one element.
    Page,
}

impl FoundBreach {
    /// A breach at one place.
    pub(super) fn at(rule: Rule, at: MmPoint, extent: MmRect, measured: f32, what: String) -> Self {
        let (at, extent, measured) = (Some(at), Some(extent), Some(measured));
        Self { rule, what, at, extent, measured, becomes_braille: false, in_file: InFile::Page }
    }

    /// A breach by the whole page.
    pub(super) fn of_page(rule: Rule, measured: Option<f32>, what: String) -> Self {
        Self { rule, what, at: None, extent: None, measured, becomes_braille: false, in_file: InFile::Page }
    }

    /// The same where nothing is measured that its rule has a limit for.
    pub(super) fn unmeasured(self) -> Self {
        Self { measured: None, ..self }
    }

    /// The same of the object of this name.
    pub(super) fn of(self, object: &str) -> Self {
        Self { in_file: InFile::Object(object.to_owned()), ..self }
    }

    /// `rows` says where objects stand in the file.
    pub(super) fn placed(self, page: &Page, render: Render, rows: &BTreeMap<String, u32>) -> Finding {
        let Self { rule, what, at, extent, measured, becomes_braille, in_file } = self;
        let (object, line) = match in_file {
            InFile::Object(name) => {
                let line = rows.get(&name).copied();
                (Some(name), line)
            }
            InFile::Row(row) => (None, Some(row)),
            InFile::Page => (None, None),
        };
        let mended = match render {
            Render::Mends if becomes_braille => Some(rules::IN_BRAILLE),
            Render::Mends => rules::mended(&rule),
            Render::LeavesAsItIs => None,
        };
        let place = at.map_or_else(|| "the whole page".to_owned(), |at| place_of(at, page));
        Finding { rule, what, at, place, extent, measured, mended, object, line }
    }
}

/// Where on a page a point lies, in words.
fn place_of(at: MmPoint, page: &Page) -> String {
    let sheet = MmRect::new(MmPoint::zero(), MmPoint::new(page.sheet[0], page.sheet[1]));
    let within = |place: MmRect| place.contains_inclusive(at);
    // an overview of dots has a sheet to itself, on which it is the figure
    let figure = if page.part_of_set() == "overview" { "the overview" } else { "the figure" };
    let all = format!("the {}", page.medium.name_of_sheet());
    let (area, whole) = match &page.overview {
        _ if within(page.figure.place) => (page.figure.place, figure),
        Some(overview) if within(overview.place) => (overview.place, "the overview"),
        _ => (sheet, all.as_str()),
    };
    format!("{} of {whole}", ninths::NAMES[ninths::ninth(at, area)])
}

/// Errors first, then by rule, then from the top of the sheet down.
pub(super) fn sorted(mut findings: Vec<Finding>) -> Vec<Finding> {
    let number = |finding: &Finding| RULES.iter().position(|rule| *rule == finding.rule);
    let place = |finding: &Finding| finding.at.map_or([0.0; 2], |at| [at.y, at.x]);
    findings.sort_by(|a, b| {
        let keys = (a.severity(), number(a)).cmp(&(b.severity(), number(b)));
        let [p, q] = [place(a), place(b)];
        keys.then(p[0].total_cmp(&q[0])).then(p[1].total_cmp(&q[1]))
    });
    findings
}

impl Finding {
    /// How bad it is: as its rule says, or a warning where `render` puts it right.
    pub fn severity(&self) -> Severity {
        if self.mended.is_some() { Severity::Warning } else { self.rule.severity }
    }

    /// Whether it is an error.
    pub fn is_error(&self) -> bool {
        self.severity() == Severity::Error
    }
}

/// The box around points; none around none.
pub(super) fn around(points: impl IntoIterator<Item = MmPoint>) -> Option<MmRect> {
    let mut points = points.into_iter();
    let first = points.next()?;
    let (low, high) = points.fold((first, first), |(low, high), at| (low.min(at), high.max(at)));
    Some(MmRect::new(low, high))
}
