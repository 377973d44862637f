//! The exact Euclidean distance transform of a grid of cells: along the columns, then by the lower envelope of
//! parabolas along the rows (P. Felzenszwalb and D. Huttenlocher, Distance transforms of sampled functions, 2012).

use crate::units::Size;

/// Stands for the squared distance of cells that are nowhere.
pub const FAR: u32 = u32::MAX;

/// For every cell the distance of the nearest that `is_set`, in cells between their centres; infinite if none is set.
pub fn distances(is_set: &[bool], size: Size) -> Vec<f32> {
    let root = |square: u32| if square == FAR { f32::INFINITY } else { (square as f32).sqrt() };
    squared_distances(is_set, size).into_iter().map(root).collect()
}

/// For every cell the square of the distance of the nearest that `is_set`, in cells between their centres; [`FAR`] if
/// none is set.
pub fn squared_distances(is_set: &[bool], size: Size) -> Vec<u32> {
    let (width, height) = (size.width as usize, size.height as usize);
    if !is_set.contains(&true) {
        return vec![FAR; is_set.len()];
    }
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
            // a column that has a set cell: there is one, or the grid would have none
            let column = lowest[at];
            let (dx, dy) = (column.abs_diff(x) as u32, row[column].abs_diff(y as u32));
            out.push(dx * dx + dy * dy);
        }
    }
    out
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
mod tests;
