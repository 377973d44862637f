//! How much of some lines lies near to others: how much of a drawing's contours is on its page, and how much on the page
//! is no contour of the drawing.

use tactograph::Page;
use tactograph::marks::Run;

/// A point of a line, mm.
pub type Point = [f64; 2];

/// A contour counts as drawn where a line lies this near, mm: half the width of a line, where its ink still covers it.
pub const NEAR_MM: f64 = 0.7;
/// Contours and lines are looked at in steps of this, mm.
const STEP_MM: f64 = 0.2;

/// Shares of one page.
#[derive(Debug, Clone, Copy)]
pub struct Shares {
    /// Of the true contours' length, what has a line within [`NEAR_MM`]; 0..=1.
    pub drawn: f64,
    /// Of the lines' length, what has no true contour within [`NEAR_MM`]; 0..=1, and 0 where there are no lines.
    pub beside: f64,
}

/// Compares polylines on the page with the true ones, all in millimetres of the sheet.
pub fn shares(truth: &[Vec<Point>], lines: &[Vec<Point>]) -> Shares {
    let drawn = share_near(truth, lines).unwrap_or(1.0);
    let beside = share_near(lines, truth).map_or(0.0, |near| 1.0 - near);
    Shares { drawn, beside }
}

/// Share of the length of `these` that lies near to `those`. None if these have no length.
pub fn share_near(these: &[Vec<Point>], those: &[Vec<Point>]) -> Option<f64> {
    share_within(these, those, NEAR_MM)
}

/// Share of the length of `these` that lies within a distance of `those`. None if these have no length.
pub fn share_within(these: &[Vec<Point>], those: &[Vec<Point>], distance_mm: f64) -> Option<f64> {
    let segments: Vec<[Point; 2]> =
        those.iter().flat_map(|line| line.windows(2).map(|pair| [pair[0], pair[1]])).collect();
    let (mut near, mut all) = (0.0, 0.0);
    for pair in these.iter().flat_map(|line| line.windows(2)) {
        let length = distance(pair[0], pair[1]);
        let steps = (length / STEP_MM).ceil().max(1.0);
        for step in 0..steps as usize {
            let share = (step as f64 + 0.5) / steps;
            let at = [0, 1].map(|axis| pair[0][axis] + share * (pair[1][axis] - pair[0][axis]));
            all += length / steps;
            if segments.iter().any(|segment| is_near(at, segment, distance_mm)) {
                near += length / steps;
            }
        }
    }
    (all > 0.0).then(|| near / all)
}

/// The pieces of these lines that lie near to those.
pub fn near(these: &[Vec<Point>], those: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let pieces = these.iter().flat_map(|line| line.windows(2)).map(<[Point]>::to_vec);
    pieces.filter(|piece| share_near(std::slice::from_ref(piece), those).is_some_and(|near| near > 0.5)).collect()
}

fn is_near(at: Point, [a, b]: &[Point; 2], most: f64) -> bool {
    let beyond = |axis: usize| at[axis] < a[axis].min(b[axis]) - most || at[axis] > a[axis].max(b[axis]) + most;
    if beyond(0) || beyond(1) {
        return false;
    }
    let along = [b[0] - a[0], b[1] - a[1]];
    let squared = along[0] * along[0] + along[1] * along[1];
    let share = if squared > 0.0 { ((at[0] - a[0]) * along[0] + (at[1] - a[1]) * along[1]) / squared } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    distance(at, [a[0] + share * along[0], a[1] + share * along[1]]) <= most
}

/// The lines of the figure of a page, mm of the sheet; closed ones come back to where they begin.
pub fn lines_of(page: &Page) -> Vec<Vec<Point>> {
    let run = |run: &Run| -> Vec<Point> {
        let points = run.points.iter().chain(run.points.first().filter(|_| run.closed));
        points.map(|at| [f64::from(at.x), f64::from(at.y)]).collect()
    };
    page.figure.lines.iter().flat_map(|line| line.runs.iter().map(run)).collect()
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_side_is_a_quarter_of_a_square_and_a_stray_line_is_beside() {
        let square = vec![vec![[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0], [0.0, 0.0]]];
        let three_sides = vec![vec![[0.0, 0.3], [39.7, 0.3], [40.0, 40.0], [0.0, 40.0]]];
        let shares_of_three = shares(&square, &three_sides);
        assert!((shares_of_three.drawn - 0.75).abs() < 0.015 && shares_of_three.beside < 1e-9, "{shares_of_three:?}");
        let stray = vec![square[0].clone(), vec![[10.0, 20.0], [26.0, 20.0]]];
        let shares_of_stray = shares(&square, &stray);
        assert!((shares_of_stray.beside - 16.0 / 176.0).abs() < 0.01, "{shares_of_stray:?}");
        assert!((shares_of_stray.drawn - 1.0).abs() < 1e-9);
        assert!(shares(&square, &[]).drawn.abs() < 1e-9 && shares(&square, &[]).beside.abs() < 1e-9);
    }
}
