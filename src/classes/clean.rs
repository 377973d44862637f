//! Areas that nobody could read join their neighbours; what is left is numbered.

use super::{Class, Region};
use crate::raster::plane::Plane;
use crate::units::Size;

type Label = Option<Class>;

/// Every cell takes the class that has most cells around it (weighted by a Gaussian of `sigma` cells): borders become
/// smooth, and the thin seams of mixed colour between two areas vanish.
pub(super) fn vote(labels: Vec<Label>, size: Size, sigma: f32) -> Vec<Label> {
    let mut winners = labels.clone();
    let mut most = vec![0.0_f32; labels.len()];
    for candidate in [None].into_iter().chain(Class::ALL.map(Some)) {
        if !labels.contains(&candidate) {
            continue;
        }
        let values = labels.iter().map(|&label| f32::from(u8::from(label == candidate))).collect();
        let votes = Plane { size, values }.blurred(sigma).values;
        for ((winner, most), votes) in winners.iter_mut().zip(&mut most).zip(votes) {
            if votes > *most {
                *most = votes;
                *winner = candidate;
            }
        }
    }
    winners
}

/// Gives connected areas (white ones too) of fewer than `min_cells` cells to the neighbour with the longest common border,
/// until none is left or all is one.
///
/// All areas of a round decide at once, and each only for a neighbour that is larger (or, at equal size, comes later in
/// the order of classes): so two never swap, the least of all always finds one, and no direction of the picture is special.
pub(super) fn clean(mut labels: Vec<Label>, size: Size, min_cells: f32) -> Vec<Label> {
    loop {
        let areas = areas(&labels, size);
        let mut area_of = vec![0; labels.len()];
        for (number, area) in areas.iter().enumerate() {
            area.iter().for_each(|&cell| area_of[cell] = number);
        }
        let weight = |area: usize| (areas[area].len(), labels[areas[area][0]]);
        let joins = |number: usize| {
            let stronger = |area: usize| weight(area) > weight(number);
            longest_border(&areas[number], &area_of, size, stronger, weight)
                .map(|winner| (number, labels[areas[winner][0]]))
        };
        let small = (0..areas.len()).filter(|&number| (areas[number].len() as f32) < min_cells);
        let joined: Vec<(usize, Label)> = small.filter_map(joins).collect();
        if joined.is_empty() {
            return labels;
        }
        for (number, label) in joined {
            areas[number].iter().for_each(|&cell| labels[cell] = label);
        }
    }
}

/// Numbers the areas that have a texture.
pub(super) fn regions(labels: &[Label], size: Size) -> (Vec<Option<u32>>, Vec<Region>) {
    let mut of_cell = vec![None; labels.len()];
    let mut regions = Vec::new();
    for area in areas(labels, size) {
        if let Some(class) = labels[area[0]] {
            for &cell in &area {
                of_cell[cell] = Some(regions.len() as u32);
            }
            regions.push(Region { class, cells: area.len() as u32 });
        }
    }
    (of_cell, regions)
}

/// Connected cells (by their sides) of one label, in reading order of their first cell.
fn areas(labels: &[Label], size: Size) -> Vec<Vec<usize>> {
    let mut seen = vec![false; labels.len()];
    let mut areas = Vec::new();
    for start in 0..labels.len() {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let mut area = vec![start];
        let mut next = 0;
        while next < area.len() {
            for cell in neighbours(area[next], size) {
                if !seen[cell] && labels[cell] == labels[start] {
                    seen[cell] = true;
                    area.push(cell);
                }
            }
            next += 1;
        }
        areas.push(area);
    }
    areas
}

fn neighbours(cell: usize, size: Size) -> impl Iterator<Item = usize> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (x, y) = (cell % width, cell / width);
    let left = (x > 0).then(|| cell - 1);
    let right = (x + 1 < width).then_some(cell + 1);
    let above = (y > 0).then(|| cell - width);
    let below = (y + 1 < height).then_some(cell + width);
    [left, right, above, below].into_iter().flatten()
}

/// Of the areas around `area` that `wanted` lets pass, the one with the longest border to it; of equals the weightiest.
fn longest_border<W: Ord>(
    area: &[usize],
    area_of: &[usize],
    size: Size,
    wanted: impl Fn(usize) -> bool,
    weight: impl Fn(usize) -> W,
) -> Option<usize> {
    let own = area_of[area[0]];
    let mut borders: Vec<usize> = area
        .iter()
        .flat_map(|&cell| neighbours(cell, size))
        .map(|neighbour| area_of[neighbour])
        .filter(|&other| other != own && wanted(other))
        .collect();
    borders.sort_unstable();
    borders.chunk_by(|a, b| a == b).max_by_key(|run| (run.len(), weight(run[0]))).map(|run| run[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(map: &str) -> (Vec<Label>, Size) {
        let rows: Vec<&str> = map.split_whitespace().collect();
        let label = |c| match c {
            'b' => Some(Class::Blue),
            'g' => Some(Class::Green),
            'r' => Some(Class::Red),
            _ => None,
        };
        (
            rows.iter().flat_map(|row| row.chars().map(label)).collect(),
            Size::new(rows[0].len() as u32, rows.len() as u32),
        )
    }

    #[test]
    fn a_small_area_joins_the_neighbour_around_it() {
        let (before, size) = read("bbbbbb bbrrbb bbrrbb bbbb.. ......");
        let (after, _) = read("bbbbbb bbbbbb bbbbbb bbbb.. ......");
        assert_eq!(clean(before, size, 5.0), after);
    }

    #[test]
    fn one_area_stays_however_small() {
        let (before, size) = read("gg gg");
        assert_eq!(clean(before.clone(), size, 100.0), before);
    }

    #[test]
    fn regions_are_connected_by_their_sides() {
        let (labels, size) = read("bb.r b..r .bb.");
        let (of_cell, regions) = regions(&labels, size);
        let sizes: Vec<u32> = regions.iter().map(|r| r.cells).collect();
        assert_eq!(sizes, [3, 2, 2]);
        assert_eq!(of_cell[3], Some(1));
        assert_eq!(of_cell[2], None);
    }
}
