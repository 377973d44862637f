//! Where strokes come nearer to one another, or to themselves, than fingers can tell apart.
//!
//! Strokes have round ends and joins, so the blank between two segments is the distance of their middle lines less
//! half the width of each: distances are exact. What lies beside a join ([`super::joins`]) does not count. Of one
//! line that comes back to itself places are compared every [`STEP`] mm, as where a bend ends and a return begins is
//! no sharp border.

use super::finding::around;
use super::joins::{self, BEND_LEAST, Join, arrives, free_parts};
use super::limits::ROUNDING;
use super::paths::{Path, Paths, may_be_near, nearest, point_at};
use crate::geom::nearby::Segment;
use crate::geom::{nearest_on_segment, segment_distance};
use crate::page::{Line, Pen};
use crate::units::{MmPoint, MmRect};

/// Places of one line are compared this often, mm.
const STEP: f32 = 0.25;
/// Two places of one line with this much arc length between them, in distances, lie on the two sides of a bend: a
/// corner of 30 degrees has the factor 1 / sin 15 = 3.9.
pub(crate) const BEND: f32 = 4.0;
/// The factor of a corner with straight sides, which lie on two sides down to 19 degrees: 1 / sin 9.5 = 6.1. Straight
/// are sides if the length over the tip is nearly as long as the line.
pub(crate) const CORNER: f32 = 6.1;
pub(crate) const STRAIGHTNESS: f32 = 0.92;
/// Most stretches that are looked at: a hundred times what the worst page of a person has. More lie where hundreds of
/// lines lie on one another, each with each.
const MOST: usize = 20_000;
/// Two stretches of one pair of lines with less than this between them are one, mm.
pub(super) const ONE: f32 = 2.0;

/// A stretch along which two lines are too near.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// The two lines; the same for a line too near to itself.
    pub lines: (usize, usize),
    /// Least blank between them, mm; negative where they overlap.
    pub gap: f32,
    /// Where that is.
    pub at: MmPoint,
    /// How far they are too near along the first, mm.
    pub length: f32,
    /// The box around the stretch.
    pub extent: MmRect,
}

/// A part of a path that is too near.
#[derive(Debug, Clone, Copy)]
struct NearStretch {
    paths: (u32, u32),
    from: f32,
    to: f32,
    gap: f32,
    at: MmPoint,
    ends: (MmPoint, MmPoint),
}

/// All places where strokes of these lines are nearer than `least` mm.
pub fn too_near(lines: &[Line], least: f32) -> Vec<Near> {
    all_too_near(lines, least).0
}

/// The same, and whether these are all.
pub(super) fn all_too_near(lines: &[Line], least: f32) -> (Vec<Near>, bool) {
    on_paths(Paths::whole(lines), lines, least, 0.0)
}

/// The same of rows of dots, which are broken where a step from dot to dot is longer than `step` mm, and join where one
/// ends within `touch` mm of another.
pub(super) fn all_too_near_of_dots(lines: &[Line], least: f32, touch: f32, step: f32) -> (Vec<Near>, bool) {
    on_paths(Paths::broken(lines, step), lines, least, touch)
}

/// The places of these `paths` of lines, which join where one ends within `touch` mm of the ink of another.
fn on_paths(paths: Paths, lines: &[Line], least: f32, touch: f32) -> (Vec<Near>, bool) {
    let widest = paths.widest();
    let index = paths.index(least + 2.0 * widest);
    let joins = joins::joins(&paths, &index, least, touch);
    // the second row of a line of dots belongs to the first
    let are_rows = |a: &Segment, b: &Segment| {
        let [a, b] = [a, b].map(|segment| paths.paths[segment.line as usize].line);
        a == b && lines[a].runs.iter().any(|run| run.pen != Pen::Stroke)
    };
    let mut found: Vec<NearStretch> = Vec::new();
    let mut seen = vec![u32::MAX; paths.segments.len()];
    for (number, segment) in paths.segments.iter().enumerate() {
        if found.len() >= MOST {
            break;
        }
        let reach = least + segment.half_width + widest;
        index.around(segment.a.min(segment.b), segment.a.max(segment.b), reach, |other| {
            let id = paths.paths[other.line as usize].segments.start + other.index as usize;
            let clearance = least + segment.half_width + other.half_width;
            if id >= number || !may_be_near(segment, other, clearance) || is_next(segment, other) {
                return;
            }
            if std::mem::replace(&mut seen[id], number as u32) == number as u32 {
                return;
            }
            let distance = segment_distance((segment.a, segment.b), (other.a, other.b));
            if distance >= clearance - ROUNDING {
                return;
            }
            if are_rows(segment, other) {
                return;
            }
            if other.line == segment.line {
                let path = &paths.paths[segment.line as usize];
                returns(&paths, path, &joins[segment.line as usize], (segment, other), clearance, distance, &mut found);
            } else {
                between(&paths, &joins, (segment, other), clearance, &mut found);
            }
        });
    }
    let are_all = found.len() < MOST;
    (merged(found, &paths), are_all)
}

/// Whether two segments of one path lie so near one another along it that they cannot be a return.
fn is_next(segment: &Segment, other: &Segment) -> bool {
    segment.line == other.line && segment.arc - other.arc <= BEND_LEAST - (segment.b - segment.a).length()
}

