//! Corners: blur rounds them, here they are made sharp again.
//!
//! Beyond the rounding the two sides of a corner are undisturbed. Where both sides are straight and the contour turns
//! between them, lines are fitted to the sides, and the corner is put where the lines cross.

use super::contour::{Contour, ContourPoint, LineFit};
use crate::units::{PxPoint, Size};

/// Smaller turns are left alone: rounding moves them by less than a fifth of the blur (cosine of 25 degrees).
const MIN_TURN: f32 = 0.9;
/// The rounding extends this far along either side, in blurs, at a right angle or more; farther at sharper corners.
const ROUNDING: f32 = 1.5;
/// Lines are fitted to this much of the contour beyond the rounding, in blurs, and at least to `MIN_FIT_LENGTH` px.
const FIT_LENGTH: f32 = 6.0;
const MIN_FIT_LENGTH: f32 = 4.0;
/// Greatest root mean square distance of points from a straight side, px, in addition to their position error.
const MAX_RMS: f32 = 0.06;
/// The share of the position error that refinement leaves.
const REFINED_SIGMA: f32 = 0.4;
/// The sides may bend by at most this share of the turn between them. On a circle they bend by two thirds of it.
const MAX_BEND: f32 = 0.3;
/// Greatest distance of the corner from the contour as it was found, in blurs, at a right angle.
const MAX_DISTANCE: f32 = 1.6;

/// Corners are at least as wide as one whose half angle has this sine: 20 degrees.
const SHARPEST: f32 = 0.174;

/// A corner is a wedge where its rounding extends at least so much farther than at a right angle: 27 degrees. At wider
/// ones, such as those of eaves, there may be a junction where the sides would be measured.
const WEDGE: f32 = 3.0;
/// Where the sides of a wedge are as near to one another as where its rounding ends, 2.1 blurs, each moves the other
/// outwards by 0.2 of a blur; so many times as far from the tip, at 3 blurs, by 0.03.
const OUTWARDS: f32 = 1.42;

/// A point nearer to one side of the corner than to the other by less than this, px, belongs to neither.
const TIE: f32 = 0.1;
/// Contours of fewer points have no room for two sides.
const MIN_POINTS: usize = 9;

/// A corner of a contour.
struct Corner {
    /// Index of the point at which it was found.
    point: usize,
    at: PxPoint,
    /// The sides before and after it, directed away from it.
    sides: [LineFit; 2],
    /// How far the rounding extends, px.
    rounding: f32,
    /// Distance of the corner from the point, px.
    distance: f32,
}

/// Makes the corners of a contour sharp, in a picture of a size. A corner beyond its border stays as it is. With
/// `wedges` those of filled wedges are looked for first.
pub(super) fn sharpen(contour: &mut Contour, picture: Size, wedges: bool) {
    let n = contour.vertices.len();
    if n < MIN_POINTS {
        return;
    }
    let (right, bottom) = (picture.width as f32, picture.height as f32);
    let is_inside = |corner: &Corner| (0.0..=right).contains(&corner.at.x) && (0.0..=bottom).contains(&corner.at.y);
    let all = |find: fn(&Contour, usize) -> Option<Corner>| -> Vec<Corner> {
        (0..n).filter_map(|i| find(contour, i)).filter(is_inside).collect()
    };
    let tips = if wedges { distinct(all(tip), Vec::new()) } else { Vec::new() };
    let mut corners = distinct(all(find), tips);
    // from the last to the first, so that inserted points do not change the indices of those before
    corners.sort_by_key(|corner| std::cmp::Reverse(corner.point));
    for corner in corners {
        let refitted = refitted(contour, &corner);
        insert(contour, refitted.as_ref().filter(|corner| is_inside(corner)).unwrap_or(&corner));
    }
}

/// The corners that are kept already, and of the neighbours at which another one was found the one nearest to it.
fn distinct(mut corners: Vec<Corner>, mut kept: Vec<Corner>) -> Vec<Corner> {
    corners.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.point.cmp(&b.point)));
    for corner in corners {
        if kept.iter().all(|other| (other.at - corner.at).length() >= corner.rounding.max(other.rounding)) {
            kept.push(corner);
        }
    }
    kept
}

/// The corner with sides measured from itself instead of from the point at which it was found, so that two points at
/// equal distances from it give the same corner; none if they do not cross near it.
fn refitted(contour: &Contour, corner: &Corner) -> Option<Corner> {
    let to = corner.rounding + fit_length(contour.vertices[corner.point].blur);
    let side = |forwards| {
        let points = contour.walk(corner.point, forwards).take_while(|(_, arc)| *arc <= 2.0 * to);
        let points = points.map(|(index, _)| contour.vertices[index].at);
        LineFit::through(points.filter(|at| (corner.rounding..=to).contains(&(*at - corner.at).length())))
    };
    let (before, after) = (side(false)?, side(true)?);
    let (back, on) = before.crossing(&after)?;
    let (at, point) = (before.point_at(back), &contour.vertices[corner.point]);
    // sides that are fitted anew may be nearly parallel, and cross anywhere
    let is_near = (at - point.at).length() <= farthest(point.blur, &before, &after);
    let crosses_behind = back < 0.0 && on < 0.0;
    (crosses_behind && is_near).then_some(Corner { at, sides: [before, after], ..*corner })
}

