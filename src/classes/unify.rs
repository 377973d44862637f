//! Classes that agree with outlines: an outlined area has one class, but for parts of others with room for a texture,
//! and none ends just beyond an outline.

use std::collections::BTreeMap;

use super::class::{Class, Classes, Region};
use super::clean::join;
use crate::geom::components::{self, Connectivity};
use crate::units::Size;

type AreaClass = Option<Class>;

/// A class holds an outlined area if it has this share of it. Chosen by us: two thirds of an area are what a finger
/// that sweeps over it meets first; below it, as at one half, the other part is as much what is there.
const CLEARLY: f32 = 2.0 / 3.0;

/// Gives the stains in outlined areas to the class that holds the area, and components within an area or between areas
/// to their neighbours on the same side of the outline, the smaller to the larger, so that stripes become one area:
/// those that are smaller than `min_cells` cells or narrower everywhere than `narrowest`. Larger ones keep their class,
/// as the shoulder of a coloured suit behind a black helmet where both are one region, unless `one_each`: then an area
/// that a class holds is of it as a whole. `area` has the number of the
/// area of each cell, 0 for the ground between them, which may have any classes. Returns the numbers of the areas that
/// still have several classes.
pub fn unify_areas(
    classes: &mut Classes,
    area: &[usize],
    [min_cells, narrowest]: [f32; 2],
    one_each: bool,
) -> Vec<usize> {
    let class_of = |region: &Option<u32>| region.map(|region| classes.regions[region as usize].class);
    let before: Vec<AreaClass> = classes.region.iter().map(class_of).collect();
    let size = classes.size;
    let small = |component: &[usize]| (component.len() as f32) < min_cells || is_narrow(component, size, narrowest);
    let own = without_stains(&before, area, size, |component| one_each || small(component));
    let labels = join(own, size, small, |component, (other, _), border| {
        (area[component[0]] == other).then_some(border.len() as f32)
    });
    let labels: Vec<AreaClass> = labels.into_iter().map(|(_, label)| label).collect();
    relabel(classes, &before, &labels);
    let count = area.iter().max().map_or(0, |most| most + 1);
    let mut seen = vec![None::<AreaClass>; count];
    let mut is_mixed = vec![false; count];
    for (&area, &label) in area.iter().zip(&labels).filter(|(area, _)| **area > 0) {
        is_mixed[area] |= *seen[area].get_or_insert(label) != label;
    }
    (0..is_mixed.len()).filter(|&area| is_mixed[area]).collect()
}

/// The area and class of each cell, with the stains of areas that one class holds given to that class: components that
/// are `small`. If all of its own are, as a narrow rim around a part of another class, the whole area is of it, as that
/// part would take in the rim.
fn without_stains(
    before: &[AreaClass],
    area: &[usize],
    size: Size,
    small: impl Fn(&[usize]) -> bool,
) -> Vec<(usize, AreaClass)> {
    let held = holders(before, area);
    let mut labels: Vec<(usize, AreaClass)> = area.iter().copied().zip(before.iter().copied()).collect();
    let parts = components::of_labels(&labels, size, Connectivity::Four);
    let is_large: Vec<bool> = parts.iter().map(|part| held[area[part[0]]].is_some() && !small(part)).collect();
    let mut holder_is_large = vec![false; held.len()];
    for (part, is_large) in parts.iter().zip(&is_large) {
        let number = area[part[0]];
        holder_is_large[number] |= *is_large && held[number] == Some(before[part[0]]);
    }
    for (part, is_large) in parts.iter().zip(&is_large) {
        let number = area[part[0]];
        let Some(holder) = held[number].filter(|_| !(*is_large && holder_is_large[number])) else { continue };
        part.iter().for_each(|&cell| labels[cell].1 = holder);
    }
    labels
}

