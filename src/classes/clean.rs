//! Regions from labels: smooth boundaries, no component too small to be read, none that differs from its neighbour by a
//! hair.

use super::blur::{BlurCells, Conductance};
use super::class::{Class, Region};
use super::hue::{self, Membership, encoded};
use crate::geom::components::{self, Connectivity, four_neighbours};
use crate::raster::plane::Plane;
use crate::units::Size;

type ComponentLabel = Option<Class>;

/// Weight of a common boundary that a contour runs along, where a component looks for a neighbour to join.
const BLOCKED_WEIGHT: f32 = 0.5;
/// Weight of a neighbour whose colour is wholly different, beside 1 for the very same.
const UNLIKE_WEIGHT: f32 = 0.25;

/// A component of the least readable size is undecided if its membership in the neighbour's class is at least this. One
/// half would be the neighbour's own class; 0.3 is 5 degrees of hue, or a saturation of 0.83 of the bound.
const UNDECIDED_FROM: f32 = 0.3;
/// The bound rises to one half at this many times the least readable size: a large area is a colour of its own, however
/// little it differs (the table in `samples/coffee.png`, a little more yellow than the saucer).
const DECIDED_AREA: f32 = 16.0;
/// An undecided component joins a neighbour only if at least this share of their common boundary is without a contour.
const OPEN_SHARE: f32 = 0.6;

/// The class of every cell by the memberships around it, weighted by a Gaussian of `sigma` cells and by the cells'
/// weights, which are low along contours. Boundaries become smooth, what is narrower than about twice `sigma` vanishes
/// (drawn outlines, tongues that have room for single glyphs only), and seams of mixed colour go to one side or the
/// other.
pub(super) fn smooth(memberships: &[Membership], grid: &BlurCells, sigma: f32) -> Vec<ComponentLabel> {
    if sigma <= 0.0 {
        return memberships.iter().map(Membership::label).collect();
    }
    if memberships.iter().all(|membership| *membership == memberships[0]) {
        return vec![memberships[0].label(); memberships.len()];
    }
    let mut planes = vec![grid.weight.clone()];
    for part in 0..Membership::PARTS {
        let weighted =
            memberships.iter().zip(&grid.weight).map(|(membership, weight)| membership.parts()[part] * weight);
        planes.push(weighted.collect());
    }
    Conductance::open(grid.size).diffuse(&mut planes, sigma);
    let mean = |cell: usize| {
        let weight = planes[0][cell];
        Membership::from_parts(std::array::from_fn(|part| planes[part + 1][cell] / weight)).label()
    };
    (0..memberships.len()).map(mean).collect()
}

/// Gives connected components (white ones too) of fewer than `min_cells` cells to the neighbour that suits best, until
/// none is left or all is one. A neighbour suits by a long common boundary, a colour that is nearly its own, and no
/// contour between.
pub(super) fn join_small(
    labels: Vec<ComponentLabel>,
    memberships: &[Membership],
    grid: &BlurCells,
    min_cells: f32,
) -> Vec<ComponentLabel> {
    let small = |area: &[usize]| (area.len() as f32) < min_cells;
    join(labels, grid.size, small, |area, label, border| {
        let membership = mean_membership(area, memberships, grid);
        let open = border.iter().filter(|&&(cell, other)| grid.conductance.is_open(cell, other)).count() as f32;
        let length = open + BLOCKED_WEIGHT * (border.len() as f32 - open);
        Some(length * (UNLIKE_WEIGHT + (1.0 - UNLIKE_WEIGHT) * membership.share(label)))
    })
}

/// Gives components that are nearly of a larger neighbour's class, and not separated from it by a contour, to that
/// neighbour: a sky that passes from blue to grey, or alternates between them in haze, keeps to one class as long as it
/// is not clearly another.
pub(super) fn join_undecided(
    labels: Vec<ComponentLabel>,
    memberships: &[Membership],
    grid: &BlurCells,
    min_cells: f32,
) -> Vec<ComponentLabel> {
    join(
        labels,
        grid.size,
        |area| (area.len() as f32) < DECIDED_AREA * min_cells,
        |area, label, border| {
            let share = mean_membership(area, memberships, grid).share(label);
            let open = border.iter().filter(|&&(cell, other)| grid.conductance.is_open(cell, other)).count();
            let is_open = open as f32 >= OPEN_SHARE * border.len() as f32;
            let decided = (area.len() as f32 / min_cells).ln() / DECIDED_AREA.ln();
            let asked = UNDECIDED_FROM + (0.5 - UNDECIDED_FROM) * decided.clamp(0.0, 1.0);
            (is_open && share >= asked).then_some(share * border.len() as f32)
        },
    )
}

/// The mean membership of some cells; those beside contours hardly count.
fn mean_membership(cells: &[usize], memberships: &[Membership], grid: &BlurCells) -> Membership {
    let mut sum = [0.0_f64; Membership::PARTS];
    let mut total = 0.0;
    for &cell in cells {
        let weight = f64::from(grid.weight[cell]);
        total += weight;
        sum.iter_mut().zip(memberships[cell].parts()).for_each(|(sum, part)| *sum += weight * f64::from(part));
    }
    Membership::from_parts(sum.map(|sum| (sum / total) as f32))
}

