//! Coloured areas of a drawing that are too small for a texture: what they mean is not on the page, and not in the key.

use crate::classes::Classes;
use crate::edges::Edges;
use crate::geom::distance::distances;
use crate::page::Medium;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::{MmVector, Size};
use crate::{About, Note, Reason, Told};

/// An area is no stroke if a circle of this radius lies in it, mm: the widest line is half as broad.
pub(super) const BROAD: f32 = 1.5;
/// The smallest area that is told, as a share of the smallest with a texture: what is smaller is a mark.
pub(super) const LEAST: f32 = 0.2;
/// So much of it at least has no texture, or another one, as it was too small.
const MOSTLY: f32 = 0.5;

/// Of each area, of which there are so many, the radius of the largest circle in it, mm, and the cell in its middle.
/// `area` has the number of the area of each cell, if it is in one.
pub(super) fn broadest(area: &[Option<u32>], count: usize, size: Size, mm_per_cell: f32) -> Vec<(f32, usize)> {
    let (width, height) = (size.width as usize, size.height as usize);
    let area_at = |x: usize, y: usize| area[y * width + x];
    let is_border = |cell: usize| {
        let (x, y) = (cell % width, cell / width);
        let inside = x > 0 && y > 0 && x + 1 < width && y + 1 < height;
        let own = area_at(x, y);
        !inside || [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)].iter().any(|&(x, y)| area_at(x, y) != own)
    };
    let borders: Vec<bool> = (0..size.len()).map(is_border).collect();
    let mut broadest = vec![(0.0_f32, 0_usize); count];
    for (cell, depth) in distances(&borders, size).into_iter().enumerate() {
        if let Some(area) = area[cell]
            && (depth + 0.5) * mm_per_cell > broadest[area as usize].0
        {
            broadest[area as usize] = ((depth + 0.5) * mm_per_cell, cell);
        }
    }
    broadest
}

/// Whether areas that are too small are told: those of a drawing, on paper.
pub(super) fn are_told(edges: &Edges, layout: &Layout) -> bool {
    edges.of_drawing() && matches!(layout.medium, Medium::Print(_))
}

/// What the maker is told of areas that are too small for a texture, and how many they are. `classes` are the sorted
/// colours of the picture, `fine` those with areas from [`LEAST`] on.
pub(super) fn told(classes: &Classes, fine: &Classes, layout: &Layout, plan: &Plan) -> Option<(Note, usize)> {
    let least = plan.profile().colours.min_area;
    let lost = lost(classes, fine, layout.figure.width() / fine.size.width as f32, least);
    let (first, cell) = *lost.first()?;
    let mut colours: Vec<&str> = lost.iter().map(|(region, _)| fine.regions[*region].class.name()).collect();
    colours.sort_unstable();
    colours.dedup();
    let width = fine.size.width as usize;
    let mm_per_cell = layout.figure.width() / fine.size.width as f32;
    let at = layout.figure.min + MmVector::new((cell % width) as f32, (cell / width) as f32) * mm_per_cell;
    let at = format!("at {}", layout.place_in_words(at));
    let (areas, they_are) = match lost.len() {
        1 => (format!("the texture of 1 area ({}, {at})", fine.regions[first].class.name()), "it is"),
        count => (format!("the textures of {count} areas ({}; the first {at})", colours.join(", ")), "they are"),
    };
    let least = format!("{least} square mm (colours.min_area)");
    let why = format!("{they_are} smaller than {least}, the least in which fingers tell a texture");
    let say = "say in labels what matters of the colours, as a key names only those that have a texture on the page";
    let helped = Told::from(format!("{areas}, as {why}")).or_larger().or(say);
    Some((Note::NotOnPage(About::Areas, Reason::AreaTooSmall, helped), lost.len()))
}

/// The regions of `fine` that are smaller than `least`, square mm, no strokes, and not in `classes`; each with the cell
/// in its middle.
fn lost(classes: &Classes, fine: &Classes, mm_per_cell: f32, least: f32) -> Vec<(usize, usize)> {
    let class_of =
        |classes: &Classes, cell: usize| classes.region[cell].map(|number| classes.regions[number as usize].class);
    let mut gone = vec![0_u32; fine.regions.len()];
    for cell in 0..fine.region.len() {
        if let Some(region) = fine.region[cell]
            && class_of(classes, cell) != class_of(fine, cell)
        {
            gone[region as usize] += 1;
        }
    }
    let cell_area = mm_per_cell * mm_per_cell;
    let is_lost = |region: usize| {
        let cells = fine.regions[region].cells as f32;
        cells * cell_area < least && gone[region] as f32 >= MOSTLY * cells
    };
    let broad = broadest(&fine.region, fine.regions.len(), fine.size, mm_per_cell).into_iter().enumerate();
    let lost = broad.filter(|(region, (radius, _))| *radius >= 2.0 * BROAD && is_lost(*region));
    lost.map(|(region, (_, cell))| (region, cell)).collect()
}

#[cfg(test)]
mod tests;