/// Greatest distance of a corner with these sides from the contour as it was found, px.
fn farthest(blur: f32, before: &LineFit, after: &LineFit) -> f32 {
    MAX_DISTANCE * blur * turn_and_stretch(before, after).1
}

/// The length of the contour to which a line is fitted, px.
fn fit_length(blur: f32) -> f32 {
    (FIT_LENGTH * blur).max(MIN_FIT_LENGTH)
}

/// The corner at a point, if there is one.
fn find(contour: &Contour, i: usize) -> Option<Corner> {
    let (rounding, stretch) = rounding(contour, i)?;
    // A sharp corner is rounded over more of its sides: they are measured once more, beyond that.
    let wanted = rounding * stretch.max(1.0);
    find_beyond(contour, i, if wanted < 1.2 * rounding { rounding } else { wanted })
}

/// The tip of a wedge at a point, if there is one.
fn tip(contour: &Contour, i: usize) -> Option<Corner> {
    let (rounding, stretch) = rounding(contour, i)?;
    if stretch < WEDGE { None } else { find_beyond(contour, i, OUTWARDS * rounding * stretch) }
}

/// How far the rounding of a corner at a point would extend at a right angle, px, and how much farther it extends.
fn rounding(contour: &Contour, i: usize) -> Option<(f32, f32)> {
    let blur = contour.vertices[i].blur;
    let rounding = ROUNDING * blur;
    let to = rounding + fit_length(blur);
    let [before, after] = [false, true].map(|forwards| contour.line_fit(i, forwards, rounding, to));
    Some((rounding, turn_and_stretch(&before?, &after?).1))
}

/// Cosine of the turn between two sides, both directed away from the corner, and how much farther than at a right angle
/// the rounding extends.
fn turn_and_stretch(before: &LineFit, after: &LineFit) -> (f32, f32) {
    let cosine = -before.direction.dot(after.direction);
    let half_sine = (0.5 * (1.0 + cosine)).max(0.0).sqrt(); // sine of half the angle between the sides
    (cosine, 0.707 / half_sine.max(SHARPEST))
}

/// The corner at a point if the rounding extends `rounding` px.
fn find_beyond(contour: &Contour, i: usize, rounding: f32) -> Option<Corner> {
    let point = &contour.vertices[i];
    let to = rounding + fit_length(point.blur);
    let before = contour.line_fit(i, false, rounding, to)?;
    let after = contour.line_fit(i, true, rounding, to)?;
    let (cosine, _) = turn_and_stretch(&before, &after);
    let max_rms = MAX_RMS.hypot(REFINED_SIGMA * point.position_sigma);
    if cosine > MIN_TURN || before.rms > max_rms || after.rms > max_rms {
        return None;
    }
    // forwards a bend to the right has one sign, backwards the other
    let turn = -before.direction.cross(after.direction);
    let bend = |forwards| bend(contour, i, forwards, rounding, to);
    if (bend(true)? - bend(false)?) * turn.signum() > MAX_BEND * cosine.clamp(-1.0, 1.0).acos() {
        return None;
    }
    let (back, on) = before.crossing(&after)?;
    // the crossing must lie behind both sides, towards the point
    if back > 0.0 || on > 0.0 {
        return None;
    }
    let at = before.point_at(back);
    let distance = (at - point.at).length();
    let near = distance <= farthest(point.blur, &before, &after);
    near.then_some(Corner { point: i, at, sides: [before, after], rounding, distance })
}

/// How much a side bends: the sine of the angle between its near and its far half.
fn bend(contour: &Contour, i: usize, forwards: bool, from: f32, to: f32) -> Option<f32> {
    let middle = from + 0.5 * (to - from);
    let near = contour.line_fit(i, forwards, from, middle)?;
    let far = contour.line_fit(i, forwards, middle, to)?;
    Some(near.direction.cross(far.direction))
}

/// Moves the points of the rounding onto the sides, and puts a point on the corner between them.
fn insert(contour: &mut Contour, corner: &Corner) {
    let [before, after] = &corner.sides;
    // signed distance from the corner along a side
    let along = |side: &LineFit, at: PxPoint| side.direction.dot(at - corner.at);
    let middle = contour.vertices[corner.point];
    let difference = along(before, middle.at) - along(after, middle.at);
    let is_before = difference > 0.0;
    for (side, forwards) in [(before, false), (after, true)] {
        let is_near = |k: usize| along(side, contour.vertices[k].at) < corner.rounding;
        let near: Vec<usize> =
            contour.walk(corner.point, forwards).map(|(k, _)| k).take_while(|&k| is_near(k)).collect();
        for k in near.into_iter().filter(|k| *k != corner.point || is_before != forwards) {
            let at = side.nearest(contour.vertices[k].at);
            // not beyond the corner
            contour.vertices[k].at = if along(side, at) > 0.0 { at } else { corner.at };
        }
    }
    let tip = ContourPoint { at: corner.at, ..middle };
    if difference.abs() < TIE {
        contour.vertices[corner.point] = tip; // it belongs to neither side
    } else {
        contour.vertices.insert(corner.point + usize::from(is_before), tip);
    }
}

#[cfg(test)]
mod tests;
