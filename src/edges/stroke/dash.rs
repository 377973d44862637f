//! Short dashes: what is left of one when it is thinned, made straight and led on to its ends.

use super::centre::{extend_end, median};
use crate::geom::first_eigenvector;
use crate::geom::polyline::Polyline;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector};

/// A dash that joins nothing may be thinned to this, px, which takes up to 3 px off its length: those of plotting
/// programs are four widths of the line long, of a chart 900 px wide 7 px, and on a small device it is shrunk.
pub(super) const SHORTEST: f32 = 2.5;
/// It is at least this many times as long as wide; what is shorter is a dot.
pub(super) const LONG: f32 = 1.7;
/// Its direction is that of what lies no farther beyond what is left of it than this, px.
const AROUND: f32 = 1.0;
/// It is led on straight by at most twice this, px.
const ENDING: f32 = 2.0;
/// What thinning has left of a dash, as a straight line along which its residue lies: it has the steps of pixels, and is
/// too short to be smoothed.
pub(super) fn straight(line: &Polyline<PxPoint>, residue: &Plane) -> Option<Polyline<PxPoint>> {
    let (first, last) = (*line.vertices.first()?, *line.vertices.last()?);
    let (middle, half) = (first.lerp(last, 0.5), 0.5 * (last - first).length());
    let most = half + AROUND;
    let reach = most.ceil() as i32;
    let value = |at: PxPoint| residue.at(at.x, at.y);
    let offsets = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| PxVector::new(x as f32, y as f32)));
    let weighted: Vec<(f32, PxVector)> =
        offsets.filter(|offset| offset.length() <= most).map(|offset| (value(middle + offset), offset)).collect();
    let sum = |of: &dyn Fn(PxVector) -> f32| weighted.iter().map(|(weight, offset)| weight * of(*offset)).sum::<f32>();
    let total = sum(&|_| 1.0);
    if total <= 0.0 {
        return None;
    }
    let mean = PxVector::new(sum(&|offset| offset.x), sum(&|offset| offset.y)) / total;
    let moment = |of: &dyn Fn(PxVector) -> f32| sum(&|offset| of(offset - mean));
    let along: PxVector = first_eigenvector(moment(&|v| v.x * v.x), moment(&|v| v.x * v.y), moment(&|v| v.y * v.y))?;
    let steps = (2.0 * half).ceil().max(1.0) as u32;
    let at = |k: u32| middle + mean + along * (half * (2.0 * k as f32 / steps as f32 - 1.0));
    Some(Polyline::open((0..=steps).map(at).collect()))
}

/// Leads both ends of a dash straight on, as `extend_ends` does those of a stroke. They are not made anew: they are
/// nearly all of it.
pub(super) fn extend(line: &mut Polyline<PxPoint>, residue: &Plane) {
    let along = median(line.vertices.iter().map(|&at| residue.at(at.x, at.y)));
    for _ in 0..2 {
        extend_end(line, residue, ENDING, along);
        line.vertices.reverse();
    }
}
