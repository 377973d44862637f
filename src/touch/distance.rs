//! The Euclidean distance transform of a grid of cells, by the lower envelope of parabolas along the columns, then
//! along the rows (P. Felzenszwalb and D. Huttenlocher, Distance transforms of sampled functions, 2012).

use crate::units::Size;

/// Stands for an infinite squared distance: larger than the square of any distance in a grid.
const FAR: f32 = 1e12;

/// The distance of each cell from the nearest marked cell, in cells between their centres; infinite where nothing is
/// marked.
pub fn distances(marked: &[bool], size: Size) -> Vec<f32> {
    let (width, height) = (size.width as usize, size.height as usize);
    let mut squares: Vec<f32> = marked.iter().map(|&here| if here { 0.0 } else { FAR }).collect();
    let mut envelope = Envelope::default();
    let mut column = Vec::with_capacity(height);
    for x in 0..width {
        column.clear();
        column.extend((0..height).map(|y| squares[y * width + x]));
        envelope.of(&column);
        for (y, square) in envelope.squares(height).enumerate() {
            squares[y * width + x] = square;
        }
    }
    for row in squares.chunks_exact_mut(width.max(1)) {
        envelope.of(row);
        let line: Vec<f32> = envelope.squares(row.len()).collect();
        row.copy_from_slice(&line);
    }
    squares.into_iter().map(|square| if square < FAR { square.sqrt() } else { f32::INFINITY }).collect()
}

/// The lowest of the parabolas `height[at] + (x - at)^2`.
#[derive(Default)]
struct Envelope {
    /// Where each parabola stands, its height, and from where on it is the lowest.
    parts: Vec<(f32, f32, f32)>,
}

impl Envelope {
    fn of(&mut self, heights: &[f32]) {
        self.parts.clear();
        for (at, &height) in heights.iter().enumerate() {
            let at = at as f32;
            let mut from = f32::NEG_INFINITY;
            while let Some(&(before, low, since)) = self.parts.last() {
                from = 0.5 * ((height - low) / (at - before) + at + before);
                if from > since {
                    break;
                }
                self.parts.pop();
                from = f32::NEG_INFINITY;
            }
            self.parts.push((at, height, from));
        }
    }

    fn squares(&self, count: usize) -> impl Iterator<Item = f32> {
        let mut part = 0;
        (0..count).map(move |x| {
            let x = x as f32;
            while self.parts.get(part + 1).is_some_and(|next| next.2 <= x) {
                part += 1;
            }
            let (at, height, _) = self.parts[part];
            (height + (x - at) * (x - at)).min(FAR)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_is_the_distance_of_the_nearest(marked in prop::collection::vec(prop::bool::weighted(0.05), 13 * 9)) {
            let size = Size::new(13, 9);
            let place = |i: usize| ((i % 13) as f32, (i / 13) as f32);
            let found = distances(&marked, size);
            for (i, found) in found.iter().enumerate() {
                let (x, y) = place(i);
                let to = |j: usize| (place(j).0 - x).hypot(place(j).1 - y);
                let want = (0..marked.len()).filter(|&j| marked[j]).map(to).fold(f32::INFINITY, f32::min);
                let is_same = (want.is_infinite() && found.is_infinite()) || (want - found).abs() < 1e-3;
                prop_assert!(is_same, "{i}: {found}, not {want}");
            }
        }
    }
}
