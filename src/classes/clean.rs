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
mod tests {
    use super::*;
    use crate::classes::class::Params;
    use crate::raster::Planes;

    /// Classes by their first letters; `g` is a green that is nearly blue.
    fn read(map: &str) -> (Vec<ComponentLabel>, Vec<Membership>, BlurCells) {
        let rows: Vec<&str> = map.split_whitespace().collect();
        let size = Size::new(rows[0].len() as u32, rows.len() as u32);
        let rgb = |c| match c {
            'B' => [0.1, 0.2, 0.9],
            'G' => [0.1, 0.8, 0.2],
            'g' => [0.1, 0.8, 0.69],
            'R' => [0.9, 0.1, 0.1],
            _ => [1.0; 3],
        };
        let colours: Vec<[f32; 3]> = rows.iter().flat_map(|row| row.chars().map(rgb)).collect();
        let memberships: Vec<Membership> = colours.iter().map(|rgb| hue::membership(*rgb, &Params::TEST)).collect();
        let planes = Planes::Colour([0, 1, 2].map(|channel| colours.iter().map(|rgb| rgb[channel]).collect()));
        let grid = BlurCells { size, planes, weight: vec![1.0; size.len()], conductance: Conductance::open(size) };
        (memberships.iter().map(Membership::label).collect(), memberships, grid)
    }

    fn written(labels: &[ComponentLabel], size: Size) -> String {
        let letter = |label: &ComponentLabel| {
            label.map_or('.', |class| class.name().to_uppercase().chars().next().unwrap_or('?'))
        };
        let rows: Vec<String> =
            labels.chunks(size.width as usize).map(|row| row.iter().map(letter).collect()).collect();
        rows.join(" ")
    }

    #[track_caller]
    fn small(before: &str, min_cells: f32, after: &str) {
        let (labels, memberships, grid) = read(before);
        assert_eq!(written(&join_small(labels, &memberships, &grid, min_cells), grid.size), after);
    }

    #[test]
    fn a_small_area_joins_the_neighbour_around_it() {
        small("BBBBBB BBRRBB BBRRBB BBBB.. ......", 5.0, "BBBBBB BBBBBB BBBBBB BBBB.. ......");
    }

    #[test]
    fn a_small_area_joins_the_neighbour_that_it_resembles() {
        // One cell less of border with blue, but nearly blue itself.
        small("RRRRRR RRggRR BBggBB BBBBBB", 5.0, "RRRRRR RRBBRR BBBBBB BBBBBB");
        small("RRRRRR RRRRRR RRGGRR BBBBBB", 5.0, "RRRRRR RRRRRR RRRRRR BBBBBB");
    }

    #[test]
    fn one_area_stays_however_small() {
        small("GG GG", 100.0, "GG GG");
    }

    #[test]
    fn an_undecided_area_joins_a_larger_neighbour_unless_a_contour_lies_between() {
        let map = "BBBBBB BBBBBB gggBBB gggBBB";
        let (labels, memberships, grid) = read(map);
        assert_eq!(written(&labels, grid.size), "BBBBBB BBBBBB GGGBBB GGGBBB");
        let calm = join_undecided(labels.clone(), &memberships, &grid, 5.0);
        assert_eq!(written(&calm, grid.size), "BBBBBB BBBBBB BBBBBB BBBBBB");
        let same = |cell: usize, other: usize| labels[cell] == labels[other];
        let parted = BlurCells { conductance: Conductance::between(grid.size, same), ..grid };
        assert_eq!(join_undecided(labels.clone(), &memberships, &parted, 5.0), labels);
    }

    #[test]
    fn regions_are_connected_by_their_sides_and_have_a_colour() {
        let (labels, _, grid) = read("BB.R B..R .BB.");
        let (of_cell, regions) = regions(&labels, &grid);
        let sizes: Vec<u32> = regions.iter().map(|r| r.cells).collect();
        assert_eq!(sizes, [3, 2, 2]);
        assert_eq!(of_cell[3], Some(1));
        assert_eq!(of_cell[2], None);
        // 0.9 and 0.1 of linear light
        assert_eq!(regions[1].colour, [243, 89, 89]);
    }
}
