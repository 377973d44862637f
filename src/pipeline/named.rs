//! What a place on a photograph names. It is looked for in a picture of one size, by the rules of one profile, so
//! that a place names the same thing on all papers and devices.

use super::find_edges::edges_of;
use super::given::Given;
use super::progress::{Stage, Watch, run_stage};
use super::read::{Read, read};
use super::request::Request;
use crate::Error;
use crate::lines::PagePart;
use crate::picture::Picture;
use crate::profile::{Plan, Profile};
use crate::raster::decode::Header;
use crate::regions::{Detail, Mask, Tree};
use crate::units::{PxPoint, Size};

/// The longer side of the picture in which things are looked for, px; a smaller one stays as it is. A picture of 3 to 2
/// then has 194 400 pixels, about as many as the tree of regions has cells at most (`regions::grid`); in a squarer one
/// cells are larger than pixels.
const SIDE: u32 = 540;

/// The things that places on a photograph may name.
pub(super) struct NamedThings {
    tree: Tree,
    size: Size,
    mm_per_px: f32,
    most_salient: Vec<u32>,
}

impl NamedThings {
    /// Those of a picture; none where no subject is asked for, or where outlines are not those of regions.
    ///
    /// # Errors
    /// If the picture cannot be decoded in this size, or the caller has cancelled.
    pub(super) fn of(
        given: &Given,
        picture: Picture<'_>,
        request: &Request<'_>,
        watch: &mut Watch<'_>,
    ) -> Result<Option<Self>, Error> {
        let Some(detail) = request.plan.region_detail() else { return Ok(None) };
        if given.subjects.is_empty() || given.lines.is_some() {
            return Ok(None);
        }
        request.go_on()?;
        run_stage(watch, Stage::Regions, || Self::found(picture, detail, request))
    }

    fn found(picture: Picture<'_>, detail: Detail, request: &Request<'_>) -> Result<Option<Self>, Error> {
        let plan = Plan::new(&Profile::named("swell-a4")?)?;
        let working_size = |Header { size, .. }: Header| {
            let scale = (SIDE as f32 / size.width.max(size.height) as f32).min(1.0);
            let side = |side: u32| ((side as f32 * scale).round() as u32).max(1);
            Ok(Size::new(side(size.width), side(size.height)))
        };
        let Read { picture, content, .. } = read(picture, &request.decoding(&working_size), None, &mut |_| ())?;
        if picture.drawing.is_some() || content.kind().is_none_or(|kind| kind.is_drawing) {
            return Ok(None);
        }
        request.go_on()?;
        let size = picture.raster.size();
        // that side is as long as the widest figure of `swell-a4`
        let mm_per_px = plan.layout().widest_upright() / size.width.max(size.height) as f32;
        let edges = edges_of(&picture, &content, &plan.edges(1.0 / mm_per_px), Some(detail), &mut |_| ());
        Ok(edges.regions.map(|tree| {
            let most_salient = tree.most_salient(mm_per_px, &plan.regions(PagePart::Figure));
            Self { tree, size, mm_per_px, most_salient }
        }))
    }

    /// The thing at a place, in shares of the picture.
    pub(super) fn at(&self, [x, y]: [f32; 2]) -> Option<Mask> {
        let at = PxPoint::new(x * self.size.width as f32, y * self.size.height as f32);
        let region = self.tree.subject_at(at, self.mm_per_px, &self.most_salient)?;
        Some(self.tree.mask(&[region]))
    }
}
