//! The contours of a picture that was read.

use super::progress::{Event, ONE_COLOUR, Stage, Watch, run_stage};
use super::read::Content;
use crate::edges::{self, Edges, Ridges};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::raster::decode;
use crate::regions::Detail;
use crate::units::PageTransform;

/// Why a drawing has no regions: its lines say enough.
const OF_DRAWING: &str = "the picture is a drawing";

/// Why no contours are looked for where a person gives lines.
pub(super) const GIVEN: &str = "lines are given";

/// The contours of a picture: those of a vector drawing from its own geometry.
pub(super) fn edges_of(
    picture: &decode::Decoded,
    content: &Content,
    params: &edges::Params,
    regions: Option<Detail>,
    watch: &mut Watch<'_>,
) -> Edges {
    let raster = &picture.raster;
    if let Some(drawing) = &picture.drawing {
        watch(Event::Skip(Stage::Regions, OF_DRAWING));
        return run_stage(watch, Stage::Edges, || edges::find_in_vector(raster, drawing, params));
    }
    // only pixels of one colour are of no kind
    let Some(kind) = content.kind() else { return Edges::none(raster.size()) };
    let Some(detail) = regions.filter(|_| !kind.is_drawing) else {
        let reason = if kind.is_drawing { OF_DRAWING } else { "lines.regions is off" };
        watch(Event::Skip(Stage::Regions, reason));
        return run_stage(watch, Stage::Edges, || edges::find_of_kind(raster, kind, params, None));
    };
    let ridges = run_stage(watch, Stage::Edges, || Ridges::of(raster, kind, params));
    let Some(ridges) = ridges else {
        watch(Event::Skip(Stage::Regions, "there are no contours"));
        return Edges::none(raster.size());
    };
    let grouped = run_stage(watch, Stage::Regions, || ridges.grouped(detail));
    run_stage(watch, Stage::Edges, || ridges.contours(grouped))
}

/// The contours of a picture; none where the page needs none.
pub(super) fn find_edges(
    picture: &decode::Decoded,
    content: &Content,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Edges {
    let reason = if !plan.profile().figure.lines && layout.overview.is_none() {
        "neither the figure nor an overview has lines"
    } else if content.is_uniform() {
        ONE_COLOUR
    } else {
        let px_per_mm = PageTransform::new(picture.raster.size(), layout.figure).px_per_mm();
        let params = plan.edges(px_per_mm);
        if let Some(drawing) = &picture.drawing {
            watch(Event::Skip(Stage::Regions, OF_DRAWING));
            return run_stage(watch, Stage::Edges, || {
                edges::find_in_vector_with_signs(&picture.raster, drawing, &params, px_per_mm)
            });
        }
        if let Some(kind) = content.kind().filter(|kind| kind.is_drawing) {
            watch(Event::Skip(Stage::Regions, OF_DRAWING));
            return run_stage(watch, Stage::Edges, || {
                edges::find_with_signs(&picture.raster, kind, &params, px_per_mm)
            });
        }
        return edges_of(picture, content, &params, plan.region_detail(), watch);
    };
    skip_edges(reason, watch);
    Edges::none(picture.raster.size())
}

/// Tells that no contours are looked for, and so no regions either.
pub(super) fn skip_edges(reason: &'static str, watch: &mut Watch<'_>) {
    for stage in [Stage::Edges, Stage::Regions] {
        watch(Event::Skip(stage, reason));
    }
}