/// Lets components join neighbours until none wants to. `wants` decides which components look for a neighbour. `suits`
/// gets a component's cells, the label of a neighbour and their common boundary (own cell, other cell), and scores that
/// neighbour, if it may be joined at all.
///
/// All components of a round decide at once, and each only for a neighbour that is larger (or, at equal size, comes
/// later in the order of labels). So two never swap labels, the loop ends, and no direction of the picture is special.
pub(super) fn join<L: Copy + Ord>(
    mut labels: Vec<L>,
    size: Size,
    wants: impl Fn(&[usize]) -> bool,
    suits: impl Fn(&[usize], L, &[(usize, usize)]) -> Option<f32>,
) -> Vec<L> {
    loop {
        let areas = components::of_labels(&labels, size, Connectivity::Four);
        let weight = |area: usize| (areas[area].len(), labels[areas[area][0]]);
        let choice = |number: usize| {
            let beside = |&cell: &usize| four_neighbours(cell, size).map(move |other| (cell, other));
            let mut border: Vec<(usize, usize)> = areas[number].iter().flat_map(beside).collect();
            border.retain(|&(_, other)| weight(areas.of(other)) > weight(number));
            border.sort_unstable_by_key(|&(cell, other)| (areas.of(other), cell, other));
            let by_neighbour = border.chunk_by(|a, b| areas.of(a.1) == areas.of(b.1));
            let scored = by_neighbour.filter_map(|run| {
                let neighbour = areas.of(run[0].1);
                let label = labels[areas[neighbour][0]];
                // In whole thousandths, so that what the order of summing changes seldom decides.
                let score = (1000.0 * suits(&areas[number], label, run)?).round() as i64;
                Some((score, weight(neighbour), label))
            });
            scored.max_by_key(|&(score, weight, _)| (score, weight)).map(|(_, _, label)| (number, label))
        };
        let looking = (0..areas.len()).filter(|&number| wants(&areas[number]));
        let joined: Vec<(usize, L)> = looking.filter_map(choice).collect();
        if joined.is_empty() {
            return labels;
        }
        for (number, label) in joined {
            areas[number].iter().for_each(|&cell| labels[cell] = label);
        }
    }
}

/// The connected components that have a texture, and which of them each cell belongs to.
pub(super) fn regions(labels: &[ComponentLabel], grid: &BlurCells) -> (Vec<Option<u32>>, Vec<Region>) {
    let mut of_cell = vec![None; labels.len()];
    let mut regions = Vec::new();
    for area in components::of_labels(labels, grid.size, Connectivity::Four).iter() {
        if let Some(class) = labels[area[0]] {
            for &cell in area {
                of_cell[cell] = Some(regions.len() as u32);
            }
            regions.push(Region { class, colour: mean_colour(area, grid), cells: area.len() as u32 });
        }
    }
    (of_cell, regions)
}

fn mean_colour(cells: &[usize], grid: &BlurCells) -> [u8; 3] {
    let total: f64 = cells.iter().map(|&cell| f64::from(grid.weight[cell])).sum();
    let mean = |plane: &Vec<f32>| {
        let sum: f64 = cells.iter().map(|&cell| f64::from(grid.weight[cell] * plane[cell])).sum();
        (255.0 * encoded((sum / total) as f32)).round() as u8
    };
    grid.planes.as_ref().map(mean).as_colour()
}

/// Lightness for the boldness of glyphs. Cells beside contours show the contour's own ink or a mixture, so they take
/// theirs from their region.
pub(super) fn lightness(colours: &[[f32; 3]], region: &[Option<u32>], grid: &BlurCells) -> Plane {
    let size = grid.size;
    let own: Vec<f32> = colours.iter().map(|rgb| hue::lightness(*rgb)).collect();
    if grid.weight.iter().all(|weight| *weight >= 1.0) {
        return Plane { size, values: own };
    }
    let weighted = own.iter().zip(&grid.weight).map(|(value, weight)| value * weight).collect();
    let mut planes = [weighted, grid.weight.clone()];
    Conductance::between(size, |cell, other| region[cell] == region[other]).diffuse(&mut planes, 1.0);
    let [sum, total] = planes;
    let fill = |cell: usize| {
        let weight = grid.weight[cell];
        weight * own[cell] + (1.0 - weight) * (sum[cell] / total[cell]).clamp(0.0, 1.0)
    };
    Plane { size, values: (0..size.len()).map(fill).collect() }
}

/// For every cell of a region the neighbouring class that the colours around it, within the region, tend to.
pub(super) fn fringe(
    colours: &[[f32; 3]],
    region: &[Option<u32>],
    regions: &[Region],
    size: Size,
    sigma: f32,
    min_cells: f32,
) -> Vec<ComponentLabel> {
    let class = |cell: usize| region[cell].map(|number| regions[number as usize].class);
    let leans: Vec<ComponentLabel> =
        (0..size.len()).map(|cell| class(cell).and_then(|class| hue::leaning(colours[cell], class))).collect();
    let within = Conductance::between(size, |cell, other| region[cell] == region[other]);
    let share_of = |class: ComponentLabel| {
        let mut planes = [leans.iter().map(|lean| f32::from(u8::from(*lean == class))).collect::<Vec<f32>>()];
        within.diffuse(&mut planes, sigma);
        let [plane] = planes;
        plane
    };
    let present: Vec<Class> = Class::ALL.into_iter().filter(|class| leans.contains(&Some(*class))).collect();
    let shares: Vec<(Class, Vec<f32>)> = present.into_iter().map(|class| (class, share_of(Some(class)))).collect();
    let smoothed = |cell: usize| {
        let leaning = shares.iter().find(|(_, share)| share[cell] > 0.5).map(|(class, _)| *class);
        (region[cell], leaning)
    };
    let labels = (0..size.len()).map(smoothed).collect();
    let small = |area: &[usize]| (area.len() as f32) < min_cells;
    let joined =
        join(labels, size, small, |area, (other, _), border| (region[area[0]] == other).then_some(border.len() as f32));
    joined.into_iter().map(|(_, leaning)| leaning).collect()
}

#[cfg(test)]
mod tests;
