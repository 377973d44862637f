//! Statistics of the colours on both sides of an edge, and of the edges in its surround.
//!
//! Three quantities are gathered row by row, each on a grid as coarse as possible:
//! * the mean colour of small cells. The edge-stopping filter ([`super::edge_stopping`]) then averages them where no
//!   edge separates them. The difference that is left between the two sides of an edge tells a contour from texture;
//! * the variance of the colours on both sides: texture has it on both sides, an outline seldom does;
//! * the surround: the mean gradient in a wide window.
//!
//! The strength of an edge is computed from them in [`super::strength`].

use std::ops::Range;

use super::chain::Chain;
use super::edge_stopping::{Barriers, WeightedColour};
use super::gradient::TensorRow;
use super::params::Params;
use super::ridge::RidgePoint;
use crate::raster::plane::Plane;
use crate::raster::shrink::Shrinker;
use crate::units::{PxPoint, PxVector, Size};

/// Sigma of the window of the surround, in cells: 25 px on photographs of 481 x 321 pixels. There, half of it scored
/// .004 less, and so did the mean over the whole picture.
const SURROUND: f32 = 5.0;

/// Gradients in one common direction are subtracted from the surround, and the rest is multiplied with this factor,
/// but never exceeds the whole. So the surround is reduced once more than 0.8 of its gradients share a direction: the
/// steps of a stair and the bars of a fence are no texture. A share of 0.6 would lower the score by .002, of none by
/// .02.
const NOT_PARALLEL: f32 = 5.0;

/// A gradient this small has no direction.
const TINY: f32 = 1e-6;

/// Gathers colours and gradients row by row.
pub(super) struct StatisticsBuilder {
    /// Size of the picture, px.
    picture: Size,
    params: Params,
    colours: Vec<Shrinker>,
    square: Shrinker,
    /// The length of the gradient, and its length times cosine and sine of the double angle of its direction.
    gradient: [Shrinker; 3],
    /// Buffer for one row.
    row: Vec<f32>,
}

/// The statistics of a picture, ready for queries.
pub(super) struct SideStatistics {
    /// Size of the picture, px.
    picture: Size,
    /// Distance from the edge at which colours are compared, px.
    offset: f32,
    grid: Size,
    /// In each cell the means of (up to) three colour axes, and the mean of the sum of their squares.
    cells: Vec<WeightedColour>,
    /// The same colours after the edge-stopping filter.
    filtered: Vec<WeightedColour>,
    /// Mean gradient, as the sum of the heights of all edges on a straight line through the window, less the part that
    /// noise causes.
    surround: Plane,
}

/// The two sides of an edge compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sides {
    /// Distance between the filtered colours of the two sides, units of strength.
    pub(super) difference: f32,
    /// Variance of the colours on the side with less of it.
    pub(super) variance: f32,
}

impl StatisticsBuilder {
    /// For a picture of `size`; the cells that begin in the rows `own` are filled.
    pub(super) fn new(size: Size, planes: usize, params: &Params, own: Range<usize>) -> Self {
        let fine = grid_size(size, params.side_cell);
        let coarse = grid_size(size, SURROUND * params.side_cell);
        let shrinker = |cells| Shrinker::part(size, cells, own.clone());
        Self {
            picture: size,
            params: *params,
            colours: (0..planes).map(|_| shrinker(fine)).collect(),
            square: shrinker(fine),
            gradient: [(); 3].map(|()| shrinker(coarse)),
            row: vec![0.0; size.width as usize],
        }
    }

    /// The rows of colours that the cells need.
    pub(super) fn colour_rows(&self) -> Range<usize> {
        self.square.rows()
    }

    /// The rows of the tensor that the cells need.
    pub(super) fn tensor_rows(&self) -> Range<usize> {
        self.gradient[0].rows()
    }

    /// Sets the numbers of the first rows that are pushed, if they are not the first of the picture.
    pub(super) fn start(&mut self, colour_row: usize, tensor_row: usize) {
        self.colours.iter_mut().chain([&mut self.square]).for_each(|shrinker| shrinker.skip_to(colour_row));
        self.gradient.iter_mut().for_each(|shrinker| shrinker.skip_to(tensor_row));
    }

    /// Appends the cells of the band below.
    pub(super) fn append(&mut self, below: Self) {
        let own = self.colours.iter_mut().chain([&mut self.square]).chain(&mut self.gradient);
        let more = below.colours.into_iter().chain([below.square]).chain(below.gradient);
        own.zip(more).for_each(|(own, more)| own.append(more));
    }

    pub(super) fn push_colours(&mut self, planes: &[Vec<f32>]) {
        self.row.fill(0.0);
        for (plane, shrinker) in planes.iter().zip(&mut self.colours) {
            shrinker.push(plane);
            self.row.iter_mut().zip(plane).for_each(|(sum, v)| *sum += v * v);
        }
        self.square.push(&self.row);
    }

    pub(super) fn push_tensor(&mut self, row: &TensorRow) {
        let width = self.picture.width as usize;
        let (xx, xy, yy, length) = (&row.xx[..width], &row.xy[..width], &row.yy[..width], &row.length[..width]);
        let [lengths, cosines, sines] = &mut self.gradient;
        lengths.push(length);
        for (((to, xx), yy), length) in self.row.iter_mut().zip(xx).zip(yy).zip(length) {
            *to = (xx - yy) / length.max(TINY);
        }
        cosines.push(&self.row);
        for ((to, xy), length) in self.row.iter_mut().zip(xy).zip(length) {
            *to = 2.0 * xy / length.max(TINY);
        }
        sines.push(&self.row);
    }

