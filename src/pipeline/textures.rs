//! From sorted colours to the textures of the figure: which areas have one, and what the maker is told of the others.

use std::collections::{BTreeMap, BTreeSet};

use lyon::geom::euclid::Box2D;

use super::dots;
use super::given::blank_cells;
use super::lines_of_part::LinesOfPart;
use super::progress::{Event, Stage, Watch, run_stage};
use super::small_areas::{BROAD, broadest};
use crate::classes::{self, Class, Classes};
use crate::geom::components::{self, Connectivity};
use crate::geom::{nearest_on_segment, ninths};
use crate::lines::Line;
use crate::listing::list;
use crate::page::layout::Layout;
use crate::page::{Medium, Texture};
use crate::profile::Plan;
use crate::regions::OutlineAreas;
use crate::units::{MmPoint, MmRect, MmVector, PxPoint, Size};
use crate::{About, Note, Reason, Told, textures};

/// Share of the picture's edge that one colour has at least where it is the ground of it. Chosen by us: a table on
/// which things stand has a half or more, the bars of a chart that stand on its edge less than a quarter.
const GROUND: f32 = 1.0 / 3.0;
/// Share of the figure without a texture for want of room from which the maker is told. Less is a few slivers.
const BARE: f32 = 0.03;
/// An area is that much larger or smaller by the rounding of its cells, square mm.
const ROUNDED: f32 = 0.5;

/// An area of which this share is white is felt as blank, with signs here and there: of several colours nobody would
/// speak. Chosen by us: a little less than what a colour needs to hold an area, as white has no signs, and colours have
/// none along lines.
const WHITE: f32 = 0.6;

/// An outlined area has a texture if it has so many signs of it, or more: fewer are felt as dots.
const FELT: usize = 6;

/// An area is outlined if lines run along this share of its border: the edge of the picture is none.
const OUTLINED: f32 = 0.6;

/// Stripes of a photograph's colours narrower than this have no texture of their own, mm. Chosen by us: where rows are
/// sparse, 8 mm apart, one row or none has room in them, and beside one another they tear an area, such as a sail with
/// folds, to pieces of which none can be told.
const NARROWEST: f32 = 8.0;

/// Areas of regions that keep several colours, of which textures may be laid.
pub(super) struct MixedAreas {
    /// The number of the area of each cell.
    area: Vec<usize>,
    /// How many cells there are.
    size: Size,
    /// Those that keep several colours, by their numbers, and the cells of each.
    mixed: BTreeMap<usize, Vec<usize>>,
}

impl MixedAreas {
    /// What the maker is told of those that have several textures on the page, and an outline.
    pub(super) fn told(&self, textures: &[Texture], lines: &[Line], layout: &Layout, plan: &Plan) -> Option<Note> {
        let signs = self.signs(textures, layout.figure);
        let of_figure = LinesOfPart::of(lines, layout.figure, layout, plan);
        let is_outlined = |cells: &[usize]| of_figure.share(self.border(cells, layout.figure).into_iter()) >= OUTLINED;
        let has_several = |number: &usize| signs.get(number).is_some_and(has_several);
        let several = self.mixed.iter().filter(|&(number, _)| has_several(number)).map(|(_, cells)| &cells[..]);
        let told: Vec<&[usize]> = several.filter(|&cells| is_outlined(cells)).collect();
        let mut places: Vec<&str> = told.iter().map(|cells| ninths::NAMES[part_of_area(cells, self.size)]).collect();
        places.sort_by_key(|place| ninths::NAMES.iter().position(|name| name == place));
        places.dedup();
        (!told.is_empty()).then_some(Note::MixedAreas { count: told.len(), places })
    }

    /// How many signs of each colour the areas have by their numbers, in a figure that lies at `place`.
    fn signs(&self, textures: &[Texture], place: MmRect) -> BTreeMap<usize, BTreeMap<Class, usize>> {
        let mut signs = BTreeMap::<usize, BTreeMap<Class, usize>>::new();
        for texture in textures {
            for glyph in &texture.glyphs {
                let [x, y] = cell_at(glyph.at, self.size, place);
                let number = self.area[y * self.size.width as usize + x];
                *signs.entry(number).or_default().entry(texture.class).or_default() += 1;
            }
        }
        signs
    }

