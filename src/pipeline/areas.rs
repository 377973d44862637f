//! The areas of a page's textures, from their signs: a page holds no areas, only what is drawn in them.
//!
//! Each cell of a grid belongs to the area of the nearest sign, unless a line lies between the two or it is too far;
//! each area takes its nearest cells until it is as large as the page says. So an area that was moved, cut or deleted
//! is where its signs are.
//!
//! Where an area was moved or copied onto another, signs of both stand among one another, and the nearest ones would
//! tear both to crumbs. There the smaller one is on top, as it would be hidden otherwise, and of two as large the
//! later, as a copy is: it takes its cells first.

use std::collections::BTreeSet;

use crate::classes::{Classes, Region};
use crate::geom::crossing;
use crate::geom::nearby::{Index, Nearby};
use crate::lines::index_of_lines;
use crate::listing::{first_few, list};
use crate::page::{Glyph, Page, Shape, Texture};
use crate::profile::Plan;
use crate::raster::plane::Plane;
use crate::units::{Mm, MmPoint, MmRect, Size};
use crate::{About, Note, Reason};

/// Side of a cell, mm, as that in which colours are sorted.
const CELL: f32 = 1.0;
/// Farthest that a cell lies from a sign of its area, mm: the gap beside the widest line and half of the distance
/// between two rows of the sparsest texture.
const REACH: f32 = 9.0;

/// Signs of two areas nearer than this share of `textures.min_glyph` stand over one another: side by side they are that
/// far apart, but for a rounding. Of an area of few signs that was moved onto another, one or two may be so near.
const OVER: f32 = 0.8;
/// What is left of an area under others, if it is less than this share of it, is a few crumbs beside them.
const CRUMBS: f32 = 0.15;
/// Farthest that the rim of an area lies from its signs where no line is near, mm: half of the distance between two
/// rows of a sparse texture.
const RIM: f32 = 4.0;
/// Most areas that are named.
const MOST_NAMED: usize = 5;

/// Cells of an area, each with its distance from the nearest sign, mm.
type AreaCells = Vec<(f32, usize)>;

/// The areas of a page on a grid over its figure.
pub(super) struct PageAreas {
    /// Them, and which cell is in which.
    pub(super) classes: Classes,
    /// For each the numbers of those on which it lies, with all or a part of it.
    pub(super) lies_on: Vec<Vec<u32>>,
}

/// A grid of cells over a figure.
struct CellsOfFigure {
    size: Size,
    corner: MmPoint,
    step: [f32; 2],
}

impl CellsOfFigure {
    fn of(place: MmRect) -> Self {
        let cells = |side: f32| (side / CELL).round().clamp(1.0, 4000.0) as u32;
        let size = Size::new(cells(place.width()), cells(place.height()));
        let step = [place.width() / size.width as f32, place.height() / size.height as f32];
        Self { size, corner: place.min, step }
    }

    fn middle(&self, cell: usize) -> MmPoint {
        let (x, y) = (cell % self.size.width as usize, cell / self.size.width as usize);
        let Self { corner, step, .. } = self;
        MmPoint::new(corner.x + (x as f32 + 0.5) * step[0], corner.y + (y as f32 + 0.5) * step[1])
    }
}

/// A sign of the area of this number.
#[derive(Clone, Copy)]
struct SignOfArea {
    area: u32,
    glyph: Glyph,
}

