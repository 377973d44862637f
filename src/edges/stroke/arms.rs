//! Paths of a skeleton become lines: short spurs go, and arms that continue one another through a junction are one
//! line.

use super::skeleton::{SkeletonNode, SkeletonPath};
use crate::edges::params::HEADING;
use crate::geom::polyline::Polyline;
use crate::geom::walk::first_beyond;
use crate::units::{PxPoint, PxVector};

/// Two arms go on through a junction if the cosine between their directions is at most this (30 degrees from straight).
const STRAIGHT_COSINE: f32 = -0.866;
/// The two straightest arms of a junction are one line, unless they make a sharper corner than this (120 degrees).
const BENT: f32 = -0.5;
/// An arm with a free end that is no longer than this, px, beyond the stroke's own half width, is a spur that thinning
/// left.
const SPUR: f32 = 3.0;
/// The length of a spur counts the stroke's half width so often, as it may lead into a corner of the stroke's end.
const CORNER: f32 = 1.5;
/// To the tip of a corner it is this many half widths of the stroke over the sine of half its angle, at most.
const TIP: f32 = 2.5;
/// Least sine of half the angle of a corner that counts: that of a corner of 15 degrees.
const SHARPEST: f32 = 0.13;
/// A spur leads to the tip if the cosine between it and the outer half of the angle is at least this (37 degrees).
const TO_TIP: f32 = 0.8;
/// There is a corner where the sum of the directions of its sides is at least this long (120 degrees). On a straight
/// line the sum has no direction, and a short branch would be a spur to its tip.
const CORNERED: f32 = 1.0;

/// A line of pixels, which may lead through junctions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strand {
    pub(super) line: Polyline<PxPoint>,
    /// Whether its start and its end are free, and not at a junction.
    pub(super) free: [bool; 2],
    /// The junctions that it leads through.
    pub(super) junctions: Vec<PxPoint>,
}

/// An end of a path at a junction.
#[derive(Debug, Clone, Copy)]
struct Arm {
    path: usize,
    at_start: bool,
    heading: PxVector,
}

/// The end of a path that goes on with another one, and the junction between.
#[derive(Debug, Clone, Copy)]
struct Partner {
    path: usize,
    at_start: bool,
    node: usize,
}

/// The lines of a skeleton, pixel by pixel.
pub(super) fn joined(paths: Vec<SkeletonPath>, nodes: &[SkeletonNode]) -> Vec<Strand> {
    let all_arms = arms(&paths, nodes);
    let is_spur = |number: usize| match paths[number].nodes {
        [Some(node), None] | [None, Some(node)] => {
            paths[number].points.len() as f32 <= longest_spur(number, &all_arms[node], nodes[node].depth)
        }
        _ => false,
    };
    let spurs: Vec<bool> = (0..paths.len()).map(is_spur).collect();
    let paths: Vec<SkeletonPath> =
        paths.into_iter().zip(spurs).filter(|(_, is_spur)| !is_spur).map(|(path, _)| path).collect();
    let arms_of = arms(&paths, nodes);
    // for the start and the end of each path
    let mut partner: Vec<[Option<Partner>; 2]> = vec![[None; 2]; paths.len()];
    for (node, arms) in arms_of.iter().enumerate() {
        for (a, b) in pairs(arms) {
            partner[a.path][usize::from(!a.at_start)] = Some(Partner { path: b.path, at_start: b.at_start, node });
            partner[b.path][usize::from(!b.at_start)] = Some(Partner { path: a.path, at_start: a.at_start, node });
        }
    }
    let lone = |node: usize| arms_of[node].len() < 2;
    concatenated(&paths, &partner, nodes, &lone)
}

/// The arms of every junction.
fn arms(paths: &[SkeletonPath], nodes: &[SkeletonNode]) -> Vec<Vec<Arm>> {
    let mut arms = vec![Vec::new(); nodes.len()];
    for (number, path) in paths.iter().enumerate() {
        for at_start in [true, false] {
            if let Some(node) = path.nodes[usize::from(!at_start)] {
                arms[node].push(Arm { path: number, at_start, heading: heading(path, at_start, nodes[node].at) });
            }
        }
    }
    arms
}

