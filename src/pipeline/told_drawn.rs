//! What the maker is told of the lines of a figure and of its overview, once both are drawn.

use super::decisions::Decisions;
use super::given::{Given, GivenLines, is_in};
use super::overview::{DrawnOverview, told_by_hand, told_of_few, told_of_overview, told_without_overview};
use super::texts::Text;
use super::told_lines::{told_beside_added, told_cut, told_dashed, told_of_lost, told_opened, told_overlaid};
use super::{areas_of_overview, links_of_overview, lost_colours, lost_marks, subject, thing_of_overview, told_signs};
use crate::edges::Edges;
use crate::lines::Lines;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::raster::Raster;
use crate::regions::Chosen;
use crate::units::{MmPoint, PageTransform};
use crate::{About, Note, Reason, Told};

/// What is told of the lines of the figure: what is not drawn, and what is drawn otherwise.
pub(super) fn told_of_figure(
    drawn: &Lines,
    edges: &Edges,
    (texts, raster): (&[Text], &Raster),
    layout: &Layout,
    plan: &Plan,
) -> Vec<Note> {
    let of_colours = lost_colours::told(drawn, edges, raster, layout, plan);
    let left_out = told_of_lost(drawn, edges, texts, layout).chain(of_colours);
    let has_lines = plan.profile().figure.lines;
    let signs = told_signs::told(drawn, edges, texts, layout);
    let otherwise = [told_short_marks(edges, layout), told_dashed(edges), told_overlaid(edges, layout)]
        .into_iter()
        .flatten()
        .filter(|_| has_lines);
    left_out.chain(lost_marks::told(&drawn.lost, layout.sheets.as_ref(), plan)).chain(otherwise).chain(signs).collect()
}

/// What the maker is told of marks on a line that are too short to be found in the pixels.
fn told_short_marks(edges: &Edges, layout: &Layout) -> Option<Note> {
    let at = PageTransform::new(edges.size, layout.figure).to_mm(edges.short_marks?);
    let told = format!(
        "short lines on one line, such as those of minutes on a clock (one of them around {}): they are too short for \
         fingers",
        layout.place_in_words(at)
    );
    Some(Note::NotOnPage(About::Lines, Reason::NoRoomForTicks, Told::from(told).or_larger()))
}

/// The lines of the figure, its overview, and what both are drawn of.
pub(super) struct DrawnLines<'a> {
    /// The contours of the picture, and the regions whose outlines are drawn.
    pub(super) of_picture: (&'a Edges, Option<&'a Chosen>),
    /// What a person gave, and what was decided.
    pub(super) by: (&'a Given, &'a Decisions),
    /// The lines of the figure.
    pub(super) drawn: &'a Lines,
    pub(super) overview: &'a DrawnOverview,
    pub(super) layout: &'a Layout,
    pub(super) plan: &'a Plan,
}

impl DrawnLines<'_> {
    /// What is told of the overview, of lines that a person drew, and of subjects. An overview of few shapes
    /// `follows_figure`, and should have all of its lines.
    pub(super) fn told(&self, follows_figure: bool) -> Vec<Note> {
        let &Self { of_picture: (edges, _), by: (_, decisions), drawn, overview, layout, plan } = self;
        let mut notes: Vec<Note> = told_of_overview(overview, &drawn.lost.marks).collect();
        notes.extend(self.told_of_shapes());
        notes.extend(self.told_of_person());
        notes.extend(if follows_figure { told_of_few(&drawn.lines, overview, layout, plan) } else { None });
        notes.extend(subject::told(decisions, edges.size, &drawn.lines, overview.marks.as_ref(), layout, plan));
        notes
    }

    /// What is told of areas of the figure, of lines between its shapes, and of the first and the large ones of its
    /// regions, that the overview lacks, and of one with nothing in it.
    fn told_of_shapes(&self) -> impl Iterator<Item = Note> {
        let &Self { of_picture: (edges, regions), by: (_, decisions), drawn, overview, layout, plan } = self;
        let lines = &drawn.lines[..];
        let areas = areas_of_overview::told(edges, lines, overview, layout, plan);
        let all = told_without_overview(overview, edges, lines, layout).into_iter().chain(areas);
        let things = thing_of_overview::told(edges, (regions, decisions), lines, overview, layout, plan);
        all.chain(links_of_overview::told(edges, lines, overview, layout, plan)).chain(things)
    }

    /// What is told of lines that a person drew: of what runs beside those that are added or is open there, of what is
    /// missing of them, and of an overview that is made of lines that are given, and what it lacks.
    fn told_of_person(&self) -> impl Iterator<Item = Note> {
        let &Self { by: (given, decisions), drawn, overview, layout, plan, .. } = self;
        let (lines, added) = (&drawn.lines[..], given.added.as_ref());
        let is_erased = |at: MmPoint| {
            let [from, size] = [at - layout.figure.min, layout.figure.size().to_vector()];
            is_in([from.x / size.x, from.y / size.y], &decisions.erased)
        };
        let cut = told_cut(added, lines, is_erased, layout, plan);
        let opened = told_opened(added, lines, &decisions.gave_way, layout, plan);
        let beside = told_beside_added(added, lines, layout, plan);
        let anew = match (&given.lines, &overview.marks) {
            (Some(GivenLines::Vectors(of_page)), Some((place, drawn))) => {
                of_page.told_overview_anew(*place, drawn.len())
            }
            _ => None,
        };
        let all = cut.into_iter().chain(opened).chain(beside).chain(anew);
        all.chain(told_by_hand(given.hand_lines(), lines, overview, layout))
    }
}
