//! The areas of a page's textures, from their signs: a page holds no areas, only what is drawn in them.
//!
//! Each cell of a grid belongs to the area of the nearest sign, unless a line lies between the two or it is too far;
//! each area takes its nearest cells until it is as large as the page says. So an area that was moved, cut or deleted
//! is where its signs are.

use crate::classes::{Classes, Region};
use crate::geom::crossing;
use crate::geom::nearby::{Index, Nearby};
use crate::page::{Line, Page, Texture};
use crate::raster::plane::Plane;
use crate::units::{Mm, MmPoint, MmRect, Size};

/// Side of a cell, mm, as that in which colours are sorted.
const CELL: f32 = 1.0;
/// Farthest that a cell lies from a sign of its area, mm: the gap beside the widest line and half of the distance
/// between two rows of the sparsest texture.
const REACH: f32 = 9.0;
/// How much larger an area may become than the page says, as a share: cells are coarse.
const LARGER: f32 = 1.02;

/// Cells of an area, each with its distance from the nearest sign, mm.
type AreaCells = Vec<(f32, usize)>;

/// The areas of a page on a grid over its figure.
pub(super) fn of_page(page: &Page) -> Classes {
    let place = page.figure.place;
    let cells = |side: f32| (side / CELL).round().clamp(1.0, 4000.0) as u32;
    let size = Size::new(cells(place.width()), cells(place.height()));
    let step = [place.width() / size.width as f32, place.height() / size.height as f32];
    let middle = |cell: usize| {
        let (x, y) = (cell % size.width as usize, cell / size.width as usize);
        MmPoint::new(place.min.x + (x as f32 + 0.5) * step[0], place.min.y + (y as f32 + 0.5) * step[1])
    };
    let textures = &page.figure.textures;
    let mut signs: Index<(u32, MmPoint), Mm> = Index::new(place, REACH);
    for (region, texture) in (0..).zip(textures) {
        texture.glyphs.iter().for_each(|glyph| signs.put_at(glyph.at, (region, glyph.at)));
    }
    let lines = index_of_lines(&page.figure.lines, page.figure.place, REACH);
    let mut near: Vec<AreaCells> = vec![Vec::new(); textures.len()];
    for cell in 0..size.area() as usize {
        let at = middle(cell);
        let mut found: Vec<(f32, u32, MmPoint)> = Vec::new();
        signs.around(at, at, REACH, |&(region, sign)| {
            let distance = (sign - at).length();
            if distance <= REACH {
                found.push((distance, region, sign));
            }
        });
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let seen = found.iter().take(MOST_TRIED).find(|(_, _, sign)| !is_between(&lines, at, *sign));
        if let Some(&(distance, region, _)) = seen {
            near[region as usize].push((distance, cell));
        }
    }
    let mut region = vec![None; size.area() as usize];
    let mut lightness = Plane::filled(size, 1.0);
    let of_texture = |(number, (texture, mut cells)): (u32, (&Texture, AreaCells))| {
        cells.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let wanted = texture.area / (step[0] * step[1]);
        cells.truncate((LARGER * wanted).ceil() as usize);
        let light = self::lightness(texture.colour);
        for &(_, cell) in &cells {
            region[cell] = Some(number);
            lightness.values[cell] = light;
        }
        // parts without a sign, behind lines, are of it still
        let count = cells.len() as u32;
        let cells = if count > 0 { count.max(wanted.round() as u32) } else { 0 };
        Region { class: texture.class, colour: texture.colour, cells }
    };
    let regions = (0..).zip(textures.iter().zip(near)).map(of_texture).collect();
    Classes { size, region, regions, lightness, fringe: Vec::new() }
}

/// HSL lightness of a colour.
pub(super) fn lightness(colour: [u8; 3]) -> f32 {
    let channels = colour.map(f32::from);
    let [low, high] = [channels.iter().copied().fold(255.0, f32::min), channels.iter().copied().fold(0.0, f32::max)];
    (low + high) / 510.0
}

/// How many signs are looked at from a cell: behind a line there are others.
const MOST_TRIED: usize = 12;

/// Lines in an area, to be found by their places; mostly within `reach`, mm.
pub(super) fn index_of_lines(lines: &[Line], area: MmRect, reach: f32) -> Nearby {
    let mut index = Nearby::new(area, reach);
    for (line, run) in (0..).zip(lines.iter().flat_map(|line| &line.runs)) {
        index.insert_line(line, run.polyline(), 0.5 * run.width);
    }
    index
}

/// Whether a line lies between two places.
fn is_between(lines: &Nearby, a: MmPoint, b: MmPoint) -> bool {
    let mut between = false;
    lines.around(a.min(b), a.max(b), 0.0, |segment| {
        between = between || crossing((a, b), (segment.a, segment.b)).is_some();
    });
    between
}
