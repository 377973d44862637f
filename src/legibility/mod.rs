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
mod layer;
mod leaders;
mod limits;
mod loose_ends;
mod marks;
mod next_cells;
mod overview;
mod paths;
mod report;
mod rows_beside;
mod rules;
mod spaces;
mod strokes;
mod twins;
mod verdict;
mod words;

pub(crate) use dotted::{least_arc, longest_approach};
pub use finding::{Finding, Render};
pub(crate) use gaps::{BEND, CORNER, STRAIGHTNESS};
pub use gaps::{Near, too_near};
pub use ink::{canvas_of, to_canvas};
pub(crate) use joins::{APART, APPROACH, BEND_LEAST, CLUSTER_APPROACH, SMALL_RING};
pub use layer::marked;
pub(crate) use leaders::{
    LEADER_FREE, LEADER_FROM_BRAILLE, LEADER_STRAIGHT, LONGEST_LEADER, SHORTEST_LEADER, is_shut_in,
};
use limits::CELL;
pub(crate) use limits::{LEADER_END, OWN_LEADER_GAP};
pub use limits::{MediumLimits, RuleLimits};
pub(crate) use loose_ends::LooseEnds;
pub use overview::told_left_out;
pub(crate) use paths::{RING_CORNER, RING_CORNER_ARMS};
pub use report::{Checked, rules_as_json, rules_as_text};
pub(crate) use rows_beside::too_many as rows_beside_lines;
pub use rules::{RULES, Rule, Severity};
pub use spaces::crowded;
pub(crate) use strokes::{GOES_ON, STEPS, longest_cut};
pub use strokes::{near_lines, short_lines};
pub use verdict::{Fingertip, Textures, Verdict};

use std::collections::BTreeMap;
use std::convert::Infallible;

use usvg::Tree;
use usvg::roxmltree::Document;

use crate::Error;
use crate::listing::and_more;
use crate::page::{InSet, Names, Page};
use crate::reading::{Reading, SeenText};
use crate::touch::Report;
use finding::FoundBreach;

/// The SVG of a page, or of any drawing.
#[derive(Debug)]
pub struct Drawn<'a> {
    /// Its elements.
    pub document: &'a Document<'a>,
    /// What is drawn.
    pub tree: &'a Tree,
    /// What `render` makes of it.
    pub render: Render,
}

impl<'a> Drawn<'a> {
    /// Holds the SVG of a page against the rules, and the page that was read from it.
    /// Where `render` puts a breach right, it is told as a warning. `go_on` is asked between the kinds of rules.
    ///
    /// # Errors
    /// Those of `go_on`.
    pub fn check(
        &self,
        read: &Reading,
        limits: &RuleLimits,
        felt: Fingertip<'_>,
        go_on: &dyn Fn() -> Result<(), Error>,
    ) -> Result<Checked, Error> {
        let page = &read.page;
        let mut found = found(page, &read.names, limits, go_on)?;
        found.extend(drawn::findings(self.document, self.tree, &read.letters, limits));
        // dots of a device are pressed one by one, whatever is drawn
        if matches!(limits.medium, limits::MediumLimits::Print { .. }) {
            found.extend(ink::blocks(self.tree));
        }
        Ok(checked((found, self.render), page, &read.names.rows, limits, felt))
    }

    /// Holds a drawing that is no page of this program against the rules: as ink. `sheet` is an empty page of its size.
    /// `texts` are those that it shows.
    pub fn check_as_ink(&self, sheet: &Page, texts: &[SeenText], limits: &RuleLimits) -> Checked {
        let mut found = vec![FoundBreach::of_page(rules::LAYERS, None, "this is no page of tactograph".into())];
        found.extend(drawn::findings(self.document, self.tree, texts, limits));
        found.extend(ink::findings(self.tree, limits));
        checked((found, Render::LeavesAsItIs), sheet, &BTreeMap::new(), limits, Fingertip::NotAsked)
    }
}

/// What the overview shows that the figure has not, and what it lacks, in words; none if they are alike.
pub fn overview_as_told(page: &Page, names: &Names, limits: &RuleLimits) -> Option<String> {
    let felt = page.risen();
    let paths = paths::Paths::whole(&felt.figure.lines);
    let found = overview::findings(&felt, names, &paths, &paths.index(CELL), limits);
    let (first, count) = (found.first()?, found.len());
    let told = and_more(&first.what, count - 1, "such place");
    Some(told)
}

