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
mod tests;
