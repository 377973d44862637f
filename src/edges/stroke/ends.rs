//! Ends of strokes, led straight on to where the pixels end; and short dashes, which are little else.

use crate::geom::first_eigenvector;
use crate::geom::order::median;
use crate::geom::polyline::Polyline;
use crate::raster::plane::Plane;
use crate::units::{PxPoint, PxVector};

/// The profile across a stroke is read in steps of this, px.
pub(super) const STEP: f32 = 0.25;
/// The direction of an end is taken over the width of the stroke and this much more, px.
const ENDING: f32 = 3.0;
/// Of a free end so many widths of the stroke, and this much more, px, are where thinning left them: on the way into a
/// corner of its end.
const UNSURE_WIDTHS: f32 = 0.8;
pub(super) const UNSURE: f32 = 1.5;
/// A dash that joins nothing may be thinned to this, px, which takes up to 3 px off its length: those of plotting
/// programs are four widths of the line long, of a chart 900 px wide 7 px, and on a small device it is shrunk.
pub(super) const SHORTEST_DASH: f32 = 2.5;
/// It is at least this many times as long as wide; what is shorter is a dot.
pub(super) const LONG_DASH: f32 = 1.7;
/// Its direction is that of what lies no farther beyond what is left of it than this, px.
const AROUND_DASH: f32 = 1.0;
/// It is led on straight by at most twice this, px.
const ENDING_OF_DASH: f32 = 2.0;

/// Goes straight on at the free ends of a line, as far as the residue is at least half of what it is along the line.
/// Thinning shortens ends and leads them into a corner of the stroke, so the last half width is made anew.
pub(super) fn extend_ends(line: &mut Polyline<PxPoint>, free: [bool; 2], residue: &Plane, width: f32) {
    let along = median(line.vertices.iter().map(|&at| residue.at(at.x, at.y)));
    let unsure = UNSURE_WIDTHS * width + UNSURE;
    // the end, then the start
    for is_free in [free[1], free[0]] {
        if is_free && line.length() > 4.0 * unsure {
            trim_end(line, unsure);
            extend_end(line, residue, width + ENDING, along);
        }
        line.vertices.reverse();
    }
}

/// Takes away the last `length` px of a line.
fn trim_end(line: &mut Polyline<PxPoint>, length: f32) {
    let mut left = length;
    while let [.., before, last] = line.vertices[..] {
        let length = (last - before).length();
        line.vertices.pop();
        if length >= left {
            line.vertices.push(last.lerp(before, left / length));
            return;
        }
        left -= length;
    }
}

/// Goes straight on for at most twice `most` px, as long as that is in the picture and the residue is at least half of
/// `along`. The direction is that of the last `most` px.
fn extend_end(line: &mut Polyline<PxPoint>, residue: &Plane, most: f32, along: f32) {
    let Some(&tip) = line.vertices.last() else { return };
    let inner = line.vertices.iter().rev().find(|at| (**at - tip).length() >= most);
    let Some(heading) = inner.and_then(|inner| (tip - *inner).try_normalize()) else { return };
    let (width, height) = (residue.size.width as f32, residue.size.height as f32);
    let is_inside = |at: PxPoint| (0.0..=width).contains(&at.x) && (0.0..=height).contains(&at.y);
    let is_stroke = |k: &i32| {
        let at = tip + heading * (*k as f32 * STEP);
        is_inside(at) && residue.at(at.x, at.y) >= 0.5 * along
    };
    let steps = (1..=(2.0 * most / STEP) as i32).take_while(is_stroke).count() as i32;
    if steps > 0 {
        line.vertices.push(tip + heading * (steps as f32 * STEP));
    }
}

/// What thinning has left of a dash, as a straight line along which its residue lies: it has the steps of pixels, and
/// is too short to be smoothed.
pub(super) fn straight_dash(line: &Polyline<PxPoint>, residue: &Plane) -> Option<Polyline<PxPoint>> {
    let (first, last) = (*line.vertices.first()?, *line.vertices.last()?);
    let (middle, half) = (first.lerp(last, 0.5), 0.5 * (last - first).length());
    let most = half + AROUND_DASH;
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

/// Leads both ends of a dash straight on, as [`extend_ends`] does those of a stroke. They are not made anew: they are
/// nearly all of it.
pub(super) fn extend_dash(line: &mut Polyline<PxPoint>, residue: &Plane) {
    let along = median(line.vertices.iter().map(|&at| residue.at(at.x, at.y)));
    for _ in 0..2 {
        extend_end(line, residue, ENDING_OF_DASH, along);
        line.vertices.reverse();
    }
}
