//! What lies on both sides of an edge, and how much else there is to see around it.
//!
//! Three things are gathered while the rows go by, each on a grid as coarse as it may be:
//! * the mean colour of small cells. They [`flow`](super::flow) together where no edge parts them, and what two places
//!   beside an edge still differ by then tells a contour from texture;
//! * the spread of the colours around these places: texture has it on both sides, an outline seldom does;
//! * how busy the surroundings are: the mean gradient in a wide window.
//!
//! What they say about an edge is put together in [`super::strength`].

use std::ops::Range;

use super::Params;
use super::chain::Chain;
use super::flow::{self, Cell};
use super::gradient::TensorRow;
use super::thin::Ridge;
use crate::raster::plane::{Plane, Shrinker};
use crate::units::{PxPoint, Size};

/// Sigma of the surroundings, in cells: 25 px of photographs of 481 x 321, where half of it scored less by .004 and the
/// mean over the whole picture as well.
const SURROUNDINGS: f32 = 5.0;

/// Surroundings count as busy by all gradients less those that point one way, times this, but never by more than all: from
/// 0.8 of them on, surroundings count the less the more point one way. Steps of a stair and bars of a fence are no texture.
/// From 0.6 on it would take .002 from the score, from none .02.
const PARALLEL: f32 = 5.0;

/// A gradient this small has no direction.
const TINY: f32 = 1e-6;

/// Gathers colours and gradients while they are computed row by row.
pub(super) struct Builder {
    from: Size,
    params: Params,
    colours: Vec<Shrinker>,
    square: Shrinker,
    /// The gradient's length, and the same times cosine and sine of the double angle of its direction.
    gradient: [Shrinker; 3],
    sums: Vec<f32>,
}

/// Side statistics, ready to be asked.
pub(super) struct Sides {
    from: Size,
    offset: f32,
    grid: Size,
    /// In each cell the mean of (up to) three colour axes, and of the sum of their squares.
    cells: Vec<Cell>,
    /// The same colours after they have flowed.
    flowed: Vec<Cell>,
    /// Mean gradient, as the heights of all edges that one meets on a straight way through the window, without what noise
    /// adds.
    busy: Plane,
}

/// What lies beside an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Beside {
    /// Distance of the flowed colours on both sides, units of strength.
    pub(super) difference: f32,
    /// Variance of the colours around the calmer of the two places.
    pub(super) variance: f32,
}

impl Builder {
    /// For a picture of `size`, of which the cells are filled that begin in the rows `own`.
    pub(super) fn new(size: Size, planes: usize, params: &Params, own: Range<usize>) -> Self {
        let fine = cells(size, params.side_cell);
        let coarse = cells(size, SURROUNDINGS * params.side_cell);
        let shrinker = |cells| Shrinker::part(size, cells, own.clone());
        Self {
            from: size,
            params: *params,
            colours: (0..planes).map(|_| shrinker(fine)).collect(),
            square: shrinker(fine),
            gradient: [(); 3].map(|()| shrinker(coarse)),
            sums: vec![0.0; size.width as usize],
        }
    }

    /// The rows of colours that its cells need.
    pub(super) fn rows_of_colours(&self) -> Range<usize> {
        self.square.rows()
    }

    /// The rows of the tensor that its cells need.
    pub(super) fn rows_of_tensors(&self) -> Range<usize> {
        self.gradient[0].rows()
    }

    /// Says which rows come first, if not those of the picture.
    pub(super) fn start(&mut self, of_colours: usize, of_tensors: usize) {
        self.colours.iter_mut().chain([&mut self.square]).for_each(|shrinker| shrinker.start(of_colours));
        self.gradient.iter_mut().for_each(|shrinker| shrinker.start(of_tensors));
    }

    /// Adds the cells below its own.
    pub(super) fn append(&mut self, below: Self) {
        let own = self.colours.iter_mut().chain([&mut self.square]).chain(&mut self.gradient);
        let more = below.colours.into_iter().chain([below.square]).chain(below.gradient);
        own.zip(more).for_each(|(own, more)| own.append(more));
    }

    pub(super) fn push_colours(&mut self, planes: &[Vec<f32>]) {
        self.sums.fill(0.0);
        for (plane, shrinker) in planes.iter().zip(&mut self.colours) {
            shrinker.push(plane);
            self.sums.iter_mut().zip(plane).for_each(|(sum, v)| *sum += v * v);
        }
        self.square.push(&self.sums);
    }

    pub(super) fn push_tensor(&mut self, row: &TensorRow) {
        let width = self.from.width as usize;
        let (xx, xy, yy, length) = (&row.xx[..width], &row.xy[..width], &row.yy[..width], &row.length[..width]);
        let [lengths, cosines, sines] = &mut self.gradient;
        lengths.push(length);
        for (((to, xx), yy), length) in self.sums.iter_mut().zip(xx).zip(yy).zip(length) {
            *to = (xx - yy) / length.max(TINY);
        }
        cosines.push(&self.sums);
        for ((to, xy), length) in self.sums.iter_mut().zip(xy).zip(length) {
            *to = 2.0 * xy / length.max(TINY);
        }
        sines.push(&self.sums);
    }

