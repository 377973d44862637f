//! Strokes in the pixels: a structure too thin for two lines is one contour, along its middle.
//!
//! ```text
//! Lab -> residue (what a square of a size does not fit into) -> skeleton (thinned to a pixel)
//!     -> arms (joined through junctions) -> parts of one breadth -> centred (sub-pixel, width, contrast, of one tint)
//!     -> those of their own
//!     -> followed (where pixels show no stroke), stubs (short and broad, several of a kind on a stroke) -> Strokes
//! ```
//!
//! A stroke thinner than the scale of the edge detector has no two clean sides: they are found too far out, link with
//! one another, and are torn apart on the page. Its middle can be found to a fraction of a pixel. The narrow squares
//! come first, so that of a grid of thin lines the lines are found and not the gaps between them.
//!
//! Only pictures that are mostly flat are looked at ([`is_drawing`]): a photograph has few strokes, and everything in
//! it that is thin has soft sides.

mod arms;
mod breadth;
mod centre;
mod cover;
mod cut_out;
mod ends;
mod flat;
mod follow;
mod head;
mod skeleton;
mod stubs;
mod tint;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use self::arms::Strand;
pub(super) use self::breadth::are_two as are_two_breadths;
pub(super) use self::centre::Stroke;
use self::cover::Most;
pub(super) use self::cover::StrokeCover;
pub(super) use self::cut_out::is_cut_out;
pub(super) use self::flat::is_drawing;
pub(super) use self::head::{FilledHead, LINE_AT, PlaneColour, filled_heads};
use self::skeleton::{SkeletonNode, SkeletonPath, StrokeMask};
pub(super) use self::tint::Tint;
use super::params::Params;
use crate::geom::components::{self, Connectivity};
use crate::geom::right_of;
use crate::raster::plane::Plane;
use crate::raster::residue::{Polarity, residue, square_max};
use crate::units::{PxPoint, Size};

/// A stroke is kept from this share of the thresholds of edges on: where it is thinner than a pixel, its contrast is
/// less in proportion.
const FAINT: f32 = 0.5;
/// With lossy compression and more noise than this standard deviation of a pixel, in units of strength (a third of a
/// code value), it is kept from the thresholds themselves on: what rings beside contours is no noise.
const QUIET: f32 = 0.13;
/// The thresholds are at least so many standard deviations of the noise: opening and closing find its extremes.
const LOW_NOISE: f32 = 4.0;
const HIGH_NOISE: f32 = 8.0;
/// Width at which pixels show the thinnest strokes, px; up to twice as wide they are taken as equally wide.
const THINNEST: f32 = 1.5;
/// Half sides of the squares, px, the largest as wide as strokes may be.
const SMALLEST_RADIUS: usize = 3;
/// A pixel belongs to a structure if its residue is at least this share of the largest within [`LOCAL`] px.
const SHARE: f32 = 0.45;
const LOCAL: usize = 3;
/// Values below this share of a number have means below that number, whatever rounding adds to them.
const ROUNDED: f32 = 0.999;
/// Strokes whose lengths differ by less than about this, px, are equally long.
const ALIKE: f32 = 16.0;

/// The noise among which strokes are looked for.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PixelNoise {
    /// Standard deviation of a pixel, in units of strength.
    pub(super) deviation: f32,
    /// Whether the picture has lossy compression.
    pub(super) is_lossy: bool,
}

impl PixelNoise {
    /// The parameters with the thresholds of strokes. They grow with the noise and have no jump in a picture without
    /// lossy compression, so that its pale lines do not depend on a code value of noise.
    fn adapted(self, params: &Params) -> Params {
        let Self { deviation, is_lossy } = self;
        let share = if is_lossy && deviation > QUIET { 1.0 } else { FAINT };
        Params {
            low: (share * params.low).max(LOW_NOISE * deviation),
            high: (share * params.high).max(HIGH_NOISE * deviation),
            ..*params
        }
    }
}

