//! The lines of the figure: drawn of contours and outlines of regions, with what of them is lost.

use super::decisions::LinesOf;
use super::dots;
use super::hand_lines::by_hand_first;
use super::joined_bars::{BarTolerances, Redraw};
use super::legend::{self, LegendEntry};
use super::outlines::outlines_of_figure;
use super::progress::{Event, Stage, Watch, run_stage};
use super::told_bars::BarStyle;
use super::too_near::{self, Rules};
use super::{lost_marks, lost_signs};
use crate::edges::Edges;
use crate::lines::{self, Lines, Outlines};
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::OutlineAreas;
use crate::units::{MmRect, PageTransform};

/// What becomes of the lines of a figure.
#[derive(Default)]
pub(super) struct FigureLines {
    pub(super) lines: Lines,
    /// The areas that the outlines of regions among them surround.
    pub(super) areas: Option<OutlineAreas>,
    /// How the bars of a chart are drawn that have no room as they are.
    pub(super) instead: Option<BarStyle>,
}

impl FigureLines {
    /// The same with all patches of a legend or none.
    pub(super) fn with_legend(self, entries: &[LegendEntry]) -> Self {
        Self { lines: legend::with_all_patches_or_none(self.lines, entries), ..self }
    }
}

/// The lines of the figure.
pub(super) fn draw_lines(
    edges: &Edges,
    lines_of: LinesOf<'_>,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> FigureLines {
    let reason = if !plan.profile().figure.lines {
        "figure.lines is off"
    } else if edges.is_empty() && !lines_of.has_subject() {
        "there are no contours"
    } else {
        let transform = PageTransform::new(edges.size, layout.figure);
        return run_stage(watch, Stage::Lines, || {
            let (outlines, areas) = outlines_of_figure(edges, lines_of.regions(), &transform, plan);
            // a figure has one place
            let draw = |edges: &Edges, _: MmRect, detail: f32| {
                let params = lines::Params { detail, ..plan.lines() };
                draw_whole(edges, &outlines, &transform, layout, &params, plan)
            };
            let (place, detail) = (layout.figure, plan.lines().detail);
            let mut drawn = draw(edges, place, detail);
            let are_few = plan.lines().most_shapes.is_some();
            // what of the few shapes of a drawing has no room is a loss, as of any drawing
            if are_few && !edges.of_drawing() && matches!(lines_of, LinesOf::Picture(_)) {
                drawn.lost.lack_on_purpose();
            }
            if are_few || matches!(lines_of, LinesOf::Person) {
                return FigureLines { lines: drawn, areas, instead: None };
            }
            let (places, tolerances) = (&[place], BarTolerances::of(layout, plan));
            let redraw =
                Redraw { edges, places, tolerances, detail, draw: &draw, lines: &|drawn: &Lines| &drawn.lines };
            let (lines, instead) = redraw.whole(drawn, place);
            FigureLines { lines, areas, instead }
        });
    };
    watch(Event::Skip(Stage::Lines, reason));
    FigureLines::default()
}

/// The lines of the figure, with what is lost. What has no room as a point of dots may have room as it is.
fn draw_whole(
    edges: &Edges,
    outlines: &Outlines,
    transform: &PageTransform,
    layout: &Layout,
    params: &lines::Params,
    plan: &Plan,
) -> Lines {
    let is_print = matches!(layout.medium, Medium::Print(_));
    let rules = Rules::of(edges, layout.figure, false, layout, plan);
    let (of_strokes, of_dots) = (rules.filter(|_| is_print), rules.filter(|_| !is_print));
    let draw = |params: &lines::Params| {
        let mut drawn = lines::draw_with(edges, outlines, transform, layout.figure, params);
        of_strokes.iter().for_each(|rules| too_near::cut(&mut drawn, rules));
        // those beyond as many shapes as are asked for are left out on purpose
        let is_all = params.most_shapes.is_none();
        if is_all {
            drawn.lost.signs = lost_signs::find(edges, &drawn, transform, params.max_spacing());
        }
        if matches!(layout.medium, Medium::Dots(_)) {
            drawn.lines = by_hand_first(drawn.lines, edges, transform);
        }
        let mut drawn = dots::pressed(drawn, edges, layout.figure, layout, plan);
        of_dots.iter().for_each(|rules| too_near::cut(&mut drawn, rules));
        if is_all {
            let (marks, boxes) = lost_marks::find(edges, &drawn, layout.figure, transform, params.min_length);
            drawn.lost.marks = marks;
            drawn.lost.gone.retain(|line| !lost_marks::is_one_of(line, &boxes));
        }
        drawn
    };
    let drawn = draw(params);
    if drawn.marks.points.is_empty() || drawn.lost.signs.is_empty() {
        return drawn;
    }
    let plain = draw(&lines::Params { takes_points: false, ..*params });
    if plain.lost.signs.len() < drawn.lost.signs.len() { plain } else { drawn }
}