/// Braille of a page that has too little blank around it or is no standard braille, in words; none if all is well.
pub fn braille_as_told(page: &Page, names: &Names, limits: &RuleLimits) -> Option<String> {
    let felt = page.risen();
    let mut found = spaces::findings(&felt, names, &marks::marks_of(&felt), limits);
    found.extend(words::findings(&felt, names, limits));
    found.retain(|found| [rules::BRAILLE_CLEAR, rules::BRAILLE_CELL].contains(&found.rule));
    let place =
        |found: &FoundBreach| found.at.map_or_else(String::new, |at| format!(" (at {:.0}, {:.0} mm)", at.x, at.y));
    let told: Vec<String> =
        found.iter().take(MOST_TOLD).map(|found| format!("{}{}", found.what, place(found))).collect();
    let told = and_more(&told.join("; "), found.len() - told.len(), "such place");
    (!found.is_empty()).then(|| format!("braille stays where it is on the page: {told}; move one of them"))
}

/// Most places that are told one by one.
const MOST_TOLD: usize = 5;

/// Holds a page against the rules. `felt` is what a fingertip feels of its textures, for the verdict.
pub fn check(page: &Page, limits: &RuleLimits, felt: Option<&Report>) -> Checked {
    let felt = felt.map_or(Fingertip::NotAsked, Fingertip::Felt);
    let names = Names::of(page);
    // who is never asked whether to go on refuses nothing
    let Ok(found) = found::<Infallible>(page, &names, limits, &|| Ok(()));
    checked((found, Render::LeavesAsItIs), page, &names.rows, limits, felt)
}

/// What was found, and what `render` makes of it. `rows` are the lines of the file in which objects stand.
fn checked(
    (found, render): (Vec<FoundBreach>, Render),
    page: &Page,
    rows: &BTreeMap<String, u32>,
    limits: &RuleLimits,
    felt: Fingertip<'_>,
) -> Checked {
    let findings = finding::sorted(found.into_iter().map(|found| found.placed(page, render, rows)).collect());
    let verdict = Verdict::of(page, &findings, felt);
    Checked { findings, limits: *limits, verdict, notes: Vec::new() }
}

/// All breaches of the rules over marks; `go_on` is asked between the kinds of rules.
fn found<E>(
    page: &Page,
    names: &Names,
    limits: &RuleLimits,
    go_on: &dyn Fn() -> Result<(), E>,
) -> Result<Vec<FoundBreach>, E> {
    go_on()?;
    let (page, names, twins) = twins::merged(page.clone(), names);
    let (page, names) = (&page, &names);
    let felt = page.risen();
    let marks = marks::marks_of(&felt);
    let mut found = twins;
    go_on()?;
    found.extend(areas::findings(&felt, names, &marks, limits));
    found.extend(areas::black(page, limits));
    found.extend(rows_beside::findings(page, limits));
    go_on()?;
    found.extend(spaces::findings(&felt, names, &marks, limits));
    go_on()?;
    let is_part = matches!(InSet::of(page), Some(InSet::One(..)));
    let window = is_part.then_some(page.figure.place);
    found.extend(strokes::findings(&felt.figure.lines, &names.lines, window, &page.medium, limits));
    if let Some(overview) = &felt.overview {
        found.extend(strokes::findings(&overview.lines, &names.overview_lines, None, &page.medium, limits));
    }
    let paths = paths::Paths::whole(&felt.figure.lines);
    let index = paths.index(CELL);
    go_on()?;
    found.extend(ends::findings(&paths, names, &index, limits));
    found.extend(loose_ends::findings(&felt, &paths, &index, limits));
    go_on()?;
    found.extend(overview::findings(&felt, names, &paths, &index, limits));
    found.extend(overview::lacks_much(&felt, names, &paths, limits));
    found.extend(words::findings(&felt, names, limits));
    go_on()?;
    found.extend(leaders::findings(&felt, names, &paths, &index, limits.least_strength));
    found.extend(next_cells::findings(&felt, limits));
    found.extend(overview::left_out(page));
    go_on()?;
    Ok(found)
}