/// What is found of the strokes of a drawing.
#[derive(Debug, Default)]
pub(super) struct FoundStrokes {
    /// The strokes, and after them what may be dashes ([`Stroke::is_dash`]), and stubs.
    pub(super) strokes: Vec<Stroke>,
    /// The tip of one of many stubs that are too short.
    pub(super) short_marks: Option<PxPoint>,
}

/// The strokes of a drawing, given as planes of Lab.
pub(super) fn find(planes: &[Plane], noise: PixelNoise, params: &Params) -> FoundStrokes {
    let Some(size) = planes.first().map(|plane| plane.size) else { return FoundStrokes::default() };
    let params = &noise.adapted(params);
    let polarities =
        if params.dark_lines.is_some() { &[Polarity::Below][..] } else { &[Polarity::Below, Polarity::Above] };
    let (mut found, mut stubs) = (Vec::new(), Vec::new());
    for radius in radii(params.widest_of_bitmap()) {
        for plane in planes {
            for &polarity in polarities {
                for (stroke, is_stub) in candidates(plane, radius, polarity, planes, params) {
                    let list = if is_stub { &mut stubs } else { &mut found };
                    list.push((radius, stroke));
                }
            }
        }
    }
    // Narrow before wide, so that what lies between two strokes is no stroke; then long before short, as another plane
    // or square may show but pieces; then as the smallest square shows them.
    let octave = |stroke: &Stroke| (stroke.width / THINNEST).max(1.0).log2() as i32;
    let length = |stroke: &Stroke| (stroke.contour.length() / ALIKE).round() as i32;
    let order = |(radius, stroke): &(usize, Stroke)| (octave(stroke), -length(stroke), *radius);
    for list in [&mut found, &mut stubs] {
        list.sort_by(|a, b| order(a).cmp(&order(b)).then(b.1.contour.length().total_cmp(&a.1.contour.length())));
    }
    // dashes are no strokes by themselves, and take no place of one
    let (dashes, found): (Vec<_>, Vec<_>) = found.into_iter().partition(|(_, stroke)| stroke.is_dash);
    let mut taken = StrokeCover::new(size);
    let mut strokes = Vec::new();
    for (_, stroke) in found {
        let new = match taken.most_of(&stroke, params.sigma) {
            Most::Between => taken.rest_of(&stroke, params.sigma),
            Most::On => taken.beside(stroke, true),
            Most::Own => taken.beside(stroke, false),
        };
        new.iter().for_each(|stroke| taken.add(stroke, params.sigma));
        strokes.extend(new);
    }
    let mut strokes = follow::follow(strokes, planes, params);
    for (_, dash) in dashes {
        if matches!(taken.most_of(&dash, params.sigma), Most::Own) {
            taken.add(&dash, params.sigma);
            strokes.push(dash);
        }
    }
    let stubs = stubs.into_iter().map(|(_, stub)| stub).collect();
    let (stubs, short_marks) = stubs::of_scales(stubs, &strokes, &mut taken, params);
    strokes.extend(stubs);
    FoundStrokes { strokes, short_marks }
}

/// Whether the picture shows something along a segment: a stroke of a width, or the border of two areas, with at
/// least a contrast.
pub(super) fn is_seen([from, to]: [PxPoint; 2], width: f32, least: f32, planes: &[Plane]) -> bool {
    let displacement = to - from;
    let along = displacement.try_normalize().unwrap_or_default();
    let across = right_of(along);
    let steps = displacement.length().ceil() as usize;
    (0..steps).all(|k| {
        let at = from + displacement * ((k as f32 + 0.5) / steps as f32);
        centre::contrast_across(at, across, width, planes) >= least
    })
}

/// The side of a stroke is no farther beyond half of its width than this, px.
const BESIDE: f32 = 1.5;