    /// `noise` is the standard deviation of the step heights that the noise of the picture causes.
    pub(super) fn finish(self, points: &[RidgePoint], chains: &[Chain], noise: f32) -> SideStatistics {
        let Self { picture, params, colours, square, gradient, .. } = self;
        let square = square.finish();
        let grid = square.size;
        // the fourth component is the weight of a cell in the filter
        let mut colour_cells = vec![[0.0, 0.0, 0.0, 1.0]; grid.len()];
        for (axis, shrinker) in colours.into_iter().enumerate().take(3) {
            colour_cells.iter_mut().zip(&shrinker.finish().values).for_each(|(cell, &v)| cell[axis] = v);
        }
        let cells = colour_cells.iter().zip(&square.values).map(|(&[a, b, c, _], &square)| [a, b, c, square]).collect();
        let filtered = Barriers::new(grid, picture, points, chains).filter(&colour_cells);
        let surround = surround(gradient, picture, &params, noise);
        SideStatistics { picture, offset: params.side_offset, grid, cells, filtered, surround }
    }
}

/// The surround: the summed heights of the edges in a wide window, without noise and without what runs in one
/// direction.
fn surround(gradient: [Shrinker; 3], picture: Size, params: &Params, noise: f32) -> Plane {
    let reach = SURROUND * params.side_cell;
    let [mut surround, cosines, sines] = gradient.map(|shrinker| {
        let plane = shrinker.finish();
        let (x, y) = scale(plane.size, picture);
        plane.blurred(reach * (x * y).sqrt())
    });
    // a straight step of height 1 through the middle of the window has a mean gradient of 1 / (sqrt(tau) sigma)
    let heights = std::f32::consts::TAU.sqrt() * reach;
    // Noise of one axis has a step height of sqrt(tau) sigma times its gradient; the mean length of the gradient of
    // both axes is sqrt(pi / 2) times that.
    let noise = (std::f32::consts::FRAC_PI_2.sqrt() * noise * reach / params.sigma).powi(2);
    for ((value, cosine), sine) in surround.values.iter_mut().zip(&cosines.values).zip(&sines.values) {
        let all = (*value * heights).powi(2);
        let all = (all - noise).max(0.0).sqrt();
        let parallel = (cosine * cosine + sine * sine).sqrt() * heights;
        *value = all.min(NOT_PARALLEL * (all - parallel).max(0.0));
    }
    surround
}

/// The rows in which the largest cells begin.
pub(super) fn cell_starts(size: Size, params: &Params) -> Vec<usize> {
    Shrinker::new(size, grid_size(size, SURROUND * params.side_cell)).starts()
}

/// Size of a grid of cells of `cell` pixels over a picture.
fn grid_size(size: Size, cell: f32) -> Size {
    let cells = |pixels: u32| ((pixels as f32 / cell.max(1.0)).ceil() as u32).clamp(1, pixels);
    Size::new(cells(size.width), cells(size.height))
}

/// Cells per pixel along x and y.
fn scale(grid: Size, picture: Size) -> (f32, f32) {
    (grid.width as f32 / picture.width as f32, grid.height as f32 / picture.height as f32)
}

impl SideStatistics {
    /// Compares the two sides of an edge at `at`.
    pub(super) fn sides(&self, at: PxPoint, normal: PxVector) -> Sides {
        let positions = [at - normal * self.offset, at + normal * self.offset].map(|at| self.position(at));
        let [left, right] = positions.map(|position| position.look_up(&self.filtered));
        let [x, y, z] = [0, 1, 2].map(|axis| right[axis] - left[axis]);
        let [left, right] = positions.map(|position| {
            let [x, y, z, square] = position.look_up(&self.cells);
            square - x * x - y * y - z * z
        });
        Sides {
            difference: (x * x + y * y + z * z).sqrt(),
            variance: left.min(right).max(0.0), // rounding may make it negative
        }
    }

    /// The surround of `at`: the summed heights of the edges on a straight line through the window.
    pub(super) fn surround(&self, at: PxPoint) -> f32 {
        let (x, y) = scale(self.surround.size, self.picture);
        self.surround.at(at.x * x, at.y * y)
    }

    /// The position in the grid of a point of the picture, px; beyond the border the nearest cell is used.
    fn position(&self, at: PxPoint) -> GridPosition {
        let (width, height) = (self.grid.width as usize, self.grid.height as usize);
        let (x_scale, y_scale) = scale(self.grid, self.picture);
        let fx = (at.x * x_scale - 0.5).clamp(0.0, (width - 1) as f32);
        let fy = (at.y * y_scale - 0.5).clamp(0.0, (height - 1) as f32);
        let (column, row) = (fx as usize, fy as usize);
        GridPosition {
            first: row * width + column,
            right: usize::from(column + 1 < width),
            down: if row + 1 < height { width } else { 0 },
            x: fx - column as f32,
            y: fy - row as f32,
        }
    }
}

/// A position between four cells, for bilinear interpolation.
#[derive(Clone, Copy)]
struct GridPosition {
    /// Index of the upper left cell.
    first: usize,
    /// Index distance of its right neighbour; 0 at the border.
    right: usize,
    /// Index distance of the cell below; 0 at the border.
    down: usize,
    /// Fractional position between the cells, 0..1.
    x: f32,
    y: f32,
}

impl GridPosition {
    fn look_up(&self, cells: &[WeightedColour]) -> WeightedColour {
        let [a, b] = [0, self.right].map(|right| &cells[self.first + right]);
        let [c, d] = [0, self.right].map(|right| &cells[self.first + self.down + right]);
        std::array::from_fn(|i| {
            let above = a[i] * (1.0 - self.x) + b[i] * self.x;
            let below = c[i] * (1.0 - self.x) + d[i] * self.x;
            above * (1.0 - self.y) + below * self.y
        })
    }
}

#[cfg(test)]
mod tests;
