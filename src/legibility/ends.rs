//! Ends of lines that point at one another over a small gap: a contour that seems broken.

use super::finding::FoundBreach;
use super::limits::{LAST_DIGIT, RuleLimits};
use super::marks::name_in;
use super::paths::{PathKind, Paths};
use super::rules::BROKEN_LINE;
use super::strokes::both;
use crate::geom::nearby::{Index, Nearby};
use crate::geom::{crossing, nearby, nearest_on_segment, segment_distance};
use crate::page::Names;
use crate::units::{Mm, MmPoint, MmRect, MmVector};

/// How far back from its end the direction of a line is taken, mm.
const BACK: f32 = 3.0;
/// Two ends point at one another if each does so within 25 degrees.
const STRAIGHT_COSINE: f32 = 0.906;
/// An end points at a side if it meets it at 45 degrees and more.
const STEEP_SINE: f32 = 0.7;
/// Dots nearer than so many pitches are next to one another, also diagonally: on a grid the same as
/// [`NEXT_DOT`](super::limits::NEXT_DOT), as there are no distances between 1.42 and 2.
const STEP: f32 = 1.6;
/// A line no further than this from the segment between two ends lies on it, mm: rounding.
const TOUCH: f32 = 2.0 * LAST_DIGIT;
/// The two ends of one line are looked at if the line is longer than so many times the gap between them.
const LEAST_LENGTH: f32 = 4.0;

#[derive(Debug, Clone, Copy)]
struct Tip {
    at: MmPoint,
    outwards: MmVector,
    radius: f32,
    path: u32,
    is_dot: bool,
}

pub(super) fn findings(paths: &Paths, all: &Names, index: &Nearby, limits: &RuleLimits) -> Vec<FoundBreach> {
    let names = &all.lines;
    let most = limits.missed_gap();
    // the second row of a heavy line of dots ends where it does because of the first
    let has_ends = |path: &usize| {
        let path = &paths.paths[*path];
        path.kind != PathKind::BesideRow && !path.is_ring_of_dots
    };
    let first_rows = (0..paths.paths.len()).filter(has_ends);
    let tips: Vec<Tip> = first_rows.flat_map(|path| tips(paths, path)).collect();
    let area = super::finding::around(tips.iter().map(|tip| tip.at)).unwrap_or_else(MmRect::zero);
    let mut near: Index<usize, Mm> = Index::new(area, most);
    tips.iter().enumerate().for_each(|(number, tip)| near.put_at(tip.at, number));
    let largest = tips.iter().map(|tip| tip.radius).fold(0.0, f32::max);
    let mut found = Vec::new();
    for (number, tip) in tips.iter().enumerate() {
        let name = name_in(names, paths.paths[tip.path as usize].line);
        if all.by_hand.contains(name) {
            found.extend(stops_short(paths, names, tip, index, most));
        }
        near.around(tip.at, tip.at, most + tip.radius + largest, |&id| {
            let other = &tips[id];
            let blank = (other.at - tip.at).length() - tip.radius - other.radius;
            // dots that are next to one another are no gap
            let step = limits.next_dot().max(STEP * limits.spacing_of_dots());
            let is_step = || tip.is_dot && other.is_dot && (other.at - tip.at).length() < step;
            let long = tip.path != other.path || paths.paths[tip.path as usize].length > LEAST_LENGTH * blank;
            if id < number && blank > 0.0 && blank <= most && long && facing(tip, other) && !is_step() {
                let between = (tip.at, other.at);
                // also a line that passes in one of its vertices: on a grid of dots all lines cross so
                let free = |segment: &nearby::Segment| {
                    let (is_own, ends) = ([tip.path, other.path].contains(&segment.line), (segment.a, segment.b));
                    if is_own { crossing(between, ends).is_none() } else { segment_distance(between, ends) > TOUCH }
                };
                let mut clear = true;
                index.around(tip.at.min(other.at), tip.at.max(other.at), TOUCH, |segment| {
                    clear &= free(segment);
                });
                if clear {
                    found.push(broken(paths, names, tip, other, blank));
                }
            }
        });
    }
    found
}

fn broken(paths: &Paths, names: &[String], tip: &Tip, other: &Tip, blank: f32) -> FoundBreach {
    let line = |tip: &Tip| name_in(names, paths.paths[tip.path as usize].line);
    let what = match tip.path == other.path {
        true => format!("the two ends of {} are {blank:.1} mm apart, so that it may be closed or not", line(tip)),
        false => format!(
            "{} end {blank:.1} mm before one another, so that they may be one or two",
            both(line(other), line(tip))
        ),
    };
    let extent = MmRect::new(tip.at.min(other.at), tip.at.max(other.at));
    FoundBreach::at(BROKEN_LINE, tip.at.lerp(other.at, 0.5), extent, blank, what).of(line(tip))
}

/// An end that a person drew which points at the side of another line over a gap of up to `most` mm and no error: of
/// what the program draws, where ends are cut to keep clear, half a page of a photograph would be told.
fn stops_short(paths: &Paths, names: &[String], tip: &Tip, index: &Nearby, most: f32) -> Option<FoundBreach> {
    let far = tip.at + tip.outwards * (2.0 * most);
    let (mut nearest, mut is_joined): (Option<(f32, MmPoint, u32)>, bool) = (None, false);
    index.around(tip.at.min(far), tip.at.max(far), most, |side| {
        let radii = tip.radius + side.half_width;
        is_joined |= side.line != tip.path && nearest_on_segment(tip.at, side.a, side.b).0 <= radii + TOUCH;
        let Some(at) = crossing((tip.at, far), (side.a, side.b)) else { return };
        let Some(along) = (side.b - side.a).try_normalize() else { return };
        let blank = (at - tip.at).length() - radii;
        // it does not pass by
        let is_steep = tip.outwards.cross(along).abs() >= STEEP_SINE;
        if is_steep && nearest.is_none_or(|(least, ..)| blank < least) {
            nearest = Some((blank, at, side.line));
        }
    });
    let (blank, at, other) = nearest.filter(|(blank, ..)| !is_joined && (0.5 * most..=most).contains(blank))?;
    let name = |path: u32| name_in(names, paths.paths[path as usize].line);
    let what =
        format!("{} ends {blank:.1} mm before {}, so that it may be meant to meet it", name(tip.path), name(other));
    let extent = MmRect::new(tip.at.min(at), tip.at.max(at));
    (other != tip.path)
        .then(|| FoundBreach::at(BROKEN_LINE, tip.at.lerp(at, 0.5), extent, blank, what).of(name(tip.path)))
}

fn facing(a: &Tip, b: &Tip) -> bool {
    let Some(across) = (b.at - a.at).try_normalize() else { return false };
    a.outwards.dot(across) >= STRAIGHT_COSINE && b.outwards.dot(-across) >= STRAIGHT_COSINE
}

fn tips(paths: &Paths, path: usize) -> Vec<Tip> {
    let length = paths.paths[path].length;
    let tip = |(segment, at, arc): (nearby::Segment, MmPoint, f32)| {
        let back = paths.at(path, if arc > 0.0 { (length - BACK).max(0.0) } else { BACK.min(length) })?;
        let outwards = (at - back).try_normalize()?;
        let is_dot = paths.paths[path].kind != PathKind::Stroke;
        Some(Tip { at, outwards, radius: segment.half_width, path: path as u32, is_dot })
    };
    paths.tips(path).into_iter().filter_map(tip).collect()
}