/// Whether a stroke may be led to another one on a way to its middle, both given with their widths and tints. One that
/// ends visibly before a stroke of another tint ends there: as a sample of a line in the frame of a legend.
pub(super) fn may_lead(
    [(width, tint), (other_width, other_tint)]: [(f32, Tint); 2],
    [from, to]: [PxPoint; 2],
    least: f32,
    planes: &[Plane],
) -> bool {
    let (gap, beyond) = (to - from, 0.5 * other_width + BESIDE);
    let before = 1.0 - beyond / gap.length().max(beyond);
    !tint.differs_from(other_tint) || is_seen([from, from + gap * before], width, least, planes)
}

/// Half sides of the squares for strokes of up to a width, px: each twice the one before. A square has to be wider by
/// 1 px than the strokes that it finds whole: a slanted one as wide as it is found in parts.
fn radii(widest: f32) -> impl Iterator<Item = usize> {
    let most = (0.5 * widest + 0.5).ceil() as usize;
    let doubled = std::iter::successors(Some(SMALLEST_RADIUS), |radius| Some(2 * radius));
    doubled.take_while(move |radius| *radius < most).chain([most.max(SMALLEST_RADIUS)])
}

/// What is thin in one plane and looks like a stroke, or like a stub.
fn candidates(
    plane: &Plane,
    radius: usize,
    polarity: Polarity,
    planes: &[Plane],
    params: &Params,
) -> Vec<(Stroke, bool)> {
    // Of a stroke thinner than a pixel, pixels show more here and less there: together with their neighbours they are
    // even.
    let residue = Plane { size: plane.size, values: residue(&plane.values, plane.size, radius, polarity) };
    // means are no larger than the largest value, but for rounding
    if residue.values.iter().all(|value| *value < ROUNDED * params.high) {
        return Vec::new();
    }
    let residue = smoothed(&residue);
    if residue.values.iter().all(|value| *value < params.high) {
        return Vec::new();
    }
    let most = square_max(&residue.values, plane.size, LOCAL, false);
    let set: Vec<bool> =
        residue.values.iter().zip(&most).map(|(value, most)| *value >= params.low.max(SHARE * most)).collect();
    let things = components::of_set(&set, plane.size, Connectivity::Eight);
    let along = |strand: Strand| -> Vec<(Stroke, bool)> {
        let short = stubs::is_stub(&strand).then(|| strand.clone());
        let strokes = centre::strokes(strand, &residue, planes, radius, params);
        let stub = short.filter(|_| strokes.is_empty());
        let stub = stub.and_then(|strand| stubs::stub(&strand, &residue, planes, radius, params));
        strokes.into_iter().map(|stroke| (stroke, false)).chain(stub.map(|stub| (stub, true))).collect()
    };
    let strokes = |cells: &[usize]| -> Vec<(Stroke, bool)> {
        let (paths, nodes) = thinned(cells, &residue);
        let arms = arms::joined(paths, &nodes);
        // the gaps between dark things are no walls
        let parts = match polarity {
            Polarity::Below => breadth::parted(arms, &residue, radius),
            Polarity::Above => arms,
        };
        parts.into_iter().flat_map(along).collect()
    };
    things.par_iter().flat_map_iter(|cells| strokes(cells)).collect()
}

/// The skeleton of a connected part of a mask, given by its cells: its paths and junctions.
fn thinned(cells: &[usize], residue: &Plane) -> (Vec<SkeletonPath>, Vec<SkeletonNode>) {
    let turn = Turn::of(cells, residue);
    let mut mask = StrokeMask::new(turn.size(), cells.iter().map(|&cell| turn.turned(cell)));
    mask.thin();
    let (mut paths, mut nodes) = mask.paths();
    paths.iter_mut().flat_map(|path| &mut path.points).for_each(|at| *at = turn.back(*at));
    nodes.iter_mut().for_each(|node| node.at = turn.back(node.at));
    (paths, nodes)
}

