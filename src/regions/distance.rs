//! Distances on the grid of cells: for every cell the nearest of some, exactly (Felzenszwalb and Huttenlocher 2012).

use crate::units::Size;

/// For every cell the nearest of those that `is_set`, and the square of its distance; none if no cell is set.
pub(super) fn nearest(is_set: &[bool], size: Size) -> Option<Vec<(u32, u32)>> {
    let (width, height) = (size.width as usize, size.height as usize);
    let columns = nearest_in_columns(is_set, width, height);
    let mut out = Vec::with_capacity(is_set.len());
    // parabolas of the row's lower envelope: their columns, and from where on each is the lowest
    let (mut lowest, mut from): (Vec<usize>, Vec<f64>) = (Vec::with_capacity(width), Vec::with_capacity(width));
    for (y, row) in columns.chunks_exact(width).enumerate() {
        lowest.clear();
        from.clear();
        let square = |x: usize| (row[x] != NONE).then(|| (row[x].abs_diff(y as u32) as f64).powi(2));
        for x in 0..width {
            let Some(here) = square(x) else { continue };
            let mut start = f64::NEG_INFINITY;
            while let (Some(&before), Some(&began)) = (lowest.last(), from.last()) {
                let there = square(before).unwrap_or(f64::INFINITY);
                let (xf, bf) = (x as f64, before as f64);
                start = ((here + xf * xf) - (there + bf * bf)) / (2.0 * (xf - bf));
                if start > began {
                    break;
                }
                lowest.pop();
                from.pop();
                start = f64::NEG_INFINITY;
            }
            lowest.push(x);
            from.push(start);
        }
        let mut at = 0;
        for x in 0..width {
            while at + 1 < lowest.len() && from[at + 1] < x as f64 {
                at += 1;
            }
            let column = *lowest.get(at)?;
            let (dx, dy) = (column.abs_diff(x) as u32, row[column].abs_diff(y as u32));
            out.push((row[column] * width as u32 + column as u32, dx * dx + dy * dy));
        }
    }
    Some(out)
}

/// No row.
const NONE: u32 = u32::MAX;

/// For every cell the row of the nearest set cell in its column.
fn nearest_in_columns(is_set: &[bool], width: usize, height: usize) -> Vec<u32> {
    let mut rows = vec![NONE; is_set.len()];
    for y in 0..height {
        for x in 0..width {
            let cell = y * width + x;
            rows[cell] = match y {
                _ if is_set[cell] => y as u32,
                0 => NONE,
                _ => rows[cell - width],
            };
        }
    }
    for y in (0..height.saturating_sub(1)).rev() {
        for x in 0..width {
            let (above, below) = (rows[y * width + x], rows[(y + 1) * width + x]);
            let nearer = below != NONE && (above == NONE || below.abs_diff(y as u32) < above.abs_diff(y as u32));
            if nearer {
                rows[y * width + x] = below;
            }
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_a_search_over_all() {
        let size = Size::new(17, 13);
        for seed in 1..20_usize {
            let is_set: Vec<bool> = (0..size.len()).map(|cell| (cell * 7919 + seed * 104_729) % 61 < 2).collect();
            let place = |cell: usize| (cell % 17, cell / 17);
            let square = |a: usize, b: usize| {
                let ((ax, ay), (bx, by)) = (place(a), place(b));
                (ax.abs_diff(bx).pow(2) + ay.abs_diff(by).pow(2)) as u32
            };
            let found = nearest(&is_set, size).expect("some are set");
            for (cell, &(near, distance)) in found.iter().enumerate() {
                let least = (0..size.len()).filter(|&other| is_set[other]).map(|other| square(cell, other)).min();
                assert_eq!(Some(distance), least);
                assert_eq!(square(cell, near as usize), distance);
            }
        }
        assert_eq!(nearest(&vec![false; size.len()], size), None);
    }
}
