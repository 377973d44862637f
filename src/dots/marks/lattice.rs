//! Where dots can be, in steps from one to the next: on a grid, or anywhere.

use std::collections::BTreeMap;

use crate::devices::Grid;
use crate::dots::grid_dot::{GridBox, GridDot, GridPoint, centre, nearest, to_grid};
use crate::dots::params::{LEAST_STEP, ROUNDED_OFF};
use crate::units::{MmPoint, MmRect, MmVector};

/// Dots of a grid are whole steps apart; elsewhere rounding takes something off a distance.
const ROUNDING: f32 = 1e-3;

/// Where dots can be.
#[derive(Debug, Clone, Copy)]
pub(in crate::dots) enum Lattice<'a> {
    /// On a part of a grid.
    Grid { grid: &'a Grid, within: GridBox },
    /// Anywhere in a part of the sheet, so many mm apart.
    Free { part: MmRect, pitch: f32 },
}

impl Lattice<'_> {
    /// A place in steps; on a grid it may lie between dots.
    pub(super) fn to_steps(self, at: MmPoint) -> GridPoint {
        match self {
            Self::Grid { grid, .. } => to_grid(at, grid),
            Self::Free { pitch, .. } => [at.x / pitch, at.y / pitch],
        }
    }

    /// The place of a dot on the sheet.
    pub(super) fn to_mm(self, dot: GridPoint) -> MmPoint {
        match self {
            Self::Grid { grid, .. } => centre(nearest(dot), grid),
            Self::Free { pitch, .. } => MmPoint::new(dot[0] * pitch, dot[1] * pitch),
        }
    }

    /// Whether a dot can be pressed.
    pub(super) fn holds(self, dot: GridPoint) -> bool {
        match self {
            Self::Grid { within, .. } => within.holds(nearest(dot)),
            Self::Free { part, .. } => part.inflate(ROUNDED_OFF, ROUNDED_OFF).contains_inclusive(self.to_mm(dot)),
        }
    }

    /// The distance of two dots in steps; on a grid those along a diagonal count as one.
    pub(super) fn steps(self, a: GridPoint, b: GridPoint) -> f32 {
        let [dx, dy] = [(a[0] - b[0]).abs(), (a[1] - b[1]).abs()];
        match self {
            Self::Grid { .. } => dx.max(dy),
            Self::Free { .. } => dx.hypot(dy),
        }
    }

    /// Whether two dots are one, or too near to press both.
    pub(super) fn are_one(self, a: GridPoint, b: GridPoint) -> bool {
        self.steps(a, b) < LEAST_STEP
    }

    /// Whether fewer than `gap` empty dots lie between two dots.
    pub(super) fn are_near(self, a: GridPoint, b: GridPoint, gap: f32) -> bool {
        self.steps(a, b) < gap + 1.0 - ROUNDING
    }

    /// Dots from a dot on in a direction of the sheet, without itself: at least so many of them.
    pub(super) fn outward(self, from: GridPoint, way: MmVector, count: usize) -> Vec<GridPoint> {
        let at = self.to_mm(from);
        match self {
            Self::Grid { .. } => {
                // a direction of the sheet in steps, which may be uneven
                let to = self.to_steps(at + way);
                let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
                let scale = (count + 1) as f32 / dx.abs().max(dy.abs()).max(f32::MIN_POSITIVE);
                let end = [from[0] + dx * scale, from[1] + dy * scale];
                straight(nearest(from), end).into_iter().skip(1).map(point).collect()
            }
            Self::Free { .. } => {
                (1..=count + 1).map(|k| [from[0] + k as f32 * way.x, from[1] + k as f32 * way.y]).collect()
            }
        }
    }

    /// A ring of dots of about this radius, in steps, around the dot nearest to a place: that dot, the dots of the ring
    /// in order, each a step from the next, and those inside.
    pub(super) fn ring(self, at: GridPoint, radius: i32) -> (GridPoint, DotDisc) {
        let middle = if let Self::Grid { .. } = self { point(nearest(at)) } else { at };
        let mut disc = self.disc(middle, MmVector::new(1.0, 0.0), radius);
        match self {
            Self::Grid { .. } => {
                let turn = |dot: &GridPoint| (dot[1] - middle[1]).atan2(dot[0] - middle[0]);
                disc.around.sort_by(|a, b| turn(a).total_cmp(&turn(b)));
            }
            Self::Free { .. } => {
                // six dots around one would be no ring yet
                let count = (6 * radius).max(8);
                let turn = std::f32::consts::TAU / count as f32;
                let radius = 0.5 / (0.5 * turn).sin();
                let dot = |k: i32| {
                    let (sin, cos) = (k as f32 * turn).sin_cos();
                    [middle[0] + radius * cos, middle[1] + radius * sin]
                };
                disc.around = (0..count).map(dot).collect();
            }
        }
        (middle, disc)
    }

    /// The dots of a disc of this radius, in steps: those around it, and those inside.
    pub(super) fn disc(self, middle: GridPoint, along: MmVector, radius: i32) -> DotDisc {
        match self {
            Self::Grid { .. } => {
                let is_in = |dx: i32, dy: i32| (dx * dx + dy * dy) as f32 <= (radius as f32 + 0.5).powi(2);
                let all = (-radius..=radius).flat_map(|dy| (-radius..=radius).map(move |dx| (dx, dy)));
                let (inside, around): (Vec<_>, Vec<_>) =
                    all.filter(|&(dx, dy)| is_in(dx, dy)).partition(|&(dx, dy)| {
                        [(1, 0), (-1, 0), (0, 1), (0, -1)].iter().all(|(x, y)| is_in(dx + x, dy + y))
                    });
                let dot = |(dx, dy): (i32, i32)| [middle[0] + dx as f32, middle[1] + dy as f32];
                DotDisc { around: around.into_iter().map(dot).collect(), inside: inside.into_iter().map(dot).collect() }
            }
            Self::Free { .. } => {
                let first = along.angle_from_x_axis().radians;
                // six dots a step apart lie a step from the middle
                let ring = |steps: i32| {
                    (0..6 * steps).map(move |k| {
                        let (sin, cos) = (first + std::f32::consts::TAU * k as f32 / (6 * steps) as f32).sin_cos();
                        [middle[0] + steps as f32 * cos, middle[1] + steps as f32 * sin]
                    })
                };
                let inside = std::iter::once(middle).chain((1..radius).flat_map(ring)).collect();
                DotDisc { around: ring(radius).collect(), inside }
            }
        }
    }
}

