//! Connected components: of the cells of a grid, and of points that lie near one another.

use std::collections::BTreeMap;
use std::ops::{Index, Range};

use lyon::geom::euclid::{Point2D, Vector2D};

use crate::units::Size;

/// The connected components of some nodes, ordered by their lowest node.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Components {
    /// The nodes, component after component, in each the lowest first.
    nodes: Vec<usize>,
    /// The end of each component in `nodes`.
    ends: Vec<usize>,
    /// The component of each node.
    of_node: Vec<u32>,
}

impl Components {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are none, as there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The nodes of each component.
    pub fn iter(&self) -> impl Iterator<Item = &[usize]> {
        (0..self.len()).map(|number| &self[number])
    }

    /// The number of the component that a node belongs to.
    pub fn of(&self, node: usize) -> usize {
        self.of_node[node] as usize
    }
}

impl Index<usize> for Components {
    type Output = [usize];

    fn index(&self, number: usize) -> &[usize] {
        let start = number.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.nodes[start..self.ends[number]]
    }
}

/// Which cells of a grid are neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Connectivity {
    /// Those that share a side.
    Four,
    /// Those that share a side or a corner.
    Eight,
}

/// The connected components of equal labels on a grid. Rows are cut into runs of one label, and each run is joined to
/// those of its label in the row above (Rosenfeld and Pfaltz 1966, by runs as in He, Chao and Suzuki 2008): work that
/// grows with the number of runs, where a search from cell to cell asks each cell for all its neighbours.
pub fn of_labels<L: PartialEq>(labels: &[L], size: Size, connectivity: Connectivity) -> Components {
    let width = size.width as usize;
    let corner = usize::from(connectivity == Connectivity::Eight);
    let mut runs: Vec<Range<usize>> = Vec::new();
    let mut sets = DisjointSets::default();
    let (mut above, mut start) = (0, 0);
    for row in labels.chunks(width.max(1)) {
        let row_start = runs.len();
        for run in row.chunk_by(|a, b| a == b) {
            let end = start + run.len();
            let number = sets.add();
            while above < row_start && runs[above].end + width + corner <= start {
                above += 1;
            }
            let touches = |upper: &&Range<usize>| upper.start + width < end + corner;
            for (upper, of) in runs[above..row_start].iter().take_while(touches).zip(above..) {
                if labels[upper.start] == run[0] {
                    sets.join(of, number);
                }
            }
            runs.push(start..end);
            start = end;
        }
        above = row_start;
    }
    sets.components(&runs)
}

/// The connected components of the cells of a grid that are set, the lowest cell of each first, ordered by that: as
/// [`of_labels`], without the work for those that are not.
pub fn of_set(set: &[bool], size: Size, connectivity: Connectivity) -> Vec<Vec<usize>> {
    let width = size.width as usize;
    let corner = usize::from(connectivity == Connectivity::Eight);
    let mut runs: Vec<Range<usize>> = Vec::new();
    let mut sets = DisjointSets::default();
    let (mut above, mut row_start) = (0, 0);
    for (y, row) in set.chunks(width.max(1)).enumerate() {
        let last_row = row_start..runs.len();
        above = above.max(last_row.start);
        row_start = runs.len();
        each_run(row, |run| {
            let run = run.start + y * width..run.end + y * width;
            let number = sets.add();
            while above < last_row.end && runs[above].end + width + corner <= run.start {
                above += 1;
            }
            let touches = |upper: &&Range<usize>| upper.start + width < run.end + corner;
            for (upper, of) in runs[above..last_row.end].iter().take_while(touches).zip(above..) {
                debug_assert!(upper.end + width + corner > run.start);
                sets.join(of, number);
            }
            runs.push(run);
        });
    }
    let mut components: Vec<Vec<usize>> = Vec::new();
    let mut numbers: Vec<usize> = Vec::with_capacity(runs.len());
    for (run, cells) in runs.into_iter().enumerate() {
        let lowest = sets.lowest(run);
        if lowest == run {
            numbers.push(components.len());
            components.push(cells.collect());
        } else {
            numbers.push(numbers[lowest]);
            components[numbers[lowest]].extend(cells);
        }
    }
    components
}

/// Cells that are looked at together, as mostly none of them or all are set.
const TOGETHER: usize = 16;

/// Visits the runs of cells of a row that are set.
fn each_run(row: &[bool], mut of: impl FnMut(Range<usize>)) {
    let (mut start, mut is_inside) = (0, false);
    for (part, cells) in row.chunks(TOGETHER).enumerate() {
        let (any, all) = cells.iter().fold((false, true), |(any, all), &set| (any | set, all & set));
        if any == all && any == is_inside {
            continue;
        }
        for (x, &set) in (part * TOGETHER..).zip(cells) {
            if set != is_inside {
                if set {
                    start = x;
                } else {
                    of(start..x);
                }
                is_inside = set;
            }
        }
    }
    if is_inside {
        of(start..row.len());
    }
}

