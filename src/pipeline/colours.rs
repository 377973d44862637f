//! From bytes to sorted colours: as for a page, but no further.

use super::areas_of_colours::sort_colours;
use super::find_edges::find_edges;
use super::progress::Watch;
use super::read::{Read, read};
use super::request::{OverviewSize, Request, working_size};
use crate::Error;
use crate::classes::{self, Classes};
use crate::picture::Picture;
use crate::profile::Plan;
use crate::raster::decode::Header;
use crate::units::MmRect;

/// The colours of a picture, sorted.
#[derive(Debug, Clone)]
pub struct Sorted {
    /// The classes on their grid of cells; `None` if the profile wants no textures.
    pub classes: Option<Classes>,
    /// Where the grid lies on the sheet.
    pub place: MmRect,
}

/// Sorts the colours of a picture as [`super::convert`] does for its textures.
///
/// # Errors
/// As [`super::convert`]; see [`Error`].
pub fn sort(picture: &[u8], request: &Request<'_>, watch: &mut Watch<'_>) -> Result<Sorted, Error> {
    let plan = request.plan;
    let fit = &request.fit;
    let working_size =
        |source: Header| working_size(source, &|size, overview| fit.layout(size, plan, overview), fit, plan);
    let options = request.decoding(&working_size);
    let Read { picture, content, .. } = read(Picture::file(picture), &options, None, watch)?;
    let layout = fit.layout(picture.source.size, plan, OverviewSize::Own)?;
    let edges = find_edges(&picture, &content, &layout, plan, watch);
    let classes = sort_colours(&picture.raster, [1.0], &edges, &layout, plan, watch).map(|[classes]| classes);
    Ok(Sorted { classes, place: layout.figure })
}

/// How a plan sorts single colours, for [`classes::class_of`]; lengths do not matter there.
pub fn params(plan: &Plan) -> classes::Params {
    plan.classes(plan.profile().figure.resolution)
}
