//! How lines of a page agree with what people outlined.

use crate::mat::Matrix;

/// A line lies on a boundary within this share of the diagonal, as in the benchmark itself (Martin, Fowlkes and Malik
/// 2004).
pub(super) const TOLERANCE: f64 = 0.0075;
/// Lines that end so near to the edge of the picture, as a share of its diagonal, part what is on both sides of them.
const AT_EDGE: f64 = 0.02;
/// Gaps up to twice this, px, part it too.
const GAP: i64 = 3;
/// A line is closed if its ends are no further apart, px.
const CLOSED: f64 = 3.0;

/// What one person outlined.
pub(super) struct Outlined {
    /// 1 on boundaries, else 0.
    pub(super) boundaries: Matrix,
    /// The number of the segment of each pixel.
    pub(super) segments: Matrix,
}

/// A line in pixels of the picture.
pub(super) type Path = Vec<(f64, f64)>;

/// Counts and shares of one picture.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Agreement {
    /// Drawn pixels, and those on any boundary.
    pub(super) drawn: usize,
    pub(super) right: usize,
    /// Boundary pixels that at least half of the people share, and those with a line.
    pub(super) wanted: usize,
    pub(super) found: usize,
    pub(super) lines: usize,
    /// Share of the drawn length in rings.
    pub(super) closed: f64,
    pub(super) covering: f64,
}

/// A bitmap of the size of the picture.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bits {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) set: Vec<bool>,
}

impl Bits {
    fn none(width: usize, height: usize) -> Self {
        Self { width, height, set: vec![false; width * height] }
    }

    pub(super) fn of(matrix: &Matrix) -> Self {
        Self { set: matrix.values.iter().map(|value| *value > 0).collect(), ..Self::none(matrix.width, matrix.height) }
    }

    pub(super) fn index(&self, x: i64, y: i64) -> Option<usize> {
        let is_on = (0..self.width as i64).contains(&x) && (0..self.height as i64).contains(&y);
        is_on.then(|| y as usize * self.width + x as usize)
    }

    pub(super) fn pixels(&self) -> impl Iterator<Item = (i64, i64)> {
        let width = self.width;
        let set = self.set.iter().enumerate().filter(|(_, set)| **set);
        set.map(move |(at, _)| ((at % width) as i64, (at / width) as i64))
    }

    fn draw(&mut self, path: &[(f64, f64)]) {
        for pair in path.windows(2) {
            let [(x, y), (to_x, to_y)] = [pair[0], pair[1]];
            let steps = (4.0 * (to_x - x).hypot(to_y - y)).ceil().max(1.0);
            for step in 0..=steps as usize {
                let share = step as f64 / steps;
                let at = (x + share * (to_x - x), y + share * (to_y - y));
                if let Some(index) = self.index(at.0.floor() as i64, at.1.floor() as i64) {
                    self.set[index] = true;
                }
            }
        }
    }

    /// With all pixels whose offset from one that is set is one of these.
    fn grown(&self, offsets: &[(i64, i64)]) -> Self {
        let mut grown = Self::none(self.width, self.height);
        for (x, y) in self.pixels() {
            for (dx, dy) in offsets {
                if let Some(index) = grown.index(x + dx, y + dy) {
                    grown.set[index] = true;
                }
            }
        }
        grown
    }
}

/// Offsets within a radius, px.
pub(super) fn disc(radius: f64) -> Vec<(i64, i64)> {
    let most = radius.floor() as i64;
    let all = (-most..=most).flat_map(|y| (-most..=most).map(move |x| (x, y)));
    all.filter(|(x, y)| (*x as f64).hypot(*y as f64) <= radius).collect()
}

/// How well lines draw what people outlined.
pub(super) fn agreement(lines: &[Path], people: &[Outlined]) -> Agreement {
    let (width, height) = (people[0].boundaries.width, people[0].boundaries.height);
    let diagonal = (width as f64).hypot(height as f64);
    let near = disc(TOLERANCE * diagonal);
    let boundaries: Vec<Bits> = people.iter().map(|person| Bits::of(&person.boundaries)).collect();
    let near_boundaries: Vec<Bits> = boundaries.iter().map(|own| own.grown(&near)).collect();
    let mut drawn = Bits::none(width, height);
    lines.iter().for_each(|line| drawn.draw(line));
    let near_drawn = drawn.grown(&near);
    let (mut wanted, mut found) = (0, 0);
    for own in &boundaries {
        for at in (0..own.set.len()).filter(|at| own.set[*at]) {
            let sharing = near_boundaries.iter().filter(|near| near.set[at]).count();
            if sharing >= people.len().div_ceil(2).max(2) {
                wanted += 1;
                found += usize::from(near_drawn.set[at]);
            }
        }
    }
    let on_any = |at: &usize| near_boundaries.iter().any(|near| near.set[*at]);
    let is_drawn: Vec<usize> = (0..drawn.set.len()).filter(|at| drawn.set[*at]).collect();
    let length = |line: &Path| line.windows(2).map(|pair| far(pair[0], pair[1])).sum::<f64>();
    let all: f64 = lines.iter().map(length).sum();
    let is_closed = |line: &&Path| line.len() > 2 && far(line[0], line[line.len() - 1]) < CLOSED;
    let closed: f64 = lines.iter().filter(is_closed).map(length).sum();
    Agreement {
        drawn: is_drawn.len(),
        right: is_drawn.iter().filter(|at| on_any(at)).count(),
        wanted,
        found,
        lines: lines.len(),
        closed: if all > 0.0 { closed / all } else { 0.0 },
        covering: covering(drawn, lines, people),
    }
}