/// The connected components of points, of which two are linked if `linked` accepts the vector between them, whichever
/// way it points. It is asked for all pairs that are at most `reach` apart, and for some that are farther.
pub fn of_points<U>(points: &[Point2D<f32, U>], reach: f32, linked: impl Fn(Vector2D<f32, U>) -> bool) -> Components {
    let square = |at: Point2D<f32, U>| ((at.y / reach).floor() as i32, (at.x / reach).floor() as i32);
    let mut by_square: BTreeMap<(i32, i32), Vec<usize>> = BTreeMap::new();
    let mut sets = DisjointSets::default();
    for (number, &here) in points.iter().enumerate() {
        sets.add();
        let (row, column) = square(here);
        let squares = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (row + dy, column + dx)));
        for &before in squares.filter_map(|square| by_square.get(&square)).flatten() {
            if linked(points[before] - here) {
                sets.join(before, number);
            }
        }
        by_square.entry((row, column)).or_default().push(number);
    }
    let runs: Vec<Range<usize>> = (0..points.len()).map(|number| number..number + 1).collect();
    sets.components(&runs)
}

/// Removes the items of all components that `stays` does not accept; the others keep their order.
pub fn retain<T>(items: &mut Vec<T>, components: &Components, stays: impl Fn(&[T], &[usize]) -> bool) {
    let stay: Vec<bool> = components.iter().map(|component| stays(items, component)).collect();
    let mut numbers = components.of_node.iter();
    items.retain(|_| numbers.next().is_some_and(|&number| stay[number as usize]));
}

/// Disjoint sets of numbers, of which the lowest stands for its set: union and find (Tarjan 1975) with path halving.
#[derive(Debug, Default)]
pub struct DisjointSets {
    /// A lower number of the same set, or itself.
    lower: Vec<u32>,
}

impl DisjointSets {
    /// Adds the next number as a set of its own.
    pub fn add(&mut self) -> usize {
        self.lower.push(self.lower.len() as u32);
        self.lower.len() - 1
    }

    /// The lowest number of the set of `number`.
    pub fn lowest(&mut self, mut number: usize) -> usize {
        loop {
            let lower = self.lower[number] as usize;
            if lower == number {
                return number;
            }
            self.lower[number] = self.lower[lower];
            number = self.lower[number] as usize;
        }
    }

