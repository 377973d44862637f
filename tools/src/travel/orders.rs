//! Simple orders of dots to compare with, and measures of an order. Positions are in hundredths of a millimetre.

use tactograph::internals::output::dots::path_order::DotPosition;

/// The path from each dot to the nearest that is left, a common measure of how good an order is. `most_back` as for
/// [`tactograph::internals::output::dots::path_order::order`].
pub fn nearest_neighbour(dots: &[DotPosition], start: DotPosition, most_back: i32) -> Vec<DotPosition> {
    let mut left = sorted(dots);
    let mut path = Vec::with_capacity(left.len());
    let mut here = start;
    while let Some(&[_, highest]) = left.first() {
        let allowed = left.partition_point(|dot| dot[1] <= highest.saturating_add(most_back.max(0)));
        let far = |&at: &usize| distance(here, left[at]);
        let Some(next) = (0..allowed).min_by(|a, b| far(a).total_cmp(&far(b))) else { break };
        here = left.remove(next);
        path.push(here);
    }
    path
}

/// The dots row by row in bands `height` high (at least 1), to and fro.
pub fn row_by_row(dots: &[DotPosition], height: i32) -> Vec<DotPosition> {
    let mut dots = sorted(dots);
    let band = |dot: &DotPosition| dot[1].div_euclid(height.max(1));
    dots.sort_unstable_by_key(|dot| (band(dot), *dot));
    for (number, row) in dots.chunk_by_mut(|a, b| band(a) == band(b)).enumerate() {
        if number % 2 == 1 {
            row.reverse();
        }
    }
    dots
}

/// Length of the path through `dots` from `ends[0]` to `ends[1]`.
pub fn length(dots: &[DotPosition], ends: [DotPosition; 2]) -> f64 {
    let positions = || [ends[0]].into_iter().chain(dots.iter().copied()).chain([ends[1]]);
    positions().zip(positions().skip(1)).map(|(a, b)| distance(a, b)).sum()
}

/// The dots from top to bottom and from left to right, equal ones once.
pub fn sorted(dots: &[DotPosition]) -> Vec<DotPosition> {
    let mut dots = dots.to_vec();
    dots.sort_unstable_by_key(|&[x, y]| (y, x));
    dots.dedup();
    dots
}

/// The Euclidean distance of two positions.
pub fn distance(a: DotPosition, b: DotPosition) -> f64 {
    let (x, y) = (f64::from(a[0]) - f64::from(b[0]), f64::from(a[1]) - f64::from(b[1]));
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Dots of a picture in characters, 1 mm apart; letters give the order.
    fn dots(picture: &str) -> Vec<DotPosition> {
        let rows = picture.split_whitespace().enumerate();
        let cells = rows.flat_map(|(y, row)| row.bytes().enumerate().map(move |(x, letter)| (letter, x, y)));
        let mut dots: Vec<_> = cells.filter(|(letter, ..)| *letter != b'.').collect();
        dots.sort_unstable();
        dots.into_iter().map(|(_, x, y)| [x as i32 * 100, y as i32 * 100]).collect()
    }

    #[test]
    fn rows_go_to_and_fro() {
        // Rows without dots do not count.
        let picture = "a.bc fed. .... g.hi";
        assert_eq!(row_by_row(&dots(picture), 1), dots(picture));
        // Bands of two rows: the first goes right, column by column, the second left.
        let picture = "a.ce .bdf .... ihg.";
        assert_eq!(row_by_row(&dots(picture), 200), dots(picture));
        assert_eq!(row_by_row(&[], 1), [[0; 2]; 0]);
    }

    #[test]
    fn the_nearest_comes_next_unless_it_leaves_another_too_far_behind() {
        for (picture, most_back) in [("a..c b... ....", i32::MAX), ("a..b c... ....", 0)] {
            assert_eq!(nearest_neighbour(&dots(picture), [0, 0], most_back), dots(picture));
        }
    }
}
