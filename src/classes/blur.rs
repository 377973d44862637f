//! Edge-stopping blur of the colours: averaging as the eye does, without mixing the colours of two areas.
//!
//! Diffusion on a grid of cells (as of P. Perona and J. Malik, Scale-space and edge detection using anisotropic
//! diffusion, 1990, but with a conductance of 0 or 1 that contours found before decide). After n steps, each of which
//! exchanges a share `k` between every two neighbours, a point has spread with sigma = sqrt(2 k n) cells, as in a
//! Gaussian blur. The conductance is 0 where a contour passes between the centres of two cells. The cells along a
//! contour hold mixed colours already (and a drawn outline has a colour of its own), so pixels beside contours hardly
//! count: colours are weighted sums.
//!
//! ```text
//!   blue blue|yell yell      | contour: conductance 0
//!   blue bl..|..ll yell      . pixels beside it: weight near 0, so these cells get their colour from their own side
//! ```
//!
//! Cells are a millimetre wide, so the default blur takes six steps, whatever the size of the picture. Share of the
//! picture that keeps the class of its own area, on drawn maps of twelve areas (`tests/colours/stains.rs`, which prints
//! more):
//!
//! | boundaries of the areas | Gaussian | this | this, boundaries smoothed |
//! |---|---|---|---|
//! | bare | 0.951 | 0.989 | 0.987 |
//! | black line, 0.6 mm | 0.969 | 0.996 | 0.996 |
//! | black line, 1.5 mm | 0.988 | 0.990 | 0.999 |
//! | white line, 1.0 mm | 0.953 | 0.983 | 0.999 |
//! | soft | 0.950 | 0.986 | 0.985 |
//! | grainy | 0.949 | 0.988 | 0.986 |
//!
//! The rest comes from the cells themselves: one that lies across a boundary can have one class only.

use pulp::Arch;
use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};

use super::hue::encoded;
use crate::geom::polyline::Polyline;
use crate::raster::plane::Plane;
use crate::raster::shrink::{Shrinker, shrink};
use crate::raster::{Planes, Raster};
use crate::units::{PxPoint, Size};

/// Largest share that two cells exchange in a step: above 0.25 the scheme is unstable.
const MOST_EXCHANGE: f32 = 0.2;

/// Weight of a pixel beside a contour; above 0, since a strip between two contours has no others.
const BESIDE_WEIGHT: f32 = 0.001;

/// Between which neighbouring cells values diffuse.
pub(super) struct Conductance {
    size: Size,
    /// Conductance from each cell to its right neighbour and to the one below, 0 or 1; 0 at the edge of the picture.
    right: Vec<f32>,
    below: Vec<f32>,
}

impl Conductance {
    /// 1 everywhere.
    pub(super) fn open(size: Size) -> Self {
        Self::between(size, |_, _| true)
    }

    /// 1 where `open` is true for two neighbouring cells.
    pub(super) fn between(size: Size, open: impl Fn(usize, usize) -> bool) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        let link = |inside: bool, cell: usize, other: usize| if inside && open(cell, other) { 1.0 } else { 0.0 };
        let right = (0..size.len()).map(|cell| link(cell % width + 1 < width, cell, cell + 1)).collect();
        let below = (0..size.len()).map(|cell| link(cell / width + 1 < height, cell, cell + width)).collect();
        Self { size, right, below }
    }

    /// Sets to 0 what a contour crosses on the line between the centres of two cells. Points are in cells.
    fn block(&mut self, contour: impl Iterator<Item = (f32, f32)> + Clone) {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        for ((ax, ay), (bx, by)) in contour.clone().zip(contour.skip(1)) {
            // The centres of a row lie at y = row + 0.5; where the contour crosses that line, it separates two cells.
            crossings(ay, by, |row, share| {
                for column in between(ax + share * (bx - ax), width).filter(|_| row < height) {
                    self.right[row * width + column] = 0.0;
                }
            });
            crossings(ax, bx, |column, share| {
                for row in between(ay + share * (by - ay), height).filter(|_| column < width) {
                    self.below[row * width + column] = 0.0;
                }
            });
        }
    }

    /// Whether values diffuse between two neighbouring cells.
    pub(super) fn is_open(&self, cell: usize, other: usize) -> bool {
        let (first, second) = (cell.min(other), cell.max(other));
        let side_by_side = second - first == 1 && self.size.width > 1;
        let links = if side_by_side { &self.right } else { &self.below };
        links[first] > 0.0
    }

    /// Diffuses planes; without barriers this is a Gaussian blur of `sigma` cells.
    pub(super) fn diffuse(&self, planes: &mut [Vec<f32>], sigma: f32) {
        if sigma <= 0.0 {
            return;
        }
        let steps = (0.5 * sigma * sigma / MOST_EXCHANGE).ceil();
        let exchange = 0.5 * sigma * sigma / steps;
        let arch = Arch::new();
        planes.par_iter_mut().for_each(|plane| {
            arch.dispatch(
                #[inline(always)]
                || (0..steps as usize).for_each(|_| self.step(plane, exchange)),
            );
        });
    }

    /// One exchange of all neighbours at once; rows are updated as soon as the row below knows what it gets from them.
    #[inline(always)]
    fn step(&self, plane: &mut [f32], exchange: f32) {
        let width = self.size.width as usize;
        // The flow into each cell from its left, and out of the last one: 0 at both ends.
        let mut along = vec![0.0; width + 1];
        let (mut from_above, mut down) = (vec![0.0; width], vec![0.0; width]);
        for start in (0..plane.len()).step_by(width) {
            let (row, next) = plane[start..].split_at_mut(width);
            let (right, below) = (&self.right[start..][..width], &self.below[start..][..width]);
            for (i, flow) in along[1..width].iter_mut().enumerate() {
                *flow = exchange * right[i] * (row[i + 1] - row[i]);
            }
            if next.is_empty() {
                down.fill(0.0);
            } else {
                let next = &next[..width];
                for i in 0..width {
                    down[i] = exchange * below[i] * (next[i] - row[i]);
                }
            }
            for i in 0..width {
                row[i] += (along[i + 1] - along[i]) + (down[i] - from_above[i]);
            }
            std::mem::swap(&mut from_above, &mut down);
        }
    }
}