    /// The middles of those cells of an area, of all these, that have cells of others beside them.
    fn border(&self, cells: &[usize], place: MmRect) -> Vec<MmPoint> {
        let [width, height] = [self.size.width, self.size.height].map(|side| side as usize);
        let number = cells.first().map(|&cell| self.area[cell]);
        let is_other = |x: usize, y: usize| Some(self.area[y * width + x]) != number;
        let is_border = |&(x, y): &(usize, usize)| {
            x > 0 && is_other(x - 1, y)
                || x + 1 < width && is_other(x + 1, y)
                || y > 0 && is_other(x, y - 1)
                || y + 1 < height && is_other(x, y + 1)
        };
        let mm_per_cell = place.width() / width as f32;
        let cells = cells.iter().map(|cell| (cell % width, cell / width)).filter(is_border);
        cells.map(|(x, y)| place.min + MmVector::new(x as f32 + 0.5, y as f32 + 0.5) * mm_per_cell).collect()
    }
}

/// Whether an area with so many signs of each colour has several textures.
fn has_several(signs: &BTreeMap<Class, usize>) -> bool {
    signs.values().filter(|count| **count >= FELT).count() > 1
}

/// Makes sorted colours agree with the areas that outlines surround. Gives those that keep several.
pub(super) fn fit_to_areas(
    classes: &mut Classes,
    areas: &OutlineAreas,
    picture: Size,
    layout: &Layout,
    plan: &Plan,
) -> Option<MixedAreas> {
    if areas.count() == 0 {
        return None;
    }
    let (width, height) = (classes.size.width, classes.size.height);
    let at = |cell: usize, count: u32, pixels: u32| (cell as f32 + 0.5) / count as f32 * pixels as f32;
    let area = |cell: usize| {
        let (x, y) = (cell % width as usize, cell / width as usize);
        areas.at(PxPoint::new(at(x, width, picture.width), at(y, height, picture.height)))
    };
    let area: Vec<usize> = (0..classes.size.len()).map(area).collect();
    let min_cells = plan.profile().colours.min_area / layout.figure.area() * classes.size.area() as f32;
    let narrowest = NARROWEST / layout.figure.width() * width as f32;
    // a field of pins has no room for several textures in one area: rests of them are felt as scribble
    let one_each = matches!(&layout.medium, Medium::Dots(dots) if !dots.device.takes_paper());
    let mixed = classes::unify_areas(classes, &area, [min_cells, narrowest], one_each);
    let mut mixed = with_cells(mixed, &area);
    mixed.retain(|_, cells| !is_mostly_white(classes, cells));
    (!mixed.is_empty()).then_some(MixedAreas { area, size: classes.size, mixed })
}

/// Some areas by their numbers, and the cells of each in order. `area` has the number of the area of each cell.
fn with_cells(numbers: Vec<usize>, area: &[usize]) -> BTreeMap<usize, Vec<usize>> {
    let mut cells_of: BTreeMap<usize, Vec<usize>> = numbers.into_iter().map(|number| (number, Vec::new())).collect();
    for (cell, number) in area.iter().enumerate() {
        if let Some(cells) = cells_of.get_mut(number) {
            cells.push(cell);
        }
    }
    cells_of
}

/// Whether an area of these cells is felt as blank, with few signs in it.
fn is_mostly_white(classes: &Classes, cells: &[usize]) -> bool {
    cells.iter().filter(|cell| classes.region[**cell].is_none()).count() as f32 >= WHITE * cells.len() as f32
}

/// The part of the figure in which the middle of an area of these cells lies.
fn part_of_area(cells: &[usize], size: Size) -> usize {
    let width = size.width as usize;
    let add = |([x, y], count): ([f32; 2], f32), &cell: &usize| {
        ([x + (cell % width) as f32 + 0.5, y + (cell / width) as f32 + 0.5], count + 1.0)
    };
    let ([x, y], count) = cells.iter().fold(([0.0; 2], 0.0), add);
    let count = f32::max(count, 1.0);
    let whole = Box2D::new(PxPoint::zero(), PxPoint::new(size.width as f32, size.height as f32));
    ninths::ninth(PxPoint::new(x / count, y / count), whole)
}

