//! Outlines of regions, for the figure and for the overview.

use super::decisions::{Decisions, OutlinedRegions};
use super::given::with_room;
use super::progress::{Stage, Watch, run_stage};
use crate::edges::Edges;
use crate::lines::{Outlines, PagePart};
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::{self, Chosen, OutlineAreas, RegionOutline};
use crate::units::PageTransform;

/// How many lines an overview has beside outlines, if it has any of these, and the least length of each, mm.
const OTHERS: usize = 8;
const OTHERS_LENGTH: f32 = 8.0;

/// The regions that get an outline in the figure.
pub(super) fn regions_of_figure(
    edges: &Edges,
    decisions: &Decisions,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Option<Chosen> {
    let tree = edges.regions.as_ref()?;
    let transform = PageTransform::new(edges.size, layout.figure);
    let params = params_of(decisions, plan, PagePart::Figure);
    let mm_per_px = transform.mm_per_px();
    let choose = || {
        let is_named = !decisions.subjects.is_empty() || decisions.calmed_around.is_some();
        // On a grid of dots a thin thing, such as a rocket, is no region, and the ground beside it would be the thing.
        let may_be = !is_named && matches!(layout.medium, Medium::Print(_));
        let main_thing = if may_be { tree.main_thing(mm_per_px, &params) } else { None };
        let first: Vec<u32> = decisions.subjects.iter().copied().chain(main_thing).collect();
        tree.chosen(mm_per_px, &params, &first, &[])
    };
    Some(run_stage(watch, Stage::Regions, choose))
}

/// The outlines of the regions of a figure, where `transform` puts it, and the areas inside them.
pub(super) fn outlines_of_figure(
    edges: &Edges,
    regions: Option<OutlinedRegions<'_>>,
    transform: &PageTransform,
    plan: &Plan,
) -> (Outlines, Option<OutlineAreas>) {
    let Some((tree, regions)) = edges.regions.as_ref().zip(regions) else { return (Outlines::default(), None) };
    let OutlinedRegions { of_figure, decisions } = regions;
    let (outlines, areas) =
        tree.outlines(transform.mm_per_px(), &params_of(decisions, plan, PagePart::Figure), of_figure);
    (outlines_with_room(outlines, &areas, None, (edges, decisions)), Some(areas))
}

/// The outlines of an overview, where `transform` puts it, of a figure with such regions: where there are to be few
/// shapes, it has no others.
pub(super) fn outlines_of_overview(
    edges: &Edges,
    regions: Option<OutlinedRegions<'_>>,
    transform: &PageTransform,
    plan: &Plan,
) -> Outlines {
    let Some((tree, regions)) = edges.regions.as_ref().zip(regions) else { return Outlines::default() };
    let OutlinedRegions { of_figure, decisions } = regions;
    let params = params_of(decisions, plan, PagePart::Overview);
    let chosen = match params.drawn {
        Some(_) => of_figure.clone(),
        None => {
            // A main thing that nobody named is one of the figure's regions, and these count more anyway. As the first
            // one it took more from the other shapes than it gave, with an earlier version on 50 photographs of BSDS500
            // (val): closed .231 in place of .261, covering .446 in place of .460 (F .577 in place of .568).
            tree.chosen(transform.mm_per_px(), &params, &decisions.subjects, &of_figure.regions)
        }
    };
    let (outlines, areas) = tree.outlines(transform.mm_per_px(), &params, &chosen);
    outlines_with_room(outlines, &areas, Some((OTHERS, OTHERS_LENGTH)), (edges, decisions))
}

fn params_of(decisions: &Decisions, plan: &Plan, part: PagePart) -> regions::Params {
    let params = plan.regions(part);
    match decisions.calmed_around {
        Some(_) => regions::Params { most: decisions.subjects.len(), ..params },
        None => params,
    }
}

fn outlines_with_room(
    outlines: Vec<RegionOutline>,
    areas: &OutlineAreas,
    others: Option<(usize, f32)>,
    (edges, decisions): (&Edges, &Decisions),
) -> Outlines {
    Outlines {
        outlines: with_room(outlines, edges, decisions),
        subjects: decisions.subjects.len(),
        shapes: areas.count(),
        others,
    }
}
