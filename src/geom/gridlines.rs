//! Which lines are those of a grid, as behind the bars of a chart or on squared paper: level or upright ones at even
//! distances that end together.

use lyon::geom::euclid::Point2D;

use super::polyline::{Located, PolylineRef};

/// So many lines of one direction are a grid.
const LEAST: usize = 3;
/// How far from level or upright they are, and how far pieces of one of them lie from its place, in the unit of the
/// points: mm or px.
const STRAIGHT: f32 = 0.5;
/// Least straightness of one, chord to length: drawn by hand, too.
const STRAIGHTNESS: f32 = 0.99;
/// How far they lie from even distances, as a share of these: lines keep apart, and on a grid of dots they lie up to
/// half a step beside their places.
const UNEVEN: f32 = 0.25;
/// Ends count as together within this share of the longest line's length: bars hide the ends of some.
const APART: f32 = 0.1;
/// Share of them that end together on one side.
const TOGETHER: f32 = 0.6;

/// A level or upright piece: where it is across, and from where to where along.
#[derive(Debug, Clone, Copy)]
struct Piece {
    at: f32,
    from: f32,
    to: f32,
}

/// The two ends of a line, if it is open and straight enough for one of a grid.
pub fn straight_ends<V: Located>(line: PolylineRef<'_, V>) -> Option<[Point2D<f32, V::Unit>; 2]> {
    let is_straight = !line.closed && line.chord() >= STRAIGHTNESS * line.length();
    let (first, last) = line.vertices.first().zip(line.vertices.last()).filter(|_| is_straight)?;
    Some([first.at(), last.at()])
}

/// Which of some lines are those of a grid; of each that may be one, the two ends.
pub fn which_are_gridlines<U>(ends: &[Option<[Point2D<f32, U>; 2]>]) -> Vec<bool> {
    let mut found = vec![false; ends.len()];
    for is_level in [true, false] {
        let piece = |[a, b]: [Point2D<f32, U>; 2]| {
            let [a, b] = [a, b].map(|at| if is_level { (at.x, at.y) } else { (at.y, at.x) });
            let piece = Piece { at: 0.5 * (a.1 + b.1), from: a.0.min(b.0), to: a.0.max(b.0) };
            ((a.1 - b.1).abs() <= STRAIGHT).then_some(piece)
        };
        let pieces: Vec<Option<Piece>> = ends.iter().map(|ends| ends.and_then(piece)).collect();
        if is_grid(pieces.iter().flatten().copied().collect()) {
            found.iter_mut().zip(&pieces).for_each(|(found, piece)| *found |= piece.is_some());
        }
    }
    found
}

/// Whether pieces of one direction are a grid.
fn is_grid(mut pieces: Vec<Piece>) -> bool {
    pieces.sort_by(|a, b| a.at.total_cmp(&b.at));
    let lines: Vec<Piece> = pieces
        .chunk_by(|a, b| b.at - a.at <= STRAIGHT)
        .map(|of| {
            let (from, to) = of.iter().fold((f32::MAX, f32::MIN), |(from, to), of| (from.min(of.from), to.max(of.to)));
            Piece { at: of[0].at, from, to }
        })
        .collect();
    let distances: Vec<f32> = lines.windows(2).map(|pair| pair[1].at - pair[0].at).collect();
    let step = distances.iter().copied().fold(f32::MAX, f32::min);
    // one may be missing between two, as where the top of a bar is
    let is_even = distances.iter().all(|distance| (distance / step - (distance / step).round()).abs() <= UNEVEN);
    let longest = lines.iter().map(|line| line.to - line.from).fold(0.0, f32::max);
    let end_together = |ends: Vec<f32>| {
        let near = |at: f32| ends.iter().filter(|end| (**end - at).abs() <= APART * longest).count();
        ends.iter().any(|end| near(*end) as f32 >= TOGETHER * ends.len() as f32)
    };
    lines.len() >= LEAST
        && is_even
        && (end_together(lines.iter().map(|line| line.from).collect())
            || end_together(lines.iter().map(|line| line.to).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::MmPoint;

    #[test]
    fn even_lines_that_end_together_are_a_grid_and_walls_are_none() {
        let level = |y: f32, from: f32, to: f32| Some([MmPoint::new(from, y), MmPoint::new(to, y)]);
        let grid = [level(10.0, 0.0, 30.0), level(10.0, 40.0, 90.0), level(20.3, 0.0, 90.0), level(40.0, 12.0, 90.0)];
        assert_eq!(which_are_gridlines(&grid), [true; 4], "in pieces, and one of them is missing");
        let upright = Some([MmPoint::new(5.0, 0.0), MmPoint::new(5.0, 50.0)]);
        assert_eq!(which_are_gridlines(&[grid.as_slice(), &[upright, None]].concat())[4..], [false; 2]);
        assert_eq!(
            which_are_gridlines(&[level(10.0, 0.0, 90.0), level(24.0, 0.0, 90.0), level(29.6, 0.0, 90.0)]),
            [false; 3]
        );
        assert_eq!(
            which_are_gridlines(&[level(10.0, 0.0, 40.0), level(20.0, 50.0, 90.0), level(30.0, 20.0, 70.0)]),
            [false; 3]
        );
        assert_eq!(which_are_gridlines(&grid[2..]), [false; 2]);
    }
}