/// Leaves the ground of a picture without a texture, where the profile wants none there. Tells of it.
///
/// The ground is the colour that most of the picture's edge has, if that is at least a third of the edge; areas of that
/// colour that do not reach the edge keep their texture.
pub(super) fn blank_ground(classes: &mut Classes, plan: &Plan) -> Option<Note> {
    if plan.profile().figure.ground {
        return None;
    }
    let [width, height] = [classes.size.width, classes.size.height].map(|side| side as usize);
    let is_edge = |cell: usize| {
        let (x, y) = (cell % width, cell / width);
        x == 0 || y == 0 || x + 1 == width || y + 1 == height
    };
    let edge: Vec<Option<u32>> = (0..width * height).filter(|&cell| is_edge(cell)).map(|c| classes.region[c]).collect();
    let class_of = |region: u32| classes.regions[region as usize].class;
    let on_edge = |class: Class| edge.iter().flatten().filter(|region| class_of(**region) == class).count();
    // of two with as much the first
    let (ground, cells) = Class::ALL.iter().rev().map(|&class| (class, on_edge(class))).max_by_key(|(_, c)| *c)?;
    if (cells as f32) < GROUND * edge.len() as f32 {
        return None;
    }
    let mut is_ground = vec![false; classes.regions.len()];
    edge.iter().flatten().filter(|region| class_of(**region) == ground).for_each(|r| is_ground[*r as usize] = true);
    let blank = blank_cells(classes, |_, number| is_ground[number as usize]);
    let (colour, percent) = (ground.name(), (100 * blank / classes.region.len().max(1)) as u32);
    let told = format!(
        "the texture of the ground ({colour}, {percent} percent of the figure), so that lines stand out; turn \
         figure.ground on to draw it"
    );
    Some(Note::NotOnPage(About::Areas, Reason::GroundBlank, told.into()))
}

/// What lines divide the regions of a figure into.
struct DividedAreas {
    /// The number of the area of each cell; none on lines, and where there is no texture.
    of_cell: Vec<Option<u32>>,
    /// The region of each.
    region: Vec<u32>,
}

impl DividedAreas {
    /// The areas of `classes`, whose cells cover `place`, between drawn lines.
    fn new(classes: &Classes, lines: &[Line], place: MmRect) -> Self {
        let (size, mm_per_cell) = (classes.size, place.width() / classes.size.width as f32);
        let mut region = classes.region.clone();
        for run in lines.iter().flat_map(|line| &line.runs) {
            // never so thin that an area goes on through it
            let half = 0.5 * run.width.max(2.0 * mm_per_cell);
            for (&a, &b) in run.polyline().segments() {
                let reach = MmVector::new(half, half);
                let [from, to] = [a.min(b) - reach, a.max(b) + reach].map(|at| cell_at(at, size, place));
                for (x, y) in (from[1]..=to[1]).flat_map(|y| (from[0]..=to[0]).map(move |x| (x, y))) {
                    let at = place.min + MmVector::new(x as f32 + 0.5, y as f32 + 0.5) * mm_per_cell;
                    if nearest_on_segment(at, a, b).0 <= half {
                        region[y * size.width as usize + x] = None;
                    }
                }
            }
        }
        let mut areas = Self { of_cell: vec![None; region.len()], region: Vec::new() };
        for component in components::of_labels(&region, size, Connectivity::Four).iter() {
            let Some(of_region) = region[component[0]] else { continue };
            component.iter().for_each(|&cell| areas.of_cell[cell] = Some(areas.region.len() as u32));
            areas.region.push(of_region);
        }
        areas
    }
}

/// Column and row of the cell at a place of the sheet, or of the nearest one.
pub(super) fn cell_at(at: MmPoint, size: Size, place: MmRect) -> [usize; 2] {
    let share = (at - place.min).component_div(place.size().to_vector());
    let index = |share: f32, count: u32| ((share * count as f32).max(0.0) as usize).min(count as usize - 1);
    [index(share.x, size.width), index(share.y, size.height)]
}

