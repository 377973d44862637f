//! Calm areas: smooth borders, no area that nobody could read, none that is another colour by a hair only.

use super::blur::{Borders, Cells};
use super::hue::{self, Shade, encoded};
use super::{Class, Region};
use crate::geom::components::{self, four_neighbours};
use crate::raster::plane::Plane;
use crate::units::Size;

type Label = Option<Class>;

/// A border that a contour runs along counts this much less when an area looks for a neighbour to join.
const SHUT_BORDER: f32 = 0.5;
/// What a neighbour of a wholly different colour counts, beside 1 for the very same.
const STRANGER: f32 = 0.25;

/// An area of the least readable size wavers if it is of the neighbour's class to at least this share. One half would be
/// the neighbour's own; 0.3 is 5 degrees of hue, or a saturation of 0.83 of the bound.
const WAVERS_FROM: f32 = 0.3;
/// What is asked for rises to one half at this many times the least readable size: a large area is a colour of its own even
/// if only by a hair (the table in `samples/coffee.png`, a little more yellow than the saucer).
const FIRM_AREAS: f32 = 16.0;
/// It joins the neighbour only if at least this share of their common border is without a contour: one thing, not two.
const OPEN_BORDER: f32 = 0.6;

/// The class of every cell from the shades around it, weighted by a Gaussian of `sigma` cells and by how far the cells lie off
/// contours. Borders become smooth, what is narrower than about twice `sigma` vanishes (drawn outlines, tongues
/// that have room for single glyphs only), and seams of mixed colour go to the one side or the other.
pub(super) fn smooth(shades: &[Shade], grid: &Cells, sigma: f32) -> Vec<Label> {
    if sigma <= 0.0 {
        return shades.iter().map(Shade::label).collect();
    }
    if shades.iter().all(|shade| *shade == shades[0]) {
        return vec![shades[0].label(); shades.len()];
    }
    let mut planes = vec![grid.weight.clone()];
    for part in 0..Shade::PARTS {
        let weighted = shades.iter().zip(&grid.weight).map(|(shade, weight)| shade.parts()[part] * weight);
        planes.push(weighted.collect());
    }
    Borders::open(grid.size).spread(&mut planes, sigma);
    let mean = |cell: usize| {
        let weight = planes[0][cell];
        Shade::from_parts(std::array::from_fn(|part| planes[part + 1][cell] / weight)).label()
    };
    (0..shades.len()).map(mean).collect()
}

/// Gives connected areas (white ones too) of fewer than `min_cells` cells to the neighbour that suits them best, until none
/// is left or all is one. What suits: a long common border, a colour that is nearly the neighbour's own, no contour between.
pub(super) fn join_small(labels: Vec<Label>, shades: &[Shade], grid: &Cells, min_cells: f32) -> Vec<Label> {
    let small = |area: &[usize]| (area.len() as f32) < min_cells;
    join(labels, grid.size, small, |area, label, border| {
        let shade = mean_shade(area, shades, grid);
        let open = border.iter().filter(|&&(cell, other)| grid.borders.is_open(cell, other)).count() as f32;
        let length = open + SHUT_BORDER * (border.len() as f32 - open);
        Some(length * (STRANGER + (1.0 - STRANGER) * shade.share(label)))
    })
}

/// Gives areas that are nearly of a larger neighbour's class, and not parted from it by a contour, to that neighbour: a sky that
/// passes from blue to grey, or flips to and fro in haze, keeps to one class as long as it is not clearly another.
pub(super) fn join_wavering(labels: Vec<Label>, shades: &[Shade], grid: &Cells, min_cells: f32) -> Vec<Label> {
    join(
        labels,
        grid.size,
        |area| (area.len() as f32) < FIRM_AREAS * min_cells,
        |area, label, border| {
            let share = mean_shade(area, shades, grid).share(label);
            let open = border.iter().filter(|&&(cell, other)| grid.borders.is_open(cell, other)).count();
            let one_thing = open as f32 >= OPEN_BORDER * border.len() as f32;
            let firm = (area.len() as f32 / min_cells).ln() / FIRM_AREAS.ln();
            let asked = WAVERS_FROM + (0.5 - WAVERS_FROM) * firm.clamp(0.0, 1.0);
            (one_thing && share >= asked).then_some(share * border.len() as f32)
        },
    )
}

/// The mean shade of some cells; those beside contours hardly count.
fn mean_shade(cells: &[usize], shades: &[Shade], grid: &Cells) -> Shade {
    let mut sum = [0.0_f64; Shade::PARTS];
    let mut total = 0.0;
    for &cell in cells {
        let weight = f64::from(grid.weight[cell]);
        total += weight;
        sum.iter_mut().zip(shades[cell].parts()).for_each(|(sum, part)| *sum += weight * f64::from(part));
    }
    Shade::from_parts(sum.map(|sum| (sum / total) as f32))
}