/// Whether a component has no room for a disc of this width, cells. The edge of the picture narrows nothing.
fn is_narrow(component: &[usize], size: Size, width: f32) -> bool {
    let (across, down) = (size.width as usize, size.height as usize);
    let (Some(&first), Some(&last)) = (component.iter().min(), component.iter().max()) else { return true };
    // of its own rows only: there may be many components
    let before = first - first % across;
    let mut cells = vec![false; last + 1 - before];
    component.iter().for_each(|&cell| cells[cell - before] = true);
    let is_in = |cell: usize| cell.checked_sub(before).and_then(|at| cells.get(at)).is_some_and(|is_in| *is_in);
    // from the middle of a cell to those of the outermost ones
    let radius = (0.5 * (width - 1.0)).max(0.0);
    let has_room = |&cell: &usize| {
        let (x, y) = (cell % across, cell / across);
        let around = |at: usize, reach: f32, end: usize| {
            let reach = reach as usize;
            at.saturating_sub(reach)..(at + reach + 1).min(end)
        };
        around(y, radius, down).all(|row| {
            let aside = row.abs_diff(y) as f32;
            let half = (radius * radius - aside * aside).max(0.0).sqrt();
            around(x, half, across).all(|column| is_in(row * across + column))
        })
    };
    !component.iter().any(has_room)
}

/// By area the label that holds it clearly, if one does; the ground has none.
fn holders(labels: &[AreaClass], area: &[usize]) -> Vec<Option<AreaClass>> {
    let count = area.iter().max().map_or(0, |most| most + 1);
    let mut cells = vec![BTreeMap::<AreaClass, usize>::new(); count];
    for (label, area) in labels.iter().zip(area) {
        *cells[*area].entry(*label).or_default() += 1;
    }
    let holder = |(number, cells): (usize, BTreeMap<AreaClass, usize>)| {
        let all: usize = cells.values().sum();
        let (label, most) = cells.into_iter().max_by_key(|(_, count)| *count).filter(|_| number > 0)?;
        (most as f32 >= CLEARLY * all as f32).then_some(label)
    };
    cells.into_iter().enumerate().map(holder).collect()
}

/// Makes regions of new labels. Cells that change take the lightness of those around them that do not, so that one
/// texture is as bold all over.
fn relabel(classes: &mut Classes, before: &[AreaClass], labels: &[AreaClass]) {
    let mut of_cell = vec![None; labels.len()];
    let mut regions = Vec::new();
    for component in components::of_labels(labels, classes.size, Connectivity::Four).iter() {
        let label = labels[component[0]];
        let stay = || component.iter().copied().filter(|&cell| before[cell] == label);
        let lightness: f64 = stay().map(|cell| f64::from(classes.lightness.values[cell])).sum();
        let count = stay().count();
        if count > 0 {
            let lightness = (lightness / count as f64) as f32;
            for &cell in component.iter().filter(|&&cell| before[cell] != label) {
                classes.lightness.values[cell] = lightness;
            }
        }
        for &cell in component.iter().filter(|&&cell| before[cell] != label) {
            if let Some(fringe) = classes.fringe.get_mut(cell) {
                *fringe = None;
            }
        }
        let Some(class) = label else { continue };
        // the colour of the region that most of it comes from
        let mut from = BTreeMap::<u32, usize>::new();
        stay().filter_map(|cell| classes.region[cell]).for_each(|region| *from.entry(region).or_default() += 1);
        let most = from.into_iter().max_by_key(|(region, cells)| (*cells, classes.regions[*region as usize].cells));
        // where none of it stays, that of the largest region of its class
        let of_class =
            || classes.regions.iter().filter(|region| region.class == class).max_by_key(|region| region.cells);
        let most = most.map(|(region, _)| &classes.regions[region as usize]).or_else(of_class);
        let colour = most.map_or([128; 3], |region| region.colour);
        component.iter().for_each(|&cell| of_cell[cell] = Some(regions.len() as u32));
        regions.push(Region { class, colour, cells: component.len() as u32 });
    }
    (classes.region, classes.regions) = (of_cell, regions);
}

#[cfg(test)]
mod tests;