/// The areas of a page that was made with `own` on a grid over its figure.
pub(super) fn of_page(page: &Page, own: &Plan) -> PageAreas {
    let place = page.figure.place;
    let grid = CellsOfFigure::of(place);
    let textures = &page.figure.textures;
    let mut signs: Index<SignOfArea, Mm> = Index::new(place, REACH);
    for (area, texture) in (0..).zip(textures) {
        texture.glyphs.iter().for_each(|glyph| signs.put_at(glyph.at, SignOfArea { area, glyph: *glyph }));
    }
    let lies_on = lies_on(textures, &signs, OVER * own.textures().min_glyph);
    let NearCells { mut near, others } = NearCells::of(page, &grid, &signs, &lies_on);
    let size = grid.size;
    let mut region = vec![None; size.len()];
    let mut lightness = Plane::filled(size, 1.0);
    let empty = |texture: &Texture| Region { class: texture.class, colour: texture.colour, cells: 0 };
    let mut regions: Vec<Region> = textures.iter().map(empty).collect();
    for number in from_above(textures) {
        let texture = &textures[number as usize];
        let mut cells = std::mem::take(&mut near[number as usize]);
        cells.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let is_covered = |cell: usize| region[cell].is_some_and(|upper: u32| lies_on[upper as usize].contains(&number));
        let around = cells.iter().map(|(_, cell)| *cell).chain(others[number as usize].iter().copied());
        let covered = around.filter(|cell| is_covered(*cell)).count() as f32;
        cells.retain(|(_, cell)| region[*cell].is_none());
        let all = texture.area / (grid.step[0] * grid.step[1]);
        let wanted = all - covered;
        if covered > 0.0 && wanted < CRUMBS * all {
            continue;
        }
        cells.truncate(wanted.ceil() as usize);
        let light = self::lightness(texture.colour);
        for &(_, cell) in &cells {
            region[cell] = Some(number);
            lightness.values[cell] = light;
        }
        // parts without a sign, behind lines, are of it still
        regions[number as usize].cells = if cells.is_empty() { 0 } else { (wanted.round() as u32).max(1) };
    }
    PageAreas { classes: Classes { size, region, regions, lightness, fringe: Vec::new() }, lies_on }
}

/// Which cells are near to the signs of each area.
struct NearCells {
    /// Those whose nearest sign, of all that are seen from them, is its own, and of the areas on which it lies those
    /// from which one of its signs is seen.
    near: Vec<AreaCells>,
    /// Of an area under others the cells of these that are as near to its own signs as its rim is.
    others: Vec<Vec<usize>>,
}

impl NearCells {
    fn of(page: &Page, grid: &CellsOfFigure, signs: &Index<SignOfArea, Mm>, lies_on: &[Vec<u32>]) -> Self {
        let lines = index_of_lines(&page.figure.lines, page.figure.place, REACH);
        let count = lies_on.len();
        let lies_under = turned(lies_on);
        let mut all = Self { near: vec![Vec::new(); count], others: vec![Vec::new(); count] };
        for cell in 0..grid.size.len() {
            let at = grid.middle(cell);
            let mut found: Vec<(f32, u32, MmPoint)> = Vec::new();
            signs.around(at, at, REACH, |sign| {
                let distance = (sign.glyph.at - at).length();
                if distance <= REACH {
                    found.push((distance, sign.area, sign.glyph.at));
                }
            });
            found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let seen = found.iter().take(MOST_TRIED).find(|(_, _, sign)| !is_between(&lines, at, *sign));
            let Some(&(distance, area, _)) = seen else { continue };
            all.near[area as usize].push((distance, cell));
            let nearest_of = |number: u32| {
                let own = found.iter().filter(|(_, of, _)| *of == number).take(MOST_TRIED);
                own.filter(|(_, _, sign)| !is_between(&lines, at, *sign)).map(|(distance, ..)| *distance).next()
            };
            for &upper in &lies_under[area as usize] {
                all.near[upper as usize].extend(nearest_of(upper).map(|distance| (distance, cell)));
            }
            for &below in &lies_on[area as usize] {
                let is_near = nearest_of(below).is_some_and(|distance| distance <= RIM);
                all.others[below as usize].extend(is_near.then_some(cell));
            }
        }
        all
    }
}

/// For each area the numbers of those that lie on it.
fn turned(lies_on: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let mut lies_under = vec![Vec::new(); lies_on.len()];
    for (upper, below) in (0..).zip(lies_on) {
        below.iter().for_each(|of| lies_under[*of as usize].push(upper));
    }
    lies_under
}

/// The numbers of areas, the uppermost first.
fn from_above(textures: &[Texture]) -> Vec<u32> {
    let mut areas: Vec<(f32, u32)> = textures.iter().map(|texture| texture.area).zip(0..).collect();
    areas.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    areas.into_iter().map(|(_, number)| number).collect()
}

