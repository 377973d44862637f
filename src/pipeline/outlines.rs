//! Outlines of regions, for the figure and for the overview.

use super::given::with_room;
use crate::edges::Edges;
use crate::lines::Outlines;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::Areas;
use crate::units::PageTransform;

/// How many lines an overview has beside outlines, and the least length of each, mm.
const OTHERS: usize = 8;
const OTHERS_LENGTH: f32 = 8.0;

/// The outlines of the most telling regions, for a figure or an overview where `transform` puts it, and what they
/// surround.
pub(super) fn outlines_of(
    edges: &Edges,
    transform: &PageTransform,
    layout: &Layout,
    plan: &Plan,
    of_overview: bool,
) -> (Outlines, Option<Areas>) {
    let Some(tree) = &edges.regions else { return (Outlines::default(), None) };
    let mut params = plan.regions(of_overview);
    if edges.only_subjects {
        params.most = edges.subjects.len();
    }
    // where there are to be few shapes, the overview has no others than the figure
    let of_figure = (of_overview && params.drawn.is_some()).then(|| {
        let of_figure = PageTransform::new(edges.size, layout.figure);
        tree.chosen(of_figure.mm_per_px(), &plan.regions(false), &edges.subjects)
    });
    let (traces, areas) = tree.outlines(transform.mm_per_px(), &params, &edges.subjects, of_figure.as_deref());
    let traces = with_room(traces, edges);
    let others = of_overview.then_some((params.drawn.map_or(OTHERS, |most| most.min(OTHERS)), OTHERS_LENGTH));
    (Outlines { traces, shapes: areas.count(), others }, Some(areas))
}