/// Lets areas join neighbours until none wants to. `wants` says which areas look for a neighbour; `suits` is asked for each
/// neighbour with the area's cells, the neighbour's label and the common border (own cell, other cell), and says how well
/// it suits, if at all.
///
/// All areas of a round decide at once, and each only for a neighbour that is larger (or, at equal size, comes later in
/// the order of labels): so two never swap, it comes to an end, and no direction of the picture is special.
fn join<L: Copy + Ord>(
    mut labels: Vec<L>,
    size: Size,
    wants: impl Fn(&[usize]) -> bool,
    suits: impl Fn(&[usize], L, &[(usize, usize)]) -> Option<f32>,
) -> Vec<L> {
    loop {
        let areas = components::of_labels(&labels, size);
        let mut area_of = vec![0; labels.len()];
        for (number, area) in areas.iter().enumerate() {
            area.iter().for_each(|&cell| area_of[cell] = number);
        }
        let weight = |area: usize| (areas[area].len(), labels[areas[area][0]]);
        let choice = |number: usize| {
            let beside = |&cell: &usize| four_neighbours(cell, size).map(move |other| (cell, other));
            let mut border: Vec<(usize, usize)> = areas[number].iter().flat_map(beside).collect();
            border.retain(|&(_, other)| weight(area_of[other]) > weight(number));
            border.sort_unstable_by_key(|&(cell, other)| (area_of[other], cell, other));
            let by_neighbour = border.chunk_by(|a, b| area_of[a.1] == area_of[b.1]);
            let scored = by_neighbour.filter_map(|run| {
                let neighbour = area_of[run[0].1];
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

/// Numbers the areas that have a texture.
pub(super) fn regions(labels: &[Label], grid: &Cells) -> (Vec<Option<u32>>, Vec<Region>) {
    let mut of_cell = vec![None; labels.len()];
    let mut regions = Vec::new();
    for area in components::of_labels(labels, grid.size) {
        if let Some(class) = labels[area[0]] {
            for &cell in &area {
                of_cell[cell] = Some(regions.len() as u32);
            }
            regions.push(Region { class, colour: mean_colour(&area, grid), cells: area.len() as u32 });
        }
    }
    (of_cell, regions)
}

fn mean_colour(cells: &[usize], grid: &Cells) -> [u8; 3] {
    let total: f64 = cells.iter().map(|&cell| f64::from(grid.weight[cell])).sum();
    let mean = |plane: &Vec<f32>| {
        let sum: f64 = cells.iter().map(|&cell| f64::from(grid.weight[cell] * plane[cell])).sum();
        (255.0 * encoded((sum / total) as f32)).round() as u8
    };
    grid.planes.as_ref().map(mean).as_colour()
}

/// Lightness for the boldness of glyphs: cells beside contours, which show the contour's own ink or a mixture, take it from
/// their region.
pub(super) fn lightness(colours: &[[f32; 3]], region: &[Option<u32>], grid: &Cells) -> Plane {
    let size = grid.size;
    let own: Vec<f32> = colours.iter().map(|rgb| hue::lightness(*rgb)).collect();
    if grid.weight.iter().all(|weight| *weight >= 1.0) {
        return Plane { size, values: own };
    }
    let weighted = own.iter().zip(&grid.weight).map(|(value, weight)| value * weight).collect();
    let mut planes = [weighted, grid.weight.clone()];
    Borders::between(size, |cell, other| region[cell] == region[other]).spread(&mut planes, 1.0);
    let [sum, total] = planes;
    let fill = |cell: usize| {
        let weight = grid.weight[cell];
        weight * own[cell] + (1.0 - weight) * (sum[cell] / total[cell]).clamp(0.0, 1.0)
    };
    Plane { size, values: (0..size.len()).map(fill).collect() }
}

/// For every cell of a region the class that its surroundings within the region lean to.
pub(super) fn fringe(
    colours: &[[f32; 3]],
    region: &[Option<u32>],
    regions: &[Region],
    size: Size,
    sigma: f32,
    min_cells: f32,
) -> Vec<Label> {
    let class = |cell: usize| region[cell].map(|number| regions[number as usize].class);
    let leans: Vec<Label> =
        (0..size.len()).map(|cell| class(cell).and_then(|class| hue::leaning(colours[cell], class))).collect();
    let within = Borders::between(size, |cell, other| region[cell] == region[other]);
    let share_of = |class: Label| {
        let mut planes = [leans.iter().map(|lean| f32::from(u8::from(*lean == class))).collect::<Vec<f32>>()];
        within.spread(&mut planes, sigma);
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
    use crate::classes::Params;
    use crate::raster::Planes;

    /// Classes by their first letters; small letters have a shade half way to the class in capitals, such as `g` for a green
    /// that is nearly blue.
    fn read(map: &str) -> (Vec<Label>, Vec<Shade>, Cells) {
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
        let shades: Vec<Shade> = colours.iter().map(|rgb| hue::shade(*rgb, &Params::TEST)).collect();
        let planes = Planes::Colour([0, 1, 2].map(|channel| colours.iter().map(|rgb| rgb[channel]).collect()));
        let grid = Cells { size, planes, weight: vec![1.0; size.len()], borders: Borders::open(size) };
        (shades.iter().map(Shade::label).collect(), shades, grid)
    }

    fn written(labels: &[Label], size: Size) -> String {
        let letter =
            |label: &Label| label.map_or('.', |class| class.name().to_uppercase().chars().next().unwrap_or('?'));
        let rows: Vec<String> =
            labels.chunks(size.width as usize).map(|row| row.iter().map(letter).collect()).collect();
        rows.join(" ")
    }

    #[track_caller]
    fn small(before: &str, min_cells: f32, after: &str) {
        let (labels, shades, grid) = read(before);
        assert_eq!(written(&join_small(labels, &shades, &grid, min_cells), grid.size), after);
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
    fn a_wavering_area_joins_a_larger_neighbour_unless_a_contour_lies_between() {
        let map = "BBBBBB BBBBBB gggBBB gggBBB";
        let (labels, shades, grid) = read(map);
        assert_eq!(written(&labels, grid.size), "BBBBBB BBBBBB GGGBBB GGGBBB");
        let calm = join_wavering(labels.clone(), &shades, &grid, 5.0);
        assert_eq!(written(&calm, grid.size), "BBBBBB BBBBBB BBBBBB BBBBBB");
        let parted = |cell: usize, other: usize| labels[cell] == labels[other];
        let parted = Cells { borders: Borders::between(grid.size, parted), ..grid };
        assert_eq!(join_wavering(labels.clone(), &shades, &parted, 5.0), labels);
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
