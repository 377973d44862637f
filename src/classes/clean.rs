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
/// the smallest first, until none is left or all is one.
pub(super) fn clean(mut labels: Vec<Label>, size: Size, min_cells: f32) -> Vec<Label> {
    // Each round removes at least one area; many rounds only come about by rings inside rings.
    for _ in 0..64 {
        let areas = areas(&labels, size);
        let mut small: Vec<&Vec<usize>> = areas.iter().filter(|area| (area.len() as f32) < min_cells).collect();
        if small.is_empty() || areas.len() == 1 {
            break;
        }
        small.sort_by_key(|area| (area.len(), area[0]));
        // Only the smallest of each round are sure to have neighbours that stay; half of them bound the rounds.
        let take = small.len().div_ceil(2);
        for area in &small[..take] {
            if let Some(label) = strongest_neighbour(area, &labels, size) {
                for &cell in *area {
                    labels[cell] = label;
                }
            }
        }
    }
    labels
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

/// The label with the longest border around an area.
fn strongest_neighbour(area: &[usize], labels: &[Label], size: Size) -> Option<Label> {
    let own = labels[area[0]];
    let mut borders: Vec<(Label, usize)> = Vec::new();
    for &cell in area {
        for label in neighbours(cell, size).map(|neighbour| labels[neighbour]).filter(|label| *label != own) {
            match borders.iter_mut().find(|(known, _)| *known == label) {
                Some((_, length)) => *length += 1,
                None => borders.push((label, 1)),
            }
        }
    }
    borders.into_iter().max_by_key(|(label, length)| (*length, std::cmp::Reverse(*label))).map(|(label, _)| label)
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