/// The cells in the middle of those areas of a drawing that have a colour and no sign of its texture, on paper.
fn bare_areas(classes: &Classes, textures: &[Texture], lines: &[Line], place: MmRect) -> Vec<usize> {
    let areas = DividedAreas::new(classes, lines, place);
    let mm_per_cell = place.width() / classes.size.width as f32;
    let broadest = broadest(&areas.of_cell, areas.region.len(), classes.size, mm_per_cell);
    let (mut has_sign, mut region_has) = (vec![false; areas.region.len()], vec![false; classes.regions.len()]);
    for glyph in textures.iter().flat_map(|texture| &texture.glyphs) {
        let [x, y] = cell_at(glyph.at, classes.size, place);
        if let Some(area) = areas.of_cell[y * classes.size.width as usize + x] {
            has_sign[area as usize] = true;
            region_has[areas.region[area as usize] as usize] = true;
        }
    }
    // of a region without any sign its broadest area stands for it
    let mut bare: Vec<usize> = (0..classes.regions.len())
        .filter(|region| !region_has[*region])
        .filter_map(|region| {
            let own = (0..areas.region.len()).filter(|&area| areas.region[area] as usize == region);
            own.max_by(|&a, &b| broadest[a].0.total_cmp(&broadest[b].0)).filter(|&area| broadest[area].0 >= BROAD)
        })
        .collect();
    let is_bare_part = |&area: &usize| !has_sign[area] && region_has[areas.region[area] as usize];
    bare.extend((0..areas.region.len()).filter(is_bare_part).filter(|&area| broadest[area].0 >= 2.0 * BROAD));
    bare.into_iter().map(|area| broadest[area].1).collect()
}

/// How many areas have a colour and no texture, and where the first is, in words; nothing of none.
fn counted_bare(bare: &[usize], classes: &Classes, layout: &Layout) -> Option<String> {
    let place = layout.figure;
    let width = classes.size.width as usize;
    let first = *bare.first()?;
    let cell = MmVector::new((first % width) as f32, (first / width) as f32);
    let at = place.min + cell * (place.width() / width as f32);
    let at = format!("at {}", layout.place_in_words(at));
    Some(match bare.len() {
        1 => format!("1 area ({at})"),
        count => format!("{count} areas (the first {at})"),
    })
}

/// What the maker is told of those areas on paper.
fn told_bare_areas(classes: &Classes, textures: &[Texture], lines: &[Line], layout: &Layout) -> Option<Note> {
    let bare = bare_areas(classes, textures, lines, layout.figure);
    let areas = counted_bare(&bare, classes, layout)?;
    let (texture, they_are) = if bare.len() == 1 { ("texture", "it is") } else { ("textures", "they are") };
    let why = format!("{they_are} too small or too narrow for the signs of a texture clear of lines");
    let told = Told::from(format!("the {texture} of {areas}, as {why}"));
    let helped = told.or_larger().or_crop().or("say in labels what matters of the colours");
    Some(Note::NotOnPage(About::Areas, Reason::NoRoomForTexture, helped))
}

/// What the maker is told of areas that have a colour and no room for its texture: of a drawing how many and where, as
/// the colours of a photograph change from place to place. Of a page of dots that tells of `unlearned` colours, too.
fn told_bare(
    classes: &Classes,
    textures: &[Texture],
    lines: &[Line],
    layout: &Layout,
    (of_drawing, unlearned): (bool, &BTreeSet<Class>),
    plan: &Plan,
) -> Option<Note> {
    match layout.medium {
        Medium::Print(_) if of_drawing => told_bare_areas(classes, textures, lines, layout),
        Medium::Print(_) => None,
        Medium::Dots(_) => {
            let bare = if of_drawing { bare_areas(classes, textures, lines, layout.figure) } else { Vec::new() };
            told_bare_on_dots(classes, textures, (&bare, unlearned), layout, plan)
        }
    }
}