    /// `noise` is the standard deviation of the step height that the picture's noise pretends.
    pub(super) fn finish(self, points: &[Ridge], chains: &[Chain], noise: f32) -> Sides {
        let Self { from, params, colours, square, gradient, .. } = self;
        let square = square.finish();
        let grid = square.size;
        // the weight with which a cell starts to flow
        let mut flowed = vec![[0.0, 0.0, 0.0, 1.0]; grid.len()];
        for (axis, shrinker) in colours.into_iter().enumerate().take(3) {
            flowed.iter_mut().zip(&shrinker.finish().values).for_each(|(cell, &v)| cell[axis] = v);
        }
        let cells = flowed.iter().zip(&square.values).map(|(&[a, b, c, _], &square)| [a, b, c, square]).collect();
        let flowed = flow::flow(&flowed, grid, from, points, chains);

        let reach = SURROUNDINGS * params.side_cell;
        let [mut busy, cosines, sines] = gradient.map(|shrinker| {
            let plane = shrinker.finish();
            let (x, y) = scale(plane.size, from);
            plane.blurred(reach * (x * y).sqrt())
        });
        // A straight step of height 1 through the middle of the window has a mean gradient of 1 / (sqrt(tau) sigma).
        let heights = std::f32::consts::TAU.sqrt() * reach;
        // Noise of one axis has a step height of sqrt(tau) sigma times its gradient; the length of the gradient of both
        // axes is sqrt(pi / 2) of that in the mean.
        let noise = (std::f32::consts::FRAC_PI_2.sqrt() * noise * reach / params.sigma).powi(2);
        for ((busy, cosine), sine) in busy.values.iter_mut().zip(&cosines.values).zip(&sines.values) {
            let all = (*busy * heights).powi(2);
            let all = (all - noise).max(0.0).sqrt();
            let one_way = (cosine * cosine + sine * sine).sqrt() * heights;
            *busy = all.min(PARALLEL * (all - one_way).max(0.0));
        }
        Sides { from, offset: params.side_offset, grid, cells, flowed, busy }
    }
}

/// The rows in which the largest cells begin.
pub(super) fn rows_of_cells(size: Size, params: &Params) -> Vec<usize> {
    Shrinker::new(size, cells(size, SURROUNDINGS * params.side_cell)).starts()
}

fn cells(size: Size, cell: f32) -> Size {
    let cells = |pixels: u32| ((pixels as f32 / cell.max(1.0)).ceil() as u32).clamp(1, pixels);
    Size::new(cells(size.width), cells(size.height))
}

/// Cells for a pixel along x and y.
fn scale(grid: Size, from: Size) -> (f32, f32) {
    (grid.width as f32 / from.width as f32, grid.height as f32 / from.height as f32)
}

impl Sides {
    /// What lies beside an edge at `at`.
    pub(super) fn beside(&self, at: PxPoint, normal: [f32; 2]) -> Beside {
        let (dx, dy) = (self.offset * normal[0], self.offset * normal[1]);
        let places = [(at.x - dx, at.y - dy), (at.x + dx, at.y + dy)].map(|(x, y)| self.place(x, y));
        let [left, right] = places.map(|place| place.look_up(&self.flowed));
        let [x, y, z] = [0, 1, 2].map(|axis| right[axis] - left[axis]);
        let [left, right] = places.map(|place| {
            let [x, y, z, square] = place.look_up(&self.cells);
            square - x * x - y * y - z * z
        });
        Beside {
            difference: (x * x + y * y + z * z).sqrt(),
            variance: left.min(right).max(0.0), // rounding may take it below
        }
    }

    /// How busy the surroundings of `at` are: the summed heights of the edges that one meets on a straight way through.
    pub(super) fn busy(&self, at: PxPoint) -> f32 {
        let (x, y) = scale(self.busy.size, self.from);
        self.busy.at(at.x * x, at.y * y)
    }

    /// The cells around a place in the picture, px; beyond the border the nearest counts.
    fn place(&self, x: f32, y: f32) -> Place {
        let (width, height) = (self.grid.width as usize, self.grid.height as usize);
        let (x_scale, y_scale) = scale(self.grid, self.from);
        let fx = (x * x_scale - 0.5).clamp(0.0, (width - 1) as f32);
        let fy = (y * y_scale - 0.5).clamp(0.0, (height - 1) as f32);
        let (column, row) = (fx as usize, fy as usize);
        Place {
            first: row * width + column,
            right: usize::from(column + 1 < width),
            down: if row + 1 < height { width } else { 0 },
            x: fx - column as f32,
            y: fy - row as f32,
        }
    }
}

/// A place between four cells, for bilinear look-ups.
#[derive(Clone, Copy)]
struct Place {
    /// Number of the upper left cell.
    first: usize,
    /// How much further its neighbours are.
    right: usize,
    down: usize,
    x: f32,
    y: f32,
}

impl Place {
    fn look_up(&self, cells: &[Cell]) -> Cell {
        let [a, b] = [0, self.right].map(|right| &cells[self.first + right]);
        let [c, d] = [0, self.right].map(|right| &cells[self.first + self.down + right]);
        std::array::from_fn(|i| {
            let above = a[i] * (1.0 - self.x) + b[i] * self.x;
            let below = c[i] * (1.0 - self.x) + d[i] * self.x;
            above * (1.0 - self.y) + below * self.y
        })
    }
}
