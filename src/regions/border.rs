//! The borders of a map of labels as chains: each is drawn once, the first region's as a ring, those after it to where
//! they meet one that is drawn.

use crate::units::{PxPoint, Size};

/// So many cells of two rows are held beside one another at once.
const AT_ONCE: usize = 16;
/// Steps over the corners of cells: right, down, left, up.
const STEPS: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

/// Corners of cells that follow one another along a border.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Border {
    /// Numbers of the corners; of a ring the first is not repeated.
    pub(super) corners: Vec<usize>,
    pub(super) closed: bool,
    /// The region whose outline it is.
    pub(super) label: u8,
}

/// A map of labels.
struct Map<'a> {
    labels: &'a [u8],
    size: Size,
}

/// Where a corner is, in cells.
pub(super) fn corner_at(corner: usize, size: Size) -> PxPoint {
    let across = size.width as usize + 1;
    PxPoint::new((corner % across) as f32, (corner / across) as f32)
}

/// The borders of the labels from 1 to `count`, in that order.
pub(super) fn borders(labels: &[u8], count: usize, size: Size) -> Vec<Border> {
    let map = Map { labels, size };
    let corners = (size.width as usize + 1) * (size.height as usize + 1);
    // by corner: whether the side to its right, or below it, is drawn
    let mut is_drawn = vec![[false; 2]; corners];
    let mut seen = vec![false; corners];
    let mut borders = Vec::new();
    for (label, starts) in (1..).zip(map.starts(count)) {
        for outline in map.outlines(label, &starts, &mut seen) {
            let is_free = |&step: &(usize, usize)| {
                let (corner, down) = side(step, size);
                !map.on_picture_edge(step) && !is_drawn[corner][down]
            };
            let free: Vec<bool> = outline.iter().map(is_free).collect();
            for run in runs(&free) {
                let steps: Vec<(usize, usize)> = run.iter().map(|&i| outline[i]).collect();
                for &step in &steps {
                    let (corner, down) = side(step, size);
                    is_drawn[corner][down] = true;
                }
                let closed = steps.len() == outline.len();
                let mut corners: Vec<usize> = steps.iter().map(|step| step.0).collect();
                if let (Some(&last), false) = (steps.last(), closed) {
                    corners.push(next(last, size));
                }
                borders.push(Border { corners, closed, label });
            }
        }
    }
    borders
}

/// Stretches of indices that are free, going round; all of them if all are.
fn runs(free: &[bool]) -> Vec<Vec<usize>> {
    let count = free.len();
    let Some(start) = free.iter().position(|free| !free) else {
        return vec![(0..count).collect()];
    };
    let round: Vec<usize> = (start..count).chain(0..start).collect();
    round.split(|&i| !free[i]).filter(|run| !run.is_empty()).map(<[usize]>::to_vec).collect()
}

/// The corner that a step from a corner leads to.
fn next((corner, direction): (usize, usize), size: Size) -> usize {
    let across = size.width as usize + 1;
    match direction {
        0 => corner + 1,
        1 => corner + across,
        2 => corner - 1,
        _ => corner - across,
    }
}

/// The side of cells that a step runs along, whichever way: its upper or left corner, and 1 if it runs down.
fn side(step: (usize, usize), size: Size) -> (usize, usize) {
    let corner = if step.1 < 2 { step.0 } else { next(step, size) };
    (corner, step.1 % 2)
}

impl Map<'_> {
    /// The label of a cell; none outside the picture.
    fn label(&self, x: i32, y: i32) -> Option<u8> {
        let (width, height) = (self.size.width as i32, self.size.height as i32);
        (x >= 0 && y >= 0 && x < width && y < height).then(|| self.labels[(y * width + x) as usize])
    }

    /// The labels on the left and on the right of a step.
    fn beside(&self, (corner, direction): (usize, usize)) -> [Option<u8>; 2] {
        let across = self.size.width as usize + 1;
        let (x, y) = ((corner % across) as i32, (corner / across) as i32);
        let [left, right] = match direction {
            0 => [(x, y - 1), (x, y)],
            1 => [(x, y), (x - 1, y)],
            2 => [(x - 1, y), (x - 1, y - 1)],
            _ => [(x - 1, y - 1), (x, y - 1)],
        };
        [self.label(left.0, left.1), self.label(right.0, right.1)]
    }

    fn on_picture_edge(&self, step: (usize, usize)) -> bool {
        self.beside(step)[0].is_none()
    }

    /// The steps to the right along the upper sides of the areas of each label from 1 to `count`: every outline has
    /// one.
    fn starts(&self, count: usize) -> Vec<Vec<(usize, usize)>> {
        let (width, across) = (self.size.width as usize, self.size.width as usize + 1);
        let mut starts = vec![Vec::new(); count];
        let ground = vec![0; width];
        let above = std::iter::once(&ground[..]).chain(self.labels.chunks_exact(width));
        for (y, (row, above)) in self.labels.chunks_exact(width).zip(above).enumerate() {
            for (first, (some, above)) in row.chunks(AT_ONCE).zip(above.chunks(AT_ONCE)).enumerate() {
                // most cells have the label of the one above
                if some == above {
                    continue;
                }
                for (x, (&label, _)) in some.iter().zip(above).enumerate().filter(|(_, (label, above))| label != above)
                {
                    if let Some(starts) = usize::from(label).checked_sub(1).and_then(|number| starts.get_mut(number)) {
                        starts.push((y * across + first * AT_ONCE + x, 0));
                    }
                }
            }
        }
        starts
    }

    /// The outlines of all areas of a label, each as its steps with the area on their right. Areas that share only a
    /// corner are two. `seen` has the corners from which a step to the right was taken, of any label: each has one cell
    /// on its right.
    fn outlines(&self, label: u8, starts: &[(usize, usize)], seen: &mut [bool]) -> Vec<Vec<(usize, usize)>> {
        let is_border = |step| {
            let [left, right] = self.beside(step);
            right == Some(label) && left != Some(label)
        };
        let mut outlines = Vec::new();
        for &start in starts {
            if seen[start.0] {
                continue;
            }
            let (mut step, mut outline) = (start, Vec::new());
            loop {
                outline.push(step);
                if step.1 == 0 {
                    seen[step.0] = true;
                }
                let corner = next(step, self.size);
                let turns = [1, 0, 3].map(|turn| (corner, (step.1 + turn) % 4));
                // a border always goes on
                let Some(&onwards) = turns.iter().find(|step| self.is_inside(**step) && is_border(**step)) else {
                    break;
                };
                step = onwards;
                if step == start {
                    break;
                }
            }
            outlines.push(outline);
        }
        outlines
    }

    /// Whether a step stays on the grid.
    fn is_inside(&self, (corner, direction): (usize, usize)) -> bool {
        let across = self.size.width as usize + 1;
        let (x, y) = ((corner % across) as i32 + STEPS[direction].0, (corner / across) as i32 + STEPS[direction].1);
        x >= 0 && y >= 0 && x <= self.size.width as i32 && y <= self.size.height as i32
    }
}

#[cfg(test)]
mod tests;
