//! Things that may be letters: connected parts that are thin and stand out from what is around them.
//!
//! A top-hat transform leaves what a square does not fit into, lighter or darker than its ground, whatever the ground
//! is. Half of the largest contrast nearby is where the edge of a smoothed letter lies, so that letters a pixel apart
//! do not run together.

use std::cell::OnceCell;

use super::levels::{Colours, Contrast, Levels};
use crate::geom::components::{self, Connectivity};
use crate::raster::plane::Plane;
use crate::raster::residue::Polarity;

/// Half side of the square that strokes of letters are narrower than, px.
const RADIUS: usize = 6;
/// A pixel belongs to a stroke if its contrast is at least half of the largest within so many px: there is the edge
/// of a smoothed letter.
pub(super) const LOCAL: usize = 3;
/// A point or a direction, px from the top left corner.
pub(super) type PixelPoint = [f32; 2];

/// Greatest height of a letter, px.
pub(super) const LARGEST: usize = 72;
/// Greatest length of a word whose letters touch one another, px.
pub(super) const LONGEST: usize = 260;
/// A part with a shorter longer side, px, is no letter.
const LEAST_SIDE: usize = 4;
/// A part of fewer pixels is a dot at most.
const LEAST_AREA: usize = 5;
/// A part that fills less of its convex hull than this is no bar and no dot.
const SOLID: f32 = 0.82;
/// A part whose hull is so much wider than its stroke is no bar.
const BAR: f32 = 1.5;
/// A part that has no more pixels than this, in longer sides of its box, is a piece of a bent line a pixel wide: a line
/// thinner than a pixel comes apart where it passes from one row of pixels to the next.
const HAIRLINE: f32 = 1.25;
/// Where a letter has its full colour: at this share of the largest contrast within [`LOCAL`] px.
const CORE: f32 = 0.85;

/// A connected part of a picture.
#[derive(Debug, Clone)]
pub(super) struct LetterShape {
    /// Its pixels.
    pub(super) cells: Vec<usize>,
    /// First column and row.
    pub(super) min: [usize; 2],
    /// Last column and row.
    pub(super) max: [usize; 2],
    /// Whether it is large and clear enough for a letter; dots are not. Of others, the numbers below are 0.
    pub(super) is_letter: bool,
    /// Mean contrast with the ground, where it is greatest.
    pub(super) contrast: f32,
    /// Mean colour there: lightness and twice a and b.
    pub(super) colour: [f32; 3],
    /// Width of its stroke, px.
    pub(super) stroke: f32,
    /// Standard deviation of its colour there, in contrasts.
    pub(super) unevenness: f32,
    /// Columns of the picture.
    width: usize,
    hull: OnceCell<Vec<PixelPoint>>,
}

impl LetterShape {
    /// Corners of its convex hull, px.
    fn hull(&self) -> &[PixelPoint] {
        self.hull.get_or_init(|| {
            let mut rows = vec![[usize::MAX, 0]; self.max[1] + 1 - self.min[1]];
            for &cell in &self.cells {
                let (x, y) = (cell % self.width, cell / self.width);
                let [low, high] = &mut rows[y - self.min[1]];
                (*low, *high) = ((*low).min(x), (*high).max(x + 1));
            }
            hull(&rows, self.min[1])
        })
    }

    /// Share of its convex hull that it fills.
    pub(super) fn solidity(&self) -> f32 {
        let count = self.cells.len() as f32;
        count / area(self.hull()).max(count)
    }

    /// Its box: top left and bottom right.
    pub(super) fn bounds(&self) -> [PixelPoint; 2] {
        let [right, bottom] = self.max.map(|last| (last + 1) as f32);
        [self.min.map(|first| first as f32), [right, bottom]]
    }

    /// The larger side of its box.
    pub(super) fn side(&self) -> f32 {
        [0, 1].map(|axis| (self.max[axis] + 1 - self.min[axis]) as f32).into_iter().fold(0.0, f32::max)
    }

    /// Whether a pixel of it is within so many columns and rows of one of another shape.
    pub(super) fn is_within(&self, other: &Self, reach: usize) -> bool {
        let are_near =
            (0..2).all(|axis| self.min[axis] <= other.max[axis] + reach && other.min[axis] <= self.max[axis] + reach);
        let place = |cell: usize| [cell % self.width, cell / self.width];
        let is_near = |a: usize, b: usize| (0..2).all(|axis| place(a)[axis].abs_diff(place(b)[axis]) <= reach);
        are_near && self.cells.iter().any(|&a| other.cells.iter().any(|&b| is_near(a, b)))
    }

    /// Whether it has the shape of a bar or a dot, or is a piece of a line a pixel wide.
    pub(super) fn is_solid(&self) -> bool {
        self.solidity() >= SOLID
            || breadth(self.hull()) <= BAR * self.stroke + 1.0
            || self.cells.len() as f32 <= HAIRLINE * self.side()
    }

    /// How far it reaches along a direction.
    pub(super) fn reach(&self, direction: PixelPoint) -> [f32; 2] {
        self.hull().iter().fold([f32::MAX, f32::MIN], |[low, high], at| {
            let along = at[0] * direction[0] + at[1] * direction[1];
            [low.min(along), high.max(along)]
        })
    }
}

/// By how much what is thin in a plane is darker or lighter than its ground; none if nothing is by `wanted`.
pub(super) fn contrast(levels: &Levels, polarity: Polarity, wanted: f32) -> Option<Contrast> {
    levels.contrast(RADIUS, LOCAL, polarity, wanted)
}

