//! The face of a dial: what its rim is like, and the ink at its middle.

use lyon::geom::euclid::Box2D;

use crate::edges::contour::Contour;
use crate::geom::order::median;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector};

/// The rim is looked at in so many directions. From one to the opposite one, and to those across, its distance from the
/// middle differs by at most this share; its sides are no nearer than this share of its corners.
const DIRECTIONS: usize = 64;
const UNEVEN: f32 = 0.05;
const SQUARE: f32 = 0.65;
/// So many directions may differ: where something stands on the rim.
const UNLIKE: usize = 12;
/// The ground is read in so many directions, so far from the middle, in radii.
const READ: usize = 48;
const AT: [f32; 5] = [0.3, 0.45, 0.6, 0.7, 0.8];
/// Ink differs from the ground by this much, in units of strength.
const INK: f32 = 20.0;
/// A face with more ink than this share of what was read has other things than hands.
const MOST_INK: f32 = 0.35;
/// The ink is followed from so near to the middle, in radii, and may not come so near to the rim.
const SEED: f32 = 0.08;
const FARTHEST: f32 = 0.93;

/// A dial without its hands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Face {
    pub(super) middle: PxPoint,
    /// To the nearest side of the rim, px.
    pub(super) radius: f32,
    /// The colour of most of it; 0 in planes that there are not.
    pub(super) ground: [f32; 3],
}

impl Face {
    /// That of a round or square rim with such a radius at least, px; its ground is not read yet.
    pub(super) fn within(rim: &Contour, least: f32) -> Option<Self> {
        if !rim.closed || rim.vertices.len() < DIRECTIONS {
            return None;
        }
        let at = || rim.vertices.iter().map(|vertex| vertex.at);
        let extent = Box2D::from_points(at());
        let middle = extent.center();
        if 0.5 * extent.width().min(extent.height()) < least {
            return None;
        }
        let mut farthest = [0.0_f32; DIRECTIONS];
        for at in at() {
            let way = at - middle;
            let share = way.y.atan2(way.x) / std::f32::consts::TAU + 1.0;
            let direction = (share * DIRECTIONS as f32) as usize % DIRECTIONS;
            farthest[direction] = farthest[direction].max(way.length());
        }
        let largest = farthest.iter().copied().fold(0.0, f32::max);
        let radius = farthest.iter().copied().fold(f32::INFINITY, f32::min);
        let differs = |k: usize, by: usize| {
            let other = farthest[(k + by) % DIRECTIONS];
            (farthest[k] - other).abs() > UNEVEN * largest
        };
        let unlike = (0..DIRECTIONS).filter(|&k| differs(k, DIRECTIONS / 2) || differs(k, DIRECTIONS / 4)).count();
        let is_rim = radius >= SQUARE * largest && radius >= least && unlike <= UNLIKE;
        is_rim.then_some(Self { middle, radius, ground: [0.0; 3] })
    }

    /// The ink that is connected at its middle; none if there is none, or if it reaches the rim. The ground is read.
    pub(super) fn ink(&mut self, planes: &[Plane]) -> Option<Ink> {
        let read: Vec<PxPoint> = (0..READ * AT.len())
            .map(|k| {
                let angle = (k % READ) as f32 / READ as f32 * std::f32::consts::TAU;
                self.middle + PxVector::new(angle.cos(), angle.sin()) * (AT[k / READ] * self.radius)
            })
            .collect();
        for (ground, plane) in self.ground.iter_mut().zip(planes) {
            *ground = median(read.iter().map(|at| plane.at(at.x, at.y)));
        }
        let is_ink = |at: PxPoint| {
            let square = |(plane, ground): (&Plane, f32)| (plane.at(at.x, at.y) - ground).powi(2);
            planes.iter().zip(self.ground).map(square).sum::<f32>() >= INK * INK
        };
        let inked = read.iter().filter(|at| is_ink(**at)).count();
        if inked as f32 > MOST_INK * read.len() as f32 {
            return None;
        }
        let side = 2 * (FARTHEST * self.radius).ceil() as usize + 1;
        let mut ink = Ink { middle: self.middle, radius: self.radius, side, cells: vec![false; side * side] };
        ink.follow(&is_ink).then_some(ink)
    }
}

/// The ink at the middle of a dial, on a grid of pixels around it.
#[derive(Debug)]
pub(super) struct Ink {
    pub(super) middle: PxPoint,
    /// Of the dial, px.
    pub(super) radius: f32,
    side: usize,
    cells: Vec<bool>,
}

impl Ink {
    /// Where a cell lies from the middle.
    pub(super) fn way(&self, cell: usize) -> PxVector {
        let half = (self.side / 2) as f32;
        PxVector::new((cell % self.side) as f32 - half, (cell / self.side) as f32 - half)
    }

    fn cell(&self, way: PxVector) -> Option<usize> {
        let half = (self.side / 2) as f32;
        let [column, row] = [way.x + half, way.y + half].map(f32::round);
        let range = 0.0..self.side as f32;
        (range.contains(&column) && range.contains(&row)).then(|| row as usize * self.side + column as usize)
    }

    /// Whether there is ink at a place, so far from the middle.
    pub(super) fn is_at(&self, way: PxVector) -> bool {
        self.cell(way).is_some_and(|cell| self.cells[cell])
    }

    /// Whether there is ink no farther from a place of the picture than this, px.
    pub(super) fn is_near(&self, at: PxPoint, reach: f32) -> bool {
        let (way, steps) = (at - self.middle, reach.ceil() as i32);
        if way.length() > self.radius {
            return false;
        }
        let offsets = (-steps..=steps).flat_map(|y| (-steps..=steps).map(move |x| PxVector::new(x as f32, y as f32)));
        offsets.filter(|offset| offset.length() <= reach).any(|offset| self.is_at(way + offset))
    }

    /// All of it, as places from the middle.
    pub(super) fn places(&self) -> impl Iterator<Item = PxVector> + '_ {
        (0..self.cells.len()).filter(|&cell| self.cells[cell]).map(|cell| self.way(cell))
    }

    /// Follows the ink from the middle on; false if there is none, or if it comes to the rim.
    fn follow(&mut self, is_ink: &dyn Fn(PxPoint) -> bool) -> bool {
        let seeds = (0..self.cells.len()).filter(|&cell| self.way(cell).length() <= SEED * self.radius);
        let mut waiting: Vec<usize> = seeds.filter(|&cell| is_ink(self.middle + self.way(cell))).collect();
        waiting.iter().for_each(|&cell| self.cells[cell] = true);
        let any = !waiting.is_empty();
        while let Some(cell) = waiting.pop() {
            let way = self.way(cell);
            if way.length() >= FARTHEST * self.radius {
                return false;
            }
            for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                let beside = way + PxVector::new(x, y);
                let Some(next) = self.cell(beside).filter(|&next| !self.cells[next]) else { continue };
                if is_ink(self.middle + beside) {
                    self.cells[next] = true;
                    waiting.push(next);
                }
            }
        }
        any
    }
}