/// Calls `cross` for every line of centres (at whole numbers plus a half) between two values, with its number and where
/// it lies between `a` (0) and `b` (1).
fn crossings(a: f32, b: f32, mut cross: impl FnMut(usize, f32)) {
    let (low, high) = (a.min(b), a.max(b));
    let mut line = (low - 0.5).ceil().max(0.0);
    // Half open, so that a contour through two segments' common point crosses once.
    while line + 0.5 < high {
        cross(line as usize, (line + 0.5 - a) / (b - a));
        line += 1.0;
    }
}

/// Of `count` cells in a row the one whose centre comes last before `at`, if another follows. A contour exactly on a
/// centre separates that cell from both neighbours, so that a mirrored picture has the mirrored barriers.
fn between(at: f32, count: usize) -> impl Iterator<Item = usize> {
    let (low, high) = ((at - 0.5).ceil() - 1.0, (at - 0.5).floor());
    let inside = move |cell: &f32| *cell >= 0.0 && *cell + 1.0 < count as f32;
    [Some(low), (high > low).then_some(high)].into_iter().flatten().filter(inside).map(|cell| cell as usize)
}

/// A picture on its grid of cells.
pub(super) struct BlurCells {
    pub(super) size: Size,
    /// Blurred planes of the raster, linear light.
    pub(super) planes: Planes<Vec<f32>>,
    /// Share of each cell that does not lie beside a contour; never 0.
    pub(super) weight: Vec<f32>,
    /// 0 where contours are.
    pub(super) conductance: Conductance,
}

impl BlurCells {
    /// The colour of a cell as sRGB values 0..=1, all three alike in a grey picture.
    pub(super) fn colour(&self, cell: usize) -> [f32; 3] {
        self.planes.as_ref().map(|plane| encoded(plane[cell])).as_colour()
    }
}

/// Averages the picture over cells and blurs it with `sigma` (cells), both without crossing `contours`. Pixels nearer
/// to a contour than `beside` px hardly count.
pub(super) fn average(
    raster: &Raster,
    contours: &[Polyline<PxPoint>],
    size: Size,
    sigma: f32,
    beside: f32,
) -> BlurCells {
    let from = raster.size();
    let mut conductance = Conductance::open(size);
    if contours.is_empty() {
        let mut planes = raster.planes().as_ref().map(|plane| shrink(plane, from, size).values);
        conductance.diffuse(planes.as_mut_slice(), sigma);
        return BlurCells { size, planes, weight: vec![1.0; size.len()], conductance };
    }
    let (sx, sy) = (size.width as f32 / from.width as f32, size.height as f32 / from.height as f32);
    for contour in contours {
        conductance.block(contour.path().map(|at| (at.x * sx, at.y * sy)));
    }
    let weights = pixel_weights(contours, from, beside);
    let weight = shrink(&weights, from, size).values;
    // Row by row: a whole plane of products would be written only to be read once.
    let weighted = |plane: &Vec<f32>| {
        let width = from.width as usize;
        let mut shrinker = Shrinker::new(from, size);
        let mut row = vec![0.0; width];
        for (values, weights) in plane.chunks_exact(width).zip(weights.chunks_exact(width)) {
            row.iter_mut().zip(values).zip(weights).for_each(|((row, value), weight)| *row = value * weight);
            shrinker.push(&row);
        }
        shrinker.finish().values
    };
    let mut planes = raster.planes().as_ref().par_map(weighted);
    let mut total = [weight.clone()];
    rayon::join(|| conductance.diffuse(planes.as_mut_slice(), sigma), || conductance.diffuse(&mut total, sigma));
    for plane in planes.as_mut_slice() {
        plane.iter_mut().zip(&total[0]).for_each(|(value, weight)| *value /= weight);
    }
    BlurCells { size, planes, weight, conductance }
}

/// Weight of every pixel: 1 if its centre is `beside` px or more away from the points of all contours, else
/// [`BESIDE_WEIGHT`].
fn pixel_weights(contours: &[Polyline<PxPoint>], size: Size, beside: f32) -> Vec<f32> {
    let mut weights = Plane::filled(size, 1.0).values;
    let pixels = |at: f32, most: u32| {
        let first = (at - beside - 0.5).ceil().max(0.0) as usize;
        let last = (at + beside - 0.5).floor().min(most as f32 - 1.0);
        first..(last + 1.0).max(0.0) as usize
    };
    for at in contours.iter().flat_map(|contour| &contour.vertices) {
        for y in pixels(at.y, size.height) {
            let dy = y as f32 + 0.5 - at.y;
            for x in pixels(at.x, size.width) {
                let dx = x as f32 + 0.5 - at.x;
                if dx * dx + dy * dy < beside * beside {
                    weights[y * size.width as usize + x] = BESIDE_WEIGHT;
                }
            }
        }
    }
    weights
}

#[cfg(test)]
mod tests;