/// How long the free path of this number may be to be a spur of its junction, px. From the inside of a sharp corner a
/// spur leads to its tip, away from both sides: the sharper the corner, the farther.
fn longest_spur(path: usize, arms: &[Arm], depth: f32) -> f32 {
    let own = arms.iter().find(|arm| arm.path == path);
    let others: Vec<&Arm> = arms.iter().filter(|arm| arm.path != path).collect();
    let to_side = SPUR + CORNER * depth;
    let (Some(own), [a, b]) = (own, &others[..]) else { return to_side };
    let half_sine = 0.5 * (a.heading - b.heading).length();
    let to_tip = -(a.heading + b.heading);
    let is_tip = to_tip.length() >= CORNERED && own.heading.dot(to_tip) >= TO_TIP * to_tip.length();
    if is_tip { to_side.max(SPUR + TIP * depth / half_sine.max(SHARPEST)) } else { to_side }
}

/// The direction in which an arm leaves its junction.
fn heading(path: &SkeletonPath, at_start: bool, node: PxPoint) -> PxVector {
    let n = path.points.len();
    let from_node = |i: usize| path.points[if at_start { i } else { n - 1 - i }];
    let far = first_beyond((0..n).map(from_node), node, HEADING);
    far.and_then(|far| (far - node).try_normalize()).unwrap_or(PxVector::zero())
}

/// Which arms of a junction go on into which.
fn pairs(arms: &[Arm]) -> Vec<(Arm, Arm)> {
    let mut all: Vec<(f32, usize, usize)> = Vec::new();
    for i in 0..arms.len() {
        for k in i + 1..arms.len() {
            all.push((arms[i].heading.dot(arms[k].heading), i, k));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free = vec![true; arms.len()];
    let mut pairs = Vec::new();
    for (number, &(cosine, i, k)) in all.iter().enumerate() {
        // of two arms that are left of a junction, both go on, whatever the corner
        let most = match (arms.len(), number) {
            (2, _) => 1.0,
            (_, 0) => BENT,
            _ => STRAIGHT_COSINE,
        };
        if cosine <= most && free[i] && free[k] {
            (free[i], free[k]) = (false, false);
            pairs.push((arms[i], arms[k]));
        }
    }
    pairs
}

/// The lines along paths and their partners.
fn concatenated(
    paths: &[SkeletonPath],
    partner: &[[Option<Partner>; 2]],
    nodes: &[SkeletonNode],
    lone: &dyn Fn(usize) -> bool,
) -> Vec<Strand> {
    let mut used = vec![false; paths.len()];
    let mut lines = Vec::new();
    // first from ends without partner, then round what is closed
    let ends = (0..paths.len()).flat_map(|path| [(path, true), (path, false)]);
    let free = ends.filter(|&(path, at_start)| partner[path][usize::from(!at_start)].is_none());
    for (path, at_start) in free.chain((0..paths.len()).map(|path| (path, true))) {
        if used[path] {
            continue;
        }
        let (mut points, mut junctions): (Vec<PxPoint>, Vec<PxPoint>) = Default::default();
        let node_at = |path: &SkeletonPath, start: bool| path.nodes[usize::from(!start)];
        let start = node_at(&paths[path], at_start).filter(|_| partner[path][usize::from(!at_start)].is_none());
        points.extend(start.map(|node| nodes[node].at));
        let (mut here, mut from_start) = (path, at_start);
        let (closed, end) = loop {
            used[here] = true;
            match from_start {
                true => points.extend(&paths[here].points),
                false => points.extend(paths[here].points.iter().rev()),
            }
            match partner[here][usize::from(from_start)] {
                Some(next) if !used[next.path] => {
                    points.push(nodes[next.node].at);
                    junctions.push(nodes[next.node].at);
                    (here, from_start) = (next.path, next.at_start);
                }
                Some(Partner { path: next, node, .. }) => {
                    junctions.push(nodes[node].at);
                    let end = node_at(&paths[here], !from_start);
                    points.extend(end.map(|node| nodes[node].at));
                    break (next == path, end);
                }
                None => {
                    let end = node_at(&paths[here], !from_start);
                    points.extend(end.map(|node| nodes[node].at));
                    break (paths[here].closed, end);
                }
            }
        };
        points.dedup();
        if points.len() > 1 {
            let line = Polyline { closed: closed && points.len() > 2, vertices: points };
            let free = [start, end].map(|node| !line.closed && node.is_none_or(lone));
            lines.push(Strand { line, free, junctions });
        }
    }
    lines
}

#[cfg(test)]
mod tests;