/// The box around some cells, and how it is flipped and turned so that they have a positive skewness to the right and
/// below, the larger one to the right. Thinning goes from one corner to the other; so it does the same to a part of a
/// picture that is flipped, turned or moved.
#[derive(Debug, Clone, Copy)]
struct Turn {
    /// Columns of the picture.
    width: usize,
    /// First column and row of the box.
    min: [usize; 2],
    /// Columns and rows of the box.
    count: [usize; 2],
    flip: [bool; 2],
    transpose: bool,
}

impl Turn {
    fn of(cells: &[usize], residue: &Plane) -> Self {
        let width = residue.size.width as usize;
        let at = |cell: usize| [cell % width, cell / width];
        let (mut min, mut max) = ([usize::MAX; 2], [0; 2]);
        let (mut sum, mut first) = (0.0_f64, [0.0_f64; 2]);
        for &cell in cells {
            let value = f64::from(residue.values[cell]);
            sum += value;
            for (axis, at) in at(cell).into_iter().enumerate() {
                (min[axis], max[axis]) = (min[axis].min(at), max[axis].max(at));
                first[axis] += value * at as f64;
            }
        }
        let mean = first.map(|first| first / sum);
        let skewness = [0, 1].map(|axis| {
            let cubes = cells
                .iter()
                .map(|&cell| f64::from(residue.values[cell]) * (at(cell)[axis] as f64 - mean[axis]).powi(3));
            cubes.sum::<f64>()
        });
        Self {
            width,
            min,
            count: [0, 1].map(|axis| max[axis] - min[axis] + 1),
            flip: skewness.map(|skewness| skewness < 0.0),
            transpose: skewness[1].abs() > skewness[0].abs(),
        }
    }

    /// Size of the turned box.
    fn size(&self) -> Size {
        let [columns, rows] = self.count.map(|count| count as u32);
        if self.transpose { Size::new(rows, columns) } else { Size::new(columns, rows) }
    }

    /// The number in the turned box of a cell of the picture.
    fn turned(&self, cell: usize) -> usize {
        let [x, y] = [cell % self.width - self.min[0], cell / self.width - self.min[1]];
        let x = if self.flip[0] { self.count[0] - 1 - x } else { x };
        let y = if self.flip[1] { self.count[1] - 1 - y } else { y };
        if self.transpose { x * self.count[1] + y } else { y * self.count[0] + x }
    }

    /// The point in the picture of a point of the turned box.
    fn back(&self, turned: PxPoint) -> PxPoint {
        let (x, y) = if self.transpose { (turned.y, turned.x) } else { (turned.x, turned.y) };
        let x = if self.flip[0] { self.count[0] as f32 - x } else { x };
        let y = if self.flip[1] { self.count[1] as f32 - y } else { y };
        PxPoint::new(x + self.min[0] as f32, y + self.min[1] as f32)
    }
}

/// Each value averaged with its neighbours, by halves with those in its row and then in its column.
pub(super) fn smoothed(plane: &Plane) -> Plane {
    let (width, height) = (plane.size.width as usize, plane.size.height as usize);
    let mean = |before: f32, here: f32, after: f32| 0.25 * before + 0.5 * here + 0.25 * after;
    let mut rows = vec![0.0; plane.values.len()];
    for (out, row) in rows.chunks_exact_mut(width).zip(plane.values.chunks_exact(width)) {
        let last = width - 1;
        out[0] = mean(row[0], row[0], row[last.min(1)]);
        out[last] = mean(row[last.saturating_sub(1)], row[last], row[last]);
        for (out, near) in out[1..].iter_mut().zip(row.windows(3)) {
            *out = mean(near[0], near[1], near[2]);
        }
    }
    let mut values = vec![0.0; rows.len()];
    for y in 0..height {
        let row = |y: usize| &rows[y * width..][..width];
        let (before, here, after) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(height - 1)));
        let out = &mut values[y * width..][..width];
        for x in 0..width {
            out[x] = mean(before[x], here[x], after[x]);
        }
    }
    Plane { size: plane.size, values }
}

#[cfg(test)]
mod tests;
