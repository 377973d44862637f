//! Connected components: of any graph, of the cells of a grid, and of points that lie near one another.

use std::collections::BTreeMap;

use lyon::geom::euclid::{Point2D, Vector2D};

use crate::units::Size;

/// The connected components of the nodes below `count` that are `member`s, found breadth first: ordered by their lowest
/// node, which comes first in each. `linked` gives the neighbours of a node; links have to go both ways.
pub fn components<I: Iterator<Item = usize>>(
    count: usize,
    member: impl Fn(usize) -> bool,
    linked: impl Fn(usize) -> I,
) -> Vec<Vec<usize>> {
    let mut seen = vec![false; count];
    let mut components = Vec::new();
    for start in 0..count {
        if seen[start] || !member(start) {
            continue;
        }
        seen[start] = true;
        let mut component = vec![start];
        let mut next = 0;
        while next < component.len() {
            for node in linked(component[next]) {
                if !seen[node] {
                    seen[node] = true;
                    component.push(node);
                }
            }
            next += 1;
        }
        components.push(component);
    }
    components
}

/// The connected components (4-neighbours) of equal labels on a grid, in reading order of their first cells.
pub fn of_labels<L: PartialEq>(labels: &[L], size: Size) -> Vec<Vec<usize>> {
    let linked = |cell: usize| four_neighbours(cell, size).filter(move |&other| labels[other] == labels[cell]);
    components(labels.len(), |_| true, linked)
}

/// The connected components of points, of which two are linked if `linked` accepts the vector between them, in both
/// directions. It is asked for all pairs that are at most `reach` apart, and for some that are farther.
pub fn of_points<U>(
    points: &[Point2D<f32, U>],
    reach: f32,
    linked: impl Fn(Vector2D<f32, U>) -> bool,
) -> Vec<Vec<usize>> {
    let square = |at: Point2D<f32, U>| ((at.y / reach).floor() as i32, (at.x / reach).floor() as i32);
    let mut by_square: BTreeMap<(i32, i32), Vec<usize>> = BTreeMap::new();
    for (number, &at) in points.iter().enumerate() {
        by_square.entry(square(at)).or_default().push(number);
    }
    let (by_square, linked) = (&by_square, &linked);
    let near = |number: usize| {
        let here = points[number];
        let (row, column) = square(here);
        let squares = (-1..=1).flat_map(move |dy| (-1..=1).map(move |dx| (row + dy, column + dx)));
        let around = squares.filter_map(|square| by_square.get(&square)).flatten().copied();
        around.filter(move |&other| linked(points[other] - here))
    };
    components(points.len(), |_| true, near)
}

/// Removes the items of all components that `stays` does not accept; the others keep their order.
pub fn retain<T>(items: &mut Vec<T>, components: &[Vec<usize>], stays: impl Fn(&[T], &[usize]) -> bool) {
    let mut kept = vec![false; items.len()];
    for component in components.iter().filter(|component| stays(items, component)) {
        component.iter().for_each(|&number| kept[number] = true);
    }
    let mut kept = kept.into_iter();
    items.retain(|_| kept.next() == Some(true));
}

/// The cells that share a side with a cell of a grid: left, right, above, below.
pub fn four_neighbours(cell: usize, size: Size) -> impl Iterator<Item = usize> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (x, y) = (cell % width, cell / width);
    let left = (x > 0).then(|| cell - 1);
    let right = (x + 1 < width).then_some(cell + 1);
    let above = (y > 0).then(|| cell - width);
    let below = (y + 1 < height).then_some(cell + width);
    [left, right, above, below].into_iter().flatten()
}

/// The cells that share a side or a corner with a cell of a grid, and the cell itself, row by row.
pub fn eight_neighbours(cell: usize, size: Size) -> impl Iterator<Item = usize> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (x, y) = (cell % width, cell / width);
    let columns = x.saturating_sub(1)..(x + 2).min(width);
    (y.saturating_sub(1)..(y + 2).min(height)).flat_map(move |y| columns.clone().map(move |x| y * width + x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{MmPoint, MmVector};

    /// A grid as it is drawn, and the components of its labels.
    fn drawn(rows: &[&str]) -> (Vec<char>, Size, Vec<Vec<usize>>) {
        let size = Size::new(rows[0].len() as u32, rows.len() as u32);
        let labels: Vec<char> = rows.concat().chars().collect();
        let components = of_labels(&labels, size);
        (labels, size, components)
    }

    #[test]
    fn equal_labels_are_connected_by_their_sides_and_not_by_corners() {
        let (.., components) = drawn(&["aab", "baa", "bbb"]);
        assert_eq!(components, [vec![0, 1, 4, 5], vec![2], vec![3, 6, 7, 8]]);
    }

    #[test]
    fn corners_connect_where_asked_for() {
        let (labels, size, _) = drawn(&["#..#", ".#.#", "....", "#..#"]);
        let is_ink = |cell: usize| labels[cell] == '#';
        let patches = components(labels.len(), is_ink, |cell| eight_neighbours(cell, size).filter(|&c| is_ink(c)));
        assert_eq!(patches, [vec![0, 5], vec![3, 7], vec![12], vec![15]]);
    }

    #[test]
    fn neighbours_end_at_the_edges_of_the_grid() {
        let size = Size::new(3, 2);
        assert_eq!(four_neighbours(0, size).collect::<Vec<_>>(), [1, 3]);
        assert_eq!(four_neighbours(4, size).collect::<Vec<_>>(), [3, 5, 1]);
        assert_eq!(eight_neighbours(5, size).collect::<Vec<_>>(), [1, 2, 4, 5]);
        assert_eq!(four_neighbours(0, Size::new(1, 1)).count(), 0);
    }

    #[test]
    fn a_spiral_is_one_component_of_any_length() {
        let (labels, _, components) =
            drawn(&["#######", "......#", "#####.#", "#...#.#", "#.###.#", "#.....#", "#######"]);
        let ink = labels.iter().filter(|&&label| label == '#').count();
        assert_eq!(components.iter().map(Vec::len).collect::<Vec<_>>(), [ink, labels.len() - ink]);
    }

    #[test]
    fn points_are_connected_over_others_and_as_the_caller_says() {
        let points: Vec<MmPoint> =
            [(0.0, 0.0), (9.0, 0.0), (0.9, 0.0), (1.8, 0.1), (1.8, -0.9)].map(|(x, y)| MmPoint::new(x, y)).into();
        assert_eq!(of_points(&points, 1.01, |v| v.length() <= 1.01), [vec![0, 2, 3, 4], vec![1]]);
        let level = |v: MmVector| v.y.abs() < 0.5 && v.x.abs() <= 1.0;
        assert_eq!(of_points(&points, 1.01, level), [vec![0, 2, 3], vec![1], vec![4]]);
    }

    #[test]
    fn what_stays_keeps_its_order() {
        let mut items = vec!['a', 'b', 'c', 'd'];
        retain(&mut items, &[vec![0, 3], vec![1], vec![2]], |_, component| component.len() == 2);
        assert_eq!(items, ['a', 'd']);
    }
}
