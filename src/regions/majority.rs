//! The label that most of what is around a place has: a map of labels becomes a coarser one.

use crate::raster::plane::{Plane, gauss};
use crate::raster::shrink::{Span, spans};
use crate::units::Size;

/// The label that is most frequent around each cell of a coarse grid, within a Gaussian of `sigma` of its cells, of
/// the labels from 0 to `count`; of several the lowest.
///
/// A label is looked at in the box that it fills, with as much around it as the Gaussian reaches. Most coarse cells
/// have one label, which is found once for all labels.
pub(super) fn majority(labels: &[u8], count: usize, [fine, coarse]: [Size; 2], sigma: f32) -> Vec<u8> {
    let map = Map::new(labels, fine, coarse);
    let mut best = vec![0.0_f32; coarse.len()];
    let mut winner = vec![0; coarse.len()];
    let reach = gauss(sigma).len() - 1;
    let width = coarse.width as usize;
    for (label, place) in (0_u8..).zip(map.boxes(count)) {
        let Some(place) = place.map(|place| place.grown(reach, coarse)) else { continue };
        let shares = map.shares(label, place).blurred(sigma);
        for (y, shares) in (place.top..).zip(shares.values.chunks_exact(place.right - place.left)) {
            let row = y * width + place.left..y * width + place.right;
            for ((best, winner), &share) in best[row.clone()].iter_mut().zip(&mut winner[row]).zip(shares) {
                if share > *best {
                    (*best, *winner) = (share, label);
                }
            }
        }
    }
    winner
}

/// A box of coarse cells, without its right and lower ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct CellBox {
    left: usize,
    top: usize,
    right: usize,
    bottom: usize,
}

impl CellBox {
    /// With so many cells around it, as far as there are.
    fn grown(self, by: usize, size: Size) -> Self {
        Self {
            left: self.left.saturating_sub(by),
            top: self.top.saturating_sub(by),
            right: (self.right + by).min(size.width as usize),
            bottom: (self.bottom + by).min(size.height as usize),
        }
    }
}

/// A map of labels, and what is in the cells of a coarse grid over it.
struct Map<'a> {
    labels: &'a [u8],
    /// Columns of the map.
    width: usize,
    across: Vec<Span<f32>>,
    down: Vec<Span<f32>>,
    /// The label that all of a coarse cell has; none if it has several.
    whole: Vec<Option<u8>>,
    /// The mean of a coarse cell that is 1 everywhere: 1, but for rounding.
    ones: Vec<f32>,
}

impl<'a> Map<'a> {
    fn new(labels: &'a [u8], fine: Size, coarse: Size) -> Self {
        let (across, down) = (spans(fine.width, coarse.width), spans(fine.height, coarse.height));
        let width = fine.width as usize;
        let whole = whole(labels, width, [&across, &down]);
        let mut ones = Vec::with_capacity(coarse.len());
        for down in &down {
            let sum = down.weights.iter().fold(0.0, |sum, weight| sum + weight);
            ones.extend(
                across.iter().map(|across| across.weights.iter().fold(0.0, |mean, weight| mean + weight * sum)),
            );
        }
        Self { labels, width, across, down, whole, ones }
    }

    /// The labels of a coarse cell, row by row.
    fn labels_of(&self, x: usize, y: usize) -> impl Iterator<Item = &[u8]> {
        let (across, down) = (&self.across[x], &self.down[y]);
        (down.start..down.end()).map(move |row| &self.labels[row * self.width..][across.start..across.end()])
    }

    /// The box around the coarse cells that have some of each label, from 0 to `count`; none of one that is nowhere.
    fn boxes(&self, count: usize) -> Vec<Option<CellBox>> {
        let mut boxes: Vec<Option<CellBox>> = vec![None; count + 1];
        let mut put = |label: u8, x: usize, y: usize| {
            let Some(place) = boxes.get_mut(usize::from(label)) else { return };
            let place = place.get_or_insert(CellBox { left: x, top: y, right: x + 1, bottom: y + 1 });
            (place.left, place.right) = (place.left.min(x), place.right.max(x + 1));
            place.bottom = y + 1;
        };
        for (y, row) in self.whole.chunks_exact(self.across.len()).enumerate() {
            let mut x = 0;
            for run in row.chunk_by(|a, b| a == b) {
                for at in x..x + run.len() {
                    match run[0] {
                        Some(label) if at == x || at + 1 == x + run.len() => put(label, at, y),
                        Some(_) => (),
                        None => self.labels_of(at, y).flatten().for_each(|&label| put(label, at, y)),
                    }
                }
                x += run.len();
            }
        }
        boxes
    }

    /// The share of a label in the coarse cells of a box.
    fn shares(&self, label: u8, place: CellBox) -> Plane {
        let size = Size::new((place.right - place.left) as u32, (place.bottom - place.top) as u32);
        let mut values = Vec::with_capacity(size.len());
        for y in place.top..place.bottom {
            let row = y * self.across.len() + place.left..y * self.across.len() + place.right;
            let cells = self.whole[row.clone()].iter().zip(&self.ones[row]).zip(place.left..);
            values.extend(cells.map(|((whole, one), x)| match whole {
                Some(own) if *own == label => *one,
                Some(_) => 0.0,
                None => self.share(label, x, y),
            }));
        }
        Plane { size, values }
    }

    /// The share of a label in a coarse cell, summed up as [`shrink`](crate::raster::shrink) does: first the rows.
    fn share(&self, label: u8, x: usize, y: usize) -> f32 {
        let down = &self.down[y].weights;
        let column = |(i, weight): (usize, &f32)| {
            let rows = self.labels_of(x, y).zip(down);
            let sum = rows.fold(0.0, |sum, (row, down)| sum + down * f32::from(u8::from(row[i] == label)));
            weight * sum
        };
        self.across[x].weights.iter().enumerate().map(column).fold(0.0, |mean, of_column| mean + of_column)
    }
}

/// The label that all of each coarse cell has; none if it has several.
fn whole(labels: &[u8], width: usize, [across, down]: [&[Span<f32>]; 2]) -> Vec<Option<u8>> {
    let mut whole = Vec::with_capacity(across.len() * down.len());
    // of each column: what bits differ from the row above, or from the column before it
    let mut differ = vec![0_u8; width];
    for down in down {
        let rows = &labels[down.start * width..down.end() * width];
        differ.fill(0);
        for (above, below) in rows.chunks_exact(width).zip(rows[width..].chunks_exact(width)) {
            differ
                .iter_mut()
                .zip(above.iter().zip(below))
                .for_each(|(differ, (above, below))| *differ |= above ^ below);
        }
        whole.extend(across.iter().map(|across| {
            let row = &rows[across.start..across.end()];
            let is_whole = row.windows(2).all(|pair| pair[0] == pair[1])
                && differ[across.start..across.end()].iter().all(|differ| *differ == 0);
            is_whole.then(|| row[0])
        }));
    }
    whole
}

#[cfg(test)]
mod tests;
