//! Is a page legible? Rules over the finished marks, each with its number, unit and source; what breaks them is told
//! with its place, its size and what to do.
//!
//! ```text
//! Page -> marks as felt -> strokes (width, length, gaps), spaces (between parts), areas, words, ends, overview
//!      -> Finding (rule, place, size) -> Checked (sorted)
//! ```
//!
//! A page is judged by its marks alone, whoever made it. Distances are exact: a stroke is what lies within half its
//! width of its middle line, a rhombus its four corners, a dot its circle.

mod areas;
mod dotted;
mod drawn;
mod ends;
mod finding;
mod gaps;
mod ink;
mod joins;
mod left_out;
mod limits;
mod mark;
mod marks;
mod overview;
mod report;
mod rules;
mod spaces;
mod strokes;
mod verdict;
mod ways;
mod words;

pub use finding::Finding;
pub use gaps::{Near, too_near};
pub use limits::{Limits, MediumLimits};
pub use mark::{LAYER, marked};
pub use report::{Checked, rules_as_text};
pub use rules::{RULES, Rule, Severity};
pub use spaces::crowded;
pub use verdict::{Textures, Verdict};

use usvg::Tree;
use usvg::roxmltree::Document;

use crate::page::{InSet, Names, Page};
use crate::reading::Reading;
use crate::touch::Report;
use finding::Found;

/// The SVG of a page, or of any drawing.
#[derive(Debug)]
pub struct Drawn<'a> {
    /// Its elements.
    pub document: &'a Document<'a>,
    /// What is drawn.
    pub tree: &'a Tree,
    /// Whether it is a page that `render` would write otherwise, by the profile whose numbers count.
    pub mends: bool,
}

impl<'a> Drawn<'a> {
    /// Holds the SVG of a page against the rules, and the page that was read from it.
    /// Where `render` puts a breach right, it is told as a warning.
    pub fn check(&self, read: &Reading, limits: &Limits, felt: Option<&Report>) -> Checked {
        let page = &read.page;
        let mut found = found(page, &read.names, limits);
        found.extend(drawn::findings(self.document, self.tree, limits));
        if !self.mends {
            found.iter_mut().for_each(|found| found.mended = None);
        }
        checked(found, page, limits, felt)
    }

    /// Holds a drawing that is no page of this program against the rules: as ink. `sheet` is an empty page of its size.
    pub fn check_as_ink(&self, sheet: &Page, limits: &Limits) -> Checked {
        let mut found = vec![Found::of_page(rules::LAYERS, None, "this is no page of tactograph".into())];
        found.extend(drawn::findings(self.document, self.tree, limits));
        found.extend(ink::findings(self.tree, limits));
        found.iter_mut().for_each(|found| found.mended = None);
        checked(found, sheet, limits, None)
    }
}

/// What the overview shows that the figure has not, and what it lacks, in words; none if they are alike.
pub fn overview_as_told(page: &Page, names: &Names, limits: &Limits) -> Option<String> {
    let felt = page.risen();
    let ways = ways::Ways::of(&felt.figure.lines, f32::INFINITY);
    let found = overview::findings(&felt, names, &ways, &ways.index(5.0), limits);
    let (first, count) = (found.first()?, found.len());
    let more = if count > 1 { format!(" (and {} more such places)", count - 1) } else { String::new() };
    Some(format!("the overview is as it was: {}{more}; change it there too, or delete it", first.what))
}

/// Holds a page against the rules. `felt` is what a fingertip feels of its textures, for the verdict.
pub fn check(page: &Page, limits: &Limits, felt: Option<&Report>) -> Checked {
    let mut found = found(page, &Names::of(page), limits);
    found.iter_mut().for_each(|found| found.mended = None);
    checked(found, page, limits, felt)
}

fn checked(found: Vec<Found>, page: &Page, limits: &Limits, felt: Option<&Report>) -> Checked {
    let findings = finding::sorted(found.into_iter().map(|found| found.placed(page)).collect());
    let verdict = Verdict::of(page, &findings, felt);
    Checked { findings, limits: *limits, verdict, notes: Vec::new() }
}

fn found(page: &Page, names: &Names, limits: &Limits) -> Vec<Found> {
    let felt = page.risen();
    let marks = marks::marks_of(&felt);
    let mut found = areas::findings(&felt, names, &marks, limits);
    found.extend(areas::black(page, limits));
    found.extend(spaces::findings(&felt, names, &marks, limits));
    let is_part = matches!(InSet::of(page), Some(InSet::One(..)));
    let window = is_part.then_some(page.figure.place);
    found.extend(strokes::findings(&felt.figure.lines, &names.lines, window, &page.medium, limits));
    if let Some(overview) = &felt.overview {
        found.extend(strokes::findings(&overview.lines, &names.overview_lines, None, &page.medium, limits));
    }
    let ways = ways::Ways::of(&felt.figure.lines, f32::INFINITY);
    let index = ways.index(5.0);
    found.extend(ends::findings(&ways, &names.lines, &index, limits));
    found.extend(overview::findings(&felt, names, &ways, &index, limits));
    found.extend(words::findings(&felt, names, limits));
    found.extend(left_out::findings(page));
    found
}