    /// Makes one set of those of two numbers.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.lowest(a), self.lowest(b));
        self.lower[a.max(b)] = a.min(b) as u32;
    }

    /// The components of nodes of which those in `runs[number]` are in the set of `number`. The runs follow one another
    /// from 0 on.
    fn components(mut self, runs: &[Range<usize>]) -> Components {
        let mut numbers: Vec<u32> = Vec::with_capacity(runs.len());
        let mut lengths: Vec<usize> = Vec::new();
        for (run, nodes) in runs.iter().enumerate() {
            let lowest = self.lowest(run);
            if lowest == run {
                numbers.push(lengths.len() as u32);
                lengths.push(0);
            } else {
                numbers.push(numbers[lowest]);
            }
            lengths[numbers[run] as usize] += nodes.len();
        }
        let count = runs.last().map_or(0, |run| run.end);
        let mut of_node = Vec::with_capacity(count);
        let mut nodes = vec![0; count];
        // where the next nodes of each component go; in the end, where it ends
        let mut ends = lengths;
        let mut start = 0;
        for end in &mut ends {
            (*end, start) = (start, start + *end);
        }
        for (&number, run) in numbers.iter().zip(runs) {
            of_node.resize(run.end, number);
            let end = &mut ends[number as usize];
            nodes[*end..*end + run.len()].iter_mut().zip(run.clone()).for_each(|(slot, node)| *slot = node);
            *end += run.len();
        }
        Components { nodes, ends, of_node }
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{MmPoint, MmVector};
    use proptest::prelude::*;

    /// The components of the labels of a grid as it is drawn, and the labels.
    fn drawn(rows: &[&str], connectivity: Connectivity) -> (Vec<char>, Vec<Vec<usize>>) {
        let size = Size::new(rows[0].len() as u32, rows.len() as u32);
        let labels: Vec<char> = rows.concat().chars().collect();
        let components = listed(&of_labels(&labels, size, connectivity));
        (labels, components)
    }

    fn listed(components: &Components) -> Vec<Vec<usize>> {
        components.iter().map(<[usize]>::to_vec).collect()
    }

    #[test]
    fn equal_labels_are_connected_by_their_sides_and_not_by_corners() {
        let (_, components) = drawn(&["aab", "baa", "bbb"], Connectivity::Four);
        assert_eq!(components, [vec![0, 1, 4, 5], vec![2], vec![3, 6, 7, 8]]);
    }

    #[test]
    fn corners_connect_where_asked_for() {
        let (labels, mut patches) = drawn(&["#..#", ".#.#", "....", "#..#"], Connectivity::Eight);
        patches.retain(|patch| labels[patch[0]] == '#');
        assert_eq!(patches, [vec![0, 5], vec![3, 7], vec![12], vec![15]]);
    }

    #[test]
    fn rows_do_not_go_on_in_the_next_row() {
        for connectivity in [Connectivity::Four, Connectivity::Eight] {
            let (_, components) = drawn(&["..#", "...", "#..", "..#"], connectivity);
            assert_eq!(components, [vec![0, 1, 3, 4, 5, 7, 8, 9, 10], vec![2], vec![6], vec![11]]);
        }
        assert!(of_labels(&[(); 0], Size::new(0, 0), Connectivity::Four).is_empty());
    }

    #[test]
    fn neighbours_end_at_the_edges_of_the_grid() {
        let size = Size::new(3, 2);
        assert_eq!(four_neighbours(0, size).collect::<Vec<_>>(), [1, 3]);
        assert_eq!(four_neighbours(4, size).collect::<Vec<_>>(), [3, 5, 1]);
        assert_eq!(four_neighbours(0, Size::new(1, 1)).count(), 0);
    }

    #[test]
    fn a_spiral_is_one_component_of_any_length() {
        let rows = ["#######", "......#", "#####.#", "#...#.#", "#.###.#", "#.....#", "#######"];
        let (labels, components) = drawn(&rows, Connectivity::Four);
        let ink = labels.iter().filter(|&&label| label == '#').count();
        assert_eq!(components.iter().map(Vec::len).collect::<Vec<_>>(), [ink, labels.len() - ink]);
    }

    proptest! {
        #[test]
        fn cells_are_in_one_component_if_a_path_of_their_label_leads_from_one_to_the_other(
            width in 1_u32..9,
            labels in prop::collection::vec(0..3, 1..80),
            eight in any::<bool>(),
        ) {
            let size = Size::new(width, (labels.len() as u32).div_ceil(width));
            let labels: Vec<i32> = labels.iter().copied().cycle().take(size.len()).collect();
            let connectivity = if eight { Connectivity::Eight } else { Connectivity::Four };
            let found = of_labels(&labels, size, connectivity);
            // the lowest cell that each is connected to, step by step
            let beside = |a: usize, b: usize| {
                let [(ax, ay), (bx, by)] = [a, b].map(|cell| (cell as u32 % width, cell as u32 / width));
                let (dx, dy) = (ax.abs_diff(bx), ay.abs_diff(by));
                labels[a] == labels[b] && if eight { dx.max(dy) == 1 } else { dx + dy == 1 }
            };
            let mut lowest: Vec<usize> = (0..labels.len()).collect();
            let pairs: Vec<(usize, usize)> = (0..labels.len())
                .flat_map(|a| (0..labels.len()).map(move |b| (a, b)))
                .filter(|&(a, b)| beside(a, b))
                .collect();
            while pairs.iter().any(|&(a, b)| lowest[a] != lowest[b]) {
                pairs.iter().for_each(|&(a, b)| lowest[b] = lowest[b].min(lowest[a]));
            }
            let set: Vec<bool> = labels.iter().map(|label| *label == 1).collect();
            let ones: Vec<&[usize]> = found.iter().filter(|cells| set[cells[0]]).collect();
            prop_assert_eq!(of_set(&set, size, connectivity), ones);
            for cell in 0..labels.len() {
                let own = &found[found.of(cell)];
                prop_assert_eq!(own[0], lowest[cell]);
                prop_assert!(own.is_sorted() && own.contains(&cell));
            }
            prop_assert_eq!(found.iter().map(<[usize]>::len).sum::<usize>(), labels.len());
        }
    }

    #[test]
    fn points_are_connected_over_others_and_as_the_caller_says() {
        let points: Vec<MmPoint> =
            [(0.0, 0.0), (9.0, 0.0), (0.9, 0.0), (1.8, 0.1), (1.8, -0.9)].map(|(x, y)| MmPoint::new(x, y)).into();
        assert_eq!(listed(&of_points(&points, 1.01, |v| v.length() <= 1.01)), [vec![0, 2, 3, 4], vec![1]]);
        let level = |v: MmVector| v.y.abs() < 0.5 && v.x.abs() <= 1.0;
        assert_eq!(listed(&of_points(&points, 1.01, level)), [vec![0, 2, 3], vec![1], vec![4]]);
    }

    #[test]
    fn what_stays_keeps_its_order() {
        let mut items = vec!['a', 'b', 'c', 'd'];
        let points = [0.0, 5.0, 10.0, 0.5].map(|x| MmPoint::new(x, 0.0));
        let components = of_points(&points, 1.0, |v| v.length() <= 1.0);
        retain(&mut items, &components, |_, component| component.len() == 2);
        assert_eq!(items, ['a', 'd']);
    }
}