/// What is thin in a plane.
pub(super) struct Thin {
    /// Whether each pixel belongs to something thin.
    pub(super) set: Vec<bool>,
    /// The contrast of each pixel with its ground.
    pub(super) contrast: Contrast,
}

/// The connected parts of what is thin, but for those that are too large. `is_clear` tells by contrast and unevenness
/// whether one may be a letter.
pub(super) fn glyphs(
    thin: &Thin,
    plane: &Plane,
    colours: &Colours<'_>,
    is_clear: impl Fn(f32, f32) -> bool,
) -> Vec<LetterShape> {
    let (set, contrast) = (&thin.set[..], &thin.contrast);
    let size = contrast.size;
    let width = size.width as usize;
    let mut found = Vec::new();
    for cells in components::of_set(set, size, Connectivity::Eight) {
        if cells.len() > LARGEST * LONGEST {
            continue;
        }
        let (mut min, mut max) = ([usize::MAX; 2], [0; 2]);
        for &cell in &cells {
            for (axis, at) in [cell % width, cell / width].into_iter().enumerate() {
                (min[axis], max[axis]) = (min[axis].min(at), max[axis].max(at));
            }
        }
        let sides = [0, 1].map(|axis| max[axis] + 1 - min[axis]);
        if sides[0].max(sides[1]) > LONGEST || sides[0].min(sides[1]) > LARGEST {
            continue;
        }
        let mut glyph = LetterShape {
            cells,
            min,
            max,
            is_letter: false,
            contrast: 0.0,
            colour: [0.0; 3],
            stroke: 0.0,
            unevenness: 0.0,
            width,
            hull: OnceCell::new(),
        };
        if glyph.cells.len() >= LEAST_AREA && sides[0].max(sides[1]) >= LEAST_SIDE {
            measure(&mut glyph, thin, plane, colours, &is_clear);
        }
        found.push(glyph);
    }
    found
}

/// Whether something may be a letter, and its numbers if so.
fn measure(
    glyph: &mut LetterShape,
    thin: &Thin,
    plane: &Plane,
    colours: &Colours<'_>,
    is_clear: &impl Fn(f32, f32) -> bool,
) {
    let core: Vec<usize> = glyph.cells.iter().copied().filter(|&cell| thin.contrast.has_share(cell, CORE)).collect();
    let mean = |of: &dyn Fn(usize) -> f32| core.iter().map(|&cell| of(cell)).sum::<f32>() / core.len() as f32;
    let contrast = mean(&|cell| thin.contrast.at(cell));
    let middle = mean(&|cell| plane.values[cell]);
    let variance = mean(&|cell| (plane.values[cell] - middle).powi(2));
    let unevenness = variance.sqrt() / contrast;
    if !is_clear(contrast, unevenness) {
        return;
    }
    let set = &thin.set[..];
    let size = thin.contrast.size;
    let (width, height) = (size.width as usize, size.height as usize);
    // sides of pixels at its border, along x and along y
    let mut borders = 0;
    for &cell in &glyph.cells {
        let (x, y) = (cell % width, cell / width);
        borders += usize::from(x == 0 || !set[cell - 1]) + usize::from(x + 1 == width || !set[cell + 1]);
        borders += usize::from(y == 0 || !set[cell - width]) + usize::from(y + 1 == height || !set[cell + width]);
    }
    // Sides of pixels overstate a border that runs aslant: by 4 / pi on average. A stroke has two borders.
    let perimeter = borders as f32 * std::f32::consts::FRAC_PI_4;
    let mut sum = [0.0; 3];
    for &cell in &core {
        sum.iter_mut().zip(colours.at(cell)).for_each(|(sum, value)| *sum += value);
    }
    glyph.is_letter = true;
    (glyph.contrast, glyph.unevenness) = (contrast, unevenness);
    glyph.colour = sum.map(|sum| sum / core.len() as f32);
    glyph.stroke = 2.0 * glyph.cells.len() as f32 / perimeter.max(1.0);
}

/// Convex hull of rows of pixels (Andrew 1979), each from its first column to behind its last.
fn hull(rows: &[[usize; 2]], top: usize) -> Vec<PixelPoint> {
    let mut points: Vec<PixelPoint> = Vec::new();
    for (row, [low, high]) in rows.iter().enumerate().filter(|(_, [low, high])| low < high) {
        let y = (top + row) as f32;
        points.extend([[*low as f32, y], [*high as f32, y], [*low as f32, y + 1.0], [*high as f32, y + 1.0]]);
    }
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = PixelPoint>| {
        let mut chain: Vec<PixelPoint> = Vec::new();
        for at in points {
            while let [.., a, b] = chain[..] {
                if (b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0]) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(at);
        }
        chain.pop();
        chain
    };
    let mut all = half(&mut points.iter().copied());
    all.extend(half(&mut points.iter().rev().copied()));
    all
}

fn area(corners: &[PixelPoint]) -> f32 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f32>().abs()
}

/// Least width of a convex polygon: across one of its sides.
fn breadth(corners: &[PixelPoint]) -> f32 {
    let next = corners.iter().cycle().skip(1);
    let across = |(a, b): (&PixelPoint, &PixelPoint)| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        corners.iter().map(|at| ((at[0] - a[0]) * dy - (at[1] - a[1]) * dx).abs() / length).fold(0.0, f32::max)
    };
    corners.iter().zip(next).map(across).fold(f32::MAX, f32::min)
}