/// The parts of two segments of two paths that are too near.
fn between(
    paths: &Paths,
    joins: &[Vec<Join>],
    (segment, other): (&Segment, &Segment),
    clearance: f32,
    found: &mut Vec<NearStretch>,
) {
    let ring_length = |path: u32| Some(&paths.paths[path as usize]).filter(|path| path.closed).map(|path| path.length);
    let line = |of: &Segment| paths.paths[of.line as usize].line;
    let parts = |of: &Segment, with: &Segment| {
        free_parts(&joins[of.line as usize], ring_length(of.line), of, line(with), clearance)
    };
    for own in parts(segment, other) {
        let (a, b) = (point_at(segment, own.0), point_at(segment, own.1));
        for theirs in parts(other, segment) {
            let (c, d) = (point_at(other, theirs.0), point_at(other, theirs.1));
            let distance = segment_distance((a, b), (c, d));
            if distance >= clearance - ROUNDING {
                continue;
            }
            let within = within((a, b), (c, d), clearance - ROUNDING);
            let arc = |share: f32| own.0 + share * (own.1 - own.0);
            found.push(NearStretch {
                paths: (segment.line, other.line),
                from: arc(within.from),
                to: arc(within.to),
                gap: distance - segment.half_width - other.half_width,
                at: a.lerp(b, within.nearest),
                ends: (a.lerp(b, within.from), a.lerp(b, within.to)),
            });
        }
    }
}

/// Shares of the length from one end of a segment to the other.
struct Within {
    from: f32,
    nearest: f32,
    to: f32,
}

/// The part of the segment `a`-`b` that lies within `reach` of another one, which it does somewhere. The distance to a
/// segment is a convex function along another one, so the part is one piece.
fn within((a, b): (MmPoint, MmPoint), (c, d): (MmPoint, MmPoint), reach: f32) -> Within {
    const HALVINGS: u32 = 30;
    let distance = |share: f32| nearest_on_segment(a.lerp(b, share), c, d).0;
    let (mut low, mut high) = (0.0_f32, 1.0_f32);
    for _ in 0..2 * HALVINGS {
        let (s, t) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if distance(s) <= distance(t) { high = t } else { low = s }
    }
    let nearest = 0.5 * (low + high);
    let border = |outer: f32| {
        if distance(outer) <= reach {
            return outer;
        }
        let (mut inside, mut outside) = (nearest, outer);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if distance(middle) <= reach { inside = middle } else { outside = middle }
        }
        inside
    };
    Within { from: border(0.0), nearest, to: border(1.0) }
}

/// The places of a segment where its path comes back to an earlier one.
fn returns(
    paths: &Paths,
    path: &Path,
    joins: &[Join],
    (segment, other): (&Segment, &Segment),
    clearance: f32,
    least: f32,
    found: &mut Vec<NearStretch>,
) {
    let (length, others) = ((segment.b - segment.a).length(), (other.b - other.a).length());
    let farthest = (segment.arc + length - other.arc).abs().max((other.arc + others - segment.arc).abs());
    if farthest <= BEND * least + BEND_LEAST {
        return;
    }
    let ring_length = path.closed.then_some(path.length);
    let steps = (length / STEP).ceil().max(1.0);
    for k in 0..steps as u32 {
        let middle = (k as f32 + 0.5) / steps;
        let (here, at) = (segment.arc + middle * length, segment.a.lerp(segment.b, middle));
        let (distance, point, there) = nearest(other, at);
        if distance >= clearance - ROUNDING {
            continue;
        }
        let along = path.between(here, there);
        let bend = along <= BEND * distance + BEND_LEAST
            || (along <= CORNER * distance + BEND_LEAST && has_corner(paths, path, (here, at), (there, point)));
        let joined = [here, there].iter().any(|arc| arrives(joins, ring_length, *arc, path.line, clearance));
        if !bend && !joined {
            let share = |k: u32| (k as f32 / steps).min(1.0);
            let ends = (segment.a.lerp(segment.b, share(k)), segment.a.lerp(segment.b, share(k + 1)));
            let gap = distance - segment.half_width - other.half_width;
            let (from, to) = (segment.arc + share(k) * length, segment.arc + share(k + 1) * length);
            found.push(NearStretch { paths: (segment.line, segment.line), from, to, gap, at, ends });
        }
    }
}

/// Whether between two of its places a path has but two straight sides of a corner.
fn has_corner(paths: &Paths, path: &Path, (s, a): (f32, MmPoint), (t, b): (f32, MmPoint)) -> bool {
    let (from, to) = (s.min(t), s.max(t));
    let over_start = path.closed && path.length - (to - from) < to - from;
    let segments = &paths.segments[path.segments.clone()];
    let tips = segments.iter().filter(|segment| (from..to).contains(&segment.arc) != over_start);
    let farthest = tips.map(|segment| (segment.a - a).length() + (segment.a - b).length()).fold(0.0, f32::max);
    farthest >= STRAIGHTNESS * path.between(s, t)
}

/// One finding for each place where two lines are too near.
fn merged(mut found: Vec<NearStretch>, paths: &Paths) -> Vec<Near> {
    found.sort_by(|a, b| a.paths.cmp(&b.paths).then(a.from.total_cmp(&b.from)).then(a.to.total_cmp(&b.to)));
    let mut all: Vec<(Near, (u32, u32), f32)> = Vec::new();
    for NearStretch { paths: pair, from, to, gap, at, ends } in found {
        match all.last_mut() {
            Some((near, last, end)) if *last == pair && from - *end <= ONE => {
                near.length += (to - from.max(*end)).max(0.0);
                near.extent = around([near.extent.min, near.extent.max, ends.0, ends.1]).unwrap_or(near.extent);
                if gap < near.gap {
                    (near.gap, near.at) = (gap, at);
                }
                *end = end.max(to);
            }
            _ => {
                let extent = around([ends.0, ends.1]).unwrap_or_else(MmRect::zero);
                let lines = (paths.paths[pair.0 as usize].line, paths.paths[pair.1 as usize].line);
                all.push((Near { lines, gap, at, length: to - from, extent }, pair, to));
            }
        }
    }
    all.into_iter().map(|(near, ..)| near).collect()
}