/// What the maker is told of the areas of a page of dots that have a colour and no texture: as a share of the figure,
/// and of a drawing how many; and of colours that went as they are `unlearned`.
fn told_bare_on_dots(
    classes: &Classes,
    textures: &[Texture],
    (bare, unlearned): (&[usize], &BTreeSet<Class>),
    layout: &Layout,
    plan: &Plan,
) -> Option<Note> {
    let coloured: u32 = classes.regions.iter().map(|region| region.cells).sum();
    let figure = layout.figure.area();
    let drawn: f32 = textures.iter().map(|texture| texture.area).sum::<f32>() / figure;
    let share = coloured as f32 / classes.size.area() as f32 - drawn;
    let (percent, rows) = ((100.0 * share).round(), plan.profile().dots.texture_rows);
    let of_figure = (share >= BARE).then(|| format!("{percent} percent of the figure"));
    let what = match (counted_bare(bare, classes, layout), of_figure) {
        (Some(areas), Some(of_figure)) => format!("{of_figure}, {areas}"),
        (areas, of_figure) => areas.or(of_figure)?,
    };
    let or_unlearned = match unlearned.is_empty() {
        true => String::new(),
        false => format!(", or they are of colours of which {}", why_unlearned(unlearned, plan)),
    };
    let told = format!(
        "the textures of {what}, as there is no room for {rows} rows of dots clear of lines \
         (dots.texture_rows){or_unlearned}"
    );
    let helped = Told::from(told).or_larger().or_crop();
    Some(Note::NotOnPage(About::Areas, Reason::NoRoomForTexture, helped))
}

/// What the maker is told of colours whose textures went as they are unlearned.
fn told_unlearned(colours: &BTreeSet<Class>, plan: &Plan) -> Option<Note> {
    let why = why_unlearned(colours, plan);
    let told =
        format!("the textures of these colours, as {why}; there is room on larger paper, or for a part of the picture");
    (!colours.is_empty()).then_some(Note::NotOnPage(About::Areas, Reason::ColourTooSmall, told.into()))
}

/// Why colours have no texture that are unlearned, with their names.
fn why_unlearned(colours: &BTreeSet<Class>, plan: &Plan) -> String {
    let names: Vec<&str> = colours.iter().map(|class| class.name()).collect();
    let least = plan.profile().colours.min_area;
    format!(
        "none has an area of {least} square mm (colours.min_area), in which fingers learn a texture: {}",
        list(&names, "and")
    )
}

/// Takes the textures that no area of at least `least`, square mm, has, but for the rounding of its cells, out of those
/// of which `counts` is true: fingers learn a texture there, and find it again in smaller areas. Gives the colours that
/// go.
pub(super) fn take_unlearned(
    textures: &mut Vec<Texture>,
    least: f32,
    counts: impl Fn(Class) -> bool,
) -> BTreeSet<Class> {
    let known: BTreeSet<Class> = textures.iter().filter(|of| of.area >= least - ROUNDED).map(|of| of.class).collect();
    textures.extract_if(.., |of| counts(of.class) && !known.contains(&of.class)).map(|of| of.class).collect()
}

/// Takes the textures of colours out that have no area in which fingers learn them. Tells of these, and of areas
/// without a texture.
pub(super) fn without_unlearned(
    textures: &mut Vec<Texture>,
    classes: Option<&Classes>,
    lines: &[Line],
    layout: &Layout,
    of_drawing: bool,
    plan: &Plan,
) -> Option<Note> {
    let mut unlearned = take_unlearned(textures, plan.profile().colours.min_area, |_| true);
    if of_drawing {
        // they are told among those that have no sign
        unlearned.clear();
    }
    let told = |classes| told_bare(classes, textures, lines, layout, (of_drawing, &unlearned), plan);
    classes.and_then(told).or_else(|| told_unlearned(&unlearned, plan))
}

pub(super) fn draw_textures(
    classes: Option<&Classes>,
    layout: &Layout,
    lines: &[Line],
    plan: &Plan,
    watch: &mut Watch<'_>,
) -> Vec<Texture> {
    let reason = match classes {
        None => "figure.textures is off",
        Some(classes) if classes.regions.is_empty() => "the picture is white",
        Some(classes) => {
            return run_stage(watch, Stage::Textures, || match &layout.medium {
                Medium::Print(_) => textures::fill(classes, layout.figure, lines, &plan.textures()),
                Medium::Dots(medium) => dots::textures(classes, layout.figure, lines, medium, plan),
            });
        }
    };
    watch(Event::Skip(Stage::Textures, reason));
    Vec::new()
}

#[cfg(test)]
mod tests;
