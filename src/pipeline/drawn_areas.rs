//! Areas that a person drew as filled shapes: they get the textures of their colours.

use std::ops::Range;

use super::label::CLEARANCE;
use super::words::blank_to_signs;
use crate::classes::{self, Classes, Region};
use crate::geom::nearest_on_segment;
use crate::page::{BrailleText, DotMedium, Glyph, Line, Medium, Parts, Texture};
use crate::profile::Plan;
use crate::raster::plane::Plane;
use crate::reading::DrawnArea;
use crate::units::{MmPoint, MmRect, MmVector, Size};
use crate::{Note, dots, textures};

/// Side of the cells in which areas are drawn, mm: as small as the blank beside signs.
const CELL: f32 = 0.5;
/// Blank between the signs of a drawn area and those of others, mm: rows of a texture are further apart.
const APART: f32 = 1.0;

/// Most areas that are drawn on a page. Chosen by us: a fingertip's area (13 x 13 mm) fits 300 times on A4; thousands
/// would keep a computer busy for long.
const MOST: usize = 1000;

/// Lays the textures of drawn areas over those that are there, the last on top. Tells how many, and which have none.
pub(super) fn lay(parts: &mut Parts, areas: &[DrawnArea], plan: &Plan) -> Vec<Note> {
    let place = parts.figure.place;
    let size = Size::new(cells_along(place.width()), cells_along(place.height()));
    let cell = place.area() / size.area() as f32;
    let mut lost: Vec<(MmPoint, &str)> = Vec::new();
    let mut drawn = Classes {
        size,
        region: vec![None; size.area() as usize],
        regions: Vec::new(),
        lightness: Plane::filled(size, 0.5),
        fringe: Vec::new(),
    };
    // the middle of each region
    let mut middles: Vec<MmPoint> = Vec::new();
    for (number, area) in areas.iter().enumerate() {
        let at = MmRect::from_points(area.outlines.iter().flatten()).center();
        let rgb = area.colour.map(|channel| f32::from(channel) / 255.0);
        let class = area.class.or_else(|| classes::class_of(rgb, &plan.classes(1.0 / CELL)));
        let inside = if number < MOST { inside(&area.outlines, place, size) } else { Vec::new() };
        let count: usize = inside.iter().map(|(_, columns)| columns.len()).sum();
        let why = match class {
            _ if number >= MOST => Some("more than 1000, the most on a page"),
            None => Some("too light for a colour"),
            _ if count == 0 => Some("outside the figure"),
            _ if count as f32 * cell < plan.profile().colours.min_area => Some("too small for a texture"),
            Some(_) => None,
        };
        if let (Some(class), None) = (class, why) {
            let region = drawn.regions.len() as u32;
            let [low, high] = [rgb.iter().copied().fold(1.0, f32::min), rgb.iter().copied().fold(0.0, f32::max)];
            for at in inside.into_iter().flat_map(|(row, columns)| columns.map(move |x| row * size.width as usize + x))
            {
                if let Some(below) = drawn.region[at].replace(region) {
                    drawn.regions[below as usize].cells -= 1;
                }
                drawn.lightness.values[at] = 0.5 * (low + high);
            }
            drawn.regions.push(Region { class, colour: area.colour, cells: count as u32 });
            middles.push(at);
        }
        lost.extend(why.map(|why| (at, why)));
    }
    if !drawn.regions.is_empty() {
        make_room(&mut parts.figure.textures, &drawn, place);
        let mut textures = fill(&drawn, place, &parts.figure.lines, &parts.medium, plan);
        let boxes: Vec<MmRect> = parts.braille.iter().filter_map(|text| text.dots.bounds()).collect();
        let least = blank_to_signs(&parts.medium);
        textures.iter_mut().for_each(|texture| clear_of_braille(&mut texture.glyphs, least, &boxes, &parts.braille));
        let mut is_laid = vec![false; middles.len()];
        for glyph in textures.iter().flat_map(|texture| &texture.glyphs) {
            if let Some(region) = region_at(&drawn, glyph.at, place) {
                is_laid[region as usize] = true;
            }
        }
        for (region, at) in middles.iter().enumerate().filter(|(region, _)| !is_laid[*region]) {
            let hidden = drawn.regions[region].cells == 0;
            lost.push((*at, if hidden { "under others" } else { "too narrow for a texture" }));
        }
        parts.figure.textures.extend(textures);
        parts.figure.textures.retain(|texture| !texture.glyphs.is_empty());
    }
    let laid = areas.len() - lost.len();
    let areas = |count: usize| if count == 1 { "1 drawn area".to_owned() } else { format!("{count} drawn areas") };
    let told = (laid > 0).then(|| Note::TakenAs(format!("{} filled with the texture of its colour", areas(laid))));
    let gone = lost.first().map(|(at, why)| {
        Note::LeftOut(format!("{} (the first at {:.0}, {:.0} mm), {why}", areas(lost.len()), at.x, at.y))
    });
    told.into_iter().chain(gone).collect()
}

/// Takes out the signs that are nearer than `blank` mm to braille, which lies in these boxes, or to its leader lines.
pub(super) fn clear_of_braille(glyphs: &mut Vec<Glyph>, blank: f32, boxes: &[MmRect], braille: &[BrailleText]) {
    let leaders = || braille.iter().filter_map(|text| text.leader.as_ref()).flat_map(|run| run.points.windows(2));
    let is_clear = |glyph: &Glyph| {
        let least = CLEARANCE + glyph.radius();
        let to_cells = blank + glyph.radius();
        boxes.iter().all(|place| (glyph.at - glyph.at.clamp(place.min, place.max)).length() >= to_cells)
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
        let mut crossings: Vec<f32> = Vec::new();
        for outline in outlines {
            let next = outline.iter().skip(1).chain(outline.first());
            let sides = outline.iter().zip(next).filter(|(a, b)| (a.y > y) != (b.y > y));
            crossings.extend(sides.map(|(a, b)| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)));
        }
        crossings.sort_by(f32::total_cmp);
        let pairs = crossings.chunks_exact(2).map(|pair| (row, column(pair[0])..column(pair[1])));
        found.extend(pairs.filter(|(_, columns)| !columns.is_empty()));
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
fn make_room(textures: &mut [Texture], drawn: &Classes, place: MmRect) {
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
mod tests {
    use super::*;

    #[test]
    fn a_shape_with_a_hole_has_its_cells() {
        let place = MmRect::new(MmPoint::new(10.0, 20.0), MmPoint::new(50.0, 60.0));
        let square = |x: f32, y: f32, side: f32| {
            [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|(a, b)| MmPoint::new(x + a, y + b)).to_vec()
        };
        let size = Size::new(cells_along(40.0), cells_along(40.0));
        let found = inside(&[square(15.0, 25.0, 20.0), square(20.0, 30.0, 5.0)], place, size);
        let cells: usize = found.iter().map(|(_, columns)| columns.len()).sum();
        assert!((cells as f32 * CELL * CELL - (400.0 - 25.0)).abs() < 1e-3);
        let has = |x: f32, y: f32| {
            let [column, row] = [x - place.min.x, y - place.min.y].map(|mm| (mm / CELL) as usize);
            found.iter().any(|(own, columns)| *own == row && columns.contains(&column))
        };
        assert!(has(16.0, 26.0) && !has(22.0, 32.0) && !has(36.0, 26.0));
        assert!(found.iter().all(|(row, _)| (10..50).contains(row)), "no other row is looked at");
        assert!(inside(&[square(100.0, 100.0, 20.0)], place, size).is_empty());
    }
}
