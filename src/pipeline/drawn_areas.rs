//! Areas that a person drew as filled shapes: they get the textures of their colours.

use std::ops::Range;

use super::areas::{self, PageAreas, lightness};
use super::label::CLEARANCE;
use super::label_params::blank_to_signs;
use crate::classes::{self, Classes, Region};
use crate::geom::nearest_on_segment;
use crate::geom::polygon::{distance_to_box, row_inside};
use crate::page::{BrailleText, DotMedium, Glyph, Line, Medium, Page, Parts, Texture};
use crate::profile::Plan;
use crate::raster::plane::Plane;
use crate::reading::DrawnArea;
use crate::units::{MmPoint, MmRect, MmVector, Size};
use crate::{About, Note, Reason, dots, textures};

/// Side of the cells in which areas are drawn, mm: as small as the blank beside signs.
const CELL: f32 = 0.5;
/// Blank between the signs of a drawn area and those of others, mm: rows of a texture are further apart.
const APART: f32 = 1.0;

/// Most areas that are drawn on a page. Chosen by us: a fingertip's area (13 x 13 mm) fits 300 times on A4; thousands
/// would keep a computer busy for long.
const MOST: usize = 1000;
const TOO_MANY: Why = (Reason::TooManyAreas, "more than 1000, the most on a page");
const _: () = assert!(MOST == 1000);
const COVERED: Why = (Reason::AreaCovered, "under others");
const TOO_NARROW: Why = (Reason::AreaTooNarrow, "too narrow for a texture");