fn far(a: (f64, f64), b: (f64, f64)) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

/// The segmentation covering (Arbelaez and others 2011) of what each person parted by what the lines part, in the mean;
/// 0 without lines.
fn covering(mut drawn: Bits, lines: &[Path], people: &[Outlined]) -> f64 {
    if lines.is_empty() {
        return 0.0;
    }
    let (width, height) = (drawn.width as f64, drawn.height as f64);
    let near = AT_EDGE * width.hypot(height);
    for &(x, y) in lines.iter().flat_map(|line| [line.first(), line.last()]).flatten() {
        let edges = [(x, (0.0, y)), (width - x, (width - 1.0, y)), (y, (x, 0.0)), (height - y, (x, height - 1.0))];
        for (_, to) in edges.into_iter().filter(|(gap, _)| *gap < near) {
            drawn.draw(&[(x, y), to]);
        }
    }
    let square: Vec<_> = (-GAP..=GAP).flat_map(|y| (-GAP..=GAP).map(move |x| (x, y))).collect();
    let parts = parts(&drawn.grown(&square));
    let of = |person: &Outlined| {
        let segments = &person.segments.values;
        let of_part = 1 + parts.iter().copied().max().unwrap_or(0);
        let of_segment = 1 + segments.iter().copied().max().unwrap_or(0) as usize;
        let (mut both, mut in_part, mut in_segment) =
            (vec![0_usize; of_part * of_segment], vec![0_usize; of_part], vec![0_usize; of_segment]);
        for (&part, &segment) in parts.iter().zip(segments) {
            both[part * of_segment + segment as usize] += 1;
            in_part[part] += 1;
            in_segment[segment as usize] += 1;
        }
        let overlap = |part: usize, segment: usize| {
            let both = both[part * of_segment + segment];
            both as f64 / (in_part[part] + in_segment[segment] - both).max(1) as f64
        };
        let best = |segment: usize| (0..of_part).map(|part| overlap(part, segment)).fold(0.0, f64::max);
        let sum: f64 = (0..of_segment).map(|segment| best(segment) * in_segment[segment] as f64).sum();
        sum / segments.len() as f64
    };
    people.iter().map(of).sum::<f64>() / people.len() as f64
}

/// The part of each pixel: connected by sides without crossing what is set; pixels that are set belong to the nearest.
fn parts(walls: &Bits) -> Vec<usize> {
    const NONE: usize = usize::MAX;
    const SIDES: [(i64, i64); 4] = [(1, 0), (-1, 0), (0, 1), (0, -1)];
    let mut part = vec![NONE; walls.set.len()];
    let mut count = 0;
    let at = |index: usize| ((index % walls.width) as i64, (index / walls.width) as i64);
    let beside = |index: usize| {
        let (x, y) = at(index);
        SIDES.into_iter().filter_map(move |(dx, dy)| walls.index(x + dx, y + dy))
    };
    for start in 0..part.len() {
        if walls.set[start] || part[start] != NONE {
            continue;
        }
        let mut open = vec![start];
        part[start] = count;
        while let Some(index) = open.pop() {
            for next in beside(index) {
                if !walls.set[next] && part[next] == NONE {
                    part[next] = count;
                    open.push(next);
                }
            }
        }
        count += 1;
    }
    // outwards from all of them at once
    let mut open: std::collections::VecDeque<usize> = (0..part.len()).filter(|index| part[*index] != NONE).collect();
    while let Some(index) = open.pop_front() {
        for next in beside(index) {
            if part[next] == NONE {
                part[next] = part[index];
                open.push_back(next);
            }
        }
    }
    // all of it is wall
    part.into_iter().map(|part| if part == NONE { 0 } else { part }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A person who parted a picture of 200 x 100 px in the middle.
    fn halves() -> Outlined {
        let matrix = |of: &dyn Fn(usize) -> u16| Matrix {
            width: 200,
            height: 100,
            values: (0..200 * 100).map(|at| of(at % 200)).collect(),
        };
        Outlined { boundaries: matrix(&|x| u16::from(x == 100)), segments: matrix(&|x| u16::from(x >= 100)) }
    }

    #[test]
    fn the_line_that_both_outlined_is_right_and_all_that_is_wanted() {
        let people = [halves(), halves()];
        let whole = agreement(&[vec![(100.5, 0.0), (100.5, 99.9)]], &people);
        assert_eq!([whole.drawn, whole.right, whole.wanted, whole.found], [100, 100, 200, 200]);
        assert!(whole.covering > 0.99, "{}", whole.covering);
        let half = agreement(&[vec![(100.5, 0.0), (100.5, 49.9)], vec![(20.5, 20.0), (40.5, 20.0)]], &people);
        assert_eq!(half.right, 50);
        assert!(half.drawn > 69 && (100..=104).contains(&half.found), "{half:?}");
        assert!((half.covering - 0.5).abs() < 0.02, "it parts nothing: {}", half.covering);
        assert_eq!(agreement(&[], &people), Agreement { wanted: 200, ..Agreement::default() });
    }

    #[test]
    fn what_is_closed_is_counted_by_length() {
        let square = vec![(20.0, 20.0), (60.0, 20.0), (60.0, 60.0), (20.0, 60.0), (20.0, 20.0)];
        let found = agreement(&[square, vec![(100.0, 10.0), (100.0, 50.0)]], &[halves()]);
        assert!((found.closed - 0.8).abs() < 1e-6, "{}", found.closed);
    }
}