/// For each area the numbers of those on which it lies: its signs stand over theirs, nearer than `least` mm.
fn lies_on(textures: &[Texture], signs: &Index<SignOfArea, Mm>, least: f32) -> Vec<Vec<u32>> {
    let mut height = vec![0_usize; textures.len()];
    for (above, number) in from_above(textures).into_iter().rev().enumerate() {
        height[number as usize] = above;
    }
    let on = |(number, texture): (usize, &Texture)| -> Vec<u32> {
        let mut below: BTreeSet<u32> = BTreeSet::new();
        for glyph in &texture.glyphs {
            signs.around(glyph.at, glyph.at, REACH, |sign| {
                if height[sign.area as usize] < height[number] && stand_over(glyph, &sign.glyph, least) {
                    below.insert(sign.area);
                }
            });
        }
        below.into_iter().collect()
    };
    textures.iter().enumerate().map(on).collect()
}

/// Whether two signs are nearer than those of areas side by side are; dots, which may stand in one grid, overlap.
fn stand_over(a: &Glyph, b: &Glyph, least: f32) -> bool {
    let (between, reach) = ((a.at - b.at).length(), a.radius() + b.radius());
    match (a.shape, b.shape) {
        (Shape::Dot { .. }, Shape::Dot { .. }) => between < reach,
        _ => between < reach + least && (between < least || a.distance_to_glyph(b) < least),
    }
}

/// The numbers of the areas of a page that have signs and no cell.
pub(super) fn lost(page: &Page, areas: &PageAreas) -> Vec<usize> {
    let all = areas.classes.regions.iter().zip(&page.figure.textures).enumerate();
    all.filter(|(_, (area, of))| area.cells == 0 && !of.glyphs.is_empty()).map(|(number, _)| number).collect()
}

/// What is told of areas that are not on the page, by their `names`: they lie under others, or beside the figure.
pub(super) fn told_lost(page: &Page, areas: &PageAreas, names: &[String], lost: &[usize]) -> Vec<Note> {
    let name = |number: &usize| {
        let class = page.figure.textures[*number].class.name();
        names.get(*number).cloned().unwrap_or_else(|| format!("an area of {class}"))
    };
    let over = |number: usize| -> Vec<String> {
        let all = areas.lies_on.iter().enumerate();
        let over = all.filter(|(_, below)| below.iter().any(|below| *below as usize == number));
        over.map(|(over, _)| name(&over)).collect()
    };
    let (beside, covered): (Vec<usize>, Vec<usize>) = lost.iter().partition(|number| over(**number).is_empty());
    let texture = |of: &[usize]| if of.len() == 1 { "texture" } else { "textures" };
    let told_covered = || {
        let under = |number: &usize| format!("{} (under {})", name(number), list(&over(*number), "and"));
        let why = "where two areas lie on one another, the smaller one is on top, and of two as large the copy";
        let told = format!("the {} of {}: {why}", texture(&covered), first_few(&covered, MOST_NAMED, under));
        Note::NotOnPage(About::Areas, Reason::AreaCovered, told.into())
    };
    let told_beside = || {
        let told = format!("the {} of {}, outside the figure", texture(&beside), first_few(&beside, MOST_NAMED, name));
        Note::NotOnPage(About::Areas, Reason::AreaOutside, told.into())
    };
    let covered_told = (!covered.is_empty()).then(told_covered);
    covered_told.into_iter().chain((!beside.is_empty()).then(told_beside)).collect()
}

/// Leaves out the areas without a sign, and their names.
pub(super) fn without_bare(textures: &mut Vec<Texture>, names: &mut Vec<String>) {
    let mut has_signs = textures.iter().map(|texture| !texture.glyphs.is_empty());
    names.retain(|_| has_signs.next().unwrap_or_default());
    textures.retain(|texture| !texture.glyphs.is_empty());
}

/// HSL lightness of a colour.
pub(super) fn lightness(colour: [u8; 3]) -> f32 {
    let channels = colour.map(f32::from);
    let [low, high] = [channels.iter().copied().fold(255.0, f32::min), channels.iter().copied().fold(0.0, f32::max)];
    (low + high) / 510.0
}

/// How many signs are looked at from a cell: behind a line there are others.
const MOST_TRIED: usize = 12;

/// Whether a line lies between two places.
fn is_between(lines: &Nearby, a: MmPoint, b: MmPoint) -> bool {
    let mut between = false;
    lines.around(a.min(b), a.max(b), 0.0, |segment| {
        between = between || crossing((a, b), (segment.a, segment.b)).is_some();
    });
    between
}

#[cfg(test)]
mod tests;
