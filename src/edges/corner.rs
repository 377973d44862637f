//! Corners: a blur rounds them off, here they are pointed again.
//!
//! Beyond the rounding the two flanks of a corner run on unharmed. Where both are straight and the path turns between
//! them, they are led on to where they cross, and the corner stands there.

use super::path::{Flank, Mark, Path};
use crate::units::PxPoint;

/// A turn smaller than this needs no pointing: rounding moves it by less than a fifth of the blur (cosine of 25 degrees).
const TURN: f32 = 0.9;
/// The rounding reaches this far along either flank, in blurs, at a right angle or less; at sharper corners farther.
const ROUND: f32 = 1.5;
/// The flanks are looked at over this much of the path beyond the rounding, in blurs; and over this much at least, px.
const FLANK: f32 = 6.0;
/// Farthest that marks may lie from a straight flank, root mean square, px, beside their doubt.
const STRAIGHT: f32 = 0.06;
/// ... of which this share is left after refining.
const DOUBT: f32 = 0.4;
/// The flanks themselves bend by at most this share of the turn between them; on a circle it is two thirds.
const BOW: f32 = 0.3;
/// Farthest that the corner may lie from the path as it was found, in blurs, for a right angle.
const AWAY: f32 = 1.6;

/// A mark that is nearer to one flank's side of the corner than to the other's by less than this, px, is on neither.
const EVEN: f32 = 0.1;

struct Corner {
    mark: usize,
    at: PxPoint,
    flanks: [Flank; 2],
    reach: f32,
    off: f32,
}

/// Points the corners of a path.
pub(super) fn sharpen(path: &mut Path) {
    let n = path.marks.len();
    if n < 9 {
        return;
    }
    let mut corners: Vec<Corner> = (0..n).filter_map(|i| look(path, i)).collect();
    // of neighbours that see one corner, the one nearest to it tells it
    corners.sort_by(|a, b| a.off.total_cmp(&b.off).then(a.mark.cmp(&b.mark)));
    let mut kept: Vec<Corner> = Vec::new();
    for corner in corners {
        if kept.iter().all(|other| (other.at - corner.at).length() >= corner.reach.max(other.reach)) {
            kept.push(corner);
        }
    }
    // from the last on, so that the numbers of the marks before stay what they are
    kept.sort_by_key(|corner| std::cmp::Reverse(corner.mark));
    for corner in kept {
        let corner = settled(path, corner);
        point(path, &corner);
    }
}

/// The corner with flanks measured from itself instead of from the mark that told it: two marks at equal distances from it
/// tell the same corner.
fn settled(path: &Path, corner: Corner) -> Corner {
    let blur = path.marks[corner.mark].blur;
    let to = corner.reach + (FLANK * blur).max(4.0);
    let flank = |forwards| {
        let marks = path.walk(corner.mark, forwards).take_while(|(_, way)| *way <= 2.0 * to);
        let points = marks.map(|(number, _)| path.marks[number].at);
        Flank::through(points.filter(|at| (corner.reach..=to).contains(&(*at - corner.at).length())))
    };
    let Some((before, after)) = flank(false).zip(flank(true)) else { return corner };
    match before.crossing(&after) {
        Some((back, on)) if back < 0.0 && on < 0.0 => {
            Corner { at: before.at + before.along * back, flanks: [before, after], ..corner }
        }
        _ => corner,
    }
}

/// Whether there is a corner at a mark.
fn look(path: &Path, i: usize) -> Option<Corner> {
    let mark = &path.marks[i];
    let blur = mark.blur;
    let mut reach = ROUND * blur;
    let mut found = None;
    // A sharp corner is rounded over more of its flanks: looked at again beyond that.
    for _ in 0..2 {
        let to = reach + (FLANK * blur).max(4.0);
        let before = path.flank(i, false, reach, to)?;
        let after = path.flank(i, true, reach, to)?;
        // both are directed away from the mark
        let cosine = -before.along.dot(after.along);
        let allowed = STRAIGHT.hypot(DOUBT * mark.doubt);
        if cosine > TURN || before.off > allowed || after.off > allowed {
            return None;
        }
        let middle = reach + 0.5 * (to - reach);
        let bow = |forwards| {
            let (near, far) = (path.flank(i, forwards, reach, middle)?, path.flank(i, forwards, middle, to)?);
            Some(near.along.cross(far.along))
        };
        // forwards a bend to the right has one sign, backwards the other
        let turn = -before.along.cross(after.along);
        if (bow(true)? - bow(false)?) * turn.signum() > BOW * cosine.clamp(-1.0, 1.0).acos() {
            return None;
        }
        let half_sine = (0.5 * (1.0 + cosine)).max(0.0).sqrt(); // sine of half the angle between the flanks
        let (back, on) = before.crossing(&after)?;
        // the crossing lies behind both flanks, towards the mark
        if back > 0.0 || on > 0.0 {
            return None;
        }
        let at = before.at + before.along * back;
        let off = (at - mark.at).length();
        if off > AWAY * blur * 0.707 / half_sine.max(0.25) {
            return None;
        }
        found = Some(Corner { mark: i, at, flanks: [before, after], reach, off });
        let wanted = ROUND * blur * (0.707 / half_sine.max(0.25)).max(1.0);
        if wanted < 1.2 * reach {
            break;
        }
        reach = wanted;
    }
    found
}

/// Puts the marks of the rounding on the flanks, and a mark on the corner between them.
fn point(path: &mut Path, corner: &Corner) {
    let [before, after] = &corner.flanks;
    let place = |flank: &Flank, at: PxPoint| flank.along.dot(at - corner.at);
    let middle = path.marks[corner.mark];
    let lean = place(before, middle.at) - place(after, middle.at);
    let is_before = lean > 0.0;
    for (flank, forwards) in [(before, false), (after, true)] {
        let is_near = |k: usize| place(flank, path.marks[k].at) < corner.reach;
        let near: Vec<usize> = path.walk(corner.mark, forwards).map(|(k, _)| k).take_while(|&k| is_near(k)).collect();
        for k in near.into_iter().filter(|k| *k != corner.mark || is_before != forwards) {
            let at = flank.nearest(path.marks[k].at);
            // not beyond the corner
            path.marks[k].at = if place(flank, at) > 0.0 { at } else { corner.at };
        }
    }
    let tip = Mark { at: corner.at, ..middle };
    if lean.abs() < EVEN {
        path.marks[corner.mark] = tip; // it lies on neither side
        return;
    }
    path.marks.insert(corner.mark + usize::from(is_before), tip);
}
