//! The areas of a figure by the colours of the picture, or as a person gave them, and which of them have no texture.

use super::bars::Chart;
use super::decisions::Decisions;
use super::given::{Given, blank, blank_cells};
use super::progress::{Event, Stage, Watch, run_stage};
use super::series::{self, ColouredBar};
use super::small_areas;
use super::subject;
use super::textures::{MixedAreas, blank_ground, fit_to_areas};
use crate::classes::{self, Classes};
use crate::edges::Edges;
use crate::geom::components::{Connectivity, of_labels};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::raster::Raster;
use crate::regions::OutlineAreas;
use crate::units::{MmRect, MmVector, PageTransform, Size};
use crate::{About, Note, Reason};

/// What is left without a colour reaches so far beyond its outline, mm: half of a stroke.
const AROUND: f32 = 0.8;

/// The areas of a figure by their colours.
pub(super) struct AreasOfColours {
    pub(super) classes: Classes,
    /// The same with areas that are too small for a texture, where such are told.
    with_small: Option<Classes>,
    /// The bars of a chart, each of one colour.
    pub(super) bars: Vec<ColouredBar>,
    /// Whether the ground has a colour, and no texture.
    pub(super) coloured_ground: bool,
    /// How many areas are told to be too small for a texture.
    pub(super) too_small: usize,
    /// Outlined areas that keep several colours.
    pub(super) mixed: Option<MixedAreas>,
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
        let of = |classes: Classes| {
            let (bars, with_small) = (Vec::new(), None);
            Self { classes, with_small, bars, coloured_ground: false, too_small: 0, mixed: None }
        };
        if let Some(areas) = &given.areas {
            return plan.profile().figure.textures.then(|| of(areas.clone()));
        }
        let are_told = small_areas::are_told(edges, layout);
        if are_told || Chart::of(edges).is_some() {
            let [mut classes, small] = sort_colours(raster, [1.0, small_areas::LEAST], edges, layout, plan, watch)?;
            let bars = series::of(edges, &small, layout.figure);
            series::colour(&mut classes, &small, &bars, layout.figure);
            return Some(Self { with_small: Some(small).filter(|_| are_told), bars, ..of(classes) });
        }
        let [classes] = sort_colours(raster, [1.0], edges, layout, plan, watch)?;
        Some(of(classes))
    }

    /// Leaves some boxes in a figure without a colour.
    pub(super) fn without(&mut self, boxes: &[MmRect], figure: MmRect) {
        let share = |of: &MmRect| {
            let [low, high] = [of.min, of.max].map(|at| (at - figure.min).component_div(figure.size().to_vector()));
            [low.x, low.y, high.x, high.y]
        };
        let boxes: Vec<[f32; 4]> = boxes.iter().map(|of| share(&of.inflate(AROUND, AROUND))).collect();
        std::iter::once(&mut self.classes).chain(&mut self.with_small).for_each(|classes| blank(classes, &boxes));
    }

    /// Takes out what has no texture on a page: crumbs beside outlines, what is erased, the ground, and what lies
    /// around a subject that is to stand out. Tells what of that is not on purpose, and the subjects their colours.
    pub(super) fn fit_to_page(
        &mut self,
        given: &Given,
        decisions: &mut Decisions,
        outlines: Option<&OutlineAreas>,
        picture: Size,
        layout: &Layout,
        plan: &Plan,
    ) -> Vec<Note> {
        let Self { classes, with_small, coloured_ground, too_small, mixed, .. } = self;
        // which areas a person gave have a texture is theirs to say
        let of_picture = given.areas.is_none();
        // what is erased is not there on purpose
        let with_small = with_small.as_ref().filter(|_| decisions.erased.is_empty());
        let told_small = with_small.and_then(|fine| small_areas::told(classes, fine, layout, plan));
        *too_small = told_small.as_ref().map_or(0, |(_, count)| *count);
        let mut notes: Vec<Note> = told_small.into_iter().map(|(note, _)| note).collect();
        let outlines = outlines.filter(|_| of_picture);
        *mixed = outlines.and_then(|areas| fit_to_areas(classes, areas, picture, layout, plan));
        notes.extend(without_remnants(classes, &decisions.erased, layout, plan));
        if of_picture {
            subject::name_colours(&mut decisions.found, classes, picture);
            let ground = blank_ground(classes, plan);
            *coloured_ground = ground.is_some();
            notes.extend(ground);
            decisions.calmed_around.iter().for_each(|subject| subject::blank_around(classes, subject, picture));
        }
        notes
    }
}

/// Leaves what lies in these boxes, in shares of the picture, without a colour, and with it what is left of an area
/// beside them where that is too small for a texture; tells of the latter.
fn without_remnants(classes: &mut Classes, boxes: &[[f32; 4]], layout: &Layout, plan: &Plan) -> Option<Note> {
    let before: Vec<u32> = classes.regions.iter().map(|region| region.cells).collect();
    blank(classes, boxes);
    let is_cut: Vec<bool> = classes.regions.iter().zip(&before).map(|(region, cells)| region.cells < *cells).collect();
    if !is_cut.contains(&true) {
        return None;
    }
    let (least, width) = (plan.profile().colours.min_area, classes.size.width as usize);
    let mm_per_cell = layout.figure.width() / width as f32;
    let parts = of_labels(&classes.region, classes.size, Connectivity::Four);
    let is_small = |part: &[usize]| {
        let is_of_cut = classes.region[part[0]].is_some_and(|region| is_cut[region as usize]);
        is_of_cut && part.len() as f32 * mm_per_cell.powi(2) < least
    };
    let small: Vec<usize> = (0..parts.len()).filter(|&number| is_small(&parts[number])).collect();
    let first = *parts[*small.first()?].first()?;
    blank_cells(classes, |cell, _| small.binary_search(&parts.of(cell)).is_ok());
    let at = layout.figure.min + MmVector::new((first % width) as f32, (first / width) as f32) * mm_per_cell;
    let at = layout.place_in_words(at);
    let (areas, it_is) = match small.len() {
        1 => (format!("the texture of what is left of 1 area (at {at})"), "it is"),
        count => (format!("the textures of what is left of {count} areas (the first at {at})"), "each is"),
    };
    let why = format!("beside what is erased {it_is} smaller than {least} square mm (colours.min_area)");
    Some(Note::NotOnPage(
        About::Areas,
        Reason::AreaCut,
        format!("{areas}, as {why}, the least in which fingers tell a texture").into(),
    ))
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
    Some(run_stage(watch, Stage::Classes, || {
        let contours = if plan.profile().colours.stop_at_lines { edges.borders() } else { Vec::new() };
        let params = plan.classes(px_per_mm);
        classes::sort_for(raster, &contours, &params, shares.map(|share| share * params.min_area))
    }))
}
