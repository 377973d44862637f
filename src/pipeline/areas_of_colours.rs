//! The areas of a figure by the colours of the picture, or as a person gave them, and which of them have no texture.

use super::decisions::Decisions;
use super::given::{Given, blank};
use super::progress::{Event, Stage, Watch, run};
use super::small_areas;
use super::subject;
use super::textures::{blank_ground, fit_to_areas};
use crate::Note;
use crate::classes::{self, Classes};
use crate::edges::Edges;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::raster::Raster;
use crate::regions::OutlineAreas;
use crate::units::{PageTransform, Size};

/// The areas of a figure by their colours.
pub(super) struct AreasOfColours {
    pub(super) classes: Classes,
    /// The same with areas that are too small for a texture, where such are told.
    with_small: Option<Classes>,
}

impl AreasOfColours {
    /// The areas that a person gave, or the colours of the picture.
    pub(super) fn of(
        given: &Given,
        raster: &Raster,
        edges: &Edges,
        layout: &Layout,
        plan: &Plan,
        watch: &mut Watch<'_>,
    ) -> Option<Self> {
        if let Some(areas) = &given.areas {
            return plan.profile().figure.textures.then(|| Self { classes: areas.clone(), with_small: None });
        }
        if small_areas::are_told(edges, layout) {
            let [classes, small] = sort_colours(raster, [1.0, small_areas::LEAST], edges, layout, plan, watch)?;
            return Some(Self { classes, with_small: Some(small) });
        }
        let [classes] = sort_colours(raster, [1.0], edges, layout, plan, watch)?;
        Some(Self { classes, with_small: None })
    }

    /// Takes out what has no texture on a page: crumbs beside outlines, what is erased, the ground, and what lies
    /// around a subject that is to stand out. Tells what of that is not on purpose.
    pub(super) fn fit_to_page(
        &mut self,
        given: &Given,
        decisions: &Decisions,
        outlines: Option<&OutlineAreas>,
        picture: Size,
        (layout, plan): (&Layout, &Plan),
    ) -> Vec<Note> {
        let Self { classes, with_small } = self;
        // which areas a person gave have a texture is theirs to say
        let of_picture = given.areas.is_none();
        // what is erased is not there on purpose
        let with_small = with_small.as_ref().filter(|_| decisions.erased.is_empty());
        let mut notes = Vec::new();
        notes.extend(with_small.and_then(|fine| small_areas::told(classes, fine, layout, plan)));
        let outlines = outlines.filter(|_| of_picture);
        notes.extend(outlines.and_then(|areas| fit_to_areas(classes, areas, picture, layout, plan)));
        blank(classes, &decisions.erased);
        if of_picture {
            notes.extend(blank_ground(classes, plan));
            decisions.calmed_around.iter().for_each(|subject| subject::blank_around(classes, subject, picture));
        }
        notes
    }
}

/// The colours of a picture, sorted for each of these least areas, in shares of that of the profile.
pub(super) fn sort_colours<const N: usize>(
    raster: &Raster,
    shares: [f32; N],
    edges: &Edges,
    layout: &Layout,
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Option<[Classes; N]> {
    if !plan.profile().figure.textures {
        watch(Event::Skip(Stage::Classes, "figure.textures is off"));
        return None;
    }
    if raster.is_grey() {
        watch(Event::Skip(Stage::Hues, "the picture is grey"));
    }
    let px_per_mm = PageTransform::new(raster.size(), layout.figure).px_per_mm();
    Some(run(watch, Stage::Classes, || {
        let contours = if plan.profile().colours.stop_at_lines { edges.borders() } else { Vec::new() };
        let params = plan.classes(px_per_mm);
        classes::sort_for(raster, &contours, &params, shares.map(|share| share * params.min_area))
    }))
}