/// Why an area has no texture, for programs and for the maker.
type Why = (Reason, &'static str);

/// What becomes of drawn areas.
struct DrawnAreas {
    /// Those that have a colour and room, the last on top.
    classes: Classes,
    /// The middle of each of them.
    middles: Vec<MmPoint>,
    /// The others, each with its middle and why.
    lost: Vec<(MmPoint, Why)>,
}

impl DrawnAreas {
    /// Areas on a figure in so many cells.
    fn of(areas: &[DrawnArea], place: MmRect, size: Size, plan: &Plan) -> Self {
        let cell = place.area() / size.area() as f32;
        let classes = Classes {
            size,
            region: vec![None; size.area() as usize],
            regions: Vec::new(),
            lightness: Plane::filled(size, 0.5),
            fringe: Vec::new(),
        };
        let mut drawn = Self { classes, middles: Vec::new(), lost: Vec::new() };
        for (number, area) in areas.iter().enumerate() {
            let at = MmRect::from_points(area.outlines.iter().flatten()).center();
            let rgb = area.colour.map(|channel| f32::from(channel) / 255.0);
            let class = area.class.or_else(|| classes::class_of(rgb, &plan.classes(1.0 / CELL)));
            let inside = if number < MOST { inside(&area.outlines, place, size) } else { Vec::new() };
            let count: usize = inside.iter().map(|(_, columns)| columns.len()).sum();
            let why = match class {
                _ if number >= MOST => Some(TOO_MANY),
                None => Some((Reason::AreaTooLight, "too light for a colour")),
                _ if count == 0 => Some((Reason::AreaOutside, "outside the figure")),
                _ if count as f32 * cell < plan.profile().colours.min_area => {
                    Some((Reason::AreaTooSmall, "too small for a texture"))
                }
                Some(_) => None,
            };
            if let (Some(class), None) = (class, why) {
                drawn.put(Region { class, colour: area.colour, cells: count as u32 }, inside);
                drawn.middles.push(at);
            }
            drawn.lost.extend(why.map(|why| (at, why)));
        }
        drawn
    }

    /// Lays a region over the others.
    fn put(&mut self, area: Region, inside: Vec<(usize, Range<usize>)>) {
        let classes = &mut self.classes;
        let region = classes.regions.len() as u32;
        let light = lightness(area.colour);
        let width = classes.size.width as usize;
        for at in inside.into_iter().flat_map(|(row, columns)| columns.map(move |x| row * width + x)) {
            if let Some(below) = classes.region[at].replace(region) {
                classes.regions[below as usize].cells -= 1;
            }
            classes.lightness.values[at] = light;
        }
        classes.regions.push(area);
    }

    /// What is told of them: how many have got a texture, and which have none.
    fn told(self, areas: usize) -> Vec<Note> {
        let Self { lost, .. } = self;
        let laid = areas - lost.len();
        let areas = |count: usize| if count == 1 { "1 drawn area".to_owned() } else { format!("{count} drawn areas") };
        let with = if laid == 1 { " with" } else { ", each with" };
        let filled = format!("{} filled{with} the texture of its colour", areas(laid));
        let told = (laid > 0).then_some(Note::TakenAs(About::Areas, Reason::AreaFilled, filled.into()));
        let mut reasons: Vec<(Why, MmPoint, usize)> = Vec::new();
        for (at, why) in lost {
            match reasons.iter_mut().find(|(known, ..)| *known == why) {
                Some((.., count)) => *count += 1,
                None => reasons.push((why, at, 1)),
            }
        }
        let gone = reasons.into_iter().map(|((reason, why), at, count)| {
            let told = format!("{} (the first at {:.0}, {:.0} mm), {why}", areas(count), at.x, at.y);
            Note::NotOnPage(About::Areas, reason, told.into())
        });
        told.into_iter().chain(gone).collect()
    }
}

/// Lays the textures of drawn areas over those that are there, which have these `names`, the last on top. Tells how
/// many, and which have none.
pub(super) fn lay(parts: &mut Parts, names: &mut Vec<String>, by_hand: &[DrawnArea], plan: &Plan) -> Vec<Note> {
    let place = parts.figure.place;
    let size = Size::new(cells_along(place.width()), cells_along(place.height()));
    let mut drawn = DrawnAreas::of(by_hand, place, size, plan);
    if !drawn.classes.regions.is_empty() {
        make_room(&mut parts.figure.textures, &drawn.classes, place);
        let mut textures = fill(&drawn.classes, place, &parts.figure.lines, &parts.medium, plan);
        let boxes: Vec<MmRect> = parts.braille.iter().filter_map(|text| text.dots.bounds()).collect();
        let least = blank_to_signs(&parts.medium);
        textures.iter_mut().for_each(|texture| clear_of_braille(&mut texture.glyphs, least, &boxes, &parts.braille));
        let mut is_laid = vec![false; drawn.middles.len()];
        for glyph in textures.iter().flat_map(|texture| &texture.glyphs) {
            if let Some(region) = region_at(&drawn.classes, glyph.at, place) {
                is_laid[region as usize] = true;
            }
        }
        for (region, at) in drawn.middles.iter().enumerate().filter(|(region, _)| !is_laid[*region]) {
            let hidden = drawn.classes.regions[region].cells == 0;
            drawn.lost.push((*at, if hidden { COVERED } else { TOO_NARROW }));
        }
        names.extend(textures.iter().map(|texture| format!("a drawn area of {}", texture.class.name())));
        parts.figure.textures.extend(textures);
        areas::without_bare(&mut parts.figure.textures, names);
    }
    drawn.told(by_hand.len())
}

/// The areas of a page that was read, those of its textures, which have these `names`, and over them those that a
/// person drew; and what is told of them. Signs have no part in these: nothing gives way to lines or braille that the
/// page has.
pub fn areas_of(page: &Page, names: &[String], by_hand: &[DrawnArea], plan: &Plan) -> (Classes, Vec<Note>) {
    let of_page = areas::of_page(page, plan);
    let lost = areas::told_lost(page, &of_page, names, &areas::lost(page, &of_page));
    let PageAreas { classes: mut all, .. } = of_page;
    let mut drawn = DrawnAreas::of(by_hand, page.figure.place, all.size, plan);
    let first = all.regions.len() as u32;
    let Classes { region, regions, lightness, .. } = &drawn.classes;
    for (cell, own) in region.iter().enumerate() {
        let Some(own) = own else { continue };
        if let Some(below) = all.region[cell].replace(first + own) {
            let cells = &mut all.regions[below as usize].cells;
            *cells = cells.saturating_sub(1);
        }
        all.lightness.values[cell] = lightness.values[cell];
    }
    let hidden = regions.iter().zip(&drawn.middles).filter(|(region, _)| region.cells == 0);
    let hidden: Vec<MmPoint> = hidden.map(|(_, at)| *at).collect();
    drawn.lost.extend(hidden.into_iter().map(|at| (at, COVERED)));
    all.regions.extend(regions.iter().cloned());
    (all, lost.into_iter().chain(drawn.told(by_hand.len())).collect())
}

/// Takes out the signs that are nearer than `blank` mm to braille, which lies in these boxes, or to its leader lines.
pub(super) fn clear_of_braille(glyphs: &mut Vec<Glyph>, blank: f32, boxes: &[MmRect], braille: &[BrailleText]) {
    let leaders = || braille.iter().filter_map(|text| text.leader.as_ref()).flat_map(|run| run.points.windows(2));
    let is_clear = |glyph: &Glyph| {
        let least = CLEARANCE + glyph.radius();
        let to_cells = blank + glyph.radius();
        boxes.iter().all(|place| distance_to_box(glyph.at, *place) >= to_cells)
            && leaders().all(|ends| nearest_on_segment(glyph.at, ends[0], ends[1]).0 >= least)
    };
    glyphs.retain(is_clear);
}

/// The signs of one area, as its paper or device takes them.
pub(super) fn fill(classes: &Classes, place: MmRect, lines: &[Line], medium: &Medium, plan: &Plan) -> Vec<Texture> {
    match medium {
        Medium::Print(print) => {
            let mut drawn = textures::fill(classes, place, lines, &plan.textures());
            let glyphs = drawn.iter_mut().flat_map(|texture| &mut texture.glyphs);
            glyphs.for_each(|glyph| glyph.shape = glyph.shape.narrowed(print.swell));
            drawn
        }
        Medium::Dots(medium @ DotMedium { area, .. }) => {
            dots::textures::fill(classes, place, lines, area, &plan.dot_textures(medium))
        }
    }
}

/// How many cells there are along a side.
fn cells_along(side: f32) -> u32 {
    (side / CELL).round().clamp(1.0, 8000.0) as u32
}

/// The cells whose middles lie in an odd number of outlines: their row and columns. Only rows that the shape reaches
/// are looked at.
fn inside(outlines: &[Vec<MmPoint>], place: MmRect, size: Size) -> Vec<(usize, Range<usize>)> {
    let (width, height) = (size.width as f32, size.height as f32);
    let reach = MmRect::from_points(outlines.iter().flatten());
    let row_at = |y: f32| ((y - place.min.y) / place.height() * height).clamp(0.0, height);
    let column = |x: f32| ((x - place.min.x) / place.width() * width - 0.5).ceil().clamp(0.0, width) as usize;
    let mut found = Vec::new();
    for row in row_at(reach.min.y).floor() as usize..row_at(reach.max.y).ceil() as usize {
        let y = place.min.y + (row as f32 + 0.5) / height * place.height();
        let sides = outlines.iter().flat_map(|outline| outline.iter().zip(outline.iter().cycle().skip(1)));
        let parts = row_inside(sides, y).into_iter().map(|[from, to]| (row, column(from)..column(to)));
        found.extend(parts.filter(|(_, columns)| !columns.is_empty()));
    }
    found
}

/// The region at a place of a figure.
fn region_at(drawn: &Classes, at: MmPoint, place: MmRect) -> Option<u32> {
    let share = (at - place.min).component_div(place.size().to_vector());
    if !(0.0..1.0).contains(&share.x) || !(0.0..1.0).contains(&share.y) {
        return None;
    }
    let Size { width, height, .. } = drawn.size;
    let (x, y) = ((share.x * width as f32) as usize, (share.y * height as f32) as usize);
    drawn.region.get(y * width as usize + x).copied().flatten()
}

/// Takes away the signs that lie in drawn areas or too near to them; their areas are smaller then.
pub(super) fn make_room(textures: &mut [Texture], drawn: &Classes, place: MmRect) {
    const AROUND: [(f32, f32); 8] =
        [(1.0, 0.0), (0.7, 0.7), (0.0, 1.0), (-0.7, 0.7), (-1.0, 0.0), (-0.7, -0.7), (0.0, -1.0), (0.7, -0.7)];
    let is_free = |glyph: &Glyph| {
        let reach = glyph.radius() + APART;
        let around = AROUND.iter().map(|(x, y)| glyph.at + MmVector::new(*x, *y) * reach);
        !around.chain([glyph.at]).any(|at| region_at(drawn, at, place).is_some())
    };
    for texture in textures {
        let before = texture.glyphs.len();
        texture.glyphs.retain(is_free);
        texture.area *= texture.glyphs.len() as f32 / before.max(1) as f32;
    }
}

#[cfg(test)]
mod tests;