/// The dots of a point.
pub(super) struct DotDisc {
    pub(super) around: Vec<GridPoint>,
    pub(super) inside: Vec<GridPoint>,
}

/// The cells along a straight line from a cell to a place, in steps.
fn straight(from: GridDot, to: GridPoint) -> Vec<GridDot> {
    let steps = (to[0] - from[0] as f32).abs().max((to[1] - from[1] as f32).abs()).round().max(1.0);
    let at = |k: f32, axis: usize| from[axis] as f32 + (to[axis] - from[axis] as f32) * k / steps;
    (0..=steps as u32).map(|k| nearest([at(k as f32, 0), at(k as f32, 1)])).collect()
}

fn point(cell: GridDot) -> GridPoint {
    cell.map(|at| at as f32)
}

/// What a dot belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// A row of dots, and its number there.
    Row(usize, usize),
    /// A tick of a scale.
    Tick(usize, usize),
}

/// Dots that are there, by place.
pub(super) struct MarkField<'a> {
    pub(super) lattice: Lattice<'a>,
    dots: BTreeMap<GridDot, Vec<(GridPoint, Owner)>>,
}

impl<'a> MarkField<'a> {
    pub(super) fn new(lattice: Lattice<'a>) -> Self {
        Self { lattice, dots: BTreeMap::new() }
    }

    pub(super) fn put(&mut self, dot: GridPoint, owner: Owner) {
        self.dots.entry(nearest(dot)).or_default().push((dot, owner));
    }

    pub(super) fn take_out(&mut self, owner: impl Fn(GridPoint, Owner) -> bool, around: GridPoint, reach: f32) {
        for cell in cells(around, reach) {
            if let Some(dots) = self.dots.get_mut(&cell) {
                dots.retain(|&(dot, of)| !owner(dot, of));
            }
        }
    }

    /// Dots no farther than `reach` from a place, in steps, with their distances.
    pub(super) fn around(&self, at: GridPoint, reach: f32) -> impl Iterator<Item = (f32, GridPoint, Owner)> + '_ {
        let dots = cells(at, reach).filter_map(|cell| self.dots.get(&cell)).flatten();
        dots.map(move |&(dot, owner)| (self.lattice.steps(at, dot), dot, owner)).filter(move |(far, ..)| *far <= reach)
    }
}

/// The cells in which dots no farther than `reach` may be.
fn cells(at: GridPoint, reach: f32) -> impl Iterator<Item = GridDot> {
    let [columns, rows] = at.map(|at| (at - reach).floor() as i32..=(at + reach).ceil() as i32);
    rows.flat_map(move |y| columns.clone().map(move |x| [x, y]))
}
